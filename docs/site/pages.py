"""Writes the pages that are made from other things: the program's from its help, those of C++ from its headers.

pages.py PROGRAM HEADERS FOLDER
"""

import re
import subprocess
import sys
from pathlib import Path

# In the order in which a reader meets them.
HEADERS = [
    "overlay",
    "region_set",
    "region_builder",
    "point",
    "options",
    "workspace",
    "error",
    "features",
    "layers",
    "check",
    "check_features",
    "repair",
    "buffer",
    "zones",
    "hull",
    "triangulate",
    "locator",
    "measure",
    "classics",
    "wkb",
    "wkt",
    "domain",
    "version",
]


def printed(*command: str) -> str:
    """What a command prints; an error if it fails."""
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def program_page(program: str) -> str:
    """One section a command: what --help prints."""
    top = printed(program, "--help")
    commands = re.findall(r"^  (\w+) {2,}\S", top.split("Commands", 1)[1], re.MULTILINE)
    wide = "---\nhtml_theme.sidebar_secondary.remove: true\n---\n\n"  # help is 88 characters wide
    links = " ".join(f"[{command}](#oblast-{command})" for command in commands if command != "help")
    sections = [f"{wide}# Program: `oblast`\n\n{links}\n\n```text\n{top.rstrip()}\n```\n"]
    for command in commands:
        if command == "help":
            continue
        text = printed(program, command, "--help").rstrip()
        sections.append(f"## `oblast {command}`\n\n```text\n{text}\n```\n")
    return "\n".join(sections)


def header_page(header: Path) -> str:
    """The comment at the top of a header, then what it declares."""
    lines = header.read_text().splitlines()
    comment = []
    for line in lines:
        if not line.startswith("//"):
            break
        comment.append(line[3:])
    title = f"<oblast/{header.name}>"
    # A drawing is indented in the comment.
    return "\n".join(
        [f"``{title}``", "=" * (len(title) + 4), "", *as_rst(comment), "", f".. doxygenfile:: {header.name}", ""]
    )


def as_rst(comment: list[str]) -> list[str]:
    """Text is kept; indented lines become a literal block."""
    result = []
    for line, before in zip(comment, ["", *comment], strict=False):
        if line.startswith(" ") and before and not before.startswith(" "):
            result += ["", "::", ""]
        if line.startswith(" ") and not before:
            result += ["::", ""]
        result.append(line if line.startswith(" ") else re.sub(r"([*`_|])", r"\\\1", line))
    return result


def main() -> None:
    """Write all pages."""
    program, headers, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    (folder / "program.md").write_text(program_page(program))
    missing = {h.stem for h in headers.glob("*.h")} - {*HEADERS, "c", "export", "oblast"}
    if missing:
        raise SystemExit(f"pages.py: HEADERS lacks {', '.join(sorted(missing))}")
    (folder / "cpp").mkdir()
    for name in HEADERS:
        (folder / "cpp" / f"{name}.rst").write_text(header_page(headers / f"{name}.h"))
    entries = "\n".join(f"cpp/{name}" for name in HEADERS)
    (folder / "cpp.md").write_text(
        "# C++\n\nOne page a header. `#include <oblast/oblast.h>` includes all of them.\n\n"
        f"```{{toctree}}\n:maxdepth: 1\n\n{entries}\n```\n"
    )


main()
