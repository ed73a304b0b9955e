#!/usr/bin/python3
"""judge_steps.py TUBEPLAN DIR [--jobs 2]: counts hidden effects that `improve` finds step by step.

For every set in DIR that hides three effects (or the number given by --of), prints how many of them the improved model
has, and which further effects it has. A hidden effect also counts as found under the name of an equivalent effect,
which no reading can distinguish from it.
"""
import argparse
import collections
from concurrent.futures import ThreadPoolExecutor
import json
import pathlib
import subprocess
import sys
import tempfile

from answers import WEAK_D
from arm_description import CELLS


def improved(program, cells, folder, timeout):
    """Returns (hidden effects, added effects, other names of the added effects) as sets of `effect@place`; the added
    effects are None if the program failed."""
    truth = json.loads((folder / "truth.json").read_text())
    hidden = {f"{part['effect']}@{part['at']}" for part in truth["hidden"]}
    cell = cells / ("bowl.yaml" if truth["design"] == "bowl" else "bench.yaml")
    with tempfile.TemporaryDirectory() as place:
        words = [program, "improve", str(cell), str(folder / "measurements.csv"), "--out", f"{place}/improved.yaml",
                 "--json", "-"]
        try:
            run = subprocess.run(words, capture_output=True, text=True, timeout=timeout)
            steps = json.loads(run.stdout)["steps"]
        except (OSError, ValueError, KeyError, subprocess.TimeoutExpired):
            return hidden, None, set()
    return hidden, *({name for step in steps for name in step[key]} for key in ("added", "also"))


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--of", type=int, default=3, help="effects hidden in the sets that are judged")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--cells", type=pathlib.Path, default=CELLS, help="folder of bench.yaml and bowl.yaml")
    parser.add_argument("--timeout", type=float, default=300., help="seconds a set may take")
    options = parser.parse_args(arguments)
    folders = [path.parent for path in sorted(options.folder.glob("*/truth.json"))
               if len(json.loads(path.read_text())["hidden"]) == options.of]
    if not folders:
        parser.error(f"no set in {options.folder} hides {options.of} effects")
    with ThreadPoolExecutor(options.jobs) as pool:
        answers = list(pool.map(lambda f: improved(options.program, options.cells, f, options.timeout), folders))
    counts = collections.Counter()
    shown = collections.Counter()
    for folder, (hidden, added, also) in zip(folders, answers):
        missed = hidden - (added or set()) - also
        found = None if added is None else len(hidden - missed)
        counts[found] += 1
        if min(json.loads((folder / "truth.json").read_text()).get("d_beside", [0.])) >= WEAK_D:
            shown[found == options.of] += 1
        wrong = sorted((added or set()) - hidden)
        print(f"{folder.name:12s} {'failed' if added is None else f'{found} of {options.of}'}  missed "
              f"{', '.join(sorted(missed)) or '-'}; beside {', '.join(wrong) or '-'}")
    print(f"all found where each is of d >= {WEAK_D:.0f} beside the others: {shown[True]}/{shown.total()}")
    for found, count in sorted(counts.items(), key=str):
        print(f"{'failed' if found is None else f'{found} of {options.of} found':14s} {count}/{len(answers)}")


if __name__ == "__main__":
    main(sys.argv[1:])
