"""tutorial_test.py TUBEPLAN SOURCE DOCUMENT: the console blocks of a document of docs/ run as written and print what they
show.

Numbers may differ between machines: with all numbers treated as equal, a shown line must begin a printed line. A command
whose block shows an error or a negative answer must end with its exit code.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


def alike(line):
    line = re.sub(r"(?<![\w.])[+-]?\d[\d.]*(e[+-]?\d+)?(?!\w)", "#", line)
    return " ".join(line.removesuffix("...").split())


def commands(text):
    """Returns [(command, lines shown as its output)] for the console blocks, in order."""
    found = []
    for block in re.findall(r"^```console\n(.*?)^```", text, re.S | re.M):
        for line in block.splitlines():
            if line.startswith("$ "):
                found.append((line[2:], []))
            else:
                found[-1][1].append(line)
    return found


def code_of(command, lines):
    if any(line.startswith("tubeplan: ") for line in lines):
        return 2
    return 1 if " compare " in command or any(line.startswith("NOT confirmed") for line in lines) else 0


class Document(unittest.TestCase):
    def test_console_blocks_print_what_they_show(self):
        shown = commands((SOURCE / "docs" / sys.argv[3]).read_text())
        self.assertGreater(len(shown), 12)
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            (folder / "app").mkdir()
            (folder / "app/cells").symlink_to(SOURCE / "app/cells")
            environment = {**os.environ, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
            for command, lines in shown:
                with self.subTest(command):
                    done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, text=True,
                                          timeout=300, check=False)
                    self.assertEqual(done.returncode, code_of(command, lines), done.stdout + done.stderr)
                    printed = [alike(line) for line in (done.stdout + done.stderr).splitlines()]
                    for line in lines:
                        self.assertTrue(any(one.startswith(alike(line)) for one in printed), f"{line}\nis not in\n{done.stdout}")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
