#!/usr/bin/env python3
"""every_source.py FOLDER: fails if a C++ source of the tree is named in no CMakeLists.txt, that is, never built."""
import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1])
FOLDERS = ["tubesheets", "deflection", "calibration", "planner", "app", "studies", "tests"]


def files(pattern):
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob(pattern)):
            if "node_modules" not in path.parts:
                yield path


named = set()
for listing in [ROOT / "CMakeLists.txt", *files("CMakeLists.txt")]:
    named |= set(re.findall(r"[\w-]+", listing.read_text()))
forgotten = [str(path.relative_to(ROOT)) for path in files("*.cpp") if path.stem not in named]
for path in forgotten:
    print(f"{path}: no CMakeLists.txt names it")
sys.exit(bool(forgotten))
