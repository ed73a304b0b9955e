#!/usr/bin/env python3
"""altered_plans.py TUBEPLAN CELL PLAN-FOLDER [--runs 300] [--seed 1]: how many altered copies of a proved plan `verify` catches.

Each copy has one change: a joint value of one tube, a joint value of one row of the path, a skipped tube, two tubes
exchanged, a hole's coordinate, a row's time, an obstacle of the cell moved into the path, or a different stiffness of
the cell's arm. `verify` must refuse every copy. `--only NAME` restricts the changes to one kind.
"""
import argparse
import contextlib
import csv
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile


def read_path(folder):
    with open(folder / "path.csv", newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], rows[1:]


def write_path(folder, head, rows):
    with open(folder / "path.csv", "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([head] + rows)


def change_plan(change):
    """Returns an alteration that applies `change` to plan.json."""
    def alter(folder, rng):
        path = folder / "plan.json"
        plan = json.loads(path.read_text())
        what = change(plan, rng)
        path.write_text(json.dumps(plan))
        return what
    return alter


def tube_joint(plan, rng):
    tube = rng.choice(plan["tubes"])
    joint, by = rng.randrange(len(tube["joints"])), rng.choice([-1, 1]) * 10 ** rng.uniform(-1.5, 1)
    tube["joints"][joint] += by
    return f"{tube['name']} joint {joint + 1} by {by:.3f} deg"


def skipped_tube(plan, rng):
    tube = plan["tubes"].pop(rng.randrange(len(plan["tubes"])))
    return f"{tube['name']} left out of the plan"


def exchanged_tubes(plan, rng):
    a, b = rng.sample(range(len(plan["tubes"])), 2)
    plan["tubes"][a], plan["tubes"][b] = plan["tubes"][b], plan["tubes"][a]
    return f"{plan['tubes'][b]['name']} and {plan['tubes'][a]['name']} exchanged"


def hole_place(plan, rng):
    tube = rng.choice(plan["tubes"])
    by = rng.choice([-1, 1]) * 10 ** rng.uniform(-2, 0)
    tube["hole"][rng.randrange(3)] += by
    return f"hole of {tube['name']} by {by:.3f}"


def path_joint(folder, rng):
    head, rows = read_path(folder)
    joints = [k for k, name in enumerate(head) if name.startswith("theta")]
    row, column = rng.choice(rows), rng.choice(joints)
    by = rng.choice([-1, 1]) * 10 ** rng.uniform(-1, 1)
    row[column] = repr(float(row[column]) + by)
    write_path(folder, head, rows)
    return f"{head[column]} at {row[0]} s by {by:.3f} deg"


def skipped_rows(folder, rng):
    head, rows = read_path(folder)
    segment = head.index("segment")
    approaches = sorted({row[segment] for row in rows if row[head.index("kind")] == "approach"})
    gone = rng.choice(approaches)
    write_path(folder, head, [row for row in rows if row[segment] != gone])
    return f"segment {gone} left out of the path"


def earlier_row(folder, rng):
    head, rows = read_path(folder)
    k = rng.randrange(1, len(rows))
    before, at = float(rows[k - 1][0]), float(rows[k][0])
    rows[k][0] = repr(before + (at - before) * rng.uniform(.01, .1))
    write_path(folder, head, rows)
    return f"row {k} at {rows[k][0]} s instead of {at} s"


def moved_obstacle(folder, rng):
    """Moves the nozzle dam below a planned tube, where the tool passes."""
    plan, path = json.loads((folder / "plan.json").read_text()), folder / "cell.yaml"
    x, y, _ = rng.choice(plan["tubes"])["hole"]
    place = f"cylinder: {{from: [{x:.3f}, {y:.3f}, -30], to: [{x:.3f}, {y:.3f}, -2], radius: 6}}"
    text, count = re.subn(r"cylinder: \{from: [^}]*\}", place, path.read_text())
    assert count == 1
    path.write_text(text)
    return f"nozzle dam under x {x:.1f}, y {y:.1f}"


def other_stiffness(folder, rng):
    """Changes one stiffness of the arm by 5 to 50 %, which only a static analysis can detect."""
    path = folder / "cell.yaml"
    text = path.read_text()
    arm = re.search(r"^arm: (.*)$", text, re.M)
    arm_text = (folder / arm[1].strip("'\"")).resolve().read_text()
    places = [(m[1], n) for m in re.finditer(r"(joint_stiffness|beam): \{[^}]*\}", arm_text)
              for n in re.finditer(r"\b([EGIJ][xyz]?|[xyz]): ([0-9.e+]+)", arm_text[:m.end()]) if n.start() > m.start()]
    kind, number = rng.choice(places)
    factor = rng.choice([-1, 1]) * 10 ** rng.uniform(-1.3, -.3) + 1
    changed = repr(float(number[2]) * factor)
    (folder / "other-arm.yaml").write_text(arm_text[:number.start(2)] + changed + arm_text[number.end(2):])
    path.write_text(text[:arm.start(1)] + "other-arm.yaml" + text[arm.end(1):])
    return f"{kind} {number[1]} from {number[2]} to {changed}"


ALTERATIONS = {"a tube's joint": change_plan(tube_joint), "a skipped tube": change_plan(skipped_tube),
               "two tubes exchanged": change_plan(exchanged_tubes), "a hole's place": change_plan(hole_place),
               "a joint on the path": path_joint, "a skipped approach": skipped_rows, "a row too early": earlier_row,
               "an obstacle moved": moved_obstacle, "another stiffness": other_stiffness}
OF_THE_CELL = {"an obstacle moved", "another stiffness"}


@contextlib.contextmanager
def copy_of(plan):
    """Yields a copy of the plan in a sibling folder, where the cell's relative path of the arm file is valid."""
    with tempfile.TemporaryDirectory(dir=plan.resolve().parent) as folder:
        shutil.copytree(plan, folder, dirs_exist_ok=True)
        yield pathlib.Path(folder)


def verify(program, cell, folder):
    return subprocess.run([program, "verify", cell, str(folder)], capture_output=True, text=True).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("cell")
    parser.add_argument("plan", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=ALTERATIONS)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with copy_of(options.plan) as folder:
        if verify(options.program, options.cell, folder) != 0:
            sys.exit("the plan as it is is not proved")
    names, caught, missed = [options.only] if options.only else list(ALTERATIONS), dict.fromkeys(ALTERATIONS, 0), []
    for run in range(options.runs):
        name = names[run % len(names)]
        with copy_of(options.plan) as folder:
            what = ALTERATIONS[name](folder, rng)
            cell = str(folder / "cell.yaml") if name in OF_THE_CELL else options.cell
            code = verify(options.program, cell, folder)
        if code in (1, 2):
            caught[name] += 1
        else:
            missed.append(f"{what} (exit code {code})")
    for name in names:
        print(f"  {name:22s} {caught[name]} of {sum(1 for k in range(options.runs) if names[k % len(names)] == name)}")
    print(f"caught {sum(caught.values())} of {options.runs}")
    for what in missed:
        print(f"  not caught: {what}")
    sys.exit(bool(missed))


if __name__ == "__main__":
    main()
