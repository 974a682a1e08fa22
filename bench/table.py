"""Times as people read them, and the tables."""

import math


def time_text(ns):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if ns >= size:
            return f"{ns / size:.3g} {unit}" if ns < 1000 * size else f"{ns / size:.0f} {unit}"
    return f"{ns:.0f} ns"


def cell(result, limit):
    if result is None:
        return "–"
    if result.status == "ok":
        return time_text(result.true_ns)
    return {"slow": f"> {limit:g} s", "wrong": "WRONG", "failed": "failed",
            "unknown": "UNKNOWN"}[result.status]


def ratio_text(ratio):
    return f"{ratio:.3g}×" if ratio < 1000 else f"{ratio:.0f}×"


def exponent(times):
    """Least squares of log time against log size; needs three sizes."""
    points = [(math.log(n), math.log(ns)) for n, ns in times if ns > 0]
    if len(points) < 3:
        return None
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    return (sum((x - mean_x) * (y - mean_y) for x, y in points)
            / sum((x - mean_x) ** 2 for x, _ in points))


def good_times(row):
    return [(n, result.true_ns) for n, result in row.items() if result.status == "ok"]


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|---" * len(header) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def aligned(text):
    """The same with columns of equal width, which reads well on a terminal too."""
    rows = [line.strip("|").split("|") for line in text.splitlines()]
    widths = [max(len(row[k].strip()) for row in rows if len(row) > k and "---" not in row[k])
              for k in range(len(rows[0]))]
    lines = []
    for row in rows:
        if row[0].startswith("---"):
            lines.append("|" + "|".join("-" * (width + 2) for width in widths) + "|")
        else:
            cells = [f" {entry.strip():<{width}} " for entry, width in zip(row, widths)]
            lines.append("|" + "|".join(cells) + "|")
    return "\n".join(lines)


def workload_tables(key, workload, sizes, results, limit):
    """Times, and how many times longer than patchproof each peer takes."""
    ours = results["patchproof"]
    header = [key] + [f"{workload.size} = {n}" for n in sizes]
    rows = []
    for name, row in results.items():
        cells = [name] + [cell(row.get(n), limit) for n in sizes]
        if workload.fit:
            slope = exponent(good_times(row))
            cells.append("" if slope is None else f"{slope:.2f}")
        rows.append(cells)
        if any(result.reading_ns for result in row.values()):
            rows.append(["… reading the text too"] +
                        [time_text(row[n].reading_ns) if n in row and row[n].status == "ok" else "–"
                         for n in sizes] + ([""] if workload.fit else []))
    times = markdown(header + (["exponent"] if workload.fit else []), rows)
    rows = []
    for name, row in results.items():
        if name == "patchproof":
            continue
        cells = [name]
        for n in sizes:
            known = n in row and n in ours and row[n].status == ours[n].status == "ok"
            cells.append(ratio_text(row[n].true_ns / ours[n].true_ns) if known else "–")
        rows.append(cells)
    ratios = markdown([f"{key}, time / patchproof"] + header[1:], rows)
    return aligned(times) + "\n\n" + aligned(ratios)
