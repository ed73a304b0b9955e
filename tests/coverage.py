"""coverage.py BUILD: prints a table of the lines, branches (each direction counts once) and functions of every folder that
the tests have executed. The tests must be built with `-fcoverage-mapping` (the coverage preset) and must have written their
profiles to BUILD/profiles. The files with the most branches never taken are listed below the table."""
import collections
import json
import pathlib
import subprocess
import sys

FOLDERS = ("tubesheets", "deflection", "calibration", "planner", "app")
KINDS = ("lines", "branches", "functions")
LISTED = 20


def programs(build):
    """Returns the executables that the tests run: their own and the program."""
    found = [path for path in (build / "tests").rglob("*_test") if path.is_file()]
    return [str(path) for path in sorted(found) + [build / "tubeplan"] if path.exists()]


def summaries(build):
    """Returns llvm-cov's counts for every file."""
    profile = build / "coverage.profdata"
    profiles = sorted(map(str, (build / "profiles").glob("*.profraw")))
    if not profiles:
        sys.exit(f"{build}/profiles is empty: no test has run, or not by `make coverage`")
    subprocess.run(["llvm-profdata-16", "merge", "-sparse", "-o", profile, *profiles], check=True)
    first, *others = programs(build)
    objects = [word for path in others for word in ("-object", path)]
    words = ["llvm-cov-16", "export", "-summary-only", f"-instr-profile={profile}", first, *objects]
    return json.loads(subprocess.run(words, check=True, stdout=subprocess.PIPE).stdout)["data"][0]["files"]


def name_of(filename, root):
    """Returns the path of a source file relative to the root, for any path given to the compiler; empty for other files."""
    parts = pathlib.Path(filename).parts
    for first in range(len(parts)):
        if parts[first] in FOLDERS and root.joinpath(*parts[first:]).is_file():
            return "/".join(parts[first:])
    return ""


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    root = build.parent
    sums = {folder: collections.Counter() for folder in (*FOLDERS, "all")}
    missed = []
    for file in summaries(build):
        name = name_of(file["filename"], root)
        if not name:
            continue
        folder = name.split("/")[0]
        for kind in KINDS:
            for part in ("count", "covered"):
                for total in (sums[folder], sums["all"]):
                    total[kind, part] += file["summary"][kind][part]
        branches = file["summary"]["branches"]
        missed.append((branches["count"] - branches["covered"], branches["count"], name))
    print("| folder | " + " | ".join(KINDS) + " |\n|" + "---|" * (1 + len(KINDS)))
    for folder, total in sums.items():
        cells = [f"{100 * total[kind, 'covered'] / max(1, total[kind, 'count']):.1f} % of {total[kind, 'count']:,}" for kind in KINDS]
        print(f"| {folder} | " + " | ".join(cells) + " |")
    print("\nbranches never taken, files with the most:")
    for count, whole, name in sorted(missed, reverse=True)[:LISTED]:
        print(f"  {count:4} of {whole:4}  {name}")


if __name__ == "__main__":
    main()
