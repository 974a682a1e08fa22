#include <patchproof/certificate/sympy_helpers.hpp>

namespace patchproof {

// Derivatives of unknown functions are further unknown functions: SymPy's own Derivative would stand
// for one value in more than one way.
std::string_view sympy_helpers() {
  return R"py(
import operator
import sys
from functools import cache, reduce
from itertools import product

from sympy import (QQ, Add, Dummy, Function, Integral, Rational, S, Symbol, binomial, cancel, diff,
                   expand, fraction, integrate, simplify, sqrt, together)
from sympy.polys.fields import field


def tidy(x):
    """An argument of a function, so that equal ones look the same."""
    if x.is_Atom:
        return x
    x = expand(x)
    return x if fraction(together(x))[1].is_number else cancel(x)


@cache
def unknown(name, arity, orders=None):
    """A function of which nothing is known; its partial derivatives are further ones."""
    if orders and not any(orders):
        return unknown(name, arity)
    orders = orders or (0,) * arity

    class Unknown(Function):
        nargs = arity

        @classmethod
        def eval(cls, *places):
            tidied = [tidy(x) for x in places]
            return cls(*tidied) if tidied != list(places) else None

        def fdiff(self, argindex=1):
            more = tuple(k + (i == argindex - 1) for i, k in enumerate(orders))
            return unknown(name, arity, more)(*self.args)

    Unknown.__name__ = name + (str(list(orders)) if any(orders) else "")
    Unknown.origin = (unknown(name, arity) if any(orders) else Unknown, orders)
    return Unknown


def array(name, *sizes, arity=0):
    """Entries V[0, 0], V[0, 1], ...; with an arity, functions."""
    entries = {}
    for place in product(*map(range, sizes)):
        text = name + str(list(place))
        entries[place if len(place) > 1 else place[0]] = (
            unknown(text, arity) if arity else Symbol(text))
    return entries


def bernstein(n, i, t):
    """The Bernstein polynomial B_i^n(t)."""
    return binomial(n, i) * S(t)**i * (1 - S(t))**(n - i)


@cache
def derivative(f, *orders):
    """The function that is f differentiated so often in each of its arguments."""
    names = [Dummy() for _ in orders]
    value = S(f(*names))
    if value.is_polynomial():
        value = expand(value)
    for name, order in zip(names, orders):
        value = diff(value, name, order)
    return lambda *place: at(value, dict(zip(names, place)))


def integral(f, lower, upper):
    """The integral of f, factor by factor: what does not depend on the variable goes outside."""
    t = Dummy("t")
    result = []
    for part in Add.make_args(expand(f(t))):
        outside, inside = part.as_independent(t, as_Add=False)
        other, d = inside.as_independent(Function, as_Add=False)
        base, orders = getattr(d.func, "origin", (None, ()))
        slots = [i for i, x in enumerate(d.args) if x.has(t)] if base else []
        if (len(slots) == 1 and d.args[slots[0]] == t and orders[slots[0]] > 0
                and other.is_polynomial(t)):
            # By parts, until nothing is differentiated in the variable.
            less = unknown(base.__name__, len(orders),
                           tuple(k - (i == slots[0]) for i, k in enumerate(orders)))(*d.args)
            ends = at(other * less, {t: upper}) - at(other * less, {t: lower})
            value = ends - integral(lambda x: at(diff(other, t) * less, {t: x}), lower, upper)
        elif inside.atoms(Function, Integral):
            # The same name for the variable of the same integral.
            bound = Symbol("t_%d" % len(inside.atoms(Integral)))
            value = Integral(inside.xreplace({t: bound}), (bound, S(lower), S(upper)))
        else:
            value = integrate(inside, (t, S(lower), S(upper)))
        result.append(outside * value)
    return Add(*result)


def at(expression, values):
    """The expression with these values for symbols and functions."""
    expression = S(expression)
    if expression in values:
        return S(values[expression])
    if not expression.args:
        return expression
    if isinstance(expression, Integral):
        # SymPy makes one integral over several variables of integrals inside each other.
        inside, *inner, (t, lower, upper) = expression.args
        inside = Integral(inside, *inner) if inner else inside
        new = Dummy("t")
        return integral(lambda x: at(inside.xreplace({t: new}), {**values, new: x}),
                        at(lower, values), at(upper, values))
    places = [at(x, values) for x in expression.args]
    f, orders = getattr(expression.func, "origin", (None, None))
    if f in values:
        return S(derivative(values[f], *orders)(*places))
    return expression.func(*places)


def parts(x):
    """What x is made of by rational operations."""
    if x.is_Rational:
        return set()
    if x.is_Add or x.is_Mul:
        return set().union(*map(parts, x.args))
    if x.is_Pow and x.exp.is_Integer:
        return parts(x.base)
    return {x}


# Differences with integrals that were not worked out: these may be zero all the same.
unsettled = []


def is_zero(x):
    """Whether x is zero as a rational function of its parts."""
    x = S(x)
    names = sorted(parts(x), key=str)
    if not names:
        return x == 0
    numbers = dict(zip(names, field([str(k) for k in range(len(names))], QQ)[1:]))

    def value(y):
        if y.is_Rational:
            return QQ(y.p, y.q)
        if y in numbers:
            return numbers[y]
        if y.is_Pow:
            return value(y.base)**int(y.exp)
        values = list(map(value, y.args))
        return reduce(operator.add if y.is_Add else operator.mul, values)

    if value(x) == 0:
        return True
    if any(y.has(Integral) for y in names):
        unsettled.append(x)
    # Roots are no names for anything: their squares are known.
    return any(y.is_Pow for y in names) and simplify(x) == 0


def is_positive(x):
    return simplify(x).is_positive is True


def is_not_negative(x):
    return is_zero(x) or is_positive(x)


def differs(x):
    return is_positive(x) or is_positive(-x)
)py";
}

}  // namespace patchproof
