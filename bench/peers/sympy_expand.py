"""W1, W2, W3 with SymPy's expressions: the difference, expanded."""

from sympy.core.cache import clear_cache
from sympy import Integer, Symbol, diff, expand, symbols

from coons import boundary, coons, part_and_coons, tensor
from measure import measure

u, v, a, b, c, d = symbols("u v a b c d")
one = Integer(1)


def points(n):
    return {place: Symbol("V_%d_%d" % place) for place in boundary(n)}


def w1(n, mutant):
    V = points(n)
    return expand(n * n * coons(n, V, u, v, one) - tensor(n, V, u, v, one, mutant)) == 0


def w2(n, mutant):
    V = points(n)
    patch = coons(n, V, u, v, one) + mutant * u**2 * v**2 * V[0, 1]
    return expand(diff(expand(patch), u, 2, v, 2)) == 0


def w3(n, mutant):
    part, own = part_and_coons(n, points(n), u, v, a, b, c, d, one, mutant)
    return expand(part - own) == 0


# What the last proof has left would make the next one a look-up.
measure({"W1": w1, "W2": w2, "W3": w3}, before=clear_cache)
