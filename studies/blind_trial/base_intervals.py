#!/usr/bin/python3
"""base_intervals.py TUBEPLAN [--runs 300] [--seed 1] [--touches 3] [--world exact|stiffness|geometry] [--prior default|world] [--jobs 1]

Compares the stated uncertainty of a calibrated base, and the step probabilities of plans made with it, with true arms
of this folder's physics. --world selects the errors of the arm's file: none; those of six stiffnesses, with a standard
deviation of 10 %; or, in addition, those of joint zeros (0.04 deg), link lengths (0.015 in) and the tip (0.020 in).
With --prior world, the cell states these standard deviations; with --prior default, it states none.

The goal, with --prior world, is that the 95 % region of the base contains the true base in 93 to 97 of 100
calibrations, whatever the command's exit code, and that predicted and observed fractions of each number of steps agree
within 3 %.
"""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import argparse
import concurrent.futures
from dataclasses import replace
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import yaml

from arm_description import read_arm
from designs import Design, identified, reach
from effect_shapes import DEG
from rotations import exponential
from session import draw_session
from step_chances import CANDIDATES, CELL, WITHIN, draw_holes, plan, steps_by, to_base, touches_csv

LIMIT = 12.592          # 95 % quantile of chi-square with six degrees of freedom
R_SN = exponential(np.array([0., 0., -90. * DEG]))      # axes of the nominal base in the sheet's frame
WORLDS = {
    "exact": {"stiffness": 0., "weight": 0., "zero": 0., "axis": 0., "length": 0., "tip": 0.},
    "stiffness": {"stiffness": .1, "weight": 0., "zero": 0., "axis": 0., "length": 0., "tip": 0.},
    "geometry": {"stiffness": .1, "weight": 0., "zero": .04, "axis": 0., "length": .015, "tip": .02},
}


def true_arm(drawn, world, rng):
    """Returns the nominal arm with random parameter errors of the given world."""
    spring, rod = drawn.spring.copy(), drawn.rod.copy()
    for name, link, axis in identified(drawn):
        (spring if name == "spring" else rod)[link, axis] *= np.exp(world["stiffness"] * rng.normal())
    theta, a = drawn.theta.copy(), drawn.a.copy()
    theta[drawn.joint_rows] += world["zero"] * DEG * rng.normal(size=len(drawn.joint_rows))
    moving = drawn.joint_rows[1:]       # beyond the first joint; errors before the first joint only move the base
    a[moving] += world["length"] * rng.normal(size=len(moving))
    return replace(drawn, spring=spring, rod=rod, theta=theta, a=a, tip=drawn.tip + world["tip"] * rng.normal(size=3))


def draw_spread_holes(holes, options, rng):
    """Returns holes from draw_holes whose touched holes are far from collinear."""
    while True:
        chosen = draw_holes(holes, options.touches + options.holes, options.touches, rng)
        places = np.array([hole["hole"] for hole in chosen[:options.touches]])
        spread = np.linalg.svd(places - places.mean(0), compute_uv=False)
        if spread[1] > .1 * spread[0]:
            return chosen


def cell_text(world):
    """Returns the text of the mock-up cell, with the uncertainty `world` if given."""
    text = CELL.read_text().replace("arm: cobra-arm.yaml", f"arm: {CELL.parent / 'cobra-arm.yaml'}")
    return text if world is None else text + f"uncertainty: {json.dumps(world)}\n"


def base_error(found, position, turn):
    """Returns displacement [in] and rotation vector [deg] from the true to the calibrated base, in the sheet's axes."""
    nominal = np.array(yaml.safe_load(CELL.read_text())["base"]["position"])
    shift = np.array(found["position"]) - (nominal + R_SN @ position)
    roll, pitch, yaw = np.radians(found["rpy"])
    R = exponential(np.array([0., 0., yaw])) @ exponential(np.array([0., pitch, 0.])) @ exponential(np.array([roll, 0., 0.]))
    off = R @ (R_SN @ exponential(turn)).T
    return np.concatenate([shift, np.array([off[2, 1] - off[1, 2], off[0, 2] - off[2, 0], off[1, 0] - off[0, 1]]) / 2. / DEG])


def draw_touches(holes, options, seed):
    """Returns a true arm at work: (generator, design, chosen holes, session with the joint readings of all of them,
    standard deviation of a touch); None if the true arm cannot make the touches."""
    rng = np.random.default_rng([options.seed, seed])
    drawn = read_arm()
    arm = true_arm(drawn, WORLDS[options.world], rng)
    sigma = yaml.safe_load(CELL.read_text())["calibration_tool"]["steps"][-1]["tolerance"] / 2
    chosen = draw_spread_holes(holes, options, rng)
    q, targets = np.radians([hole["joints"] for hole in chosen]), to_base([hole["hole"] for hole in chosen])
    session = draw_session(q, np.zeros(len(q)), rng)
    design = Design("bowl", arm, session, targets, q[:, 1:].sum(1), np.arange(len(q)), rng.normal(0., .4, 3), rng.normal(0., .5 * DEG, 3))
    touched = reach(design, [], targets + rng.normal(0., sigma, targets.shape))
    if not np.all(np.isfinite(touched[:options.touches])):
        return None
    session.q = touched + rng.normal(0., drawn.encoder_sigma, touched.shape)
    return rng, design, chosen, session, sigma


def calibrate(program, drawn, options, folder):
    """Calibrates the cell by the drawn touches, in the folder's cell.yaml and t.csv, and writes c2.yaml; returns the
    exit code, the figures and the messages."""
    _, _, chosen, session, sigma = drawn
    (pathlib.Path(folder) / "cell.yaml").write_text(cell_text(None if options.prior == "default" else WORLDS[options.world]))
    (pathlib.Path(folder) / "t.csv").write_text(touches_csv(chosen[:options.touches], session, sigma))
    words = [program, "calibrate", "cell.yaml", "t.csv", "--out", "c2.yaml", "--json", "-"]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    return done.returncode, json.loads(done.stdout) if done.stdout else {}, done.stderr.strip()


def trial(program, holes, options, seed):
    """Returns (exit code, chi-square of the base's error, predicted steps, observed steps), or None if the true arm
    cannot make the touches."""
    drawn = draw_touches(holes, options, seed)
    if drawn is None:
        return None
    rng, design, chosen, _, _ = drawn
    tool = yaml.safe_load(CELL.read_text())["calibration_tool"]
    with tempfile.TemporaryDirectory() as folder:
        code, found, said = calibrate(program, drawn, options, folder)
        if "base" not in found:
            print((found.get("reason") or said).strip(), file=sys.stderr)
            return code, np.nan, None, None
        cell = pathlib.Path(folder) / "cell.yaml"
        tubes = ",".join(hole["name"] for hole in chosen[options.touches:])
        planned = plan(program, ["--touches", "t.csv", "--tubes", tubes], folder, cell) if options.holes else None
    error = base_error(found["base"], design.base_position, design.base_turn)
    chi2 = error @ np.linalg.solve(np.array(found["covariance"]), error)
    visits = [tube for tube in planned["tubes"] if tube["probability_by_steps"]] if planned else []
    if not visits:
        return code, chi2, None, None
    return code, chi2, np.sum([tube["probability_by_steps"] for tube in visits], axis=0), steps_by(design, [], visits, tool, rng)


def share(held):
    """Returns a fraction with its standard error, such as '95.0 +- 1.3 % of 300'."""
    held = np.asarray(held)
    if len(held) == 0:
        return "none"
    part = held.mean()
    return f"{100 * part:5.1f} +- {100 * np.sqrt(.95 * .05 / len(held)):.1f} % of {len(held)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda word: str(pathlib.Path(word).resolve()))
    parser.add_argument("--runs", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--touches", type=int, default=3)
    parser.add_argument("--holes", type=int, default=10)
    parser.add_argument("--world", choices=WORLDS, default="stiffness")
    parser.add_argument("--prior", choices=("default", "world"), default="world")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        holes = plan(options.program, ["--tubes", f"spread:{CANDIDATES}"], folder)["tubes"]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        found = [one for one in pool.map(trial, *zip(*[(options.program, holes, options, k) for k in range(options.runs)])) if one]
    code, chi2 = np.array([one[0] for one in found]), np.array([one[1] for one in found])
    placed = np.isfinite(chi2)
    held = chi2 < LIMIT
    print(f"world {options.world}, prior {options.prior}, {options.touches} touches: {len(found)} calibrations, {int((~placed).sum())} refused")
    print(f"  95 % region holds the base: {share(held[placed])}; exit 0: {share(held[placed & (code == 0)])}; exit 1: {share(held[placed & (code == 1)])}")
    print(f"  median of chi-square on six: {np.median(chi2[placed]):.2f} (5.35)")
    planned = [one for one in found if one[2] is not None]
    wrong = bool(abs(held[placed].mean() - .95) > .02)
    if planned:
        predicted, happened = (np.array(column) for column in zip(*[one[2:] for one in planned]))
        count = happened.sum()
        print(f"  steps of {int(count)} visits: predicted {' / '.join(f'{100 * p:.1f}' for p in predicted.sum(0) / count)}, happened {' / '.join(f'{100 * p:.1f}' for p in happened.sum(0) / count)} %")
        wrong |= bool(np.abs((predicted - happened).sum(0) / count).max() > WITHIN)
    sys.exit(wrong)


if __name__ == "__main__":
    main()
