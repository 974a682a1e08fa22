"""The workloads as case text: `text(workload, n, mutant)`.

A mutant is the same claim with one thing wrong, and goes the same way through the program."""

from nets import coordinate, plane_net


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


def w4(n, mutant):
    """The Bézier points of neighbouring segments, which share their edge, have equal first and second
    differences there. The mutant has one knot in the wrong place."""
    rows = " ; ".join(", ".join("({}/{},{}/{},{}/{})".format(*coordinate(i, j, 0), *coordinate(i, j, 1),
                                                          *coordinate(i, j, 2)) for j in range(n))
                      for i in range(n))
    knots = [0, 0, 0] + list(range(n - 2)) + [n - 3] * 3
    if mutant:
        knots[4] = "4/5"
    m = 3 * (n - 3)
    lines = [f"matrix d = [{rows}]",
             f"spline S = bspline(d, degree 3, knots [{', '.join(map(str, knots))}])"
             if mutant else "spline S = bspline(d, degree 3, 3, clamped uniform)",
             "let B = bezier_net(S)"]
    for name, at in (("u", "B[{}, 0..%d]" % m), ("v", "B[0..%d, {}]" % m)):
        p = [at.format(f"3*k{shift}") for shift in ("-2", "-1", "", "+1", "+2")]
        lines.append(f"prove C1_{name}: {p[3]} - {p[2]} == {p[2]} - {p[1]} for k in 1..{n - 4}")
        lines.append(f"prove C2_{name}: {p[4]} - 2*{p[3]} + {p[2]} == {p[2]} - 2*{p[1]} + {p[0]} "
                     f"for k in 1..{n - 4}")
    return lines


def w5(n, mutant):
    """The mutant is the net with one point wrong."""
    wrong = (f" + {mutant}/{n * n}*bernstein({n}, 1, u)*bernstein({n}, 1, v)*V[0,1]" if mutant
             else "")
    return ["param u, v in [0, 1]", f"scalar V[0..{n}, 0..{n}], q[0..{n}, 0..{n}]",
            "patch c(u,v) = bezier(discrete_coons(V))" + wrong, "patch p(u,v) = bezier(q)",
            "let E(q) = integral(q_uv^2, u in [0, 1], v in [0, 1])",
            "prove claim: c minimizes E(p) over p where p == bezier(V) on boundary"]


def w6(n, mutant):
    x, y = plane_net(n, mutant)
    rows = " ; ".join(", ".join(f"({a},{b})" for a, b in zip(*row)) for row in zip(x, y))
    return ["param u, v in [0, 1]", f"matrix V = [{rows}]", "patch r(u,v) = bezier(V)",
            "prove claim: det(r_u, r_v) > 0"]


def text(workload, n, mutant):
    lines = {"W1": w1, "W2": w2, "W3": w3, "W4": w4, "W5": w5, "W6": w6}[workload](n, mutant)
    return "\n".join([f"case bench.{workload.lower()}"] + ["  " + line for line in lines]
                     + ["end", ""])
