#!/usr/bin/env python3
"""header_comments.py FOLDER: fails if Doxygen (docs/Doxyfile) cannot parse a comment in a header of the tree."""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])

with tempfile.TemporaryDirectory() as folder:
    settings = (ROOT / "docs/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {folder}\n"
    run = subprocess.run(["doxygen", "-"], input=settings, cwd=ROOT, capture_output=True, text=True)
    if not pathlib.Path(folder, "xml/index.xml").exists():
        sys.exit(run.stderr or "doxygen has written no index")

# Doxygen reads an inline function once per file that includes it, so equal warnings are printed only once.
for line in sorted(set(run.stderr.splitlines())):
    print(re.sub(r"^" + re.escape(f"{ROOT.resolve()}/"), "", line))
sys.exit(run.returncode)
