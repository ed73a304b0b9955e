#!/usr/bin/env python3
"""wrong_readings.py TUBEPLAN CELLS-FOLDER [--runs 5000] [--seed 1] [--jobs 1] [--command NAME] [--pairs]: gives plausible wrong readings to the commands.

Readings are simulated, then altered by typical human mistakes: wrong units, signs, orders or zeros, shifted or lost
rows, wrong digits, or few readings of a single posture. Each altered file is given to one command. No run may crash,
hang, end with an undocumented exit code, refuse its input without a message, or print NaN or infinity. No verdict may
contradict the results in the same document, and none may be "adequate" if the error exceeds any plausible noise.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

from workbench_client import Workbench, WorkbenchLost

CELLS = [("bench.yaml", "bench"), ("bowl.yaml", "bowl"), ("bowl.yaml", "bench"), ("bowl.yaml", "touch")]
EFFECTS = ["", "backlash@tool.z", "joint-offset@theta3", "tool-weight@tool", "hysteresis@theta2"]
SIZES = [2, 3, 4, 6, 9, 12, 18, 24]
COMMANDS = ["compare", "identify", "diagnose", "improve", "ladder", "touches", "sensitivity", "serve"]
JOBS = ["compare", "diagnose", "identify", "ladder", "improve", "add", "touches"]  # jobs of a served workbench
ASSUMPTIONS = ["coordinates=mm", "angles=rad", "mirror=y", "joint-sign=theta3", "joint-zero=theta4:90", "joint-order=theta3:theta4",
               "shift=1", "loads=N", "sigma=mil", "base=unknown", "axes=yxz", "as-is", "coordinates=parsec", "nonsense=1", "shift="]
NO_NUMBER = re.compile(r"(?<![A-Za-z])-?(nan|inf)(?![A-Za-z])", re.IGNORECASE)
SECONDS = 240
MOST_NOISE_RATIO = 3  # largest ratio of the scatter of repeats to the stated noise at which "adequate" is acceptable
SLACK = 1.3  # factor for the random error of an rms of few readings


class Table:
    def __init__(self, text):
        rows = list(csv.reader(text.splitlines()))
        self.head, self.rows = rows[0], rows[1:]

    def columns(self, *starts):
        return [k for k, name in enumerate(self.head) if name.startswith(starts)]

    def change(self, columns, change, rows=None):
        for row in self.rows if rows is None else rows:
            for column in columns:
                if row[column]:
                    row[column] = repr(change(float(row[column])))

    def joints(self):
        return [k for k in self.columns("theta") if not self.head[k].endswith("_dir")]

    def places(self):
        return self.columns("x_", "y_", "z_")

    def text(self):
        return "\n".join(",".join(row) for row in [self.head] + self.rows) + "\n"


def scaled(of, factors):
    def spoil(table, rng):
        factor = rng.choice(factors)
        table.change(of(table), lambda value: value * factor)
    return spoil


def exchanged_axes(table, rng):
    a, b = rng.sample(table.places(), 2)
    for row in table.rows:
        row[a], row[b] = row[b], row[a]


def mirrored(table, rng):
    table.change([rng.choice(table.places())], lambda value: -value)


def joint_sign(table, rng):
    table.change([rng.choice(table.joints())], lambda value: -value)


def joint_zero(table, rng):
    by = rng.choice([-90, 90, 180, 1, 3, 10, 30, -40])
    table.change([rng.choice(table.joints())], lambda value: value + by)


def joint_order(table, rng):
    a, b = rng.sample(table.joints(), 2)
    for row in table.rows:
        row[a], row[b] = row[b], row[a]


def shifted_rows(table, rng):
    places, by = table.places() + table.columns("point"), rng.choice([-1, 1])
    told = [[row[k] for k in places] for row in table.rows]
    for n, row in enumerate(table.rows):
        for k, value in zip(places, told[(n + by) % len(told)]):
            row[k] = value


def single_digit(table, rng):
    table.change([rng.choice(table.joints() + table.places())], lambda value: value * rng.choice([10, 0.1, -1, 0]), [rng.choice(table.rows)])


def one_posture(table, rng):
    for row in table.rows:
        for k in table.joints():
            row[k] = table.rows[0][k]


def rows_twice(table, rng):
    for row in list(table.rows)[:rng.randint(1, 3)]:
        table.rows.append([row[0] + "-again"] + row[1:])


def stale_joints(table, rng):
    """Copies the joints of the row before into some rows, as if logged before the controller had the new joints."""
    joints = table.joints()
    for n in rng.sample(range(1, len(table.rows)), min(len(table.rows) - 1, rng.choice([1, 1, 2, 3]))):
        for k in joints:
            table.rows[n][k] = table.rows[n - 1][k]


def lost_rows(table, rng):
    del table.rows[rng.randint(1, max(1, len(table.rows) - 1)):]


def lost_columns(table, rng):
    gone = {k for k in table.columns("load", "point", "time", "temperature", "setup") if rng.random() < 0.5}
    gone |= {k for k, name in enumerate(table.head) if name.endswith("_dir")} if rng.random() < 0.5 else set()
    table.rows = [[value for k, value in enumerate(row) if k not in gone] for row in table.rows]
    table.head = [name for k, name in enumerate(table.head) if k not in gone]


def all_alike(table, rng):
    column = rng.choice(table.joints() + table.places())
    for row in table.rows:
        row[column] = table.rows[0][column]


def far_away(table, rng):
    by = rng.choice([100, 1e4, 1e6])
    table.change([rng.choice(table.places())], lambda value: value + by)


SPOILS = [scaled(Table.places, [25.4, 2.54, 0.0254, 1000, 1 / 12, 1 / 25.4]), scaled(lambda t: t.columns("load_"), [4.448, 0.4536, 1000, 9.81, 0]),
          scaled(Table.joints, [math.pi / 180, 180 / math.pi]), scaled(lambda t: t.columns("sigma_"), [1000, 25.4, 1e-3, 1e6, 1e-9]),
          exchanged_axes, mirrored, joint_sign, joint_zero, joint_order, shifted_rows, single_digit, one_posture, rows_twice,
          lost_rows, lost_columns, all_alike, far_away]


def named(spoil):
    return spoil.__qualname__.removesuffix(".<locals>.spoil")


def arguments(command, cell, rng):
    if command == "improve":
        words = [command, cell, "m.csv", "--steps", "1", "--out", "better.yaml"]
    elif command == "ladder":
        words = [command, "m.csv", cell]
    elif command in ("touches", "sensitivity"):
        words = [command, cell, "--readings", "m.csv"]
        words += ["--candidates", "40", "--count", "3"] if command == "touches" else ["--postures", "10"]
    else:
        words = [command, cell, "m.csv"]
    if command in ("compare", "identify"):
        words += ["--folds", rng.choice(["0", "3"])]
    if rng.random() < 0.2:
        words += ["--assume", rng.choice(ASSUMPTIONS)]
    return words + (["--json", "-"] if rng.random() < 0.5 else [])


def complaint(done, command, as_json):
    """Returns a description of the error of a finished run, or an empty string."""
    if done.returncode not in (0, 1, 2):
        return f"exit code {done.returncode}: {done.stderr[-300:]}"
    if done.returncode == 2 and not done.stderr.strip():
        return "a refusal without a word"
    if "internal error" in done.stderr:
        return done.stderr[-300:]
    if as_json and done.returncode != 2:
        try:
            figures = json.loads(done.stdout, parse_constant=refuse_constant)
        except ValueError as error:
            return f"no JSON: {error}"
        if found := contradictions(command, figures):
            return "; ".join(found)
    found = NO_NUMBER.search(done.stdout)
    return f"'{found.group()}' in: {done.stdout[max(0, found.start() - 80):found.end() + 20]!r}" if found else ""


def contradictions(command, figures):
    """Returns the contradictions between the verdict of a document, if any, and its results."""
    rms, found = figures.get("rms") or {}, []
    if command == "compare":
        refit = figures["after_refit"]
        rms = {"noise_floor": refit["noise_floor"], "before": refit["rms"]}
        repeats = refit["repeats"] or {}
        excused = repeats and repeats["noise_over_stated"] is not None and repeats["noise_over_stated"] <= MOST_NOISE_RATIO
        if figures["verdict"] == "adequate" and refit["p_value"] is not None and refit["p_value"] < 1e-6 and not excused:
            found.append(f"adequate at p = {refit['p_value']}")
        if figures["verdict"] == "falls-short" and not figures["grounds"]:
            found.append("falls short on no ground")
    if command == "identify" and figures["p_value"] is not None and figures["p_value"] < 1e-6:
        if figures["adequacy"] != "falls-short" and not figures["warnings"]:
            found.append(f"p = {figures['p_value']} without a word")
    if command not in ("compare", "diagnose"):
        return found
    if command == "diagnose" and figures["verdict"] == "adequate" and figures["p_value"] < 0.01 and len(figures["sentences"]) == 1:
        found.append(f"adequate at p = {figures['p_value']}, which no repeats excuse")
    numbers = [rms.get(key) for key in ("noise_floor", "before")]
    if figures["verdict"] == "adequate" and None not in numbers and numbers[1] > SLACK * MOST_NOISE_RATIO * numbers[0]:
        found.append(f"adequate with an error of {numbers[1]} beside a floor of {numbers[0]}")
    if command == "diagnose" and figures["verdict"] in ("explained", "partly-explained"):
        if rms["heldout_after"] is None or rms["heldout_after"] >= rms["heldout_before"]:
            found.append("explained though the held-out error does not fall")
    if command == "diagnose" and figures["verdict"] == "explained" and rms["after"] > SLACK * MOST_NOISE_RATIO * rms["noise_floor"]:
        found.append(f"explained with {rms['after']} left beside a floor of {rms['noise_floor']}")
    return found


def refuse_constant(word):
    raise ValueError(f"{word} in the JSON")


def serve(program, cell, folder, rng):
    """Opens the readings in a workbench and runs three random jobs; returns the error as text, or an empty string."""
    bench = Workbench(program, [cell, "m.csv"], folder, SECONDS)
    try:
        if bench.code is not None:
            return "" if bench.code == 2 and bench.words().strip() else f"exit code {bench.code}: {bench.words()[-300:]}"
        for job in rng.sample(JOBS, 3):
            body = {"causes": [rng.choice(EFFECTS[1:])]} if job == "add" else {"goal": "parameters"} if job == "touches" else {}
            refused = bench.job(job, body)
            if "internal error" in refused or "assertion" in refused:
                return f"{job}: {refused}"
            for text in (bench.result(job if job != "add" else "identify"), bench.ask("api/state")[1]):
                json.loads(text, parse_constant=refuse_constant)
                if NO_NUMBER.search(text):
                    return f"{job}: no number in {text[max(0, NO_NUMBER.search(text).start() - 80):][:160]}"
    except (WorkbenchLost, ValueError) as error:
        return str(error)
    finally:
        code = bench.end()
    return "" if code in (0, 130) else f"serve ended with {code}"


def attempt(program, cells, seed, command, pairs):
    """Alters one set and runs one command (by default a random command); returns texts on the run and its error."""
    rng = random.Random(seed)
    cell, design = rng.choice(CELLS)
    effect, size, command = rng.choice(EFFECTS), rng.choice(SIZES), command or COMMANDS[seed % len(COMMANDS)]
    with tempfile.TemporaryDirectory() as folder:
        cell = str(cells / cell)
        hide = ["--hide", effect] if effect else []
        made = subprocess.run([program, "simulate", cell, "--design", design, "--readings", str(size), "--seed", str(seed % 1000 + 1),
                               "--out", "s"] + hide, cwd=folder, capture_output=True, text=True)
        if made.returncode != 0:
            return None, ""
        table = Table((pathlib.Path(folder) / "s/measurements.csv").read_text())
        spoils = rng.sample(SPOILS + [stale_joints], 2) if pairs else rng.sample(SPOILS, rng.choice([1, 1, 1, 2]))
        for spoil in spoils:
            spoil(table, rng)
        (pathlib.Path(folder) / "m.csv").write_text(table.text())
        if command == "serve":
            return f"seed {seed}: {design} {size} {effect or 'nothing hidden'}: serve", serve(program, cell, folder, rng)
        words = arguments(command, cell, rng)
        what = f"seed {seed}: {design} {size} {effect or 'nothing hidden'}: {' + '.join(named(s) for s in spoils)}: {' '.join(words)}"
        try:
            done = subprocess.run([program] + words, cwd=folder, capture_output=True, text=True, timeout=SECONDS, errors="replace")
        except subprocess.TimeoutExpired:
            return what, f"not done after {SECONDS} s"
        wrong = complaint(done, command, "--json" in words)
        if not wrong and done.returncode == 1 and (pathlib.Path(folder) / "better.yaml").exists():
            wrong = "a cell written by a run that answered no"
        return what, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("cells", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--command", choices=COMMANDS, help="the only one to run")
    parser.add_argument("--pairs", action="store_true", help="two mistakes in every file")
    options = parser.parse_args()
    program, cells = str(options.program.resolve()), options.cells.resolve()
    wrong = made = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        seeds = range(options.seed, options.seed + options.runs)
        for what, complaint_found in pool.map(lambda seed: attempt(program, cells, seed, options.command, options.pairs), seeds):
            made += what is not None
            if made % 100 == 0 and sys.stderr.isatty():
                print(f"\r{made} runs, {wrong} of them wrong", end="", file=sys.stderr, flush=True)
            if complaint_found:
                wrong += 1
                print(f"{what}: {complaint_found}", flush=True)
    print(f"{made} runs, {wrong} of them wrong")
    sys.exit(bool(wrong) or made < options.runs // 2)


if __name__ == "__main__":
    main()
