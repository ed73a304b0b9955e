"""demo_test.py TUBEPLAN SOURCE: in `make demo`, the touches fit, no warning is given, and the predicted steps happen."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SIGMAS = 3


class Demo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name) / "demo"
        cls.made = subprocess.run(["make", "-C", SOURCE, "-o", "program", "demo", f"BUILD={PROGRAM.parent}", f"OUT={cls.out}"],
                                  capture_output=True, text=True, timeout=300, check=True)
        cls.plan = json.loads((cls.out / "plan.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_command_is_printed(self):
        for command in ("simulate", "identify", "plan"):
            self.assertIn(f"/tubeplan {command} ", self.made.stdout)

    def test_the_touches_fit_and_nothing_is_warned_of(self):
        self.assertEqual(self.plan["calibration"]["verdict"], "adequate")
        self.assertGreater(self.plan["calibration"]["p_value"], 0.01)
        self.assertEqual(self.plan["base"]["status"], "calibrated")
        self.assertEqual(self.plan["warnings"] + self.plan["calibration"]["warnings"], [])

    def test_the_steps_that_are_foretold_happen(self):
        tubes = self.plan["tubes"]
        self.assertGreater(len(tubes), 50)
        for steps, happened in enumerate(self.plan["counts"]["via_point"]):
            chances = [tube["probability_by_steps"][steps] for tube in tubes]
            sigma = sum(chance * (1 - chance) for chance in chances) ** 0.5
            self.assertLessEqual(abs(sum(chances) - happened), SIGMAS * sigma + 0.5, f"{steps} steps")

    def test_the_report_opens_on_the_answer(self):
        sentence = self.plan["sentence"]
        self.assertIn(self.plan["base"]["words"], sentence)
        self.assertIn(sentence, (self.out / "report.html").read_text())
        self.assertIn(sentence, self.made.stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
