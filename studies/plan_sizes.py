#!/usr/bin/env python3
"""Measures the cost of plans as a function of size: time, memory and optimality gap of `tubeplan plan` and `verify` for
work lists and sheets of 500 to 15,529 holes, with the slopes of log-log fits.

    python3 studies/plan_sizes.py build/tubeplan [--quick]
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

CELLS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "app", "cells")
RUNS = [
    ("mockup.yaml", "spread:500"), ("mockup.yaml", "spread:1000"), ("mockup.yaml", "spread:2000"),
    ("mockup.yaml", "all"), ("sheets/model-f.yaml", "all"), ("sheets/ce-3410.yaml", "all"),
    ("sheets/once-through.yaml", "all"),
]


def run(command):
    """Runs a command and returns wall time [s], CPU time [s] and exit code."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    out, err = child.communicate()
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if child.returncode not in (0, 1):
        sys.exit(err)
    return wall, cpu, child.returncode


def peak(folder, program, cell, tubes):
    """Returns the peak memory [MB] of the planning command, measured in a separate process."""
    code = ("import resource,subprocess,sys;c=subprocess.run(sys.argv[1:],stdout=subprocess.DEVNULL,"
            "stderr=subprocess.DEVNULL);print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss/1024)")
    finished = subprocess.run([sys.executable, "-c", code, program, "plan", cell, "--tubes", tubes, "--out", folder],
                              stdout=subprocess.PIPE, text=True, check=True)
    return float(finished.stdout)


def slope(points):
    """Returns the least-squares slope of log y against log x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mx = sum(x for x, _ in logs) / len(logs)
    my = sum(y for _, y in logs) / len(logs)
    return sum((x - mx) * (y - my) for x, y in logs) / sum((x - mx) ** 2 for x, _ in logs)


def main():
    program = os.path.abspath(sys.argv[1])
    runs = RUNS[:3] if "--quick" in sys.argv else RUNS
    rows = []
    print(f"{'cell':<20}{'holes':>7}{'visited':>9}{'wall s':>8}{'CPU s':>8}{'MB':>6}{'gap %':>7}"
          f"{'saved %':>9}{'verify s':>9}  proved")
    for cell, tubes in runs:
        path = os.path.join(CELLS, cell)
        with tempfile.TemporaryDirectory() as folder:
            wall, cpu, code = run([program, "plan", path, "--tubes", tubes, "--out", folder])
            if code:
                sys.exit(f"{cell}: no plan")
            with open(os.path.join(folder, "plan.json"), encoding="utf-8") as file:
                plan = json.load(file)
            verify_wall, _, refuted = run([program, "verify", path, folder])
            visited, holes = len(plan["tubes"]), len(plan["tubes"]) + len(plan["unreachable"])
            memory = peak(os.path.join(folder, "again"), program, path, tubes)
            rows.append((holes, visited, wall, cpu, memory))
            print(f"{cell.split('/')[-1]:<20}{holes:>7}{visited:>9}{wall:>8.1f}{cpu:>8.1f}{memory:>6.0f}"
                  f"{100 * plan['gap']:>7.2f}{100 * (1 - plan['travel_time_s'] / plan['row_by_row_time_s']):>9.1f}"
                  f"{verify_wall:>9.1f}  {'no' if refuted else 'yes'}", flush=True)
    print(f"slope of CPU time over tubes visited {slope([(r[1], r[3]) for r in rows]):.2f}, "
          f"of memory {slope([(r[1], r[4]) for r in rows]):.2f}")


if __name__ == "__main__":
    main()
