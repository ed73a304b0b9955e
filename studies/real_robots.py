#!/usr/bin/env python3
"""real_robots.py TUBEPLAN REAL-FOLDER [SET...] [--farthest]: compares `improve` with a black box on measured robots.

REAL-FOLDER holds one folder per robot, with a nominal cell and readings, half of which the column `split` holds out.
REAL-FOLDER is not part of the repository; without it, the study reports this and exits with code 77. For each set:

  improve   `improve` from the nominal cell; `compare` judges the resulting cell without a refit. A cell has only one
            base, so for sets with several set-ups the bases, and nothing else, are fitted before the cell is judged
  black box a Gaussian process over the joints (and the direction of motion, the load and the set-up if they vary),
            added to a fit of geometry and base alone; length scale and noise are chosen by marginal likelihood
  goal      the mean held-out error that `improve` must reach, if a goal is set

All errors are means of the position error [mm] over readings held out from both methods. Touches of points of unknown
position are judged by their scatter about the mean of each point. Since a model that shrinks the arm also reduces this
scatter, the known distance between two of the points is shown too.

The farthest quarter is defined as in `diagnose`: the poses of each set-up (the readings of one `point` are one pose)
whose reach is not below the element at 3/4 of the sorted reaches. Reach is the distance from the arm's base to the tip
predicted by the fit of geometry. The columns `far` are means over the held-out readings of this quarter. With
--farthest, both methods also start again from readings of which exactly this quarter is held out, to test the
extrapolation.
"""
import argparse
import csv
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.optimize import minimize
from scipy.spatial.distance import cdist

ABSENT = 77  # exit code if REAL-FOLDER is missing


@dataclass
class RobotSet:
    cell: str
    readings: str
    goal: float = None      # mean held-out error to be reached [mm]
    setup: str = ""         # set-up whose readings are used; empty means all
    carried_to: str = ""    # further readings on which the improved cell is judged with base, or base and tip, refitted
    carried_goal: float = None
    pair_apart: float = None  # independently known distance between the points NAME-0 and NAME-1 [mm]


SETS = {
    "irb120": RobotSet("irb120/cell.yaml", "irb120/measurements.csv", 0.33),
    "hilti-flat": RobotSet("hilti/cell.yaml", "hilti/measurements.csv", 1.5, setup="flat"),
    "hilti": RobotSet("hilti/cell.yaml", "hilti/measurements.csv"),
    "motoman-wide": RobotSet("motoman/cell-wide.yaml", "motoman/measurements-wide.csv", 1.3),
    "iiwa-all": RobotSet("kuka-iiwa7/cell.yaml", "kuka-iiwa7/measurements-allaxes.csv", 0.28),
    "iiwa-2.5": RobotSet("kuka-iiwa7/cell-payload.yaml", "kuka-iiwa7/measurements-payload-2.5kg.csv", 0.35,
                         carried_to="kuka-iiwa7/measurements-allaxes.csv", carried_goal=0.9),
    "wam": RobotSet("wam/cell.yaml", "wam/measurements.csv", 1.75),
    "panda": RobotSet("panda-touch/cell.yaml", "panda-touch/measurements.csv", pair_apart=50.0),
    "ur5": RobotSet("ur5/cell.yaml", "ur5/measurements.csv"),
    "justin-right": RobotSet("justin-right/cell.yaml", "justin-right/measurements.csv"),
    "justin-weights": RobotSet("justin-right/cell-assumed-weights.yaml", "justin-right/measurements.csv", 5.0),
}


class Refused(Exception):
    """Raised with the program's message if a command fails."""


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write_rows(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return path


def copy_of_cell(cell, to, free):
    """Writes a copy of the cell with a different `identify` list and the path of the original arm file."""
    arm = re.search(r'^arm: *"?([^"\n]+?)"? *$', cell.read_text(), re.MULTILINE).group(1)
    text = re.sub(r"^arm:.*$", f'arm: "{cell.parent / arm}"', cell.read_text(), flags=re.MULTILINE)
    to.write_text(re.sub(r"^identify:.*$", f"identify: [{', '.join(free)}]", text, flags=re.MULTILINE))
    return to


class Program:
    def __init__(self, path):
        self.path = path

    def run(self, *words):
        """Runs a command and returns its JSON output and CPU time [s]."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [self.path] + [str(word) for word in words] + ["--json", "-"]
        done = subprocess.run(command, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            figures = json.loads(done.stdout)
        except ValueError:
            said = done.stderr.strip().splitlines() or ["no word"]
            raise Refused(f"{words[0]} ended with {done.returncode}: {said[-1]}") from None
        return figures, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def compare(self, cell, readings):
        return self.run("compare", cell, readings, "--folds", 0, "--assume", "as-is")[0]


class Comparison:
    """Results of `compare` for each reading, in the order of the file: errors and positions in mm."""

    def __init__(self, figures, rows):
        by_id = {str(reading["id"]): reading for reading in figures["readings"]}
        readings = [by_id.get(row["id"]) for row in rows]
        if not all(readings) or len(by_id) != len(rows):
            raise Refused(f"compare told of {len(by_id)} readings out of {len(rows)}")
        self.as_written = np.array([reading["error_before"] for reading in readings], float)
        self.refitted = np.array([reading["error_after"] for reading in readings], float)
        self.tips_as_written = np.array([reading["position_before"] for reading in readings], float)
        self.kept_out = np.array([reading["held_out"] for reading in readings])
        bases = {base["setup"]: np.array(base["base"]["position"]) for base in figures["refit"]["bases"]}
        tips = np.array([reading["position_after"] for reading in readings], float)
        self.reach = np.linalg.norm([tip - bases[row.get("setup") or ""] for tip, row in zip(tips, rows)], axis=1)


def farthest_quarter(rows, reach):
    """Returns for each reading whether it belongs to the farthest quarter of the poses of its set-up."""
    far = np.zeros(len(rows), bool)
    setups = np.array([row.get("setup") or "" for row in rows])
    points = np.array([row["point"] or f"row {k}" for k, row in enumerate(rows)])
    for setup in np.unique(setups):
        here = setups == setup
        reaches = {point: reach[here & (points == point)].max() for point in np.unique(points[here])}
        least = sorted(reaches.values())[3 * len(reaches) // 4]
        far |= here & np.array([reaches.get(point, 0) >= least for point in points])
    return far


def is_slide(column):
    return column.endswith("_mm") and column not in ("x_mm", "y_mm", "z_mm", "sigma_mm")


def features_of(rows):
    """Returns the features of the readings: sine and cosine of revolute joints, prismatic joints and loads divided
    by their standard deviation, directions of motion, and set-ups as 0 or 1."""
    columns = []
    for name in rows[0]:
        if name.endswith("_deg") and not name.startswith("temperature"):
            angles = np.radians([float(row[name]) for row in rows])
            columns += [np.sin(angles), np.cos(angles)]
        elif name.endswith("_dir"):
            columns.append(np.array([float(row[name] or 0) for row in rows]))
        elif name.startswith("load_") or is_slide(name):
            values = np.array([float(row[name] or 0) for row in rows])
            columns.append(values / (values.std() or 1))
    setups = sorted({row.get("setup") or "" for row in rows})
    columns += [np.array([float((row.get("setup") or "") == setup) for row in rows]) for setup in setups[1:]]
    return np.column_stack([column for column in columns if np.ptp(column) > 0])


class GaussianProcess:
    """Gaussian process for error vectors over features: squared-exponential kernel, with one length scale and one noise
    level for all three coordinates."""

    def __init__(self, features, errors):
        self.features, self.mean = features, errors.mean(axis=0)
        self.errors = errors - self.mean
        self.squares = cdist(features, features, "sqeuclidean")
        start = np.log(self.errors.std())
        tries = [minimize(self.cost, [start, np.log(scale), start - 1], jac=True, method="L-BFGS-B",
                          bounds=[(start - 5, start + 5), (-3, 4), (start - 6, start + 2)]) for scale in (0.5, 2, 6)]
        self.size, self.scale, self.noise = np.exp(min(tries, key=lambda found: found.fun).x)
        kernel = self.kernel(self.squares) + (self.noise ** 2 + self.jitter()) * np.eye(len(features))
        self.weights = cho_solve(cho_factor(kernel, lower=True), self.errors)

    def jitter(self):
        return 1e-8 * self.size ** 2

    def kernel(self, squares):
        return self.size ** 2 * np.exp(-squares / (2 * self.scale ** 2))

    def cost(self, logs):
        """Returns the negative log marginal likelihood of the errors and its gradient in the log hyperparameters."""
        self.size, self.scale, self.noise = np.exp(logs)
        kernel = self.kernel(self.squares)
        unit = np.eye(len(kernel))
        factor = cho_factor(kernel + (self.noise ** 2 + self.jitter()) * unit, lower=True)
        weights, inverse = cho_solve(factor, self.errors), cho_solve(factor, unit)
        count = self.errors.shape[1]
        value = 0.5 * np.sum(self.errors * weights) + count * np.log(np.diag(factor[0])).sum()
        pull = weights @ weights.T - count * inverse
        slope = [-np.sum(pull * kernel) - self.jitter() * np.trace(pull),
                 -0.5 * np.sum(pull * kernel * self.squares) / self.scale ** 2, -self.noise ** 2 * np.trace(pull)]
        return value, np.array(slope)

    def predict(self, features):
        return self.mean + self.kernel(cdist(features, self.features, "sqeuclidean")) @ self.weights


def is_touched_alone(rows):
    return not any(row["x_mm"] for row in rows)


def sizes(rows, errors):
    """Returns the length of each error; for touches, relative to the mean error of each point, whose position is
    unknown."""
    errors = errors.copy()
    if is_touched_alone(rows):
        points = np.array([row["point"] for row in rows])
        for point in np.unique(points):
            errors[points == point] -= errors[points == point].mean(axis=0)
    return np.linalg.norm(errors, axis=1)


def mean_of(rows, errors, chosen):
    return sizes([row for row, is_chosen in zip(rows, chosen) if is_chosen], errors[chosen]).mean()


def geometry_alone(program, cell, readings, rows, folder):
    """Fits geometry and base to the readings that are not held out. If there are only touches, which do not determine
    the scale, the cell's own `identify` list is used."""
    if not is_touched_alone(rows):
        cell = copy_of_cell(cell, folder / "geometry.yaml", ["geometry"])
    return Comparison(program.compare(cell, readings), rows)


def by_black_box(rows, rigid):
    """Returns the errors of all readings minus the prediction of the Gaussian process."""
    features = features_of(rows)
    process = GaussianProcess(features[~rigid.kept_out], rigid.refitted[~rigid.kept_out])
    return rigid.refitted - process.predict(features)


def judgement(program, written, readings, rows, folder):
    """Returns the comparison for the written cell; with several set-ups, after refitting only the bases."""
    if len({row.get("setup") or "" for row in rows}) < 2:
        return Comparison(program.compare(written, readings), rows)
    placed = Comparison(program.compare(copy_of_cell(written, folder / "placed.yaml", []), readings), rows)
    placed.as_written = placed.refitted
    return placed


def by_improve(program, cell, readings, rows, folder):
    """Returns the comparison for the improved cell, the output of `improve`, its CPU time [s], and the cell file."""
    written = folder / "improved.yaml"
    improvement, seconds = program.run("improve", cell, readings, "--out", written)
    if not written.exists():
        raise Refused(f"improve wrote no cell and ended with {improvement['end']}: {improvement['steps'][-1]['reason']}")
    return judgement(program, written, readings, rows, folder), improvement, seconds, written


def without_farthest(program, cell, rows, far, folder):
    """Returns the mean errors of both methods over the farthest quarter, which neither method was fitted to."""
    split_rows = [dict(row, split="held-out" if is_far else "fit") for row, is_far in zip(rows, far)]
    readings = write_rows(folder / "without-farthest.csv", split_rows)
    rigid = geometry_alone(program, cell, readings, split_rows, folder)
    box = by_black_box(split_rows, rigid)
    improved = by_improve(program, cell, readings, split_rows, folder)[0].as_written
    return {"far_apart": mean_of(split_rows, improved, far), "box_far_apart": mean_of(split_rows, box, far),
            "rigid_far_apart": mean_of(split_rows, rigid.refitted, far)}


def carried(program, written, readings, folder):
    """Returns the mean held-out errors of the improved cell on other readings, with the base refitted, and
    with base and tip refitted."""
    figures = program.compare(copy_of_cell(written, folder / "carried.yaml", ["tool.tip"]), readings)
    errors = figures["refit"]["errors"]
    return errors["heldout_before"]["mean"], errors["heldout_after"]["mean"]


def pairs_apart(rows, tips):
    """Returns the mean distance between the model's positions of the points NAME-0 and NAME-1."""
    points = np.array([row["point"] for row in rows])
    places = {point: tips[points == point].mean(axis=0) for point in np.unique(points)}
    return np.mean([np.linalg.norm(place - places[point[:-1] + "1"]) for point, place in places.items()
                    if point.endswith("-0") and point[:-1] + "1" in places])


def first_added(improvement):
    for step in improvement["steps"]:
        if step["added"]:
            return step["added"][0] + (f" and {len(step['added']) - 1} more" if len(step["added"]) > 1 else "")
    return "nothing"


def study(program, real, robot, with_farthest, folder):
    """Returns the results of one set."""
    cell, readings = real / robot.cell, real / robot.readings
    if robot.setup:
        readings = write_rows(folder / "some.csv", [row for row in read_rows(readings) if row["setup"] == robot.setup])
    rows = read_rows(readings)
    rigid = geometry_alone(program, cell, readings, rows, folder)
    far = farthest_quarter(rows, rigid.reach)
    out, far_out = rigid.kept_out, rigid.kept_out & far
    box = by_black_box(rows, rigid)
    judged, improvement, seconds, written = by_improve(program, cell, readings, rows, folder)
    improved = judged.as_written
    figures = {"rigid": mean_of(rows, rigid.refitted, out), "improved": mean_of(rows, improved, out),
               "box": mean_of(rows, box, out), "far": mean_of(rows, improved, far_out),
               "box_far": mean_of(rows, box, far_out), "seconds": seconds, "first": first_added(improvement),
               "end": improvement["end"]}
    if robot.carried_to:
        figures["carried"] = carried(program, written, real / robot.carried_to, folder)
    if robot.pair_apart:
        figures["apart"] = pairs_apart(rows, judged.tips_as_written)
    if with_farthest:
        figures.update(without_farthest(program, cell, rows, far, folder))
    return figures


def number(value, width=9):
    return f"{'-' if value is None else format(value, '.3f'):>{width}s}"


def print_head(with_farthest):
    apart = f"{'geometry':>11s}{'improve':>9s}{'box':>9s}" if with_farthest else ""
    over = f"{'without farthest':>29s}" if with_farthest else ""
    print(f"{'':13s}{'held out, mean in mm':>36s}{'far':>18s}{over}\n{'set':13s}{'geometry':>9s}{'improve':>9s}"
          f"{'goal':>9s}{'box':>9s}{'improve':>9s}{'box':>9s}{apart}{'CPU s':>8s}  added first, end", flush=True)


def print_row(name, robot, figures, with_farthest):
    apart = "".join(number(figures[key], width) for key, width in
                    (("rigid_far_apart", 11), ("far_apart", 9), ("box_far_apart", 9))) if with_farthest else ""
    missed = "" if robot.goal is None or figures["improved"] <= robot.goal else "  goal missed"
    told = "".join(number(value) for value in (figures["rigid"], figures["improved"], robot.goal, figures["box"],
                                               figures["far"], figures["box_far"]))
    print(f"{name:13s}{told}{apart}{figures['seconds']:8.1f}  {figures['first']}, {figures['end']}{missed}", flush=True)
    if robot.pair_apart:
        print(f"{'':13s} points known to be {robot.pair_apart:.1f} mm apart: {figures['apart']:.1f} mm", flush=True)
    if robot.carried_to:
        placed, with_tip = figures["carried"]
        print(f"{'':13s} carried to {pathlib.Path(robot.carried_to).name}: {placed:.3f} with the base placed anew, "
              f"{with_tip:.3f} with base and tip; goal {robot.carried_goal:.3f}"
              f"{'' if with_tip <= robot.carried_goal else '  goal missed'}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("real", type=pathlib.Path)
    parser.add_argument("sets", nargs="*", metavar="SET", help=", ".join(SETS))
    parser.add_argument("--farthest", action="store_true", help="both ways afresh, without the farthest quarter")
    options = parser.parse_args()
    unknown = [name for name in options.sets if name not in SETS]
    if unknown:
        parser.error(f"no set {unknown[0]}; there are {', '.join(SETS)}")
    if not options.real.is_dir():
        print(f"{options.real} is not there: the measured robots are no part of the repository, nothing was judged")
        sys.exit(ABSENT)
    program, real = Program(str(options.program.resolve())), options.real.resolve()
    print_head(options.farthest)
    for name in options.sets or SETS:
        with tempfile.TemporaryDirectory() as folder:
            try:
                figures = study(program, real, SETS[name], options.farthest, pathlib.Path(folder))
            except Refused as refusal:
                print(f"{name:13s} {refusal}", flush=True)
                continue
            print_row(name, SETS[name], figures, options.farthest)


if __name__ == "__main__":
    main()
