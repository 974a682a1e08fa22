#!/usr/bin/env python3
"""Proposes mutants of the library: small faults such as a sign, a comparison, an index.

propose.py > mutants.txt, from the top folder. The same seed and sources give the same table; it is
kept in the repository, because the sources change. A line of it is

    path <tab> the line of code, once in its file <tab> what it becomes
"""

import collections
import pathlib
import random
import re

SEED = 2026
LIBRARY = pathlib.Path("lib/patchproof")
# How many from each folder.
WANTED = {"prelude": 24, "algebra": 26, "kernel": 26, "symbolic": 16, "decide": 14, "claims": 6,
          "language": 16}

CODE = [(r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" / ", " * "), (r" < ", " <= "),
        (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
        (r" && ", " || "), (r" \|\| ", " && "), (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
        (r" \+ 1\b", ""), (r" - 1\b", ""), (r"\breturn -", "return "), (r"\(!", "("),
        (r" \+= ", " -= "), (r" -= ", " += "), (r"^(\s*)if \(.*\) (return|continue).*;$", r"\1;")]
DEFINITION = [(r"\+", "-"), (r"-", "+"), (r"\b3\b", "2"), (r"\b2\b", "3"), (r"\b1\b", "2"),
              (r"\bC1\b", "C2"), (r"\bD2\b", "D1"), (r"\bu\b", "v"), (r"\bv\b", "u"),
              (r"\b0\b", "1"), (r"H33", "H03"), (r"H13", "H23"), (r"\bi\b", "j"), (r"\bm\b", "n")]


def is_code(line, definition):
    text = line.strip()
    if definition:
        return text and not re.match(r"(define|title|source|#|end)\b|#", text)
    return text and not re.match(r"(//|#|using|template|namespace|case |throw)", text) \
        and "\"" not in text and "operator" not in text


def candidates(path):
    definition = path.suffix == ".proof"
    lines = path.read_text(encoding="utf-8").split("\n")
    often = collections.Counter(line.strip() for line in lines)
    for line in lines:
        if not is_code(line, definition) or often[line.strip()] > 1 or "\t" in line:
            continue
        code = line.split("  //")[0]
        for pattern, instead in DEFINITION if definition else CODE:
            for found in re.finditer(pattern, code):
                changed = code[:found.start()] + found.expand(instead) + code[found.end():]
                yield str(path), code.strip(), changed.strip() or ";"


def main():
    chosen = random.Random(SEED)
    for folder, count in WANTED.items():
        ending = "*.proof" if folder == "prelude" else "*.cpp"
        found = {}
        for path in sorted((LIBRARY / folder).glob(ending)):
            found[path] = sorted(set(candidates(path)))
        # Each file about as often as any other, so that long ones do not get all.
        names = sorted(name for name in found if found[name])
        for name in chosen.sample(names * (1 + count // len(names)), count):
            mutant = chosen.choice(found[name])
            found[name].remove(mutant)
            print("\t".join(mutant))


main()
