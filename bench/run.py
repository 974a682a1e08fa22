#!/usr/bin/env python3
"""run.py: times the workloads, prints a table, writes JSON. `make bench` calls it.

Ends with 1 when a verdict is wrong, of patchproof or of a peer."""

import argparse
import pathlib
import sys

import record
from processes import PROGRAMS, run_processes, run_program
from runners import OURS, run_ours, run_peer
from table import workload_tables
from targets import target_table
from workloads import WORKLOADS


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/bench"))
    parser.add_argument("--quick", action="store_true", help="smaller sizes, fewer repeats")
    parser.add_argument("--only", nargs="+", default=[], help="some workloads: W1 W3")
    parser.add_argument("--peers", nargs="+", default=None, help="some peers: PARI 'SymPy ring'")
    parser.add_argument("--limit", type=float, help="seconds for one proof; usual: 60, quick: 20")
    parser.add_argument("--write-docs", metavar="FILE", type=pathlib.Path,
                        help="put the tables between the markers of this document")
    options = parser.parse_args()
    options.limit = options.limit or (20 if options.quick else 60)
    options.seconds = 0.1 if options.quick else 0.5
    options.programs = options.build / "bench"
    options.folder = options.output / "claims"
    options.folder.mkdir(parents=True, exist_ok=True)
    return options


def measured(key, workload, sizes, options):
    """Name -> size -> result. Who is too slow or fails at one size does not try larger ones."""
    results = {}
    if key == "W7":
        for n in sizes:
            print(f"{key} {n} claims …", file=sys.stderr, flush=True)
            for name, result in run_processes(n, options).items():
                results.setdefault(name, {})[n] = result
        return results
    for name in (OURS,) + workload.peers:
        if name != OURS and options.peers is not None and name not in options.peers:
            continue
        row = results[name] = {}
        for n in sizes:
            print(f"{key} {name} {workload.size} = {n} …", file=sys.stderr, flush=True)
            if name == OURS:
                row[n] = run_ours(key, n, options)
            elif name in PROGRAMS:
                row[n] = run_program(name, n, options)
            else:
                row[n] = run_peer(name, key, n, options)
            if row[n].note:
                print(f"  {row[n].status}: {row[n].note}", file=sys.stderr, flush=True)
            if row[n].status in ("slow", "failed"):
                break
    return results


def main():
    options = arguments()
    everything, tables = {}, []
    for key, workload in WORKLOADS.items():
        if options.only and key not in options.only:
            continue
        sizes = workload.quick if options.quick else workload.sizes
        everything[key] = measured(key, workload, sizes, options)
        tables.append(f"**{key}**: {workload.title}\n\n"
                      + workload_tables(key, workload, sizes, everything[key], options.limit))
    text = record.heading(options) + "\n\n" + "\n\n".join(tables)
    text += "\n\n**Targets**\n\n" + target_table(everything) + "\n"
    print(text)
    record.write_json(everything, options)
    if options.write_docs:
        record.write_docs(options.write_docs, text)
    bad = [f"{key} {name} {n}: {result.status} {result.note}" for key, rows in everything.items()
           for name, row in rows.items() for n, result in row.items()
           if result.status in ("wrong", "failed")]
    for line in bad:
        print(line, file=sys.stderr)
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
