"""Runs a command within a limit of processor time."""

import os
import pathlib
import signal
import subprocess
import time

TICKS = os.sysconf("SC_CLK_TCK")


def _processor_time(session):
    """Of all processes of a session, in seconds; some systems are started by a script."""
    ticks = 0
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:
            continue  # It has just ended.
        if int(fields[3]) == session:
            ticks += sum(map(int, fields[11:15]))
    return ticks / TICKS


def finished(command, text, limit):
    """What a command prints, or what it had printed when its time was over, and whether it was.

    The limit is processor time, so that a busy machine changes nothing; four times as much by the
    clock is the end for what only waits. It is watched from outside: with a limit set for the process
    (RLIMIT_CPU) the kernel counts its time in ticks, too coarse for what is measured here."""
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", LC_ALL="C.UTF-8")
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, env=environment,
                               start_new_session=True)
    begin, over = time.monotonic(), False
    while True:
        try:
            out, errors = process.communicate(text, timeout=0.25)
            return out, errors, over
        except subprocess.TimeoutExpired:
            text = None  # It is sent once.
            if _processor_time(process.pid) > limit or time.monotonic() - begin > 4 * limit:
                over = True
                os.killpg(process.pid, signal.SIGKILL)
