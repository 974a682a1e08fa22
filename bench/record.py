"""What is kept of a run: JSON, and the tables of a document."""

import dataclasses
import datetime
import json
import os
import subprocess

from table import exponent, good_times

PACKAGES = ("python3-sympy", "python3-gmpy2", "maxima", "libginac-dev", "singular-ui", "pari-gp",
            "libflint-dev")
BEGIN, END = "<!-- bench: begin -->", "<!-- bench: end -->"


def _output(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
    except FileNotFoundError:
        return ""


def versions(options):
    found = {"patchproof": _output(str(options.build / "bin/patchproof"), "--version")
             .removeprefix("patchproof "),
             "commit": _output("git", "rev-parse", "--short", "HEAD")}
    for package in PACKAGES:
        found[package] = _output("dpkg-query", "--show", "--showformat=${Version}", package)
    return found


def machine():
    model = "unknown"
    with open("/proc/cpuinfo", encoding="utf-8") as lines:
        for line in lines:
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    return {"processor": model, "processors": os.cpu_count(), "system": os.uname().sysname,
            "kernel": os.uname().release}


def heading(options):
    found, computer = versions(options), machine()
    named = ", ".join(f"{name} {version}" for name, version in found.items() if version)
    return (f"{datetime.date.today()}, {computer['processor']} ({computer['processors']} processors); "
            f"medians of processor time of one proof, no start-up; limit {options.limit:g} s"
            f"{'; quick' if options.quick else ''}.\n{named}.")


def write_json(everything, options):
    workloads = {}
    for key, rows in everything.items():
        ours = rows.get("patchproof", {})
        workloads[key] = {}
        for name, row in rows.items():
            sizes = {}
            for n, result in row.items():
                sizes[n] = dataclasses.asdict(result)
                if n in ours and result.status == ours[n].status == "ok":
                    sizes[n]["ratio"] = result.true_ns / ours[n].true_ns
            workloads[key][name] = {"sizes": sizes, "exponent": exponent(good_times(row))}
    report = {"date": datetime.datetime.now().astimezone().isoformat(timespec="seconds"),
              "machine": machine(), "versions": versions(options), "quick": options.quick,
              "limit_s": options.limit, "workloads": workloads}
    path = options.output / "bench.json"
    path.write_text(json.dumps(report, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def write_docs(path, text):
    document = path.read_text(encoding="utf-8")
    before, rest = document.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    path.write_text(before + BEGIN + "\n" + text + END + after, encoding="utf-8")
