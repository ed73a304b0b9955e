"""recipes_test.py TUBEPLAN SOURCE: every command of docs/recipes.md runs as written and leaves the files that the
next command reads."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
INDENT = "    "


def blocks(text):
    """Returns the indented blocks of a page, each with the number of its first line."""
    found, lines, begin = [], [], 0
    for number, line in enumerate(text.splitlines() + [""], 1):
        if line.startswith(INDENT):
            begin = begin if lines else number
            lines.append(line[len(INDENT):])
        elif lines:
            found.append((begin, "\n".join(lines) + "\n"))
            lines = []
    return found


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "app").mkdir()
        (cls.folder / "app/cells").symlink_to(SOURCE / "app/cells")
        cls.environment = {**os.environ, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        cls.said = {}
        for begin, script in blocks((SOURCE / "docs/recipes.md").read_text()):
            cls.said[begin] = (script, cls.run_script(script))

    @classmethod
    def run_script(cls, script):
        return subprocess.run(["bash", "-e", "-c", script], cwd=cls.folder, env=cls.environment, capture_output=True,
                              text=True, timeout=600, check=False)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_every_command_is_done(self):
        commands = 0
        for begin, (script, done) in self.said.items():
            with self.subTest(line=begin):
                self.assertEqual(done.returncode, 0, f"docs/recipes.md:{begin}\n{script}\n{done.stdout}\n{done.stderr}")
            commands += len(re.findall(r"^tubeplan ", script, re.MULTILINE))
        text = (SOURCE / "docs/recipes.md").read_text()
        self.assertEqual(commands, len(re.findall(rf"^{INDENT}tubeplan ", text, re.MULTILINE)))
        self.assertGreaterEqual(commands, 13)

    def test_each_simulated_table_has_as_many_readings_as_were_asked_for(self):
        for begin, (script, _) in self.said.items():
            for asked, folder in re.findall(r"simulate .*--readings (\d+) .*--out (\w+)", script):
                rows = (self.folder / folder / "measurements.csv").read_text().splitlines()
                self.assertEqual(len(rows) - 1, int(asked), f"docs/recipes.md:{begin}")

    def test_a_pointing_run_becomes_readings(self):
        rows = [line.split(",") for line in (self.folder / "run.csv").read_text().splitlines()]
        self.assertEqual(rows[0], ["id", "kind", "az_deg", "el_deg", "azimuth_deg", "altitude_deg"])
        self.assertEqual([row[1] for row in rows[1:]], ["direction"] * 3)
        self.assertAlmostEqual(float(rows[1][4]), -10)
        self.assertAlmostEqual(float(rows[3][2]), 360 - 250.055)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
