"""The claims W1, W2, W3 over any arithmetic: `ring` has one, the parameters, and points V[i, j]."""

from math import comb


def powers(x, n, one):
    result = [one]
    for _ in range(n):
        result.append(result[-1] * x)
    return result


def bernstein(n, t, one):
    up, down = powers(t, n, one), powers(one - t, n, one)
    return [comb(n, i) * (up[i] * down[n - i]) for i in range(n + 1)]


def blended(s, t, r):
    """The Coons patch at (s, t) of r(corner) and r(edge): r("c1"), r("00")…"""
    return (r("c1") + t * (r("c2") - r("c1")) + r("d1") + s * (r("d2") - r("d1"))
            - (r("00") + s * (r("10") - r("00")))
            - t * (r("01") + s * (r("11") - r("01")) - r("00") - s * (r("10") - r("00"))))


def coons(n, V, s, t, one):
    """The Coons patch of the boundary points at (s, t)."""
    at_s, at_t = bernstein(n, s, one), bernstein(n, t, one)
    span = range(n + 1)
    parts = {"c1": sum(at_s[i] * V[i, 0] for i in span), "c2": sum(at_s[i] * V[i, n] for i in span),
             "d1": sum(at_t[j] * V[0, j] for j in span), "d2": sum(at_t[j] * V[n, j] for j in span),
             "00": V[0, 0], "10": V[n, 0], "01": V[0, n], "11": V[n, n]}
    return blended(s, t, parts.__getitem__)


def net_point(n, V, i, j, mutant):
    """n*n times a point of the discrete Coons net; one factor of the mutant is wrong."""
    wrong = mutant if (i, j) == (1, 1) else 0
    return (n * (n - j) * V[i, 0] + n * j * V[i, n] + n * (n - i) * V[0, j] + n * i * V[n, j]
            - (n - i) * (n - j) * V[0, 0] - i * (n - j) * V[n, 0] - (n - i) * j * V[0, n]
            - i * j * V[n, n] + wrong * V[0, 1])


def tensor(n, V, u, v, one, mutant):
    """n*n times the tensor product Bézier patch of the net, row by row."""
    at_u, at_v = bernstein(n, u, one), bernstein(n, v, one)
    span = range(n + 1)
    return sum(at_u[i] * sum(at_v[j] * net_point(n, V, i, j, mutant) for j in span) for i in span)


def part_and_coons(n, V, u, v, a, b, c, d, one, mutant):
    """The patch over [a, b] x [c, d], and the Coons patch of its own edges. The mutant takes one
    corner from the wrong place."""
    s, t = a + u * (b - a), c + v * (d - c)
    places = {"c1": (s, c), "c2": (s, d), "d1": (a, t), "d2": (b, t),
              "00": (a, c), "10": (b, c), "01": (a, d), "11": (a if mutant else b, d)}
    edges = {name: coons(n, V, *place, one) for name, place in places.items()}
    return coons(n, V, s, t, one), blended(u, v, edges.__getitem__)


def boundary(n):
    return [(i, j) for i in range(n + 1) for j in range(n + 1) if i % n == 0 or j % n == 0]
