#!/usr/bin/env python3
"""unweighed_arms.py TUBEPLAN [--seeds 50] [--first-seed 1] [--each]: naming of effects of arms without weights.

There are three practice arms without weights and compliances: an elbow arm with six joints, an arm with seven, and one
with five, of which one is prismatic. For each seed, the lengths of the true arm differ from the drawing by 1 mm and its
angles by 3 mrad (standard deviations), `simulate` displaces its base, and it hides two effects that need no weights.
The size of an effect is 0.3 to 1 times the smaller of two sizes: the largest usual one, and that which moves the tip by
3 mm. `simulate` makes readings of 150 unloaded postures with directions of motion, with 0.032 mm noise of tracker and
repeatability together, and holds out a third of them; `diagnose` gets the drawing and the readings.

An effect counts as named if it, or an effect that is exactly equivalent (`also`), is a cause of an alternative. It
counts as half if an alternative has it at all joints. The goal is to name both effects for 90 % of the seeds. Needs
PyYAML.
"""
import argparse
import collections
import copy
import json
import math
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

import yaml

LENGTH_ERROR, ANGLE_ERROR = 1., math.degrees(.003)  # mm, deg: standard deviations of the true arm from the drawing
TRACKER, REPEATABILITY = .011, .03                  # mm per coordinate
READINGS, HELD_OUT = 150, .333
SMALLEST_SHARE, MOST_AT_TIP = .3, 3.                # smallest size relative to the largest; largest tip motion [mm]
FIRST_PLACES = 4                                    # number of places of the ranking that count
SECONDS = 300                                       # time limit of a diagnosis
GOAL = .9
ALL_JOINTS = "all joints"
# Largest usual sizes, as in the table of effects: rad (m for a prismatic joint), or a dimensionless fraction.
USUAL = {"gravity-sag": .005, "hysteresis": .01, "joint-scale": .01, "transmission-error": .005,
         "encoder-eccentricity": .01, "joint-coupling": .05}
TURNING_ONLY = ("gravity-sag", "transmission-error", "encoder-eccentricity", "joint-coupling")
UNITS = {"length": "mm", "angle": "deg", "force": "N", "temperature": "degC", "time": "s"}


def dh(name, alpha, a, d, limits, offset=0.):
    return {"name": name, "dh": {"alpha": alpha, "a": a, "d": d},
            "joint": {"name": name.replace("row", "J"), "type": "revolute", "offset": offset, "limits": limits}}


def origin(name, position, rpy, limits):
    """Returns a row whose axis is parallel to the axis before, where DH parameters cannot represent a small tilt."""
    return {"name": name, "origin": {"position": position, "rpy": rpy},
            "joint": {"name": name.replace("row", "J"), "type": "revolute", "offset": 0., "limits": limits}}


def slide(name, alpha, a, theta, limits):
    return {"name": name, "dh": {"alpha": alpha, "a": a, "theta": theta},
            "joint": {"name": name.replace("row", "J"), "type": "prismatic", "offset": 0., "limits": limits}}


def arm(name, links, tip):
    return {"units": UNITS, "name": name, "gravity": [0, 0, -1], "links": links, "tool": {"tip": tip}}


ARMS = [
    arm("elbow", [dh("row1", 0., 0., 290., [-165, 165]), dh("row2", -90., 0., 0., [-100, 100], -90.),
                  origin("row3", [280., 0., 0.], [0., 0., 0.], [-100, 70]), dh("row4", -90., 60., 310., [-160, 160]),
                  dh("row5", 90., 0., 0., [-115, 115]), dh("row6", -90., 0., 75., [-180, 180])], [45., 0., 60.]),
    arm("seven", [dh("row1", 0., 0., 340., [-165, 165]), dh("row2", -90., 0., 0., [-115, 115]),
                  dh("row3", 90., 0., 400., [-165, 165]), dh("row4", 90., 0., 0., [-115, 115]),
                  dh("row5", -90., 0., 400., [-165, 165]), dh("row6", -90., 0., 0., [-115, 115]),
                  dh("row7", 90., 0., 126., [-170, 170])], [50., 0., 60.]),
    arm("slide", [dh("row1", 0., 0., 400., [-160, 160]), dh("row2", -90., 0., 120., [-110, 110]),
                  slide("row3", 90., 0., 0., [250., 600.]), origin("row4", [0., 0., 60.], [0., 0., 0.], [-170, 170]),
                  dh("row5", -90., 0., 0., [-110, 110])], [140., 0., 50.]),
]


def cell_of(arm):
    """Returns a cell with the arm, whose base is unknown and is identified with the geometry."""
    return {"name": arm["name"] + "-cell", "arm": arm,
            "base": {"position": [0, 0, 0], "rpy": [0, 0, 0], "known": False}, "identify": ["geometry"]}


def true_arm(drawn, rng):
    """Returns the arm as built, with deviations from the drawing. The offset of a prismatic joint is a length."""
    built = copy.deepcopy(drawn)
    for row in built["links"]:
        numbers, joint = row.get("dh", {}), row["joint"]
        for key in numbers:
            numbers[key] += rng.gauss(0, LENGTH_ERROR if key in "ad" else ANGLE_ERROR)
        if numbers:
            joint["offset"] += rng.gauss(0, LENGTH_ERROR if joint["type"] == "prismatic" else ANGLE_ERROR)
        else:
            row["origin"] = {"position": [value + rng.gauss(0, LENGTH_ERROR) for value in row["origin"]["position"]],
                             "rpy": [value + rng.gauss(0, ANGLE_ERROR) for value in row["origin"]["rpy"]]}
    built["tool"]["tip"] = [value + rng.gauss(0, LENGTH_ERROR) for value in built["tool"]["tip"]]
    return built


def length_of(row):
    """Returns the distance from the row before to this row [mm], with a prismatic joint fully extended."""
    if "origin" in row:
        return math.hypot(*row["origin"]["position"])
    along = row["joint"]["limits"][1] if row["joint"]["type"] == "prismatic" else row["dh"]["d"]
    return math.hypot(row["dh"]["a"], along)


def reach_beyond(arm, index):
    """Returns the largest possible distance from a joint to the tip [mm]."""
    return sum(length_of(row) for row in arm["links"][index + 1:]) + math.hypot(*arm["tool"]["tip"])


def largest_reading(row):
    """Returns the largest absolute joint value within the limits [rad; m for a prismatic joint]."""
    furthest = max(abs(limit) for limit in row["joint"]["limits"])
    return furthest / 1e3 if row["joint"]["type"] == "prismatic" else math.radians(furthest)


def motion_at_tip(arm, effect, index, other):
    """Returns the largest tip motion caused by an effect of size 1 [mm]."""
    row = arm["links"][index]
    lever = 1e3 if row["joint"]["type"] == "prismatic" else reach_beyond(arm, index)
    if effect == "joint-scale":
        return lever * largest_reading(row)
    if effect == "joint-coupling":
        return lever * largest_reading(arm["links"][other])
    if effect == "gravity-sag":         # sag under the weight of the link and under the weight at the tip
        return lever * (1 + reach_beyond(arm, index) / 1e3)
    return lever


def places_of(arm, effect):
    """Returns the possible places of an effect as [(row, other row or None)]. Sag needs a joint that gravity loads and
    that carries further links; a coupling is driven by the joint before."""
    rows = arm["links"]
    turning = [k for k, row in enumerate(rows) if row["joint"]["type"] == "revolute"]
    if effect == "gravity-sag":
        return [(k, None) for k in turning if 0 < k < len(rows) - 1]
    if effect == "joint-coupling":
        return list(zip(turning[1:], turning))
    return [(k, None) for k in (turning if effect in TURNING_ONLY else range(len(rows)))]


def numbers_of(effect, size, is_slide, rng):
    """Returns the effect's parameters in the cell's units for a size in rad (m for a prismatic joint, or a
    fraction)."""
    angle = size * 1e3 if is_slide else math.degrees(size)
    phase = rng.uniform(0, 2 * math.pi)
    sign = rng.choice([-1, 1])
    if effect == "gravity-sag":
        return {"own_x": angle * math.cos(phase), "own_y": angle * math.sin(phase), "tip": angle}
    if effect in ("transmission-error", "encoder-eccentricity"):
        return {"sine": angle * math.sin(phase), "cosine": angle * math.cos(phase)}
    if effect == "hysteresis":
        return {"half_width": sign * angle}
    return {"scale" if effect == "joint-scale" else "share": sign * size}


def draw_effect(arm, rng):
    """Returns a random effect as (effect, place, argument of --hide)."""
    effect = rng.choice(sorted(USUAL))
    index, other = rng.choice(places_of(arm, effect))
    joint = arm["links"][index]["joint"]
    at = joint["name"] if other is None else f"{joint['name']}<-{arm['links'][other]['joint']['name']}"
    largest = min(USUAL[effect], MOST_AT_TIP / motion_at_tip(arm, effect, index, other))
    size = largest * rng.uniform(SMALLEST_SHARE, 1.)
    numbers = numbers_of(effect, size, joint["type"] == "prismatic", rng)
    return effect, at, f"{effect}@{at}:" + ",".join(f"{name}={value:.6g}" for name, value in numbers.items())


def draw_pair(arm, rng):
    """Returns two random effects that differ in kind or place."""
    first = draw_effect(arm, rng)
    while True:
        second = draw_effect(arm, rng)
        if second[:2] != first[:2]:
            return [first, second]


def run(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=SECONDS)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"exit code {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def diagnosed(program, arm, built, hidden, seed, folder):
    """Simulates readings of the arm as built, diagnoses them with the drawing; returns the answer and its time [s]."""
    folder = pathlib.Path(folder)
    (folder / "nominal.yaml").write_text(yaml.safe_dump(cell_of(arm), sort_keys=False))
    (folder / "true.yaml").write_text(yaml.safe_dump(cell_of(built), sort_keys=False))
    noise = str(math.hypot(TRACKER, REPEATABILITY))
    words = ["--design", "bench", "--readings", str(READINGS), "--seed", str(seed), "--loads", "0", "--sigma", noise]
    words += ["--held-out", str(HELD_OUT), "--out", "."] + [word for part in hidden for word in ("--hide", part[2])]
    run([program, "simulate", "true.yaml"] + words, folder)
    start = time.time()
    answer = json.loads(run([program, "diagnose", "nominal.yaml", "measurements.csv", "--json", "-"], folder))
    return answer, time.time() - start


def names_of(cause):
    return {(name["effect"], name["at"]) for name in [cause, *cause.get("also", [])]}


def is_at_all_joints(alternative, effect, arm):
    """Returns True if the alternative has the effect at all joints, written as one cause per revolute joint."""
    turning = {row["joint"]["name"] for row in arm["links"] if row["joint"]["type"] == "revolute"}
    return turning <= {cause["at"] for cause in alternative if cause["effect"] == effect}


def naming(alternative, wanted, arm):
    """Returns 1 if an alternative names the effect, 1/2 if the alternative names it at all joints, else 0."""
    named = 0.
    for cause in alternative:
        if wanted in names_of(cause):
            named = max(named, .5 if is_at_all_joints(alternative, cause["effect"], arm) else 1.)
    return named


def ranked(answer, wanted):
    """Returns 1 if the first places of the ranking have the effect, 1/2 if they have it at all joints, else 0."""
    first = [(entry["effect"], entry["at"]) for entry in answer["ranking"][:FIRST_PLACES]]
    return 1. if wanted in first else .5 if (wanted[0], ALL_JOINTS) in first else 0.


class Case:
    """Result of one seed: the hidden effects, the answer, and the scores."""

    def __init__(self, seed, arm, hidden, answer, seconds):
        self.seed, self.arm, self.hidden, self.answer, self.seconds = seed, arm, hidden, answer, seconds
        wanted = [part[:2] for part in hidden]
        alternatives = answer["alternatives"]
        self.named = [max((naming(one, name, arm) for one in alternatives), default=0.) for name in wanted]
        self.together = any(all(naming(one, name, arm) == 1 for name in wanted) for one in alternatives)
        self.ranked = [ranked(answer, name) for name in wanted]

    @property
    def is_at_one_joint(self):
        """True if both effects are at the same joint; a coupling counts as at the driven joint."""
        return len({at.split("<-")[0] for _, at, _ in self.hidden}) == 1

    @property
    def both_named(self):
        return min(self.named) == 1

    @property
    def both_ranked(self):
        return min(self.ranked) == 1

    def over_floor(self, key):
        rms = self.answer["rms"]
        return rms[key] / rms["noise_floor"] if rms.get(key) and rms.get("noise_floor") else math.nan

    def line(self):
        sizes = " ".join(part[2] for part in self.hidden)
        return (f"seed {self.seed} {self.arm['name']:6s} {'named ' if self.both_named else 'MISSED'} "
                f"{'ranked' if self.both_ranked else 'UNRANKED'} {self.answer['verdict']:16s} held-out/floor "
                f"{self.over_floor('heldout_before'):6.2f} to {self.over_floor('heldout_after'):5.2f}  "
                f"{self.seconds:5.1f} s  hidden {sizes}")

    def answered(self):
        """Yields the alternatives and the ranking as lines of text."""
        for alternative in self.answer["alternatives"]:
            causes = []
            for cause in alternative:
                name = f"{cause['effect']}@{cause['at']}"
                if is_at_all_joints(alternative, cause["effect"], self.arm):
                    name = f"{cause['effect']}@{ALL_JOINTS}"
                also = ", ".join(f"{other['effect']}@{other['at']}" for other in cause.get("also", []))
                causes.append(name + (f" (also {also})" if also else ""))
            yield "alternative " + " + ".join(dict.fromkeys(causes))
        yield "ranking " + ", ".join(f"{entry['effect']}@{entry['at']} {entry['probability']:.2f}"
                                     for entry in self.answer["ranking"][:FIRST_PLACES + 2])
        if self.answer.get("remainder"):
            rest = self.answer["remainder"]
            follows = ", ".join(f"{part['variable']} {part['share']:.2f}" for part in rest["follows"])
            yield f"remainder {rest['size']:.4f} mm follows {follows or 'nothing'}"


def attempt(program, seed):
    drawn, rng = ARMS[seed % len(ARMS)], random.Random(seed)
    built, hidden = true_arm(drawn, rng), draw_pair(drawn, rng)
    with tempfile.TemporaryDirectory() as folder:
        answer, seconds = diagnosed(program, drawn, built, hidden, seed, folder)
    return Case(seed, drawn, hidden, answer, seconds)


def share(count, of):
    return f"{count:g} of {of}, {100 * count / max(1, of):.0f} %"


def print_scores(label, cases):
    count = len(cases)
    def of(holds): return share(sum(map(holds, cases)), count)
    print(f"{label}: {count} seeds")
    print("  both named by the alternatives                   ", of(lambda case: case.both_named))
    print("  ... by one alternative together                  ", of(lambda case: case.together))
    print("  ... or at all joints, which counts as half       ", of(lambda case: min(case.named)))
    print(f"  both among the first {FIRST_PLACES} of the ranking            ", of(lambda case: case.both_ranked))
    print("  ... or at all joints, which counts as half       ", of(lambda case: min(case.ranked)))
    print("  one or both named by the alternatives            ", of(lambda case: max(case.named) == 1))


def print_effects(cases):
    """Prints how often each kind of effect was named."""
    hidden, named = collections.Counter(), collections.Counter()
    for case in cases:
        for part, score in zip(case.hidden, case.named):
            hidden[part[0]] += 1
            named[part[0]] += score == 1
    shares = (f"{effect} {named[effect]} of {hidden[effect]}" for effect in sorted(hidden))
    print("named, by effect: " + "; ".join(shares))


def print_figures(cases):
    verdicts = collections.Counter(case.answer["verdict"] for case in cases)
    print("verdicts: " + ", ".join(f"{verdict} {count}" for verdict, count in verdicts.most_common()))
    for when in ("before", "after"):
        ratios = [ratio for ratio in (case.over_floor("heldout_" + when) for case in cases) if math.isfinite(ratio)]
        if ratios:
            print(f"held-out error over the noise floor, {when}: median {statistics.median(ratios):.2f}, "
                  f"largest {max(ratios):.2f}")
    seconds = [case.seconds for case in cases]
    print(f"seconds: median {statistics.median(seconds):.1f}, slowest {max(seconds):.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--seeds", type=int, default=50)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--each", action="store_true", help="a line for every seed, with the answer where it is missed")
    options = parser.parse_args()
    cases, failed = [], 0
    for seed in range(options.first_seed, options.first_seed + options.seeds):
        try:
            case = attempt(str(options.program.resolve()), seed)
        except (RuntimeError, ValueError, subprocess.TimeoutExpired) as error:
            failed += 1
            print(f"seed {seed} failed: {error}", flush=True)
            continue
        cases.append(case)
        if options.each:
            print(case.line(), flush=True)
            if not (case.both_named and case.both_ranked):
                print("".join(f"    {line}\n" for line in case.answered()), end="", flush=True)
    if not cases:
        raise SystemExit("no seed was diagnosed")
    for drawn in ARMS:
        of_arm = [case for case in cases if case.arm is drawn]
        if of_arm:
            print_scores(f"arm {drawn['name']}", of_arm)
    print_scores("all arms", cases)
    for label, is_at_one in (("both at one joint", True), ("at two joints", False)):
        these = [case for case in cases if case.is_at_one_joint == is_at_one]
        print(f"hidden {label}: named {share(sum(case.both_named for case in these), len(these))}")
    print_effects(cases)
    print_figures(cases)
    print(f"failed: {failed}")
    sys.exit(sum(case.both_named for case in cases) < GOAL * options.seeds)


if __name__ == "__main__":
    main()
