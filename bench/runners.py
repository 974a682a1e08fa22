"""How each peer is started, and what it says."""

import pathlib
from dataclasses import dataclass

import claims
import nets
from limited import finished

HERE = pathlib.Path(__file__).resolve().parent
PEERS = HERE / "peers"
OURS = "patchproof"
# That of the Debian packages, whichever else there may be.
PYTHON = "/usr/bin/python3"


@dataclass
class Result:
    """One peer, one workload, one size. Times are medians in nanoseconds."""
    status: str  # "ok", "slow", "wrong", "failed", "unknown"
    true_ns: float = 0
    mutant_ns: float = 0
    reading_ns: float = 0
    memory_kb: float = 0
    note: str = ""


def _number(workload):
    return workload[1:]


def _words(workload, n, options):
    """What every peer with a command line is told; where the nets of W6 are comes last."""
    data = [str(options.folder)] if workload == "W6" else []
    return [workload, str(n), str(options.seconds)] + data


def _python(script):
    return lambda workload, n, options: (
        [PYTHON, str(PEERS / script)] + _words(workload, n, options), "")


def _compiled(program):
    return lambda workload, n, options: (
        [str(options.programs / program)] + _words(workload, n, options), "")


def _maxima(workload, n, options):
    start = (f"workload:{_number(workload)}$ n:{n}$ seconds:{options.seconds}$ "
             f'load("{PEERS}/maxima.mac")$')
    return ["maxima", "--very-quiet", "--batch-string=" + start], ""


def _singular(workload, n, options):
    return ["Singular", "-q"], (f"int workload={_number(workload)}; int size_n={n};\n"
                                f"int seconds={round(1000 * options.seconds)};\n"
                                f'< "{PEERS}/singular.sing";\n')


def _pari(workload, n, options):
    # A new size of the stack ends the line it stands on.
    return ["gp", "-q", "-f"], (f"default(parisizemax, 8*10^9);\nworkload={_number(workload)};"
                                f'n={n};seconds={options.seconds};folder="{options.folder}";'
                                f'read("{PEERS}/pari.gp")\n')


COMMANDS = {
    "SymPy expand": _python("sympy_expand.py"),
    "SymPy ring": _python("sympy_ring.py"),
    "Maxima rat": _maxima,
    "GiNaC expand": _compiled("ginac_expand"),
    "Singular": _singular,
    "PARI": _pari,
    "FLINT mpoly": _compiled("flint_mpoly"),
    "FLINT fmpq": _compiled("flint_net"),
    "FLINT matrix": _compiled("flint_matrix"),
    "FLINT fmpz": _compiled("flint_matrix"),
    "CLN (GiNaC's numbers)": _compiled("cln_net"),
    "GiNaC matrix": _compiled("ginac_matrix"),
    "Maxima matrix": _maxima,
    "SymPy numbers": _python("sympy_net.py"),
    "SymPy matrix": _python("sympy_matrix.py"),
    "SymPy (Python integers)": _python("sympy_matrix.py"),
}


def run_peer(name, workload, n, options):
    """The true claim has to be proved, its mutant not."""
    if workload == "W6":
        nets.write(options.folder, n)
    command, text = COMMANDS[name](workload, n, options)
    # Both claims have to come to an end, each within the limit.
    out, errors, over = finished(command, text, 2 * options.limit)
    said = {}
    for line in out.splitlines():
        words = line.split()
        if len(words) == 3 and words[0] in ("true", "mutant"):
            said[words[0]] = (float(words[1]), words[2])
    if over or any(ns > 1e9 * options.limit for ns, _ in said.values()):
        return Result("slow")
    if set(said) != {"true", "mutant"}:
        return Result("failed", note=(errors or out).strip()[-300:])
    if not all(ns > 0 for ns, _ in said.values()):
        return Result("failed", note="its clock did not move")
    right = said["true"][1] == "1" and said["mutant"][1] == "0"
    return Result("ok" if right else "wrong", said["true"][0], said["mutant"][0],
                  note="" if right else f"true: {said['true'][1]}, mutant: {said['mutant'][1]}")


def run_ours(workload, n, options):
    """The same for patchproof, whose claims are texts."""
    files = []
    for mutant in (0, 1):
        path = options.folder / f"{workload}_{n}_{'mutant' if mutant else 'true'}.proof"
        path.write_text(claims.text(workload, n, mutant))
        files.append(path)
    said = []
    for path in files:
        command = [str(options.programs / "patchproof_bench"), str(options.seconds), str(path)]
        out, errors, over = finished(command, "", options.limit)
        words = out.strip().split(" ", 3)
        if over or len(words) == 4 and float(words[0]) > 1e9 * options.limit:
            return Result("slow")
        if len(words) != 4:
            return Result("failed", note=(errors or out).strip()[-300:])
        if float(words[0]) <= 0:
            return Result("failed", note="its clock did not move")
        said.append((float(words[0]), float(words[1]), words[3], float(words[2])))
    verdicts = [verdict for _, _, verdict, _ in said]
    note = ", ".join(verdicts)
    if verdicts[0].startswith("UNKNOWN") or verdicts[1].startswith("UNKNOWN"):
        return Result("unknown", said[0][0], said[1][0], said[0][1],
                      said[0][3], note)
    right = verdicts == ["PROVED", "REFUTED"]
    return Result("ok" if right else "wrong", said[0][0], said[1][0], said[0][1],
                  said[0][3], "" if right else note)
