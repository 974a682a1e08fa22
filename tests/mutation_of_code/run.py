#!/usr/bin/env python3
"""Runs the tests against faults in the library, one at a time.

run.py [--portion 2/5] [--first N] from the top folder. The faults are those of mutants.txt; they are
put into a copy of the last commit in build/mutants, never into the sources. The tests are those of
build/release, which has to be built; they are only linked again. Results are added to
build/mutants/results.txt, and what stands there is not run again:

    killed by …, survived, does not compile, or gone (the line is no longer there)
"""

import argparse
import pathlib
import random
import resource
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).parent
FOLDER = pathlib.Path("build/mutants")
TREE = FOLDER / "tree"
BUILD = TREE / "build/release"
TESTED = pathlib.Path("build/release")
RESULTS = FOLDER / "results.txt"
# Seconds of a processor for one command: a fault may well make a loop endless.
LONGEST = 60

# What is run first for a fault in a folder; then what comes below it, then the cases.
NEXT = {"algebra": ["algebra", "kernel", "claims", "decide"], "kernel": ["kernel", "claims", "decide"],
        "symbolic": ["symbolic", "claims", "decide"], "decide": ["claims", "decide"],
        "claims": ["claims", "report", "decide"],
        "language": ["language", "claims", "decide", "repair", "mutation"],
        "grid": ["grid", "decide"], "prelude": []}


def run(*command, **more):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", check=False, **more)


def fails(*command):
    """Whether a command fails; what takes too long fails too."""
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))
    return run(*command, preexec_fn=limit).returncode != 0


def committed(file):
    return subprocess.run(["git", "show", f"HEAD:{file.relative_to(TREE)}"], check=True,
                          capture_output=True).stdout


def prepare():
    if not TREE.exists():
        TREE.mkdir(parents=True)
        subprocess.run(f"git archive HEAD | tar -x -C {TREE}", shell=True, check=True)
        subprocess.run(["cmake", "--preset", "release", "-DBUILD_TESTING=OFF"], cwd=TREE, check=True,
                       stdout=subprocess.DEVNULL)
    # What a run that was ended left behind.
    for file in (TREE / "lib").rglob("*"):
        if file.is_file() and file.read_bytes() != (kept := committed(file)):
            file.write_bytes(kept)
    if not build():
        sys.exit("the library without faults does not compile")


def build():
    if run("cmake", "--build", str(BUILD), "-j1", "--target", "patchproof_program").returncode != 0:
        return False
    link = run("ninja", "-C", str(TESTED), "-t", "commands", "tests/unit_tests").stdout.splitlines()
    here = BUILD.absolute()
    command = link[-1].replace("libpatchproof.a", f"{here}/libpatchproof.a")
    command = command.replace("-o tests/unit_tests", f"-o {here}/unit_tests")
    return run("sh", "-c", command, cwd=TESTED).returncode == 0


def tests_of(folder):
    files = sorted((TREE / "tests" / folder).glob("*_test.cpp"))
    return ",".join(f"[#{folder}/{file.name.removesuffix('_test.cpp')}]" for file in files)


def size(cases):
    return sum(file.stat().st_size for file in cases.rglob("*.proof"))


def verdict(folder):
    if not build():
        return "does not compile"
    tests = str(BUILD / "unit_tests")
    for tested in NEXT[folder]:
        if fails(tests, "--abort", tests_of(tested)):
            return f"killed by tests/{tested}"
    if fails("env", "PATCHPROOF_CLAIMS=150", tests, "--abort", "[#differential/differential]"):
        return "killed by tests/differential"
    engines = "both" if folder == "symbolic" else "kernel"
    for cases in sorted((path for path in (TREE / "cases").iterdir() if path.is_dir()), key=size):
        if fails(str(BUILD / "bin/patchproof"), "check", "--quiet", "--engines", engines,
                 str(cases)):
            return f"killed by cases/{cases.name}"
    return "survived"


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--portion", default="1/1")
    options.add_argument("--first", type=int, default=10**6)
    given = options.parse_args()
    part, parts = (int(number) for number in given.portion.split("/"))
    table = [line.split("\t") for line in (HERE / "mutants.txt").read_text().splitlines()]
    prepare()
    done = set()
    if RESULTS.exists():
        done = {tuple(line.split("\t")[2:]) for line in RESULTS.read_text().splitlines()}
    left = [mutant for i, mutant in enumerate(table)
            if i % parts == part - 1 and tuple(mutant) not in done]
    # All folders by turns, so that a run that is ended early says something about each.
    random.Random(1).shuffle(left)
    for path, code, instead in left[:given.first]:
        file = TREE / path
        text = file.read_text(encoding="utf-8")
        lines = text.split("\n")
        places = [i for i, line in enumerate(lines) if line.split("  //")[0].strip() == code]
        start = time.monotonic()
        if len(places) != 1:
            found = "gone"
        else:
            lines[places[0]] = lines[places[0]].replace(code, instead)
            file.write_text("\n".join(lines), encoding="utf-8")
            try:
                found = verdict(pathlib.Path(path).parent.name)
            finally:
                file.write_text(text, encoding="utf-8")
        seconds = round(time.monotonic() - start)
        with RESULTS.open("a", encoding="utf-8") as results:
            results.write("\t".join([found, f"{seconds} s", path, code, instead]) + "\n")


main()
