"""What patchproof wants to reach, and what a run says about it.

`structured` is the aim for claims that still say Bézier, Coons or spline, as the claims here do;
`opaque` that for claims of which only the formula is left."""

from dataclasses import dataclass

from table import exponent, good_times, markdown, aligned, ratio_text, time_text

OURS = "patchproof"
FLINT = ("FLINT mpoly",)
STRONG = ("FLINT mpoly", "PARI", "Singular")


@dataclass(frozen=True)
class Ratio:
    """How many times faster than the best of these peers."""
    workload: str
    n: int
    peers: tuple
    structured: float
    opaque: float = 0


RATIOS = [
    *(Ratio("W1", n, FLINT, s, o) for n, s, o in
      ((3, 10, 1.3), (8, 35, 3), (20, 150, 5), (40, 400, 2))),
    Ratio("W1", 8, ("GiNaC expand",), 100, 100),
    Ratio("W1", 8, ("SymPy expand",), 5000, 5000),
    *(Ratio("W2", n, FLINT, s, o) for n, s, o in
      ((3, 15, 1.3), (8, 40, 3), (20, 120, 5), (40, 400, 2))),
    Ratio("W3", 3, STRONG, 100, 5),
    Ratio("W3", 8, STRONG, 800, 5),
    Ratio("W4", 50, ("FLINT fmpq",), 150),
    *(Ratio("W5", n, ("FLINT matrix",), 15) for n in (3, 8, 16)),
    *(Ratio("W6", n, ("FLINT fmpz", "PARI", "SymPy (Python integers)"), s) for n, s in
      ((3, 80), (8, 400), (12, 400))),
    Ratio("W7", 1000, ("Singular",), 3),
]
# Workload, name of the row, size, nanoseconds.
TIMES = [("W7", OURS, 1, 3e6), ("W7", OURS, 1000, 20e6), ("W7", "patchproof, both engines", 1000, 1e9)]
# Workload, structured, opaque.
EXPONENTS = [("W1", 2.2, 3.5), ("W3", 1.2, 4.5)]
# Workload, size, megabytes.
MEMORY = [("W1", 40, 100)]


def good(everything, workload, name, n):
    result = everything.get(workload, {}).get(name, {}).get(n)
    return result if result is not None and result.status == "ok" else None


def verdict(met):
    return "met" if met else "missed"


def ratio_row(target, everything):
    name = " / ".join(target.peers)
    wanted = f"≥ {target.structured:g}×"
    opaque = f"≥ {target.opaque:g}×" if target.opaque else ""
    row = [f"{target.workload}, n = {target.n}", f"faster than {name}", wanted, opaque]
    ours = good(everything, target.workload, OURS, target.n)
    peers = [good(everything, target.workload, peer, target.n) for peer in target.peers]
    times = [peer.true_ns for peer in peers if peer is not None]
    if not times or target.n not in everything.get(target.workload, {}).get(OURS, {}):
        return row + ["–", "not measured"]
    if ours is None:
        return row + ["too slow", "missed"]
    ratio = min(times) / ours.true_ns
    if ratio < target.structured and target.opaque and ratio >= target.opaque:
        return row + [ratio_text(ratio), "missed (opaque: met)"]
    return row + [ratio_text(ratio), verdict(ratio >= target.structured)]


def target_table(everything):
    rows = [ratio_row(target, everything) for target in RATIOS if target.workload in everything]
    for workload, name, n, limit in TIMES:
        if workload in everything:
            result = good(everything, workload, name, n)
            rows.append([f"{workload}, n = {n}", f"time, {name}", f"≤ {time_text(limit)}", "",
                         time_text(result.true_ns) if result else "–",
                         verdict(result.true_ns <= limit) if result else "not measured"])
    for workload, structured, opaque in EXPONENTS:
        if workload in everything:
            slope = exponent(good_times(everything[workload][OURS]))
            rows.append([workload, "growth exponent", f"≤ {structured:g}", f"≤ {opaque:g}",
                         "–" if slope is None else f"{slope:.2f}",
                         "not measured" if slope is None else verdict(slope <= structured)])
    for workload, n, megabytes in MEMORY:
        if n in everything.get(workload, {}).get(OURS, {}):
            result = good(everything, workload, OURS, n)
            rows.append([f"{workload}, n = {n}", "memory", f"≤ {megabytes} MB", "",
                         f"{result.memory_kb / 1000:.0f} MB" if result else "too slow",
                         verdict(result is not None and result.memory_kb <= 1000 * megabytes)])
    return aligned(markdown(["", "patchproof is to be", "wanted", "wanted, opaque", "measured", ""],
                            rows))
