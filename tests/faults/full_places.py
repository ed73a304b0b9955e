#!/usr/bin/env python3
"""full_places.py TUBEPLAN CELLS-FOLDER: runs commands that write to a full disk, a read-only folder, a full standard
output and a pipe without a reader. Each must print a reason, return a documented exit code and leave no partial file.

The full disk is a small file system in memory, mounted in a private namespace. If mounting is not permitted, the script
says so and exits with 77.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import cases

SMALL = "16k"
BAD_INPUT = 2
LONG_TEXTS = ["map cells/mockup.yaml --json -", "man", "effects", "--help", "readings cells/bench.yaml made/measurements.csv"]


def problems_of(what, done, folder=None, is_quiet_done=False):
    told = done.stderr.decode(errors="replace")
    if is_quiet_done and done.returncode == 0:
        return []
    found = []
    if done.returncode != BAD_INPUT:
        found.append(f"exit code {done.returncode}")
    if not told.startswith("tubeplan: ") or told.count("\n") != 1:
        found.append(f"says {told!r}")
    if folder and (left := [path.name for path in folder.rglob("*")]):
        found.append(f"left {left}")
    return [f"{what}: {problem}" for problem in found]


def with_outputs_in(case, place):
    return [word.replace("new", f"{place}/new", 1) if word.startswith("new") else word for word in case.words]


def on_full_disk(program, folder, place):
    """Runs the cases on a full disk and returns the problems."""
    found = []
    for case in cases.CASES:
        if case.name not in ("show",):
            done = subprocess.run([program, *with_outputs_in(case, place)], cwd=folder, capture_output=True)
            left = [path for path in place.rglob("*") if path.name != "filler"]
            found += problems_of(f"{case.name} on a full disk", done)
            found += [f"{case.name} on a full disk: left {path}" for path in left]
    return found


def in_locked_folder(program, folder, place):
    """Runs the cases as the user `nobody`, who may only read the folder, and returns the problems."""
    found = []
    for case in cases.CASES:
        done = subprocess.run([program, *with_outputs_in(case, place)], cwd=folder, capture_output=True, user=65534,
                              env={"HOME": "/nonexistent", "PATH": "/usr/bin:/bin"})
        found += problems_of(f"{case.name} into a locked folder", done, place)
    return found


def to_bad_output(program, folder):
    found = []
    for text in LONG_TEXTS:
        with open("/dev/full", "wb") as full:
            done = subprocess.run([program, *text.split()], cwd=folder, stdout=full, stderr=subprocess.PIPE)
        found += problems_of(f"{text} > /dev/full", done)
        unread, written = os.pipe()
        os.close(unread)
        done = subprocess.run([program, *text.split()], cwd=folder, stdout=written, stderr=subprocess.PIPE)
        os.close(written)
        found += problems_of(f"{text} into a closed pipe", done)
    return found


def mounted(name):
    """Runs this script again in a separate mount namespace; returns True in that run, False if it is not permitted."""
    if os.environ.get("FULL_PLACES_MOUNTED") or os.geteuid() != 0:
        return bool(os.environ.get("FULL_PLACES_MOUNTED"))
    if subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode != 0:
        return False
    os.environ["FULL_PLACES_MOUNTED"] = "1"
    os.execvp("unshare", ["unshare", "-m", sys.executable, *name])


def main():
    if not mounted(sys.argv):
        print("skipped: only root may mount a small disk (unshare -m)")
        return 77
    program, cells = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory(prefix="tubeplan-places-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        cases.Inputs(program, cells, folder)
        found = to_bad_output(program, folder)
        for place, check in (("disk", on_full_disk), ("locked", in_locked_folder)):
            (folder / place).mkdir(mode=0o755)
            if place == "disk":
                subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={SMALL}", "tmpfs", str(folder / place)], check=True)
                try:
                    (folder / place / "filler").write_bytes(bytes(1 << 20))
                except OSError:
                    pass  # the disk is full now
            found += check(program, folder, folder / place)
        subprocess.run(["umount", str(folder / "disk")], check=True)
    print("\n".join(found) or "all refused as they should be")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
