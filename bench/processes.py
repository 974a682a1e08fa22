"""Whole processes, their start included. W7: so many small claims, read as text; the inputs are
written so that each peer says 1 or 0 for each claim."""

import resource
import statistics
import subprocess
import time

from runners import PEERS, PYTHON, Result
from small_claims import small_claims


# Rows of other workloads that are whole processes: name -> command for (n, mutant, options). It has to
# end with 0 for the true claim and with 1 for the mutant. The name goes to the peers of the workload.
PROGRAMS = {}


def differences(claims):
    return [f"{left}-({right})" for left, right, _ in claims]


def case_text(claims):
    lines = ["case bench.w7", "  param u, v in [0, 1]", "  scalar a, b, c, d"]
    for k, (left, right, holds) in enumerate(claims):
        lines.append(f"  {'prove ' if holds else 'refute'} c{k}: {left} == {right}")
    return "\n".join(lines + ["end", ""])


def singular_text(claims):
    return ("ring R = 0, (u, v, a, b, c, d), lp;\nstring s;\n"
            + "".join(f"s = s + string(({d}) == 0);\n" for d in differences(claims))
            + "s;\nquit;\n")


def maxima_text(claims):
    return ("answers: []$\n"
            + "".join(f"answers: cons(if rat({d}) = 0 then 1 else 0, answers)$\n"
                      for d in differences(claims))
            + "for answer in reverse(answers) do print(answer)$\nquit()$\n")


def gp_text(claims):
    return "".join(f"print1(({d})==0);\n" for d in differences(claims)) + "quit\n"


def commands(claims, options):
    """Name -> command, its standard input."""
    folder, count = options.folder, len(claims)
    case, maxima = folder / f"W7_{count}.proof", folder / f"W7_{count}.mac"
    case.write_text(case_text(claims))
    maxima.write_text(maxima_text(claims))
    lines = "\n".join(differences(claims)) + "\n"
    check = [str(options.build / "bin/patchproof"), "check", "--jobs", "1", "--quiet", str(case)]
    python = [PYTHON, "-B"]
    return {
        "patchproof": (check + ["--engines", "kernel"], ""),
        "patchproof, usual engines": (check + ["--engines", "usual"], ""),
        "patchproof, both engines": (check + ["--engines", "both"], ""),
        "SymPy expand": (python + [str(PEERS / "sympy_lines.py"), "expand"], lines),
        "SymPy ring": (python + [str(PEERS / "sympy_lines.py"), "ring"], lines),
        "Maxima rat": (["maxima", "--very-quiet", f'--batch-string=load("{maxima}")$'], ""),
        "GiNaC expand": ([str(options.programs / "ginac_lines")], lines),
        "Singular": (["Singular", "-q"], singular_text(claims)),
        "PARI": (["gp", "-q", "-f"], gp_text(claims)),
        "FLINT mpoly": ([str(options.programs / "flint_lines")], lines),
    }


def once(command, text, limit):
    """Processor time in nanoseconds, exit code, output; None when it takes too long."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=limit,
                              check=False)
    except subprocess.TimeoutExpired:
        return None
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return 1e9 * spent, done.returncode, done.stdout


def verdicts_right(name, claims, code, out):
    if name.startswith("patchproof"):
        # It compares with what is expected itself; claims left out would show in the count.
        return code == 0 and f"{len(claims)} claim" in out
    expected = "".join("1" if holds else "0" for _, _, holds in claims)
    return "".join(word for word in out.split() if set(word) <= {"0", "1"}) == expected


def run_processes(n, options):
    """Name -> result."""
    claims = small_claims(n)
    results = {}
    for name, (command, text) in commands(claims, options).items():
        if options.peers is not None and name not in options.peers:
            continue
        times, begin = [], time.monotonic()
        result = None
        while len(times) < 3 or time.monotonic() - begin < 2 * options.seconds:
            said = once(command, text, options.limit)
            if said is None:
                result = Result("slow")
                break
            times.append(said[0])
            if not verdicts_right(name, claims, *said[1:]):
                result = Result("wrong", note=f"exit {said[1]}: {said[2].strip()[-200:]}")
                break
        results[name] = result or Result("ok", statistics.median(times))
    return results


def run_program(name, n, options):
    """A row of PROGRAMS."""
    medians = []
    for mutant, expected in ((False, 0), (True, 1)):
        times, begin = [], time.monotonic()
        while len(times) < 3 or time.monotonic() - begin < options.seconds:
            said = once(PROGRAMS[name](n, mutant, options), "", options.limit)
            if said is None:
                return Result("slow")
            if said[1] != expected:
                return Result("wrong", note=f"exit {said[1]} instead of {expected}")
            times.append(said[0])
        medians.append(statistics.median(times))
    return Result("ok", *medians)
