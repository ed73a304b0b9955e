#!/usr/bin/env python3
"""stop_signals.py TUBEPLAN CELLS-FOLDER [--instants 5] [--readings 10000] [--most 1.0] [--commands plan,identify]
[--seconds 8]

Interrupts every long command, alternately by Ctrl-C and SIGTERM, at instants spread over its first --seconds. The
command must end within --most seconds, with exit code 130 (its own code if it was done before), must not change
existing files, and must leave no files except those from which the next run resumes.
"""
import argparse
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

OLD = "arm: new-arm.yaml  # an old file, which a cell may replace\n"
TELLS_SO_FAR = {"score"}  # commands that print the results of the completed runs, with status stopped
KEPT = {"new/progress.json", "new/tally.json"}
BENCH = "cells/bench.yaml made/measurements.csv"
COMMANDS = {
    "plan": "plan cells/mockup.yaml --tubes all --out new",
    "identify": f"identify {BENCH} --out new.yaml --json new.json",
    "diagnose": f"diagnose {BENCH} --json new.json --report new.html",
    "compare": f"compare {BENCH} --json new.json",
    "improve": f"improve {BENCH} --out new.yaml --json new.json",
    "ladder": "ladder made/measurements.csv cells/bench.yaml --rigid --json new.json",
    "simulate": "simulate cells/bench.yaml --design bench --readings 20000 --out new",
    "campaign": "campaign cells/mockup.yaml --runs 1000000 --out new",
    "campaign-diagnose": "campaign cells/bench.yaml --kind diagnose --runs 10000 --out new",
    "score": "score cells/mockup.yaml --truth cells/mockup-true.yaml --tubes all --runs 200 --json new.json",
    "touches": "touches cells/mockup.yaml --tubes all --candidates 2000 --json new.json --csv new.csv",
    "sensitivity": "sensitivity cells/mockup.yaml --tubes all --json new.json",
    "verify": "verify cells/mockup.yaml planned --json new.json",
    "serve": f"serve {BENCH} --port 0 --state state",
}


def outputs(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*")
            if not path.is_symlink() and path.is_file() and not str(path.relative_to(folder)).startswith("state/")}


def interrupted(program, words, inputs, after, kind):
    """Returns the exit code, the time from the signal to the end [s], and a list of problems."""
    with tempfile.TemporaryDirectory(prefix="tubeplan-stop-") as name:
        folder = pathlib.Path(name)
        for name in ("cells", "made", "planned"):
            (folder / name).symlink_to(inputs / name)
        for name in ("new.yaml", "new-arm.yaml", "new.json", "new.html", "new.csv"):
            (folder / name).write_text(OLD)
        before = outputs(folder)
        process = subprocess.Popen([str(program), *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            process.wait(after)
            return process.returncode, 0, []
        except subprocess.TimeoutExpired:
            pass
        sent = time.monotonic()
        process.send_signal(kind)
        try:
            said = process.communicate(timeout=60)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            said = process.communicate()[1]
        took = time.monotonic() - sent
        problems = [f"left {name}" for name in sorted(outputs(folder) - before - KEPT)]
        if process.returncode in (130, -kind) and words[0] not in TELLS_SO_FAR:
            problems += [f"{name} is another" for name in before if (folder / name).read_text() != OLD]
        if process.returncode in (0, 1):
            return process.returncode, 0, []  # had ended before the signal
        # Before a command starts its work, the signal's default action ends the process.
        if process.returncode not in {130, -kind}:
            problems.append(f"exit code {process.returncode}: {said.decode(errors='replace')[-300:].strip()}")
        return process.returncode, took, problems


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tubeplan", type=pathlib.Path)
    parser.add_argument("cells", type=pathlib.Path)
    parser.add_argument("--instants", type=int, default=5)
    parser.add_argument("--readings", type=int, default=10000)
    parser.add_argument("--seconds", type=float, default=8)
    parser.add_argument("--most", type=float, default=1.0)
    parser.add_argument("--commands", default=",".join(COMMANDS))
    options = parser.parse_args()
    program, failures = options.tubeplan.resolve(), 0
    with tempfile.TemporaryDirectory(prefix="tubeplan-stop-inputs-") as name:
        inputs = pathlib.Path(name)
        shutil.copytree(options.cells, inputs / "cells")
        made = ["simulate", "cells/bench.yaml", "--design", "bench", "--readings", str(options.readings), "--hide",
                "hysteresis@theta4:0.06deg", "--out", "made"]
        subprocess.run([str(program), *made], cwd=inputs, check=True, stdout=subprocess.DEVNULL)
        planned = ["plan", "cells/mockup.yaml", "--tubes", "spread:60", "--out", "planned"]
        subprocess.run([str(program), *planned], cwd=inputs, check=True, stdout=subprocess.DEVNULL)
        for command in options.commands.split(","):
            told = []
            for k in range(options.instants):
                kind = (signal.SIGINT, signal.SIGTERM)[k % 2]
                after = options.seconds * (k + 0.3) / options.instants
                code, took, problems = interrupted(program, COMMANDS[command].split(), inputs, after, kind)
                if took > options.most:
                    problems.append(f"ends after {took:.1f} s")
                failures += bool(problems)
                told.append(f"{after:.1f} s: {'done' if took == 0 else f'{took:.2f} s'} ({code}){' '.join(['', *problems])}")
            print(f"{command}: {'; '.join(told)}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
