"""Runs a driver on a workload file: what bench/run and bench/before_after share."""

import json
import os
import struct
import subprocess

from suite import BUILD, fires

ROUND_SECONDS = 0.3  # short runs are repeated inside the process until a round takes about this long


def prepare(workload, folder, shared, scale):
    """The workload's file, made when it is not there yet."""
    path = folder / f"{workload.name}-{scale}.bin"
    if path.exists():
        return path
    if workload.name == "fires":
        fires(scale)
    unfinished = path.with_suffix(".part")
    subprocess.run([BUILD / "bench" / "oblast_workload", *workload.make, "-o", unfinished], check=True)
    unfinished.rename(path)
    return path


def edges_of(path):
    """Edges of both operands, from the head of a workload file (workloads/workload_file.h)."""
    with open(path, "rb") as file:
        pairs = struct.unpack("<8x6I", file.read(32))[5]
        points_a, contours, polygons = struct.unpack("<3Q", file.read(24))
        file.seek(16 * points_a + 4 * (contours + polygons + (contours + polygons) % 2) + 24 * pairs, os.SEEK_CUR)
        return points_a + struct.unpack("<Q", file.read(8))[0]


def drive(peer, path, operation, threads, timeout, repeat=1, dump=None):
    """Runs a driver; its lines as objects. A crash or a time-out is one line too: that is a finding."""
    command = [*peer.command(threads), str(path), operation, "--repeat", str(repeat), "--threads", str(threads)]
    if peer.name == "geos-newest-coverage":
        command.append("--coverage")
    if dump:
        command += ["--dump", str(dump)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        return [{"error": f"not done in {timeout} s"}]
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    if done.returncode != 0 or not lines:
        last = (done.stderr.strip().splitlines() or [""])[-1]
        return [{"error": f"exit code {done.returncode}: {last}"[:200]}]
    return lines


def repeats_of_a_round(seconds):
    """How often a run that takes so long is repeated within a round."""
    return max(1, min(200, round(ROUND_SECONDS / max(seconds, 1e-9))))
