#!/usr/bin/env python3
"""failing_calls.py TUBEPLAN CELLS-FOLDER LIBRARY [--kinds write,rename] [--commands plan,add] [--memory 8] [--most
0]

Runs each command that writes files once for every call of a kind; in each run the preloaded LIBRARY makes another
call fail. Calls of kind thread-memory are allocations by threads other than the first. After each run, the exit
code must be a documented one with a message, every output must be entirely old or entirely new, files that belong
together must be all old or all new, and nothing else may be left in the folder. Allocations are too many to try
all: --memory limits them for each command (0 if there is no limit). `--kinds order` instead checks that every
renamed file was synchronised to disk before the rename, and its folder after it.
"""
import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import cases

DISK = ["open", "write", "short-write", "fsync", "close", "rename", "mkdir"]
FAILED = {2, 3}  # exit codes: 2 for bad input, including a path that cannot be written; 3 for failures such as memory
MADE_AT = re.compile(rb"\d{4}-\d\d-\d\d \d\d:\d\d UTC")
SECONDS = 60  # time [s] after which a run is considered hung; alone, a run takes less than 1 s


class Run:
    """One run of a case in a separate folder, with or without old output files."""

    def __init__(self, options, case, inputs, over_old, environment=()):
        with tempfile.TemporaryDirectory(prefix="tubeplan-faults-") as name:
            folder = pathlib.Path(name)
            notes = folder.with_suffix(".notes")
            tally = folder.with_suffix(".tally")
            case.prepare(folder, inputs, over_old)
            before = {path for path in folder.rglob("*")}
            variables = {"LD_PRELOAD": str(options.library), "FAULT_TALLY": str(tally), **dict(environment)}
            if variables.get("FAULT_KIND") == "order":
                variables["FAULT_NOTES"] = str(notes)
            self.code, self.told = self.outcome([str(options.tubeplan), *case.words], folder, variables)
            self.calls = int(tally.read_text().split()[-1]) if tally.exists() else None
            self.notes = notes.read_text().splitlines() if notes.exists() else []
            for path in (notes, tally):
                path.unlink(missing_ok=True)
            self.outputs = {output: self.content(folder / output) for output in case.outputs}
            there = {path for path in folder.rglob("*")} - before
            kept = {folder / name for name in case.keeps} & there
            named = {folder / output for output in case.outputs} | kept
            made = {parent for path in named & there for parent in path.parents}
            self.left = sorted(str(path.relative_to(folder)) for path in there - named - made)

    @staticmethod
    def outcome(words, folder, variables):
        """Returns the exit code (None if the run hung) and standard error."""
        try:
            done = subprocess.run(words, cwd=folder, capture_output=True, timeout=SECONDS,
                                  env={"PATH": "/usr/bin:/bin", "HOME": str(folder), "LC_ALL": "C", **variables})
        except subprocess.TimeoutExpired:
            return None, ""
        return done.returncode, done.stderr.decode(errors="replace")

    @staticmethod
    def content(path):
        return MADE_AT.sub(b"then", path.read_bytes()) if path.exists() else None


class Check:
    """Checks runs of a case with a fault against a reference run without faults."""

    def __init__(self, options, case, inputs, over_old):
        self.options, self.case, self.inputs, self.over_old = options, case, inputs, over_old
        self.reference = Run(options, case, inputs, over_old)
        missing = [output for output, content in self.reference.outputs.items() if content is None]
        if self.reference.code != case.code or missing or self.reference.left:
            sys.exit(f"{case.name}: without a fault exit code {self.reference.code}, without {missing}, with "
                     f"{self.reference.left}: {self.reference.told}")

    def run(self, **variables):
        return Run(self.options, self.case, self.inputs, self.over_old, variables.items())

    def problems(self, run):
        found = []
        is_done = run.code == self.case.code
        if run.code is None:
            return ["hangs"]
        if not is_done and run.code not in FAILED:
            found.append(f"exit code {run.code}: {run.told.strip()[-200:] or 'nothing was said'}")
        if not is_done and not re.search(r"^tubeplan: .", run.told, re.MULTILINE):
            found.append("no word why")
        state = {output: self.state(output, content) for output, content in run.outputs.items()}
        found += [f"{output} is neither old nor new" for output, is_new in state.items() if is_new is None]
        if is_done and not all(state.values()):
            found.append("not all is new, and nothing said so")
        found += [f"{', '.join(group)}: old and new mixed" for group in self.case.groups
                  if len({state[output] for output in group}) > 1]
        if run.left:
            found.append(f"left behind: {', '.join(run.left)}")
        return found

    def state(self, output, content):
        """Returns True for new content, False for old content or a file still absent, None for other content."""
        if content == self.reference.outputs[output]:
            return True
        return False if content == (cases.OLD if self.over_old else None) else None


def places(total, most, seed):
    """Returns the numbers of the calls that fail: all, or at most `most`, half of them early and half anywhere."""
    if most == 0 or total <= most:
        return range(1, total + 1)
    rng = random.Random(seed)
    spread = {int(total ** rng.random()) for _ in range(most // 2)}
    return sorted(spread | {rng.randint(1, total) for _ in range(most - len(spread))})


def disk_faults(check, kind, from_on, options):
    """Yields faults with their problems. Every call fails once (at most --most of them); the last fault is beyond
    the last call."""
    calls = check.run(FAULT_KIND=kind).calls
    for at in [*places(calls, options.most, options.seed), calls + 1]:
        variables = {"FAULT_KIND": kind, "FAULT_AT": str(at), **({"FAULT_FROM_ON": "1"} if from_on else {})}
        run = check.run(**variables)
        is_hit = run.calls is None or run.calls >= at
        is_silent = is_hit and kind != "short-write" and run.code == check.case.code
        yield (f"{kind} {at}{' and on' if from_on else ''}",
               check.problems(run) + ["it failed, and nothing said so"] * is_silent)


def memory_faults(check, most, seed, **where):
    total = check.run(FAULT_KIND="memory", **where).calls
    for at in places(total, most, seed):
        run = check.run(FAULT_KIND="memory", FAULT_AT=str(at), **where)
        if where:
            run.left = []  # a thread that cannot start ends the program; the next run removes the files left
        yield f"memory {at} of {total}{' in threads' if where else ''}", check.problems(run)


def order_faults(check):
    """Checks that every renamed file is synchronised to disk after its last write, and its folder after the rename."""
    run = check.run(FAULT_KIND="order")
    paths, dirty, to_sync, found, renames = {}, set(), set(), [], 0
    for line in run.notes:
        verb, *words = line.split(" ")
        if verb == "open":
            paths[words[0]] = words[1]
        elif verb == "write":
            dirty.add(paths.get(words[0]))
        elif verb == "fsync":
            dirty.discard(paths.get(words[0]))
            to_sync.discard(paths.get(words[0]))
        elif verb == "rename":
            renames += 1
            if words[0] in dirty:
                found.append(f"{words[0]} is renamed before it is on the disk")
            to_sync.add(str(pathlib.PurePath(words[1]).parent))
    found += [f"the folder {folder} is not brought to the disk" for folder in to_sync]
    if renames < len(check.case.outputs):
        found.append(f"{renames} renames for {len(check.case.outputs)} files")
    yield "order of the calls", found + check.problems(run)


def faults(check, kind, options):
    if kind == "memory":
        yield from memory_faults(check, options.memory, options.seed)
    elif kind == "thread-memory":
        yield from memory_faults(check, options.memory, options.seed, FAULT_THREADS="1")
    elif kind == "order":
        yield from order_faults(check)
    else:
        yield from disk_faults(check, kind, False, options)
        if kind in ("write", "fsync"):
            yield from disk_faults(check, kind, True, options)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tubeplan", type=pathlib.Path)
    parser.add_argument("cells", type=pathlib.Path)
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("--kinds", default=",".join(DISK))
    parser.add_argument("--commands", default="", help="names of cases; else all")
    parser.add_argument("--memory", type=int, default=8)
    parser.add_argument("--most", type=int, default=0, help="calls of a kind to fail in a case; 0: every one")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.tubeplan, options.library = options.tubeplan.resolve(), options.library.resolve()
    wanted = [word for word in options.commands.split(",") if word]
    failures = runs = 0
    with tempfile.TemporaryDirectory(prefix="tubeplan-faults-inputs-") as name:
        inputs = cases.Inputs(options.tubeplan, options.cells.resolve(), pathlib.Path(name))
        for case in cases.CASES:
            if wanted and case.name not in wanted:
                continue
            for over_old in (True, False):
                check = Check(options, case, inputs, over_old)
                for kind in options.kinds.split(","):
                    for what, problems in faults(check, kind, options):
                        runs += 1
                        failures += bool(problems)
                        for problem in problems:
                            print(f"{case.name}{'' if over_old else ' into nothing'}, {what}: {problem}", flush=True)
    print(f"{runs} runs, {failures} with problems")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
