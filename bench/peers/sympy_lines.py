"""Reads expressions, one a line; says for each whether it is zero. The argument: expand or ring."""

import sys

from sympy import QQ, expand, ring, sympify

answers = []
if sys.argv[1] == "ring":
    # Python reads the expression, the ring computes; a quotient of integers has to be exact.
    R, *generators = ring("u,v,a,b,c,d", QQ)
    names = dict(zip("uvabcd", generators))
    for line in sys.stdin:
        text = line.strip().replace("^", "**").replace("/", "*one/")
        answers.append(eval(text, {"one": QQ(1), **names}) == 0)
else:
    for line in sys.stdin:
        answers.append(expand(sympify(line.strip().replace("^", "**"))) == 0)
print("".join("1" if answer else "0" for answer in answers))
