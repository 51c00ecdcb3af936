"""Reports of bench/run: begun, combined, written."""

import datetime
import json
import subprocess

from chart import draw
from machine import describe
from suite import SOURCE
from tables import detail_table, growth_table, summary_table


def begun(scale):
    """A report without rows, of this machine and today."""
    return {"date": datetime.date.today().isoformat(), "scale": scale, "machine": describe(), "rows": []}


def commit():
    """What of oblast is measured, as git tells it."""
    done = subprocess.run(
        ["git", "describe", "--always", "--dirty"], cwd=SOURCE, capture_output=True, text=True, check=False
    )
    return done.stdout.strip() or "unknown"


def read(path):
    return json.loads(path.read_text())


def combined(reports):
    """One report of several. A later row replaces an earlier one of the same workload, operation, threads and peer."""
    for report in reports[1:]:
        for what in ("scale", "machine"):
            if report[what] != reports[0][what]:
                raise SystemExit(f"not to be combined: {what} {report[what]!r} and {reports[0][what]!r}")
    rows = {}
    for report in reports:
        for row in report["rows"]:
            rows[row["workload"], row["operation"], row["threads"], row["peer"]] = row
    return reports[-1] | {"rows": list(rows.values())}


def save(report, folder):
    unfinished = folder / "results.json.part"
    unfinished.write_text(json.dumps(report, indent=1))
    unfinished.rename(folder / "results.json")


def publish(report, folder):
    """Everything a reader wants, besides results.json."""
    table = growth_table if report["scale"] == "growth" else summary_table
    summary = table(report)
    (folder / "table.md").write_text(summary + "\n\n## In detail\n\n" + detail_table(report["rows"]) + "\n")
    draw(report, folder / "ratios.svg")
    print(summary)
    print(f"\nwritten: {folder}/results.json, table.md, ratios.svg")
