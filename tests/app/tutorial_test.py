"""tutorial_test.py TUBEPLAN SOURCE DOCUMENT: the console blocks of a document of docs/ run as written and print what they
show.

Numbers may differ between machines by one unit of their last digit or by 0.2 %: but for that, a shown line must begin a
printed line. A command whose block shows an error or a negative answer must end with its exit code.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


NUMBER = re.compile(r"(?<![\w.])[+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?!\w|\.\d)")


def parts(line):
    """Returns the words of a line with # in place of its numbers, and the numbers as they are written."""
    line = line.removesuffix("...").rstrip()
    return " ".join(NUMBER.sub("#", line).split()), NUMBER.findall(line)


def equal(shown, printed):
    digits = len(shown.partition(".")[2]) if "e" not in shown else 12
    return abs(float(shown) - float(printed)) <= max(1.01 * 10.0 ** -digits, 0.002 * abs(float(printed)))


def begins(shown, printed):
    (words, numbers), (all_words, all_numbers) = parts(shown), parts(printed)
    return all_words.startswith(words) and all(map(equal, numbers, all_numbers))


def commands(text):
    """Returns [(command, lines shown as its output)] for the console blocks, in order."""
    found = []
    for block in re.findall(r"^```console\n(.*?)^```", text, re.S | re.M):
        for line in block.splitlines():
            if line.startswith("$ "):
                found.append((line[2:], []))
            elif line.startswith("> "):  # continues the command, such as the lines of a file
                found[-1] = (found[-1][0] + "\n" + line[2:], [])
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
                    printed = (done.stdout + done.stderr).splitlines()
                    for line in lines:
                        self.assertTrue(any(begins(line, one) for one in printed), f"{line}\nis not in\n{done.stdout}")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
