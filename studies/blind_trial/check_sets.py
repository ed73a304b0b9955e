#!/usr/bin/python3
"""check_sets.py: checks that the generator's sets agree with their stated truth. Exit code 0 if all checks hold.

With the true effects in the model and the fitted parameters fitted, the squared whitened residuals must add up to their
degrees of freedom; without the true effects, the sum must be larger by d^2. Both are tested over many sets of each
design. A generator that states a wrong d, noise or effect fails.
"""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import collections
from dataclasses import replace
import sys

import numpy as np

from arm_description import read_arm
from arm_physics import measured, solve
from effects import CATALOGUE
from generate import measure
from odd_effects import ODD
from signatures import COARSE
from truths import draw_truth, joint_change

SETS, LENGTHS = 105, (5., 8., 12.)
DEVIATIONS = 4.         # largest accepted deviation of a sum from its expectation, in standard deviations


def residual(truth, readings, points, with_truth):
    """Returns the squared norm of the whitened residual after fitting the parameters, and its degrees of freedom."""
    design, scene = truth.design, truth.scene
    session = replace(design.session, q=readings)
    numbers = design.numbers(session)
    for part in truth.hidden if with_truth else []:
        part.effect.apply(numbers, design.arm, session, part.place, part.shape, part.size)
    predicted = measured(numbers, solve(design.arm, numbers, COARSE))
    goal = design.targets if points is None else points
    beyond = scene.beyond(predicted - goal)
    return beyond @ beyond, len(beyond) - scene.fitted.shape[1]


def main():
    arm, rows = read_arm(), collections.defaultdict(list)
    for index in range(SETS):
        rng, pool = np.random.default_rng([2024, index]), CATALOGUE + ODD
        truth = draw_truth(arm, [pool[index % len(pool)]], [LENGTHS[index % 3]], "check", rng)
        reading = measure(truth, rng)
        if reading is None:
            continue
        known, freedom = residual(truth, *reading, True)
        unknown, _ = residual(truth, *reading, False)
        signature = truth.scene.beyond(joint_change(truth))
        rows[truth.design.kind].append((known, unknown - known, freedom, signature @ signature))
    failures = 0
    for kind, sets in rows.items():
        known, excess, freedom, d_squared = np.array(sets).T.sum(1)
        off = ((known - freedom) / np.sqrt(2. * freedom), (excess - d_squared) / np.sqrt(4. * d_squared))
        failures += any(abs(value) > DEVIATIONS for value in off)
        print(f"{kind:6s} {len(sets):3d} sets: residual over freedom {known / freedom:.4f} ({off[0]:+.1f} deviations), "
              f"excess without the truth over d^2 {excess / d_squared:.4f} ({off[1]:+.1f} deviations)")
    return int(failures > 0 or len(rows) < 3)


if __name__ == "__main__":
    sys.exit(main())
