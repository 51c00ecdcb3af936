"""What a table of times must say about the machine, and the Python that bench/peers/install set up."""

import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

from suite import INSTALLED


def in_environment():
    """Goes on in the environment of bench/peers/install, which has matplotlib and geopandas, where there is one."""
    environment = INSTALLED / "venv"
    python = environment / "bin" / "python"
    if python.exists() and Path(sys.prefix).resolve() != environment.resolve():
        os.execv(python, [str(python), *sys.argv])


def version(program):
    """The first line a program says of its version; empty where there is no such program."""
    if not shutil.which(program):
        return ""
    return subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split("\n")[0]


def describe():
    with open("/proc/cpuinfo") as file:
        model = re.search(r"model name\s*:\s*(.*)", file.read())
    with open("/proc/meminfo") as file:
        memory = int(re.search(r"MemTotal:\s*(\d+)", file.read()).group(1)) / 2**20
    with open("/etc/os-release") as file:
        system = re.search(r'PRETTY_NAME="(.*)"', file.read()).group(1)
    compilers = [version("g++"), version("rustc")]
    return (
        f"{model.group(1) if model else platform.machine()}, {os.cpu_count()} cores, {memory:.0f} GiB; "
        f"{system}; {'; '.join(compiler for compiler in compilers if compiler)}"
    )
