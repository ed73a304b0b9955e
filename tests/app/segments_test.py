"""segments_test.py TUBEPLAN SOURCE: every command that reports poses asks for more `segments` if, and only if, one
element per beam is too few.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])


class Segments(unittest.TestCase):
    def setUp(self):
        self.made = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.made.name)
        for name in (SOURCE / "app/cells").iterdir():
            (shutil.copytree if name.is_dir() else shutil.copy)(name, self.folder / name.name)

    def tearDown(self):
        self.made.cleanup()

    def soften(self):
        """Gives the beams a material twenty times softer than aluminium."""
        arm = self.folder / "cobra-arm.yaml"
        arm.write_text(re.sub(r"(\bE: *)([0-9.e+]+)", lambda m: f"{m[1]}{float(m[2]) / 20:g}", arm.read_text()))

    def said(self, words):
        done = subprocess.run([PROGRAM, *words.split()], cwd=self.folder, capture_output=True, text=True, timeout=240)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return "too few segments" in done.stdout and "`segments: " in done.stdout or "too few segments" in done.stderr

    COMMANDS = ("pose mockup.yaml --joints=10,90,-20,5 --load 100",
                "plan mockup.yaml --tubes spread:12 --load 100 --out planned",
                "score mockup.yaml --truth mockup.yaml --tubes spread:12",
                "identify bench.yaml made/measurements.csv")

    def test_they_are_named_where_they_are_too_few(self):
        self.soften()
        self.said("simulate bench.yaml --design bench --readings 30 --seed 2 --out made")
        for words in self.COMMANDS:
            with self.subTest(words):
                self.assertTrue(self.said(words))

    def test_nothing_is_said_where_they_do(self):
        self.said("simulate bench.yaml --design bench --readings 30 --seed 2 --out made")
        for words in self.COMMANDS:
            with self.subTest(words):
                self.assertFalse(self.said(words))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
