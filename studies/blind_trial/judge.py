#!/usr/bin/python3
"""judge.py TUBEPLAN DIR [--jobs 2]: diagnoses every set in DIR and scores the answers by the truth.

Weak data are judged leniently: below d = 8, `adequate` and `inconclusive` are no faults; below d = 12, an effect
outside the catalogue need not be refused, but must not be named. A set is `separable` if no rival of its truth has a
correlation above 0.99 beyond the fitted parameters, and `without a peer` if no such rival has as few parameters as
the truth.
"""
import argparse
import collections
from concurrent.futures import ThreadPoolExecutor
import pathlib
import random
import statistics
import sys

from answers import REFUSABLE_D, WEAK_D, ask
from arm_description import CELLS
from true_numbers import true_numbers

SEPARABLE, STRANGE = .99, .9


def share(part, whole):
    """Returns a count such as `18/20 90 %`, or a dash if there are no cases."""
    whole = list(whole)
    count = sum(1 for case in whole if part(case))
    return f"{count}/{len(whole)} {100. * count / len(whole):.0f} %" if whole else "-"


def held_out_ratio(case):
    """Returns the ratio of the held-out error after the answer to the noise floor, or None if unknown."""
    rms = case.answer.get("rms") or {}
    floor, after = rms.get("noise_floor"), rms.get("heldout_after")
    return after / floor if floor and after else None


def median(values):
    values = [value for value in values if value is not None]
    return f"{statistics.median(values):.2f}" if values else "-"


def stratum_row(stratum, cases):
    """Returns the results of one stratum as a list of strings."""
    null, odd = cases[0].kind == "null", cases[0].kind == "odd"
    pair, known = cases[0].kind == "pair", cases[0].kind in ("single", "pair")
    def only(when, part, whole=cases): return share(part, whole) if when else ""
    return [stratum, str(len(cases)),
            only(null, lambda case: case.word == "false-alarm"),
            only(known, lambda case: case.within), only(known, lambda case: case.right),
            only(known, lambda case: case.right, [case for case in cases if case.named]),
            only(odd, lambda case: case.word == "refused"), only(known, lambda case: case.word == "called-unknown"),
            only(pair, lambda case: case.within), str(sum(case.failed for case in cases)),
            median(map(held_out_ratio, cases)), f"{max(case.seconds for case in cases):.1f}"]


COLUMNS = ["stratum", "sets", "false alarm", "truth in answer", "named right", "right of named", "unknown refused",
           "called unknown", "both found", "failed", "held-out/floor", "slowest s"]


def print_table(rows):
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    for row in rows:
        print("  ".join(word.ljust(width) for word, width in zip(row, widths)).rstrip())


def covered(case):
    """Returns for each fitted parameter of the true effect whether the 95 % interval contains the true value."""
    if case.kind != "single":
        return []
    hidden = case.truth["hidden"][0]
    true = true_numbers(hidden["effect"], hidden["parameters"])
    for alternative in case.answer.get("alternatives") or []:
        for found in alternative:
            if len(alternative) == 1 and (found["effect"], found["at"]) in case.wanted:
                return [abs(number["value"] - true[name]) <= 1.96 * number["sigma"]
                        for name, number in found["parameters"].items() if number.get("sigma") and name in true]
    return []


def calibration(cases, bins=10, draws=400):
    """Returns the expected calibration error of the first candidate's probability, and a reference value.

    The reference is the calibration error of exact probabilities for the same number of sets, simulated with truths
    drawn from the stated probabilities.
    """
    stated = []
    for case in cases:
        first = (case.answer.get("ranking") or [{}])[0]
        probability = first.get("probability")
        if isinstance(probability, (int, float)):
            stated.append((probability, (first.get("effect"), first.get("at")) in case.wanted))
    if not stated:
        return "-"

    def error(hits):
        gaps = collections.defaultdict(float)
        for (probability, _), hit in zip(stated, hits):
            gaps[min(int(probability * bins), bins - 1)] += probability - hit
        return sum(map(abs, gaps.values())) / len(stated)

    drawn = random.Random(1)
    exact = sorted(error([drawn.random() < probability for probability, _ in stated]) for _ in range(draws))
    return (f"{error([hit for _, hit in stated]):.3f} over {len(stated)} (exact probabilities would show "
            f"{statistics.fmean(exact):.3f}, 95 % of the time below {exact[int(0.95 * draws)]:.3f})")


def said(case):
    """Returns the answer as a single label."""
    if case.verdict == "ambiguous":
        return "A or B, truth among" if case.within else "A or B, truth not among"
    if not case.named:
        return case.verdict.split(":")[0]
    if not case.alternatives:
        return "explained by nothing"
    return " + ".join(f"{effect}@{at}" for effect, at in sorted(case.alternatives[0]))


def print_confusion(cases):
    """Prints the answers given to each truth, most frequent first."""
    table = collections.defaultdict(collections.Counter)
    for case in cases:
        truth = " + ".join(sorted(effect for effect, _ in case.wanted)) if case.kind != "pair" else "(pairs)"
        answer = "right" if case.right else said(case)
        table[truth or "none"][answer] += 1
    for truth in sorted(table):
        print(f"  {truth:26s} " + ", ".join(f"{answer} {count}" for answer, count in table[truth].most_common()))


def print_strata(cases):
    strata = collections.defaultdict(list)
    for case in cases:
        strata[case.truth.get("stratum", case.kind)].append(case)
    print_table([COLUMNS] + [stratum_row(stratum, strata[stratum]) for stratum in sorted(strata)])


def print_totals(cases):
    by_kind = {kind: [case for case in cases if case.kind == kind] for kind in ("null", "single", "pair", "odd")}
    strong = [case for case in by_kind["single"] if case.truth["d"] >= WEAK_D]
    clear = [case for case in strong if case.likeness() <= SEPARABLE]
    peerless = [case for case in strong if case.likeness("peer") <= SEPARABLE]
    twinned = [case for case in strong if case.likeness("peer") > SEPARABLE]
    named = [case for case in cases if case.named]
    intervals = [holds for case in by_kind["single"] for holds in covered(case)]
    answers = [len(case.alternatives) for case in strong if case.within]
    good = [ratio for ratio in (held_out_ratio(case) for case in cases if case.right) if ratio is not None]
    strange = [case for case in by_kind["odd"] if case.truth["d"] >= REFUSABLE_D and case.likeness() <= STRANGE]
    refusable = [case for case in by_kind["odd"] if case.truth["d"] >= REFUSABLE_D]
    for label, figure in (
            ("false alarms", share(lambda case: case.word == "false-alarm", by_kind["null"])),
            (f"single, d >= {WEAK_D:.0f}, separable: named right", share(lambda case: case.right, clear)),
            (f"single, d >= {WEAK_D:.0f}, separable: truth in answer", share(lambda case: case.within, clear)),
            (f"single, d >= {WEAK_D:.0f}, without a peer: named right", share(lambda case: case.right, peerless)),
            (f"single, d >= {WEAK_D:.0f}, without a peer: truth in answer", share(lambda case: case.within, peerless)),
            (f"single, d >= {WEAK_D:.0f}, with a peer: truth in answer", share(lambda case: case.within, twinned)),
            (f"single, d >= {WEAK_D:.0f}, with a peer: A or B with the truth",
             share(lambda case: case.within and not case.named, twinned)),
            (f"single, d >= {WEAK_D:.0f}: answers given where one is true",
             f"{statistics.mean(answers):.2f} on average" if answers else "-"),
            ("right when one answer is given (any truth)", share(lambda case: case.right, named)),
            ("known called unknown", share(lambda case: case.word == "called-unknown", by_kind["single"])),
            (f"unknown refused, d >= {REFUSABLE_D:.0f}", share(lambda case: case.word == "refused", refusable)),
            (f"unknown refused, d >= {REFUSABLE_D:.0f}, no rival above {STRANGE}",
             share(lambda case: case.word == "refused", strange)),
            ("pairs: both found", share(lambda case: case.within, by_kind["pair"])),
            (f"pairs: both found, each of d >= {WEAK_D:.0f} beside the other",
             share(lambda case: case.within, [case for case in by_kind["pair"]
                                              if min(case.truth.get("d_beside", [0.])) >= WEAK_D])),
            ("pairs: at least one found", share(lambda case: case.within or case.word == "half", by_kind["pair"])),
            ("held-out/floor <= 1.05 where right", f"{sum(r <= 1.05 for r in good)}/{len(good)}" if good else "-"),
            ("95 % interval of the size holds the truth",
             f"{sum(intervals)}/{len(intervals)} numbers where the truth is among the answers" if intervals else "-"),
            ("calibration error of the first probability, single", calibration(by_kind["single"])),
            ("calibration error of the first probability, all", calibration(cases)),
            ("failed", share(lambda case: case.failed, cases)),
            ("seconds, median", median(case.seconds for case in cases)),
            ("seconds, slowest", f"{max(case.seconds for case in cases):.1f}")):
        print(f"{label:58s} {figure}")


def print_each(cases):
    for case in cases:
        hidden = " + ".join(f"{effect}@{at}" for effect, at in sorted(case.wanted)) or "none"
        print(f"{case.word:14s} {case.name:12s} d {case.truth['d']:6.1f}  hidden {hidden:44s} "
              f"said {case.verdict}: {said(case)}  {case.seconds:.1f} s")
    print()


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--cells", type=pathlib.Path, default=CELLS, help="folder of bench.yaml and bowl.yaml")
    parser.add_argument("--timeout", type=float, default=120., help="seconds a set may take")
    parser.add_argument("--each", action="store_true", help="one line for every set first")
    options = parser.parse_args(arguments)
    folders = sorted(path.parent for path in options.folder.glob("*/truth.json"))
    if not folders:
        parser.error(f"{options.folder}: no set (a folder with truth.json) found")
    with ThreadPoolExecutor(options.jobs) as pool:
        cases = list(pool.map(lambda folder: ask(options.program, options.cells, folder, options.timeout), folders))
    if options.each:
        print_each(cases)
    print_strata(cases)
    print()
    print_totals(cases)
    print("\ntruth: answers")
    print_confusion(cases)


if __name__ == "__main__":
    main(sys.argv[1:])
