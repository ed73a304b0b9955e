#!/usr/bin/env python3
"""skipped.py BUILD: prints why the last run of ctest skipped tests, with the number of tests for each reason."""
import collections
import pathlib
import re
import sys


def reasons(log):
    """Yields the name of every skipped test and the reason that it printed."""
    for part in re.split(r"(?m)^\d+/\d+ Test(?:ing)?: ", log)[1:]:
        if "Test Skipped" not in part and "Skipped" not in part.split("Test time")[-1] and "[  SKIPPED ]" not in part:
            continue
        name = part.split("\n", 1)[0].strip()
        said = re.search(r"Skipped\n(.+)", part) or re.search(r"(?m)^skipped: (.+)", part)
        yield name, said[1].strip().removeprefix("skipped: ") if said else "no reason given"


def main():
    log = pathlib.Path(sys.argv[1], "Testing/Temporary/LastTest.log")
    if not log.exists():
        return
    by_reason = collections.defaultdict(list)
    for name, reason in reasons(log.read_text(errors="replace")):
        by_reason[reason].append(name)
    for reason, names in sorted(by_reason.items(), key=lambda entry: -len(entry[1])):
        print(f"skipped {len(names)}: {reason} ({names[0]}{', ...' if len(names) > 1 else ''})")


if __name__ == "__main__":
    main()
