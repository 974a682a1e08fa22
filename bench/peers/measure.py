"""Timing that all peers written in Python share."""

import statistics
import sys
import time


def measure(claims, before=lambda: None):
    """Prints "true NANOSECONDS VERDICT" and "mutant NANOSECONDS VERDICT" for WORKLOAD N SECONDS.

    `before` is called before each proof, and not timed."""
    workload, n, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])
    proof = claims[workload]
    for mutant in (0, 1):
        times, verdicts = [], set()
        while sum(times) < (5 * seconds if len(times) < 3 else seconds) and len(times) < 1001:
            before()
            begin = time.process_time_ns()
            verdicts.add(bool(proof(n, mutant)))
            times.append((time.process_time_ns() - begin) * 1e-9)
        if len(verdicts) != 1:
            sys.exit("the verdict differs from run to run")
        print("mutant" if mutant else "true", round(1e9 * statistics.median(times)),
              int(verdicts.pop()), flush=True)
