"""The nets of W4, and those of W6: plane patches whose Jacobian is nearly zero inside the unit square, so that it has
to be subdivided. The mutant folds there."""

from fractions import Fraction
from math import comb

SCALE = 10000


def coordinate(i, j, k):
    """Coordinate k of the point (i, j) in W4: numerator, denominator. Each peer has this formula."""
    return (7 * i + 13 * j + 5 * k + i * j) % 101 - 50, 1 + (i + 2 * j + 3 * k) % 7


def _powers(n, i):
    """The i-th Bernstein coefficients of 1, t, t^2, t^3 at degree n."""
    return [Fraction(comb(i, k), comb(n, k)) for k in range(4)]


def plane_net(n, mutant):
    """Rows of x and rows of y, whole numbers; det(r_u, r_v) is (u-1/3)^2 + (v-1/2)^2 + small, but for
    a disturbance."""
    least = Fraction(-1, 50) if mutant else Fraction(1, 400)
    x, y, state = [], [], 12345
    for i in range(n + 1):
        u = _powers(n, i)
        x.append([])
        y.append([])
        for j in range(n + 1):
            v = _powers(n, j)
            value = (u[1] / 9 - u[2] / 3 + u[3] / 3
                     + u[1] * (Fraction(1, 4) - v[1] + v[2]) + least * u[1])
            noise = []
            for _ in range(2):
                state = (1103515245 * state + 12345) % 2**31
                noise.append((state >> 16) % 41 - 20)
            x[-1].append(round(SCALE * value) + noise[0])
            y[-1].append(round(SCALE * v[1]) + noise[1])
    return x, y


def write(folder, n):
    """For the peers: as rows of numbers, and as two matrices of PARI."""
    for mutant in (0, 1):
        parts = plane_net(n, mutant)
        stem = f"W6_{n}_{'mutant' if mutant else 'true'}"
        matrices = ["[" + ";".join(",".join(map(str, row)) for row in part) + "]" for part in parts]
        (folder / f"{stem}.gp").write_text("[" + ",".join(matrices) + "]\n")
        rows = [row for part in parts for row in part]
        (folder / f"{stem}.txt").write_text("\n".join(" ".join(map(str, row)) for row in rows) + "\n")
