#!/usr/bin/python3
"""oracle.py TRUE_EVIDENCE DIR [--jobs 2] [--only pair,single]: what limits the diagnosis on sets whose truth is known.

TRUE_EVIDENCE is build/studies/true_evidence. For every set with a known truth, prints the log weight (prior times
evidence) of the true model, fitted from the true sizes, minus that of the best model that the diagnosis found. If the
truth is not in the answer, the cause is

- the search, if the true model is more probable than that model but was not among the fitted ones,
- the fit, if the true model was fitted but ended in a worse optimum,
- the answer, if the true model was found as the most probable one but is not in the answer,
- the readings, if the true model is less probable than the best one found: no rule by evidence names it first.
"""
import argparse
import collections
from concurrent.futures import ThreadPoolExecutor
import json
import pathlib
import subprocess
import sys

from arm_description import CELLS
from true_numbers import true_numbers

CLOSE = 1.   # difference in log weight below which two fits have reached the same optimum


def hidden_texts(truth):
    """Yields the hidden effects in the input format of `true_evidence`, with the sizes that the program can name."""
    for part in truth["hidden"]:
        numbers = true_numbers(part["effect"], part["parameters"])
        sizes = ",".join(f"{name}={value!r}" for name, value in numbers.items())
        yield f"{part['effect']}@{part['at']}" + (f":{sizes}" if sizes else "")


def ask(program, cells, folder):
    truth = json.loads((folder / "truth.json").read_text())
    cell = cells / ("bowl.yaml" if truth["design"] == "bowl" else "bench.yaml")
    known = not any(part["effect"].startswith(("odd-", "none")) for part in truth["hidden"])
    texts = list(hidden_texts(truth)) if known else []
    run = subprocess.run([program, str(cell), str(folder / "measurements.csv"), *texts], capture_output=True, text=True)
    return folder.name, truth, json.loads(run.stdout) if run.returncode == 0 else {"failed": run.stderr.strip()}


def holds(wanted, model):
    """Returns True if a model has exactly the wanted effects, under any of their equivalent names."""
    return len(model["effects"]) == len(wanted) and all(any(name in names for names in model["effects"])
                                                         for name in wanted)


def cause_of_loss(wanted, answer):
    """Returns a one-word judgement and the log weight of the true model minus that of the best model found."""
    best = answer["found"][0]
    ahead = answer["truth"][0]["log_weight"] - best["log_weight"] if answer["truth"][0]["effects"] else float("-inf")
    if any(holds(wanted, alternative) for alternative in answer["alternatives"]):
        return "in the answer", ahead
    fitted = [model for model in answer["found"] if holds(wanted, model)]
    if ahead < 0 and not (fitted and fitted[0] is best):
        return "readings", ahead
    if not fitted:
        return "search", ahead
    return ("fit" if answer["truth"][0]["log_weight"] > fitted[0]["log_weight"] + CLOSE else "answer"), ahead


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--only", default="single,pair,triple", help="strata, or names of sets")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--cells", type=pathlib.Path, default=CELLS, help="folder of bench.yaml and bowl.yaml")
    options = parser.parse_args(arguments)
    only = options.only.split(",")
    folders = [path.parent for path in sorted(options.folder.glob("*/truth.json"))
               if path.parent.name in only or json.loads(path.read_text())["stratum"].split("-")[0] in only]
    with ThreadPoolExecutor(options.jobs) as pool:
        cases = list(pool.map(lambda folder: ask(options.program, options.cells, folder), folders))
    counts = collections.defaultdict(collections.Counter)
    for name, truth, answer in cases:
        wanted = [f"{part['effect']}@{part['at']}" for part in truth["hidden"]]
        if answer.get("truth"):
            word, ahead = cause_of_loss(wanted, answer)
            counts[truth["stratum"].split("-")[0]][word] += 1
            words = f"{word:14s} ahead {ahead:8.2f}"
        else:
            words = answer.get("failed", "")
        best = answer["found"][0] if answer.get("found") else {"effects": []}
        said = " + ".join(names[0] for names in best["effects"]) or "nothing"
        beside = "/".join(f"{d:.0f}" for d in truth.get("d_beside", [truth["d"]]))
        print(f"{name:12s} {words} d {beside:8s} hidden {' + '.join(wanted):60s} {answer.get('verdict')}, best {said}"
              f" (remainder {best.get('remainder', 0):.2f})")
    for stratum, of in counts.items():
        print(f"{stratum}: " + ", ".join(f"{word} {count}" for word, count in of.most_common()))


if __name__ == "__main__":
    main(sys.argv[1:])
