#!/usr/bin/python3
"""padding_coverage.py TUBEPLAN [--runs 40] [--seed 3]: compares the padding of plans with the errors of true arms.

For each calibration of a true arm of this folder's physics, the error of the tip in eight random postures is
projected on random directions and divided by one standard deviation of the padding (`plan --padding 1`): the part
due to the base in this posture, and the part that the plan adds for the arm. Two standard deviations must hold 95
% of the errors or more.
"""
import argparse
import json
import subprocess
import sys
import tempfile

import numpy as np
import yaml

from arm_physics import measured, solve
from base_intervals import CELL, R_SN, calibrate, draw_touches
from designs import within_limits
from effect_shapes import DEG
from rotations import exponential
from session import draw_session
from step_chances import CANDIDATES, plan

POSTURES, DIRECTIONS = 8, 4
RANGES = np.array([[-170, 170], [-20, 160], [-150, 150], [-100, 100]]) * DEG


def answer(program, words, folder):
    done = subprocess.run([program] + words + ["--json", "-"], cwd=folder, capture_output=True, text=True)
    return json.loads(done.stdout) if done.stdout.startswith("{") else None


def draw_postures(arm, rng):
    postures = []
    while len(postures) < POSTURES:
        q = rng.uniform(RANGES[:, 0], RANGES[:, 1])
        if np.all(within_limits(arm, q[None])):
            postures.append(q)
    return np.array(postures)


def tip_covariance(covariance, r):
    """Returns the covariance [in^2] of a point at r [in] from the base that the base's covariance [in, deg] causes."""
    turn = np.array([[0, r[2], -r[1]], [-r[2], 0, r[0]], [r[1], -r[0], 0]])
    slopes = np.hstack([np.eye(3), turn * DEG])
    return slopes @ covariance @ slopes.T


def trial(program, holes, options, seed):
    """Returns errors divided by the standard deviation of the padding; an empty list if the arm cannot be
    calibrated."""
    drawn = draw_touches(holes, options, seed)
    if drawn is None:
        return []
    rng, design, chosen, _, _ = drawn
    with tempfile.TemporaryDirectory() as folder:
        _, found, _ = calibrate(program, drawn, options, folder)
        if "base" not in found:
            return []
        planned = answer(program, ["plan", "c2.yaml", "--tubes", chosen[-1]["name"], "--padding", "1", "--out", "p"], folder)
        if not planned or not planned["tubes"]:
            return []
        base, covariance = np.array(found["base"]["position"]), np.array(found["covariance"])
        roll, pitch, yaw = np.radians(found["base"]["rpy"])
        R = exponential(np.array([0., 0., yaw])) @ exponential(np.array([0., pitch, 0.])) @ exponential(np.array([roll, 0., 0.]))
        at_hole = tip_covariance(covariance, np.array(planned["tubes"][0]["predicted_tip"]) - base)
        of_arm = max(0., planned["padding"]["added"] ** 2 - np.linalg.eigvalsh(at_hole)[-1])
        q = draw_postures(design.arm, rng)
        numbers = design.numbers(draw_session(q, np.zeros(len(q)), rng))
        nominal = np.array(yaml.safe_load(CELL.read_text())["base"]["position"])
        true = nominal + measured(numbers, solve(design.arm, numbers)) @ R_SN.T
        ratios = []
        for tip, posture in zip(true, np.degrees(q)):
            pose = answer(program, ["pose", "c2.yaml", "--joints=" + ",".join(map(repr, posture.tolist()))], folder)
            if not pose:
                continue
            p = base + R @ np.array(pose["flexible"]["position"])
            spread = tip_covariance(covariance, p - base)
            for direction in rng.normal(size=(DIRECTIONS, 3)):
                direction /= np.linalg.norm(direction)
                ratios.append((tip - p) @ direction / np.sqrt(direction @ spread @ direction + of_arm))
        return ratios


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--runs", type=int, default=40)
    parser.add_argument("--seed", type=int, default=3)
    options = parser.parse_args()
    options.touches, options.holes = 3, 1
    with tempfile.TemporaryDirectory() as folder:
        holes = plan(options.program, ["--tubes", f"spread:{CANDIDATES}"], folder)["tubes"]
    is_wrong = False
    for options.world, options.prior in (("exact", "world"), ("stiffness", "world"), ("geometry", "default")):
        ratios = np.array([r for k in range(options.runs) for r in trial(options.program, holes, options, k)])
        held = np.mean(np.abs(ratios) <= 2)
        print(f"world {options.world}, prior {options.prior}: {len(ratios)} errors, {100 * held:.1f} % within two standard deviations, rms {np.sqrt(np.mean(ratios ** 2)):.2f} of one")
        is_wrong |= bool(held < .95)
    sys.exit(is_wrong)


if __name__ == "__main__":
    main()
