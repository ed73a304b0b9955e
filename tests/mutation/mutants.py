#!/usr/bin/env python3
"""mutants.py BUILD [--seed 1] [--count 20] [--parts statics,proof] [--jobs 1]

Measures whether the tests detect faults in the code that computes results. Makes a seeded sample of mutants, one
at a time: with another operator or comparison, a changed constant or sign, or a statement omitted. Of each, only
the mutated source is compiled and linked before the library (BUILD, the release build), and the tests of that
part run until one fails. Prints every survivor. The exit code is 1 if fewer than 85 % of the mutants of a part
are killed. A mutant that does not compile is not counted. Survivors that were found to be equivalent to the
original are listed in equivalent.txt, with the reason.
"""
import argparse
import dataclasses
import json
import pathlib
import random
import re
import resource
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOAL = 0.85


@dataclasses.dataclass
class Part:
    """A set of files, the sources to recompile for each (for a header, those that include it), and its tests:
    binaries with a filter, starting with the tests most likely to fail."""
    name: str
    target: str
    sources: dict
    tests: list


def headers(pattern, *sources):
    return {str(path.relative_to(ROOT)): list(sources) for path in sorted(ROOT.glob(pattern))}


def own(*names):
    return {name: [name] for name in names}


ELEMENTS = "deflection/elements/elements.cpp"
EFFECTS = "deflection/effects/effects.cpp"
DEFLECTION_TEST = ("deflection/deflection_test", "*")
CALIBRATION_TEST = "calibration/calibration_test"
PARTS = [
    Part("statics", "deflection",
         {**own("deflection/equilibrium.cpp"),
          "deflection/elements/beam.hpp": [ELEMENTS, EFFECTS],
          "deflection/elements/joint_stiffness.hpp": [ELEMENTS, EFFECTS],
          "deflection/elements/clearance.hpp": ["deflection/equilibrium.cpp"]},
         [DEFLECTION_TEST]),
    Part("effects", "deflection",
         {name: sources for name, sources in headers("deflection/effects/*.hpp", EFFECTS).items()
          if pathlib.Path(name).stem not in {"effect", "effect_context", "expression", "formula", "formula_sizes",
                                             "placed_effect", "places", "signature", "user_formula", "rigid_frames"}},
         [DEFLECTION_TEST]),
    Part("residuals", "calibration",
         own("calibration/estimation/campaign_residual.cpp", "calibration/estimation/whitened_residual.cpp",
             "calibration/measurements/frame_motion.cpp", "calibration/measurements/predict_all.cpp",
             "calibration/measurements/measurement_prediction.cpp"),
         [(CALIBRATION_TEST, "*")]),
    Part("evidence", "calibration",
         own("calibration/diagnosis/evidence/linear_evidence.cpp",
             *(f"calibration/diagnosis/judgement/{name}.cpp"
               for name in ("claims", "posterior", "decision", "ranking", "remainder"))),
         [(CALIBRATION_TEST, "*Evidence*:LogSum.*"), (CALIBRATION_TEST, "Decide.*:*Diagnos*"), (CALIBRATION_TEST, "*")]),
    Part("bound", "planner", own("planner/order/one_tree_bound.cpp", "planner/order/priced_tree.cpp"),
         [("planner/planner_test", "*")]),
    Part("proof", "planner", own("planner/motion/motion_check.cpp", "planner/collision/deflection_travel.cpp",
                                 "planner/collision/travel_bound.cpp"),
         [("planner/planner_test", "CheckMotion.*:TravelBound.*"), ("planner/visit_plan_test", "DeflectionTravel.*"),
          ("planner/planner_test", "*"), ("planner/visit_plan_test", "*")]),
]

# Operators and their replacements. The spaces around an operator exclude templates, pointers and signs.
SWAPS = {
    " + ": [" - "], " - ": [" + "], " * ": [" / "], " / ": [" * "],
    " += ": [" -= "], " -= ": [" += "], " *= ": [" /= "], " /= ": [" *= "],
    " < ": [" <= ", " > "], " <= ": [" < ", " > "], " > ": [" >= ", " < "], " >= ": [" > ", " < "],
    " == ": [" != "], " != ": [" == "], " && ": [" || "], " || ": [" && "],
}
NUMBER = re.compile(r"(?<![\w.\"])(\d+(?:\.\d*)?(?:e[-+]?\d+)?)(?![\w.\"x])")
SIGN = re.compile(r"(?<=[(=,?:{] )-(?=[\w(])|(?<=[(\[{])-(?=[\w(])|(?<=return )-(?=[\w(])")
STATEMENT = re.compile(r"^\s+(?!return\b|const\b|auto\b|double\b|int\b|bool\b|using\b|break\b|continue\b|static\b|else\b|for\b|if\b|while\b|assert\b)"
                       r"[\w.\[\]>*()-]+(?:\([^;]*\)| (?:[-+*/|&]?=) [^;]*);$")
UNTOUCHED = re.compile(r"^\s*(//|#|\*|using |namespace |static_assert|assert|template|})|assert\(")


@dataclasses.dataclass
class Mutant:
    part: Part
    file: str
    line: int  # from 1
    before: str
    after: str

    def key(self):
        return f"{self.file}: {self.before.strip()} -> {self.after.strip() or '(left out)'}"


def changes(line):
    """The lines that one fault makes of this one."""
    code = re.sub(r'"[^"]*"', lambda text: "_" * len(text[0]), line).split("//")[0]  # words are no code
    if UNTOUCHED.search(line):
        return
    for found in re.finditer(r" [-+*/<>=!&|]{1,2} ", code):
        for other in SWAPS.get(found[0], []):
            yield line[:found.start()] + other + line[found.end():]
    if "template" not in code:
        for found in NUMBER.finditer(code):
            if re.search(r"<[^<>]*$", code[:found.start()]) and ">" in code[found.end():]:
                continue  # a template's argument
            value = found[1]
            other = {"0": "1", "1": "2", "1.": "2.", "0.": "1."}.get(value, f"(1.5 * {value})" if "." in value or "e" in value
                                                                    else f"({value} + 1)")
            yield line[:found.start()] + other + line[found.end():]
    for found in SIGN.finditer(code):
        yield line[:found.start()] + line[found.end():]
    if STATEMENT.match(code.rstrip()):
        yield ""


def mutantsOf(part):
    for file in part.sources:
        lines = (ROOT / file).read_text().splitlines()
        for number, line in enumerate(lines, 1):
            for changed in changes(line):
                yield Mutant(part, file, number, line, changed)


class Bench:
    """Compiles, links and tests in BUILD."""

    def __init__(self, build, folder):
        self.build, self.folder = build, folder
        self.commands = json.loads((build / "compile_commands.json").read_text())

    def compiled(self, target, source, overlay, out):
        entry = next(e for e in self.commands if f"/{target}.dir/" in e["command"] and "_cxx.cxx.o" in e["command"])
        words, keep = shlex.split(entry["command"]), []
        skip = False
        for word in words:
            if skip or word in ("ccache", "-c", "-MD") or word.endswith("_cxx.cxx"):
                skip = False
            elif word in ("-o", "-MT", "-MF"):
                skip = True
            else:
                keep.append("-O1" if word in ("-O2", "-O3") else word)
        at = next(k for k, word in enumerate(keep) if word.startswith("-I"))
        place = overlay / source if (overlay / source).exists() else ROOT / source
        keep[at:at] = [f"-I{overlay}"]
        # The order of -include and -I must not part the precompiled header from its source.
        done = subprocess.run([*keep, "-w", "-c", str(place), "-o", str(out)], cwd=entry["directory"], capture_output=True)
        return done.returncode == 0

    def linked(self, test, objects, out):
        name = pathlib.Path(test).name
        lines = subprocess.run(["ninja", "-t", "commands", name], cwd=self.build, capture_output=True, text=True).stdout
        link = next(line for line in reversed(lines.splitlines()) if f"-o tests/{test} " in line)
        words = shlex.split(re.search(r": && (.*?) && ", link)[1])
        words[words.index("-o") + 1] = str(out)
        words[1:1] = [*map(str, objects), "-Wl,-z,muldefs"]
        done = subprocess.run(words, cwd=self.build, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stderr[-2000:])

    def passes(self, program, filter_, seconds):
        """Returns True if all tests pass within `seconds` of processor time."""
        limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        done = subprocess.run([str(program), f"--gtest_filter={filter_}", "--gtest_fail_fast", "--gtest_brief=1"],
                              cwd=self.folder, capture_output=True, text=True, errors="replace", preexec_fn=limit)
        failed = re.search(r"FAILED\s+\] (\S+)", done.stdout)
        return done.returncode == 0, failed[1] if failed else f"exit code {done.returncode}"

    def objects(self, part, file, overlay):
        out = []
        for k, source in enumerate(part.sources[file]):
            out.append(self.folder / f"mutant{k}.o")
            if not self.compiled(part.target, source, overlay, out[-1]):
                return None
        return out


def outcome(bench, mutant, seconds):
    overlay = bench.folder / "overlay"
    place = overlay / mutant.file
    place.parent.mkdir(parents=True, exist_ok=True)
    lines = (ROOT / mutant.file).read_text().splitlines()
    assert lines[mutant.line - 1] == mutant.before
    lines[mutant.line - 1] = mutant.after
    place.write_text("\n".join(lines) + "\n")
    try:
        objects = bench.objects(mutant.part, mutant.file, overlay)
        if objects is None:
            return "not compiled", ""
        for test, filter_ in mutant.part.tests:
            program = bench.folder / "test"
            bench.linked(test, objects, program)
            passed, how = bench.passes(program, filter_, seconds)
            if not passed:
                return "killed", how
        return "survived", ""
    finally:
        place.unlink()


def equivalents():
    path = pathlib.Path(__file__).with_name("equivalent.txt")
    lines = path.read_text().splitlines() if path.exists() else []
    return {line.split(" # ")[0].strip() for line in lines if " -> " in line}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=20, help="mutants of each part that compile")
    parser.add_argument("--parts", default=",".join(part.name for part in PARTS))
    parser.add_argument("--seconds", type=int, default=120, help="processor time of a test run, after which it hangs")
    parser.add_argument("--list", action="store_true", help="only say how many there are")
    options = parser.parse_args()
    known = equivalents()
    short = False
    with tempfile.TemporaryDirectory(prefix="tubeplan-mutants-") as name:
        bench = Bench(options.build.resolve(), pathlib.Path(name))
        for part in (part for part in PARTS if part.name in options.parts.split(",")):
            every = list(mutantsOf(part))
            if options.list:
                print(f"{part.name}: {len(every)} mutants of {len(part.sources)} files")
                continue
            same = next(iter(part.sources))
            first = (ROOT / same).read_text().splitlines()[0]
            if outcome(bench, Mutant(part, same, 1, first, first), options.seconds)[0] != "survived":
                sys.exit(f"{part.name}: the tests fail without a mutant")
            random.Random(f"{options.seed} {part.name}").shuffle(every)
            killed = tried = equivalent = 0
            for mutant in every:
                if tried == options.count:
                    break
                if mutant.key() in known:
                    equivalent += 1
                    continue
                result, how = outcome(bench, mutant, options.seconds)
                if result == "not compiled":
                    continue
                tried += 1
                killed += result == "killed"
                print(f"{part.name} {tried}/{options.count} {result} {mutant.file}:{mutant.line} "
                      f"{mutant.before.strip()} -> {mutant.after.strip() or '(left out)'} {how}", flush=True)
            print(f"== {part.name}: {killed} of {tried} killed, {equivalent} known to be equivalent passed over, "
                  f"of {len(every)}", flush=True)
            short = short or killed < GOAL * tried
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
