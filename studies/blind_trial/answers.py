"""One data set diagnosed by the program: the truth, the answer, and a one-word judgement of the answer."""
from dataclasses import dataclass
import json
import subprocess
import time

QUIET = ("adequate", "inconclusive")
REFUSALS = ("unexplained", "partly-explained")  # verdicts with a residual that no known effect explains
WEAK_D, REFUSABLE_D = 8., 12.


@dataclass
class Case:
    name: str
    truth: dict
    answer: dict
    seconds: float

    @property
    def wanted(self):
        return {(part["effect"], part["at"]) for part in self.truth["hidden"] if part["effect"] != "none"}

    @property
    def kind(self):
        if not self.wanted:
            return "null"
        if any(effect.startswith("odd-") for effect, _ in self.wanted):
            return "odd"
        return ("single", "pair", "triple")[len(self.wanted) - 1]

    @property
    def verdict(self):
        return self.answer.get("verdict", "failed: no verdict")

    @property
    def alternatives(self):
        """Alternatives as sets of (effect, place); a cause equivalent to a true effect has the true effect's name."""
        return [{self.name_of(part) for part in alternative} for alternative in self.answer.get("alternatives") or []]

    def name_of(self, part):
        names = [(name.get("effect"), name.get("at")) for name in [part, *(part.get("also") or [])]]
        return next((name for name in names if name in self.wanted), names[0])

    @property
    def failed(self):
        return self.verdict.startswith("failed")

    @property
    def named(self):
        return self.verdict == "explained"

    @property
    def right(self):
        return self.named and self.alternatives == [self.wanted]

    @property
    def within(self):
        """True if the complete truth is among the alternatives of the answer."""
        return self.wanted in self.alternatives

    def likeness(self, rival="twin"):
        """Correlation of the truth with the most similar rival; a `peer` is a rival without more parameters."""
        return self.truth.get(rival, {}).get("correlation", 0.)

    @property
    def word(self):
        """One-word judgement of the answer."""
        if self.failed:
            return "failed"
        if self.kind == "null":
            return "right" if self.verdict in QUIET else "false-alarm"
        if self.kind == "odd":
            fair = self.truth["d"] < REFUSABLE_D and not self.named
            return "refused" if self.verdict in REFUSALS else "fair" if fair else "wrong"
        if self.right:
            return "right"
        if self.within:
            return "in-set"
        if self.verdict in QUIET:
            return "fair" if min(self.truth.get("d_each", [0.])) < WEAK_D else "missed"
        if self.kind == "pair" and any(part & self.wanted for part in self.alternatives):
            return "half"
        if self.verdict == "partly-explained" and any(part <= self.wanted for part in self.alternatives):
            return "half"
        return "called-unknown" if self.verdict in REFUSALS else "wrong"


def ask(program, cells, folder, timeout):
    """Returns the Case of one set; a crash, a hang or invalid JSON counts as a failed answer."""
    truth = json.loads((folder / "truth.json").read_text())
    cell = cells / ("bowl.yaml" if truth["design"] == "bowl" else "bench.yaml")
    start = time.time()
    try:
        run = subprocess.run([program, "diagnose", str(cell), str(folder / "measurements.csv"), "--json", "-"],
                             capture_output=True, text=True, timeout=timeout)
        answer = json.loads(run.stdout)
        if not isinstance(answer, dict):
            raise ValueError("the JSON is no object")
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        answer = {"verdict": f"failed: {str(error)[:60]}"}
    return Case(folder.name, truth, answer, time.time() - start)
