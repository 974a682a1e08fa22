"""W1, W2, W3 with SymPy's sparse polynomials.

The claims are linear in the points, so the k-th point may be x^k: short monomials are faster."""

from sympy import QQ, ring

from coons import boundary, coons, part_and_coons, tensor
from measure import measure


def points(n, x):
    return {place: x**k for k, place in enumerate(boundary(n))}


def w1(n, mutant):
    R, u, v, x = ring("u,v,x", QQ)
    V = points(n, x)
    return n * n * coons(n, V, u, v, R.one) == tensor(n, V, u, v, R.one, mutant)


def w2(n, mutant):
    R, u, v, x = ring("u,v,x", QQ)
    V = points(n, x)
    patch = coons(n, V, u, v, R.one) + mutant * u**2 * v**2 * V[0, 1]
    return patch.diff(u).diff(u).diff(v).diff(v) == 0


def w3(n, mutant):
    R, u, v, a, b, c, d, x = ring("u,v,a,b,c,d,x", QQ)
    part, own = part_and_coons(n, points(n, x), u, v, a, b, c, d, R.one, mutant)
    return part == own


measure({"W1": w1, "W2": w2, "W3": w3})
