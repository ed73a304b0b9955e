#!/usr/bin/env python3
"""additions.py TUBEPLAN BENCH-CELL BOWL-CELL SETS-FOLDER: compares errors of added models with promised ones.

For each set (measurements.csv, truth.json with a design) whose diagnosis names a cause, the output has three
held-out errors: as promised by the diagnosis, of the cell after `add` and `identify`, and of the model that the
served page adds. A set is right if the second and third error are within 5 % of the first.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from workbench_client import Workbench

WITHIN = 0.05


def figures(program, words, folder):
    done = subprocess.run([program] + words + ["--json", "-"], cwd=folder, capture_output=True, text=True)
    return json.loads(done.stdout)


def by_command(program, cell, readings, causes, folder):
    subprocess.run([program, "add", cell] + causes + ["--out", "added.yaml"], cwd=folder, check=True, capture_output=True)
    return figures(program, ["identify", "added.yaml", readings], folder)["rms"]["heldout_after"]


def by_page(program, cell, readings, causes, folder):
    bench = Workbench(program, [cell, readings], folder)
    try:
        refused = bench.job("add", {"causes": causes})
        if refused:
            raise SystemExit(f"{readings}: {refused}")
        return json.loads(bench.result("identify"))["rms"]["heldout_after"]
    finally:
        bench.end()


def main():
    program, bench, bowl, sets = (str(pathlib.Path(word).resolve()) for word in sys.argv[1:])
    wrong = judged = 0
    print(f"{'set':34s} {'promised':>10s} {'command':>10s} {'page':>10s}")
    for truth in sorted(pathlib.Path(sets).glob("*/truth.json")):
        cell, readings = bowl if json.loads(truth.read_text())["design"] == "bowl" else bench, str(truth.parent / "measurements.csv")
        with tempfile.TemporaryDirectory() as folder:
            found = figures(program, ["diagnose", cell, readings], folder)
            causes = [cause["add"] for cause in found["alternatives"][0]] if found["alternatives"] else []
            if not causes:
                continue
            promised = found["rms"]["heldout_after"]
            got = [way(program, cell, readings, causes, folder) for way in (by_command, by_page)]
            is_right = all(abs(value - promised) <= WITHIN * promised for value in got)
            judged, wrong = judged + 1, wrong + (not is_right)
            print(f"{truth.parent.name:34s} {promised:10.6f} {got[0]:10.6f} {got[1]:10.6f}{'' if is_right else '  not as promised'}", flush=True)
    print(f"{judged - wrong} of {judged} as promised")
    sys.exit(bool(wrong) or not judged)


if __name__ == "__main__":
    main()
