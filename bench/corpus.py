#!/usr/bin/env python3
"""corpus.py CLAIMS FOLDER: writes case files with so many small claims, true and false, always the same.

Each case has ten claims about one patch; each file has a hundred cases."""

import pathlib
import random
import sys

CLAIMS_OF_CASE = 10
CASES_OF_FILE = 100


def case(number, source):
    a, b, c = (source.randint(1, 9) for _ in range(3))
    n = source.randint(1, 3)
    claims = [
        "prove  south: r(u,0) == b(u,0)",
        "prove  north: r(u,1) == b(u,1)",
        "prove  west: r(0,v) == b(0,v)",
        "refute flat: r(u,v) == b(u,0)",
        f"prove  square: ({a}*x + {b}*y)^2 == {a * a}*x^2 + {2 * a * b}*x*y + {b * b}*y^2",
        f"refute middle: ({a}*x + {b}*y)^2 == {a * a}*x^2 + {2 * a * b + 1}*x*y + {b * b}*y^2",
        f"prove  corner: {c}*r_u(0,0) == {c * n}*(V[1,0] - V[0,0])",
        "prove  pde: r_uuvv(u,v) == 0*V[0,0]",
        "prove  half: 2*b(1/2,0) - b(1/2,0) == b(1/2,0)",
        f"refute sign: r(u,0) == b(u,0) + {c}*(V[0,0] - V[{n},0])",
    ]
    lines = [f"case corpus.c{number}", "  param u, v in [0, 1]", "  scalar x, y",
             f"  point V[0..{n}, 0..{n}]", "  patch b(u,v) = bezier(V)",
             "  patch r(u,v) = coons(b(u,0), b(u,1), b(0,v), b(1,v))"]
    return "\n".join(lines + ["  " + claim for claim in claims] + ["end", ""])


def main():
    claims, folder = int(sys.argv[1]), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    source = random.Random(2024)
    cases = claims // CLAIMS_OF_CASE
    for first in range(0, cases, CASES_OF_FILE):
        numbers = range(first, min(first + CASES_OF_FILE, cases))
        text = "\n".join(case(number, source) for number in numbers)
        (folder / f"{first:07}.proof").write_text(text)


main()
