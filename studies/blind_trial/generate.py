#!/usr/bin/python3
"""generate.py --out DIR --sets SPEC --seed S: generates measurements of a Cobra with hidden effects.

SPEC is a list such as null=24,null-outliers=4,null-heavy-tails=4,single=60,pair=12,odd=16. Each set has a folder
DIR/NAME: `tubeplan diagnose` gets measurements.csv and must not see truth.json. The same seed gives the same sets.
"""
import os
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")      # matrices are small, so that threads only slow each other down

import argparse
import collections
from dataclasses import replace
import json
import pathlib
import sys
import time

import numpy as np

from arm_description import read_arm
from arm_physics import PIECES, measured, solve
from designs import EXACTLY, NEARLY, SIGMA, reach, within_limits
from effect_shapes import DEG
from effects import CATALOGUE
from odd_effects import ODD
from truths import NoPlace, draw_truth, joint_change, lengths_beside, rivals_of, twins

SINGLE_D = (5., 8., 12., 20., None)      # wanted d; None for a physical size, with d as it results
ODD_D = (8., 12., 20., None)
PAIR_D = (8., 12., 20.)
TRIPLE_D = (12., 20.)
OUTLIER_SHARE, OUTLIER_SIGMAS, TAIL_FREEDOM = .02, 10., 4
HEADER = ("id,kind,point,load_lbf,{joints},x_in,y_in,z_in,sigma_in,{directions},temperature_degF,time_min")


def recipes(spec, rng):
    """Returns [(stratum, effects, wanted lengths d)] in random order, in which all effects and strata occur."""
    made = []
    for kind, count in spec.items():
        for k in range(count):
            if kind.startswith("null"):
                made.append((kind, [], []))
            elif kind == "single":
                d = SINGLE_D[(k + 2 * (k // len(CATALOGUE))) % len(SINGLE_D)]
                made.append((_stratum(kind, d), [CATALOGUE[k % len(CATALOGUE)]], [d]))
            elif kind == "odd":
                d = ODD_D[(k + 2 * (k // len(ODD))) % len(ODD_D)]
                made.append((_stratum(kind, d), [ODD[k % len(ODD)]], [d]))
            else:
                count_of, sizes = (2, PAIR_D) if kind == "pair" else (3, TRIPLE_D)
                some = rng.choice(len(CATALOGUE), count_of, replace=False)
                made.append((kind, [CATALOGUE[i] for i in some], [float(d) for d in rng.choice(sizes, count_of)]))
    return [made[i] for i in rng.permutation(len(made))]


def _stratum(kind, d):
    return f"{kind}-physical" if d is None else f"{kind}-d{d:.0f}"


def noise(rng, count, stratum):
    """Returns noise of unit variance for the measured tip, (count, 3): Gaussian, Gaussian with 10-sigma outliers, or
    Student's t."""
    if stratum == "null-heavy-tails":
        return rng.standard_t(TAIL_FREEDOM, (count, 3)) / np.sqrt(TAIL_FREEDOM / (TAIL_FREEDOM - 2.))
    unit = rng.normal(size=(count, 3))
    if stratum == "null-outliers":
        hit = rng.choice(count, max(1, round(OUTLIER_SHARE * count)), replace=False)
        ways = rng.normal(size=(len(hit), 3))
        unit[hit] += OUTLIER_SIGMAS * ways / np.linalg.norm(ways, axis=1, keepdims=True)
    return unit


def measure(truth, rng):
    """Returns recorded readings (N, J) and recorded points (N, 3) or None, computed with fine rods; None alone if the
    arm cannot reach the targets."""
    design, session = truth.design, truth.design.session
    parts = [part.parts for part in truth.hidden]
    disturbance = SIGMA[design.kind] * noise(rng, len(session.q), truth.stratum)
    if design.kind == "bench":
        numbers, points = design.numbers(session), None
        for effect, *rest in parts:
            effect.apply(numbers, design.arm, session, *rest)
        solution = solve(design.arm, numbers)
        q, points = session.q, measured(numbers, solution) + disturbance
        fine = solution.converged
    else:
        targets = design.targets + disturbance
        q = reach(design, parts, targets, NEARLY)
        if np.all(np.isfinite(q)):
            q = reach(replace(design, session=replace(session, q=q)), parts, targets, EXACTLY, PIECES)
        points = design.targets if design.kind == "bowl" else None
        fine = bool(np.all(np.isfinite(q))) and bool(within_limits(design.arm, q, 0.).all())
    return (q + rng.normal(0., design.arm.encoder_sigma, q.shape), points) if fine else None


def truth_content(truth, seed, arm):
    """Returns the content of truth.json."""
    design, hidden = truth.design, truth.hidden
    change = joint_change(truth) if hidden else np.zeros((len(design.session.q), 3))
    content = {
        "design": design.kind, "seed": seed,
        "hidden": [part.entry(design.arm) for part in hidden] or [{"effect": "none", "at": "", "parameters": {}}],
        "scale": hidden[0].scale if hidden else 1., "d": round(float(np.linalg.norm(truth.scene.beyond(change))), 2),
        "raw_rms_in": round(float(np.sqrt((change ** 2).sum(1).mean())), 5),
        "joint_noise_deg": round(arm.encoder_sigma / DEG, 6), "stratum": truth.stratum}
    if hidden:
        content["d_each"] = [round(part.d, 2) for part in hidden]
        rivals = rivals_of(truth)
        if len(hidden) > 1:
            content["d_beside"] = [round(d, 2) for d in lengths_beside(truth, rivals)]
        for name, alike in zip(("twin", "peer"), zip(*twins(truth, rivals))):
            content[name] = max(alike, key=lambda rival: rival["correlation"])
    return content


def write_set(folder, truth, readings, points, content):
    """Writes the two files of a set in the format of the practice sets."""
    design, session, arm = truth.design, truth.design.session, truth.design.arm
    kind, prefix = ("position", "P") if design.kind == "bench" else ("touch", "H")
    joints, directions = (",".join(f"{name}_{what}" for name in arm.joints) for what in ("deg", "dir"))
    lines = [HEADER.format(joints=joints, directions=directions)]
    for k in range(len(readings)):
        angles = ",".join(f"{angle:.4f}" for angle in readings[k] / DEG)
        place = ",".join(f"{value:.4f}" for value in points[k]) if points is not None else ",,"
        ways = ",".join(str(way) for way in session.direction[k])
        lines.append(f"{k + 1},{kind},{prefix}{design.point[k] + 1},{session.load[k]:.0f},{angles},{place},"
                     f"{SIGMA[design.kind]},{ways},{session.temperature[k]:.1f},{session.time[k]:.1f}")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "measurements.csv").write_text("\n".join(lines) + "\n")
    (folder / "truth.json").write_text(json.dumps(content, indent=1) + "\n")


def make_set(out, index, recipe, seed, arm):
    """Generates one set and returns the content of its truth file."""
    stratum, effects, wanted = recipe
    rng = np.random.default_rng([seed, index])
    while True:
        try:
            truth = draw_truth(arm, effects, wanted, stratum, rng)
        except NoPlace:
            if len(effects) < 2:
                raise
            effects = [CATALOGUE[i] for i in rng.choice(len(CATALOGUE), len(effects), replace=False)]
            continue
        reading = measure(truth, rng)
        if reading:
            break
    content = truth_content(truth, 100000 * seed + index, arm)
    write_set(out / f"{truth.design.kind}-{index:04d}", truth, *reading, content)
    return content


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--sets", required=True, help="such as null=24,single=60,pair=12,triple=10,odd=16")
    parser.add_argument("--seed", required=True, type=int)
    options = parser.parse_args(arguments)
    spec = {kind: int(count) for kind, count in (part.split("=") for part in options.sets.split(","))}
    unknown = set(spec) - {"null", "null-outliers", "null-heavy-tails", "single", "pair", "triple", "odd"}
    if unknown:
        parser.error(f"--sets: unknown kind {', '.join(sorted(unknown))}")
    arm, start, counts = read_arm(), time.time(), collections.Counter()
    for index, recipe in enumerate(recipes(spec, np.random.default_rng(options.seed)), 1):
        content = make_set(options.out, index, recipe, options.seed, arm)
        counts[content["stratum"]] += 1
    for stratum, count in sorted(counts.items()):
        print(f"{stratum:20s} {count}")
    print(f"{sum(counts.values())} sets in {time.time() - start:.0f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
