"""Says of each claim of a file whether its two sides are equal, by SymPy.

opinion.py ASKED.json writes a list of true, false or null (nothing asked) to standard output.
ASKED.json is a list of {"statements": [...], "left": "...", "right": "..."}; the statements are
those of this little language: the constructions of the textbook, written down once more.
"""

import json
import sys

from sympy import Integer, Poly, Rational, Symbol, expand
from sympy import binomial as number_of_choices
from sympy import diff as sympy_diff
from sympy.polys.domains import QQ
from sympy.polys.fields import field
from sympy.polys.rings import ring


class Matrix:
    """Rows of entries. A point of R^3 is a column."""

    def __init__(self, rows):
        self.rows = [list(row) for row in rows]

    def __getitem__(self, index):
        i, j = index if isinstance(index, tuple) else (index, 0)
        return self.rows[int(i)][int(j)]

    def map(self, change):
        return Matrix([[change(x) for x in row] for row in self.rows])

    def __add__(self, other):
        if not isinstance(other, Matrix):
            assert other == 0
            return self
        return Matrix([[a + b for a, b in zip(x, y)] for x, y in zip(self.rows, other.rows)])

    __radd__ = __add__

    def __neg__(self):
        return self.map(lambda x: -x)

    def __sub__(self, other):
        return self + (-other)

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if not isinstance(other, Matrix):
            return self.map(lambda x: x * other)
        columns = list(zip(*other.rows))
        return Matrix([[sum(a * b for a, b in zip(row, column)) for column in columns]
                       for row in self.rows])

    def __rmul__(self, other):
        return self.map(lambda x: other * x)

    def __truediv__(self, other):
        return self.map(lambda x: x / other)

    x = property(lambda self: self[0])
    y = property(lambda self: self[1])
    z = property(lambda self: self[2])


class Function:
    """A function by its expression in formal parameters."""

    def __init__(self, body, arity):
        self.body, self.arity = body, arity

    def __call__(self, *arguments):
        assert len(arguments) == self.arity
        return self.body.subs(dict(zip(FORMALS, arguments)), simultaneous=True) \
            if hasattr(self.body, "subs") else self.body


FORMALS = (Symbol("first formal"), Symbol("second formal"))
S, T = FORMALS
M = Matrix


def net(name, rows, columns):
    return Matrix([[Symbol(f"{name}[{i},{j}]") for j in range(columns)] for i in range(rows)])


def in_space(name):
    return Matrix([[Symbol(f"{name}.{c}")] for c in "xyz"])


def unknown(name, arity):
    """A polynomial of a degree that is large enough to be like any function."""
    if arity == 1:
        return Function(sum(Symbol(f"{name}#{i}") * S**i for i in range(8)), 1)
    return Function(sum(Symbol(f"{name}#{i},{j}") * S**i * T**j
                        for i in range(5) for j in range(5)), 2)


def defined(names, body):
    if isinstance(body, Function):
        return body
    return Function(expand(body).subs(dict(zip((Symbol(n) for n in names), FORMALS)),
                                      simultaneous=True), len(names))


def partial(function, variables):
    body = function.body
    for variable in variables:
        body = sympy_diff(body, T if function.arity == 2 and variable == "v" else S)
    return Function(body, function.arity)


def diff(body, variable):
    return body.map(lambda x: sympy_diff(x, variable)) if isinstance(body, Matrix) \
        else sympy_diff(body, variable)


def integral(body, variable, low, high):
    """Of a polynomial, power by power."""
    terms = Poly(expand(body), variable).terms()
    return sum(c * (high**(k + 1) - low**(k + 1)) / (k + 1) for (k,), c in terms)


def binomial(n, k):
    return number_of_choices(int(n), int(k))


def bernstein(n, i, t):
    return binomial(n, i) * t**int(i) * (1 - t)**int(n - i)


def bezier(points):
    m, n = len(points.rows) - 1, len(points.rows[0]) - 1
    if n == 0:
        return Function(sum(bernstein(m, i, S) * points[i] for i in range(m + 1)), 1)
    return Function(sum(bernstein(m, i, S) * bernstein(n, j, T) * points[i, j]
                        for i in range(m + 1) for j in range(n + 1)), 2)


def transpose(a):
    return Matrix(zip(*a.rows))


def of_columns(points, change):
    return transpose(Matrix([change(list(column)) for column in zip(*points.rows)]))


def coefficients(body, degree):
    """Bernstein coefficients of a polynomial in S: of the powers, b_i = sum C(i,k)/C(n,k) a_k."""
    powers = [expand(body).coeff(S, k) for k in range(degree + 1)]
    return [sum(Rational(binomial(i, k), binomial(degree, k)) * powers[k] for k in range(i + 1))
            for i in range(degree + 1)]


def elevated(points, more):
    return of_columns(points, lambda b: coefficients(bezier(Matrix([[x] for x in b])).body,
                                                     len(b) - 1 + int(more)))


def elevated_net(points, more, more_columns):
    return transpose(elevated(transpose(elevated(points, more)), more_columns))


def restricted_points(points, a, c):
    return of_columns(points, lambda b: coefficients(
        bezier(Matrix([[x] for x in b]))((1 - S) * a + S * c), len(b) - 1))


def restricted_net(points, a, c, low, high):
    return transpose(restricted_points(transpose(restricted_points(points, a, c)), low, high))


def bilinear(p, q, r, s):
    return Function((1 - S) * (1 - T) * p + S * (1 - T) * q + (1 - S) * T * r + S * T * s, 2)


def ruled(c, d):
    return Function(c(S) + T * (d(S) - c(S)), 2)


def ruled_in_u(c, d):
    return Function(c(T) + S * (d(T) - c(T)), 2)


def ruled_over(c, d, a, b):
    return Function(((b - T) * c(S) + (T - a) * d(S)) / (b - a), 2)


def translation_surface(c, d):
    return Function(c(S) + d(T), 2)


def curve(given, name):
    """A function, or an expression in one parameter."""
    return given if isinstance(given, Function) else defined((name,), given)


def coons(south, north, west, east):
    south, north = curve(south, "u"), curve(north, "u")
    west, east = curve(west, "v"), curve(east, "v")
    corners = bilinear(south(Integer(0)), south(Integer(1)), north(Integer(0)), north(Integer(1)))
    return Function(ruled(south, north).body + ruled_in_u(west, east).body - corners.body, 2)


def partially_bicubic_coons(*boundary):
    """Where the boundary is written in blended parameters, this is the Coons patch of it."""
    c1, c2, d1, d2 = boundary
    f, g = 3 * S**2 - 2 * S**3, 3 * T**2 - 2 * T**3
    corners = bilinear(c1(Integer(0)), c1(Integer(1)), c2(Integer(0)), c2(Integer(1)))
    return Function((1 - g) * c1(S) + g * c2(S) + (1 - f) * d1(T) + f * d2(T) - corners(f, g), 2)


def discrete_coons(b):
    """The Bézier net of the Coons patch of the boundary: its coefficients, one direction first."""
    m, n = len(b.rows) - 1, len(b.rows[0]) - 1
    body = bezier(b).body
    patch = coons(body.subs(T, 0).subs(S, Symbol("u")), body.subs(T, 1).subs(S, Symbol("u")),
                  body.subs(S, 0).subs(T, Symbol("v")), body.subs(S, 1).subs(T, Symbol("v"))).body
    in_u = coefficients(patch, m)
    return Matrix([coefficients(x.subs(T, S), n) for x in in_u])


def bspline(points, degree, knots):
    """The pieces of a B-spline curve, by the recursion of Cox and de Boor."""
    def basis(i, p, span, x):
        if p == 0:
            return Integer(1 if i == span else 0)
        total = Integer(0)
        for j, sign in ((i, 1), (i + 1, -1)):
            length = knots[j + p] - knots[j]
            if length != 0:
                start = x - knots[j] if sign == 1 else knots[j + p] - x
                total += start / length * basis(j, p - 1, span, x)
        return total

    pieces = []
    for span in range(degree, len(knots) - degree - 1):
        if knots[span] == knots[span + 1]:
            continue
        x = knots[span] + S * (knots[span + 1] - knots[span])
        pieces.append((knots[span], knots[span + 1], expand(
            sum(points[i] * basis(i, degree, span, x) for i in range(len(points.rows))))))
    return pieces


def insert_knot(pieces, knot):
    cut = []
    for low, high, body in pieces:
        if low < knot < high:
            s = (knot - low) / (high - low)
            cut += [(low, knot, body.subs(S, s * S)), (knot, high, body.subs(S, s + (1 - s) * S))]
        else:
            cut.append((low, high, body))
    return cut


def elevate_degree(pieces):
    return pieces


def segment(pieces, k):
    return Function(pieces[int(k)][2], 1)


def cubic(p, q, m, n, t):
    """Solved for: p and q at 0 and 1, slopes m and n."""
    return p + m * t + (3 * (q - p) - 2 * m - n) * t**2 + (2 * (p - q) + m + n) * t**3


def hermite_curve(p, q, m, n):
    return Function(cubic(p, q, m, n, S), 1)


def hermite_loft(c, d, m, n):
    return Function(cubic(c(S), d(S), m(S), n(S), T), 2)


def bicubic_hermite(g):
    return Function(cubic(*(cubic(*row, T) for row in g.rows), S), 2)


def ferguson(p, a, b):
    rows = [[p[i, 0], p[i, 1], b[i, 0], b[i, 1]] for i in range(2)]
    rows += [[a[i, 0], a[i, 1], Integer(0), Integer(0)] for i in range(2)]
    return bicubic_hermite(Matrix(rows))


def dot(a, b):
    return sum(x * y for (x,), (y,) in zip(a.rows, b.rows))


def cross(a, b):
    return Matrix([[a.y * b.z - a.z * b.y], [a.z * b.x - a.x * b.z], [a.x * b.y - a.y * b.x]])


def det(*rows):
    a = rows[0].rows if len(rows) == 1 else [[x for (x,) in row.rows] for row in rows]
    if len(a) == 1:
        return a[0][0]
    return sum((-1)**k * a[0][k] * det(Matrix([row[:k] + row[k + 1:] for row in a[1:]]))
               for k in range(len(a)))


def vanishes(x):
    symbols = sorted(getattr(x, "free_symbols", ()), key=str)
    if not symbols:
        return x == 0
    known = ring if x.is_polynomial(*symbols) else field
    return known(symbols, QQ)[0].from_expr(x) == 0


WORDS = dict(globals())


def opinion(asked):
    if not asked["left"]:
        return None
    words = dict(WORDS)
    words["range"] = lambda low, high: [Integer(k) for k in range(int(low), int(high))]
    for statement in asked["statements"]:
        exec(statement, words)
    left, right = eval(asked["left"], words), eval(asked["right"], words)
    difference = left - right
    entries = sum(difference.rows, []) if isinstance(difference, Matrix) else [difference]
    return all(vanishes(entry) for entry in entries)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        asked = json.load(file)
    answers = []
    for one in asked:
        try:
            answers.append(opinion(one))
        except Exception:
            print("in", one, file=sys.stderr)
            raise
    json.dump(answers, sys.stdout)


main()
