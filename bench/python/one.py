"""one.py JOB_TOOL FOLDER ROUNDS: runs a job, and prints its seconds by part, the best of the rounds, as JSON.

A job is a generator. It yields when its input is loaded, when the input is in the tool's natural types, when the
operation is done, and when the result is in arrays, or in geometries if the caller had geometries. Then it yields
what to compare.
"""

import itertools
import json
import os
import resource
import sys
import time

import fires
import layers
import pairs


def parts(job):
    """Seconds to convert the input, of the operation, to convert the result; and what it answered."""
    next(job)
    times = [time.perf_counter()]
    for _ in range(3):
        next(job)
        times.append(time.perf_counter())
    return [end - begin for begin, end in itertools.pairwise(times)], next(job)


def main():
    name, folder, rounds = sys.argv[1], sys.argv[2], int(sys.argv[3])
    job = next(getattr(module, name) for module in (fires, pairs, layers) if hasattr(module, name))
    best = None
    for _ in range(rounds):
        seconds, answer = parts(job(folder))
        if best is None or sum(seconds) < sum(best):
            best = seconds
        if sum(seconds) > 5:  # the noise is small then
            break
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        json.dumps({"seconds": best, "area": float(answer[0]), "count": answer[1] and int(answer[1]), "peak_mb": peak})
    )
    sys.stdout.flush()
    os._exit(0)  # some packages take seconds to leave


main()
