"""origin_test.py TUBEPLAN SOURCE: every result states its inputs and the version that made it; files of version 0.1
are read.

The files in `written_by_0_1` are unchanged output of tubeplan 0.1.0.
"""
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
CELLS, OLD = SOURCE / "app/cells", SOURCE / "tests/app/written_by_0_1"
VERSION = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]


class Folder(unittest.TestCase):
    def setUp(self):
        self.made = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.made.name)
        for name in CELLS.iterdir():
            (shutil.copytree if name.is_dir() else shutil.copy)(name, self.folder / name.name)
        shutil.copytree(OLD, self.folder / "old")
        shutil.copy(OLD / "measurements.csv", self.folder)

    def tearDown(self):
        self.made.cleanup()

    def run_program(self, words, code=0):
        done = subprocess.run([PROGRAM, *words.split()], cwd=self.folder, capture_output=True, text=True, timeout=240)
        self.assertEqual(done.returncode, code, f"{words}: {done.stderr}")
        return done.stdout

    def check(self, document, *files):
        self.assertEqual(document["version"], VERSION)
        stated = {entry["name"]: entry["sha256"] for entry in document["inputs"]}
        for file in files:
            path = self.folder / file
            self.assertEqual(stated.get(path.name), hashlib.sha256(path.read_bytes()).hexdigest(), file)
        self.assertEqual(len(stated), len(files), stated)


class Results(Folder):
    BENCH = ("bench.yaml", "cobra-arm.yaml")

    def of(self, words, files, code=0):
        with self.subTest(words):
            self.check(json.loads(self.run_program(words + " --json -", code)), *files)

    def test_every_command_states_its_origin(self):
        readings = (*self.BENCH, "measurements.csv")
        self.of("pose bench.yaml --joints=0,90,0,0", self.BENCH)
        self.of("map mockup.yaml", ("mockup.yaml", "cobra-arm.yaml"))
        self.of("effects bench.yaml", self.BENCH)
        self.of("arm show cobra-arm.yaml", ("cobra-arm.yaml",))
        self.of("compare bench.yaml measurements.csv", readings, 1)
        self.of("identify bench.yaml measurements.csv --out found.yaml", readings)
        self.of("diagnose bench.yaml measurements.csv", readings)
        self.of("ladder measurements.csv bench.yaml", readings)
        self.of("improve bench.yaml measurements.csv --out better.yaml", readings)
        self.of("score mockup.yaml --truth mockup-true.yaml --tubes spread:3",
                ("mockup.yaml", "cobra-arm.yaml", "mockup-true.yaml", "cobra-arm-true.yaml"))
        self.of("campaign mockup.yaml --runs 2 --holes 3 --tubes spread:6 --out many", ("mockup.yaml", "cobra-arm.yaml"))

    def test_a_name_that_is_no_text_is_no_internal_error(self):
        name = bytes(self.folder) + b"/caf\xe9.yaml"
        with open(name, "wb") as copy:
            copy.write((self.folder / "bench.yaml").read_bytes())
        done = subprocess.run([PROGRAM.encode(), b"pose", name, b"--joints=0,90,0,0", b"--json", b"-"], capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["inputs"][0]["name"], "caf?.yaml")

    def test_plans_campaigns_and_reports_state_it(self):
        cell = ("mockup.yaml", "cobra-arm.yaml")
        self.run_program("plan mockup.yaml --tubes spread:3 --out planned")
        self.check(json.loads((self.folder / "planned/plan.json").read_text()), *cell)
        self.run_program("campaign mockup.yaml --runs 2 --holes 3 --tubes spread:6 --out many")
        self.check(json.loads((self.folder / "many/campaign.json").read_text()), *cell)
        self.run_program("compare bench.yaml measurements.csv --report compared.html", 1)
        self.run_program("diagnose bench.yaml measurements.csv --report diagnosed.html")
        for page in ("planned/report.html", "many/report.html", "compared.html", "diagnosed.html"):
            with self.subTest(page):
                line = re.search(r'<p id="origin">(.*?)</p>', (self.folder / page).read_text(), re.S)[1]
                self.assertIn(f"tubeplan {VERSION} of ", line)
                self.assertIn(hashlib.sha256((self.folder / "cobra-arm.yaml").read_bytes()).hexdigest(), line)


class OldFiles(Folder):
    """Fails if a format changes without a reader for the files of version 0.1."""

    def setUp(self):
        super().setUp()
        # The files name the shipped arm relative to the folder in which they were written.
        for path in [self.folder / "old/added.yaml", self.folder / "old/truth.yaml", self.folder / "old/plan/cell.yaml"]:
            path.write_text(re.sub(r"(\.\./)+app/cells/", str(self.folder) + "/", path.read_text()))

    def test_cells_arms_and_readings(self):
        compared = json.loads(self.run_program("compare old/identified.yaml old/measurements.csv --json -"))
        self.assertEqual(compared["verdict"], "adequate")
        self.assertEqual(json.loads(self.run_program("pose old/added.yaml --joints=0,90,0,0 --json -"))["version"], VERSION)

    def test_plans(self):
        self.assertIn("3", self.run_program("verify old/plan/cell.yaml old/plan"))

    def test_projects(self):
        self.run_program("report old/bench.tubeplan --out page.html --files files")
        self.assertIn("bench", (self.folder / "page.html").read_text())

    def test_tallies_of_another_version_are_refused_in_words(self):
        self.run_program("campaign mockup.yaml --runs 2 --holes 3 --tubes spread:6 --out many")
        tally = self.folder / "many/tally.json"
        old = re.sub(r'"program","[^"]*"', '"program","0.1.0 9bc91f66361e0b69"', tally.read_text(), count=1)
        tally.write_text(re.sub(r',"question_checksum":"[^"]*"', "", old, count=1))  # 0.1 did not write this key
        done = subprocess.run([PROGRAM, *"campaign mockup.yaml --runs 4 --holes 3 --tubes spread:6 --out many --resume".split()],
                              cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("program", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
