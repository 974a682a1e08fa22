"""The workloads as case text: `text(workload, n, mutant)`.

A mutant is the same claim with one thing wrong, and goes the same way through the program."""


def _patch(n):
    return ["param u, v in [0, 1]", f"point V[0..{n}, 0..{n}]", "patch b(u,v) = bezier(V)",
            "patch r(u,v) = coons(b(u,0), b(u,1), b(0,v), b(1,v))"]


def w1(n, mutant):
    wrong = f" + {mutant}/{n * n}*bernstein({n}, 1, u)*bernstein({n}, 1, v)*V[0,1]"
    return _patch(n) + ["patch q(u,v) = bezier(discrete_coons(V))" + (wrong if mutant else ""),
                        "prove claim: r == q"]


def w2(n, mutant):
    wrong = " + u^2*v^2*V[0,1]" if mutant else ""
    return _patch(n) + [f"patch p(u,v) = r{wrong}", "prove claim: p_uuvv == 0"]


def w3(n, mutant):
    """The mutant takes one corner from the wrong place."""
    corner = "a" if mutant else "c"
    return _patch(n) + [
        "scalar a, c, d, e",
        "patch q(u,v) = restriction(r, a, c, d, e)",
        "matrix K = [q(0,0), q(0,1) ; q(1,0), " + f"r({corner},e)]",
        "patch own(u,v) = (1-v)*q(u,0) + v*q(u,1) + (1-u)*q(0,v) + u*q(1,v) - [1-u, u]*K*[1-v ; v]",
        "prove claim: own == q"]


def text(workload, n, mutant):
    lines = {"W1": w1, "W2": w2, "W3": w3}[workload](n, mutant)
    return "\n".join([f"case bench.{workload.lower()}"] + ["  " + line for line in lines]
                     + ["end", ""])
