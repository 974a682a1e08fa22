"""W4 with SymPy's rational numbers: as flint_net.c does it."""

from functools import lru_cache

from sympy import QQ

from measure import measure


@lru_cache
def given(n):
    """Three nets of numbers. They are given, so they are no part of the proof."""
    return [[[QQ((7 * i + 13 * j + 5 * k + i * j) % 101 - 50, 1 + (i + 2 * j + 3 * k) % 7)
              for j in range(n)] for i in range(n)] for k in range(3)]


def to_bezier(d, mutant):
    """The Bézier points of a clamped uniform cubic. The mutant has one wrong factor."""
    last = len(d) - 3
    b = [d[0]] * (3 * last) + [d[-1]]
    for k in range(last):
        begin, end = max(k - 1, 0), min(k + 2, last)
        change = d[k + 2] - d[k + 1]
        for side in (1, 2):
            factor = QQ(k + side - 1 - begin, end - begin)
            if mutant and k == 1 and side == 1:
                factor = QQ(1, 5)
            b[3 * k + side] = d[k + 1] + factor * change
    for k in range(1, last):
        b[3 * k] = (b[3 * k - 1] + b[3 * k + 1]) * QQ(1, 2)
    return b


def smooth(b):
    for k in range(3, len(b) - 1, 3):
        left, right = b[k] - b[k - 1], b[k + 1] - b[k]
        if left != right or left - b[k - 1] + b[k - 2] != b[k + 2] - b[k + 1] - right:
            return False
    return True


def w4(n, mutant):
    for net in given(n):
        in_u = zip(*(to_bezier(column, mutant) for column in zip(*net)))
        points = [to_bezier(row, False) for row in in_u]
        if not all(smooth(row) for row in points):
            return False
        if not all(smooth(column) for column in zip(*points)):
            return False
    return True


measure({"W4": w4})
