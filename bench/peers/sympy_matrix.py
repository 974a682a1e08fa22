"""W5 and W6 with SymPy's dense matrices over the integers, and with Python's integers."""

import pathlib
import sys
from functools import lru_cache
from math import comb, lcm

from sympy import ZZ
from sympy.polys.matrices import DomainMatrix

from coons import boundary, net_point
from measure import measure


class Form(dict):
    """A linear form: the number of a point -> its factor."""

    def __rmul__(self, factor):
        return Form({k: factor * value for k, value in self.items()})

    def __add__(self, other):
        return Form({k: self.get(k, 0) + other.get(k, 0) for k in {**self, **other}})

    def __sub__(self, other):
        return self + (-1) * other


def gram(n):
    """Integrals of products of derivatives of Bernstein polynomials, times a whole number."""
    m = n - 1
    common = lcm(*(comb(2 * m, k) for k in range(2 * m + 1)))

    def product(p, q):
        inside = 0 <= p <= m and 0 <= q <= m
        return common // comb(2 * m, p + q) * comb(m, p) * comb(m, q) if inside else 0

    return [[product(i - 1, k - 1) + product(i, k) - product(i - 1, k) - product(i, k - 1)
             for k in range(n + 1)] for i in range(n + 1)]


def positive_definite(m):
    """By elimination without fractions: all leading minors are positive."""
    m, before = [row[:] for row in m], 1
    for p, pivots in enumerate(m):
        if pivots[p] <= 0:
            return False
        for row in m[p + 1:]:
            factor = row[p]
            row[p:] = [(pivots[p] * a - factor * b) // before for a, b in zip(row[p:], pivots[p:])]
        before = pivots[p]
    return True


def w5(n, mutant):
    """All points beside each other in one matrix; the gradient is G C G at inner points."""
    g, places = gram(n), boundary(n)
    number = {place: k for k, place in enumerate(places)}
    V = {place: Form({k: 1}) for place, k in number.items()}
    nets = [[0] * (len(places) * (n + 1)) for _ in range(n + 1)]
    for i in range(n + 1):
        for j in range(n + 1):
            for k, value in net_point(n, V, i, j, mutant).items():
                nets[i][k * (n + 1) + j] = value
    rows = DomainMatrix(g[1:n], (n - 1, n + 1), ZZ)
    half = (rows * DomainMatrix(nets, (n + 1, len(nets[0])), ZZ)).to_list()
    turned = [row[k:k + n + 1] for row in half for k in range(0, len(row), n + 1)]
    gradient = DomainMatrix(turned, (len(turned), n + 1), ZZ) * rows.transpose()
    convex = positive_definite([row[1:n] for row in g[1:n]])
    return convex and not any(any(row) for row in gradient.to_list())


@lru_cache
def read_net(n, mutant):
    path = pathlib.Path(sys.argv[4]) / f"W6_{n}_{'mutant' if mutant else 'true'}.txt"
    rows = [[int(word) for word in line.split()] for line in path.read_text().splitlines()]
    return rows[:n + 1], rows[n + 1:]


def turned(a):
    return [list(row) for row in zip(*a)]


def product_of_differences(n, a, b):
    """(differences in u of a) * (differences in v of b), in scaled Bernstein form."""
    left = [[comb(n - 1, i) * comb(n, j) * (q - p) for j, (p, q) in enumerate(zip(a[i], a[i + 1]))]
            for i in range(n)]
    right = [[comb(n, i) * comb(n - 1, j) * (row[j + 1] - row[j]) for j in range(n)]
             for i, row in enumerate(b)]
    result = [[0] * (2 * n) for _ in range(2 * n)]
    for i, one in enumerate(left):
        for k, other in enumerate(right):
            target = result[i + k]
            for j, p in enumerate(one):
                for l, q in enumerate(other):
                    target[j + l] += p * q
    return result


def halves(line):
    """De Casteljau at 1/2 without divisions: everything becomes 2^(side - 1) times as large."""
    first, second, last = [], [], len(line) - 1
    for k in range(len(line)):
        first.append(line[0] << (last - k))
        second.append(line[-1] << (last - k))
        line = [a + b for a, b in zip(line, line[1:])]
    return first, second[::-1]


def positive(box, depth=0):
    if all(value > 0 for row in box for value in row):
        return True
    if min(box[0][0], box[0][-1], box[-1][0], box[-1][-1]) <= 0 or depth == 40:
        return False
    # The other direction each time: the halves are turned.
    first, second = zip(*(halves(row) for row in turned(box)))
    return positive(first, depth + 1) and positive(second, depth + 1)


def w6(n, mutant):
    x, y = read_net(n, mutant)
    p, q = product_of_differences(n, x, y), product_of_differences(n, y, x)
    side = range(2 * n)
    common = lcm(*(comb(2 * n - 1, i) for i in side))
    weights = [common // comb(2 * n - 1, i) for i in side]
    return positive([[(p[i][j] - q[i][j]) * weights[i] * weights[j] for j in side] for i in side])


measure({"W5": w5, "W6": w6})
