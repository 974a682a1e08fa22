"""Small textbook claims between polynomials, true and false, always the same."""

import random
from math import comb


def _bernstein(n, i, t):
    return f"{comb(n, i)}*{t}^{i}*(1-{t})^{n - i}"


def _square(source):
    a, b = source.randint(1, 9), source.randint(1, 9)
    return f"({a}*a+{b}*b)^2", f"{a * a}*a^2+{2 * a * b}*a*b+{b * b}*b^2"


def _unity(source):
    n = source.randint(2, 5)
    return "+".join(_bernstein(n, i, "u") for i in range(n + 1)), "1"


def _precision(source):
    n, t = source.randint(2, 5), source.choice("uv")
    return "+".join(f"{i}/{n}*{_bernstein(n, i, t)}" for i in range(n + 1)), t


def _elevation(source):
    n, i = source.randint(1, 4), 0
    i = source.randint(0, n)
    return (_bernstein(n, i, "u"),
            f"{n + 1 - i}/{n + 1}*({_bernstein(n + 1, i, 'u')})"
            f"+{i + 1}/{n + 1}*({_bernstein(n + 1, i + 1, 'u')})")


def _edge(source):
    """A bilinear patch on a line of its surface."""
    k = source.randint(2, 9)
    s = f"1/{k}"
    return (f"(1-{s})*((1-v)*a+v*b)+{s}*((1-v)*c+v*d)",
            f"(1-v)*({k - 1}/{k}*a+{s}*c)+v*({k - 1}/{k}*b+{s}*d)")


def _hermite(source):
    a = source.randint(1, 9)
    return (f"{a}*(2*u^3-3*u^2+1)+{a}*(3*u^2-2*u^3)+b*(u^3-2*u^2+u)-b*u*(1-u)^2", f"{a}")


def _coons_is_bilinear(_):
    return ("(1-v)*((1-u)*a+u*b)+v*((1-u)*c+u*d)+(1-u)*((1-v)*a+v*c)+u*((1-v)*b+v*d)"
            "-((1-u)*(1-v)*a+u*(1-v)*b+(1-u)*v*c+u*v*d)",
            "a+u*(b-a)+v*(c-a)+u*v*(a-b-c+d)")


KINDS = (_square, _unity, _precision, _elevation, _edge, _hermite, _coons_is_bilinear)


def small_claims(count):
    """Left side, right side, whether they are equal."""
    source = random.Random(2024)
    result = []
    for k in range(count):
        left, right = KINDS[k % len(KINDS)](source)
        wrong = source.random() < 0.3
        result.append((left, right + f"+{source.randint(1, 9)}*u*v*a" if wrong else right,
                       not wrong))
    return result
