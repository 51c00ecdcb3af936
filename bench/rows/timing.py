"""Runs commands in fresh processes: wall time, peak of memory, and what became of the output file."""

import json
import os
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
INSTALLED = HERE / ".installed"
PYTHON = INSTALLED / "venv" / "bin" / "python"
MAPSHAPER = INSTALLED / "node_modules" / ".bin" / "mapshaper"


def timed(command, timeout):
    """Seconds, peak memory in MB, and standard output of a fresh process; or an error."""
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
        begin = time.perf_counter()
        process = subprocess.Popen([str(word) for word in command], stdout=out, stderr=err, start_new_session=True)
        guard = threading.Timer(timeout, os.killpg, (process.pid, signal.SIGKILL))
        guard.start()
        _, status, usage = os.wait4(process.pid, 0)
        guard.cancel()
        seconds = time.perf_counter() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        if process.returncode == -signal.SIGKILL and seconds >= timeout:
            return {"error": f"more than {timeout:.0f} s"}
        if process.returncode:
            return {"error": (err.read().strip().splitlines() or ["failed"])[-1][:200]}
        return {"seconds": seconds, "megabytes": usage.ru_maxrss / 1024, "out": out.read()}


def measure(command, operation, output, rounds, timeout):
    best = None
    for _ in range(rounds):
        Path(output).unlink(missing_ok=True)
        run = timed(command, timeout)
        if "error" in run:
            return run
        if best is None or run["seconds"] < best["seconds"]:
            best = run
        if run["seconds"] > 60:  # the noise is small then
            break
    best["operation"] = operation(best)
    del best["out"]
    judged = subprocess.run([PYTHON, HERE / "judge.py", output], capture_output=True, text=True, check=True)
    return best | json.loads(judged.stdout)
