#!/usr/bin/python3
"""step_chances.py TUBEPLAN [--runs 1000] [--seed 1] [--touches 3] [--hidden mixed|effects|odd|stiffnesses] [--jobs 1]

Compares step probabilities with true arms of this folder's physics, which have stiffness errors of up to a tenth, a
base displaced by millimetres, and up to two effects that the model lacks, from the catalogue or not. The program gets
the touches of such an arm, plans visits and predicts how many steps of the tool enter. The visits are then simulated
with the true arm. The predicted and observed fractions must agree within 3 % for each number of steps.
"""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import yaml

from arm_description import CELLS, read_arm
from arm_physics import Numbers, measured, solve
from designs import Design, identified, reach, true_arm
from effect_shapes import DEG
from effects import CATALOGUE
from odd_effects import ODD
from rotations import turned
from session import draw_session
from signatures import linearise

CELL = CELLS / "mockup.yaml"
WITHIN = .03
CANDIDATES = 150        # number of spread holes from which holes are drawn
UNSEEN = ("thermal-growth", "base-slip", "base-drift", "scale-error")      # effects of time or of an unused instrument
KINDS = {"mixed": (0, 2), "effects": (1, 2), "odd": (1, 1), "stiffnesses": (0, 0)}


def to_base(places):
    """Converts sheet coordinates [in] to the nominal base frame, which is rotated by -90 deg about z."""
    x, y, z = (np.asarray(places) - yaml.safe_load(CELL.read_text())["base"]["position"]).T
    return np.stack([-y, x, z], axis=1)


def plan(program, words, folder, cell=CELL):
    done = subprocess.run([program, "plan", str(cell)] + words + ["--out", "plan"], cwd=folder, capture_output=True, text=True)
    path = pathlib.Path(folder) / "plan/plan.json"
    return json.loads(path.read_text()) if path.exists() else None      # None: the program refused the touches


def draw_effects(scene, arm, rng, hidden):
    """Returns random hidden effects [(effect, place, shape, size)] that depend on neither time nor temperature."""
    fewest, most = KINDS[hidden]
    usual = [effect for effect in CATALOGUE if effect.name not in UNSEEN]
    found = []
    for _ in range(rng.integers(fewest, most + 1)):
        table = ODD if hidden == "odd" or (hidden == "mixed" and rng.uniform() < .3) else usual
        effect = table[rng.integers(len(table))]
        place = str(rng.choice(effect.places(arm)))
        size = np.exp(rng.uniform(np.log(effect.low), np.log(effect.high)))
        found.append((effect, place, effect.shapes(rng, arm, place, scene), float(size)))
    return found


def draw_holes(holes, count, touches, rng):
    """Returns randomly drawn holes; the first of them are touched and are at least 20 in apart."""
    while True:
        chosen = rng.permutation(len(holes))[:count]
        places = np.array([holes[k]["hole"] for k in chosen[:touches]])
        distances = np.linalg.norm(places[:, None] - places[None], axis=2)[np.triu_indices(touches, 1)]
        if distances.min() >= 20.:
            return [holes[k] for k in chosen]


def touches_csv(chosen, session, sigma):
    rows = ["id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,sigma_in,theta1_dir,theta2_dir,theta3_dir,theta4_dir"]
    for k, hole in enumerate(chosen):
        angles = ",".join(f"{angle / DEG:.10f}" for angle in session.q[k])
        rows.append(f"{k + 1},touch,{hole['name']},{angles},{sigma},{','.join(str(way) for way in session.direction[k])}")
    return "\n".join(rows) + "\n"


def steps_inserted(tool, offset, lean):
    """Returns the number of steps that enter the hole: the offset at both ends of each step is within tolerance."""
    below = entered = 0
    for step, length in zip(tool["steps"], tool["lengths"]):
        for depth in (below, below + length):
            if np.linalg.norm(offset - depth * lean) > step["tolerance"]:
                return entered
        below, entered = below + length, entered + 1
    return entered


def trial(program, holes, options, seed):
    """Returns the predicted and observed numbers of visited holes per number of steps; None if calibration failed."""
    rng = np.random.default_rng([options.seed, seed])
    drawn_arm = read_arm()
    arm, tool = true_arm(drawn_arm, rng), yaml.safe_load(CELL.read_text())["calibration_tool"]
    sigma = tool["steps"][-1]["tolerance"] / 2
    chosen = draw_holes(holes, options.touches + options.holes, options.touches, rng)
    q, targets = np.radians([hole["joints"] for hole in chosen]), to_base([hole["hole"] for hole in chosen])
    session = draw_session(q, np.zeros(len(q)), rng)
    design = Design("bowl", arm, session, targets, q[:, 1:].sum(1), np.arange(len(q)), rng.normal(0., .16, 3), rng.normal(0., .004, 3))
    scene = linearise(arm, session, design.numbers(session), sigma, drawn_arm.encoder_sigma, identified(drawn_arm))
    hidden = draw_effects(scene, arm, rng, options.hidden)
    touched = reach(design, hidden, targets + rng.normal(0., sigma, targets.shape))
    if not np.all(np.isfinite(touched[:options.touches])):
        return None
    session.q = touched + rng.normal(0., drawn_arm.encoder_sigma, touched.shape)
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "t.csv").write_text(touches_csv(chosen[:options.touches], session, sigma))
        tubes = ",".join(hole["name"] for hole in chosen[options.touches:])
        planned = plan(program, ["--touches", "t.csv", "--tubes", tubes], folder)
    visits = [tube for tube in planned["tubes"] if tube["probability_by_steps"]] if planned else []
    if not visits:
        return None
    return np.sum([tube["probability_by_steps"] for tube in visits], axis=0), steps_by(design, hidden, visits, tool, rng)


def steps_by(design, hidden, visits, tool, rng):
    """Returns the numbers of planned visits at which the design's true arm inserts 0, 1, ... steps."""
    q = np.radians([tube["joints"] for tube in visits])
    q = q + rng.normal(0., design.arm.encoder_sigma, q.shape)
    at_work = draw_session(q, np.zeros(len(q)), rng)
    numbers = design.numbers(at_work)
    for effect, place, shape, size in hidden:
        effect.apply(numbers, design.arm, at_work, place, shape, size)
    state = solve(design.arm, numbers)
    off = measured(numbers, state) - to_base([tube["hole"] for tube in visits])
    axis = turned(state.R_tip, np.broadcast_to(tool_axis(design.arm), off.shape))
    happened = np.zeros(len(tool["steps"]) + 1)
    for offset, up in zip(off, axis):
        happened[steps_inserted(tool, offset[:2], up[:2] / up[2])] += 1
    return happened


def tool_axis(arm):
    """Returns the calibration tool's axis in the last frame, perpendicular to the tool link towards the tip."""
    return np.array([0., 1., 0.]) * np.sign(arm.tip[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda word: str(pathlib.Path(word).resolve()))
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--touches", type=int, default=3)
    parser.add_argument("--holes", type=int, default=10)
    parser.add_argument("--hidden", choices=KINDS, default="mixed")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        holes = plan(options.program, ["--tubes", f"spread:{CANDIDATES}"], folder)["tubes"]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        found = [one for one in pool.map(trial, *zip(*[(options.program, holes, options, k) for k in range(options.runs)])) if one]
    predicted, happened = (np.array(column) for column in zip(*found))
    count = happened.sum()
    off = (predicted - happened).sum(0) / count
    error = np.sqrt(((predicted - happened) ** 2).sum(0)) / count
    print(f"{options.touches} touches, {options.hidden}: {len(found)} of {options.runs} arms calibrated, {int(count)} holes")
    print("  steps      predicted   happened   difference  (standard error)")
    for k in range(len(off)):
        print(f"  {k:5d}      {100 * predicted[:, k].sum() / count:8.1f} %  {100 * happened[:, k].sum() / count:8.1f} %  {100 * off[k]:+9.1f} %  ({100 * error[k]:.1f} %)")
    sys.exit(bool(np.abs(off).max() > WITHIN))


if __name__ == "__main__":
    main()
