"""What a table of times must say about the machine, and the Python that bench/peers/install set up."""

import os
import platform
import re
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


def describe():
    with open("/proc/cpuinfo") as file:
        model = re.search(r"model name\s*:\s*(.*)", file.read())
    with open("/proc/meminfo") as file:
        memory = int(re.search(r"MemTotal:\s*(\d+)", file.read()).group(1)) / 2**20
    with open("/etc/os-release") as file:
        system = re.search(r'PRETTY_NAME="(.*)"', file.read()).group(1)
    compiler = subprocess.run(["g++", "--version"], capture_output=True, text=True).stdout.splitlines()[:1]
    return (
        f"{model.group(1) if model else platform.machine()}, {os.cpu_count()} cores, {memory:.0f} GiB; "
        f"{system}; {compiler[0] if compiler else 'no g++'}"
    )
