"""Commands that write files, each run in a separate folder."""
import dataclasses
import pathlib
import shutil
import signal
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent.parent / "studies"))
from workbench_client import Workbench

OLD = b"arm: new-arm.yaml  # an old file, which a cell may replace\n"


class Inputs:
    """Input files of all commands, generated once."""

    def __init__(self, tubeplan, cells, folder):
        self.tubeplan, self.cells, self.folder = tubeplan, cells, folder
        shutil.copytree(cells, folder / "cells")
        shutil.copy(cells.parent.parent / "tests/app/urdf/ur5.urdf", folder)
        self.make("simulate", "cells/bench.yaml", "--design", "bench", "--readings", "40", "--hide", "backlash@tool.z", "--out", "made")
        self.make("plan", "cells/mockup.yaml", "--tubes", "spread:3", "--touches", "auto", "--truth", "cells/mockup-true.yaml",
                  "--out", "planned")
        self.save_project()

    def make(self, *words):
        subprocess.run([str(self.tubeplan), *words], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def save_project(self):
        served = Workbench(str(self.tubeplan), ["cells/bench.yaml", "made/measurements.csv"], str(self.folder))
        served.ask("api/project/save", {"file": "bench.tubeplan"})
        served.process.send_signal(signal.SIGTERM)
        served.process.wait(30)
        shutil.copy(self.folder / "cells/bench.tubeplan", self.folder)


@dataclasses.dataclass
class Case:
    name: str
    words: list
    outputs: list
    together: bool = False  # all outputs must be old or all must be new
    groups: list = dataclasses.field(default_factory=list)
    code: int = 0  # exit code of a run without a fault
    keeps: list = dataclasses.field(default_factory=list)  # files that a failed run may leave, to resume from

    def __post_init__(self):
        if self.together:
            self.groups = [self.outputs]

    def prepare(self, folder, inputs, over_old):
        for name in ("cells", "made", "planned", "ur5.urdf", "bench.tubeplan"):
            (folder / name).symlink_to(inputs.folder / name)
        for output in self.outputs if over_old else []:
            (folder / output).parent.mkdir(exist_ok=True)
            (folder / output).write_bytes(OLD)


def case(name, words, outputs, **more):
    return Case(name, words.split(), outputs.split(), **more)


ON_BENCH = "cells/bench.yaml made/measurements.csv"
CASES = [
    case("map", "map cells/mockup.yaml --csv new/holes.csv --json new.json", "new/holes.csv new.json"),
    case("simulate", "simulate cells/bench.yaml --design bench --readings 12 --out new",
         "new/measurements.csv new/truth.yaml", together=True),
    case("calibrate", "calibrate cells/mockup.yaml planned/touches.csv --out new.yaml --json new.json", "new.yaml new.json"),
    case("add", "add cells/bench.yaml backlash@tool.z --out new.yaml", "new.yaml"),
    case("identify", f"identify {ON_BENCH} --out new.yaml --json new.json",
         "new.yaml new-arm.yaml new.json", groups=[["new.yaml", "new-arm.yaml"]]),
    case("improve", f"improve {ON_BENCH} --steps 1 --out new.yaml --json new.json", "new.yaml new-arm.yaml new.json",
         groups=[["new.yaml", "new-arm.yaml"]]),
    case("compare", f"compare {ON_BENCH} --json new.json --report new.html", "new.json new.html", code=1),
    case("diagnose", f"diagnose {ON_BENCH} --effects 1 --json new.json --report new.html", "new.json new.html"),
    case("ladder", "ladder made/measurements.csv cells/bench.yaml --rigid --json new.json --report new.html", "new.json new.html"),
    case("plan", "plan cells/mockup.yaml --tubes spread:3 --out new --trajectory",
         "new/plan.json new/path.csv new/memory.json new/cell.yaml new/worklist.csv new/report.html new/trajectory.yaml", together=True,
         keeps=["new/progress.json"]),
    case("score", "score cells/mockup.yaml --truth cells/mockup-true.yaml --tubes spread:3 --json new.json", "new.json"),
    case("campaign-threads", "campaign cells/mockup.yaml --runs 8 --holes 3 --tubes spread:6 --jobs 4 --out new",
         "new/campaign.json new/holes.csv new/report.html",
         groups=[["new/campaign.json", "new/holes.csv", "new/report.html"]], keeps=["new/tally.json"]),
    case("campaign", "campaign cells/mockup.yaml --runs 40 --holes 3 --tubes spread:6 --jobs 1 --out new --json new.json",
         "new/campaign.json new/holes.csv new/report.html new.json",
         groups=[["new/campaign.json", "new/holes.csv", "new/report.html"]], keeps=["new/tally.json"]),
    case("readings", "readings cells/bench.yaml made/measurements.csv --out new.csv", "new.csv"),
    case("touches", "touches cells/mockup.yaml --tubes spread:6 --candidates 8 --csv new.csv --json new.json", "new.csv new.json"),
    case("sensitivity", "sensitivity cells/mockup.yaml --tubes spread:3 --json new.json", "new.json"),
    case("import", "arm import ur5.urdf --out new-arm.yaml --cell new.yaml", "new-arm.yaml new.yaml", together=True),
    case("export", "arm export cells/bench.yaml --out new.urdf", "new.urdf"),
    case("show", "arm show cells/cobra-arm.yaml --svg new.svg --json new.json", "new.svg new.json"),
    case("report", "report bench.tubeplan --out new.html --files new --json new.json",
         "new.html new.json new/measurements.csv new/model-0.yaml new/model-0-arm.yaml",
         groups=[["new/measurements.csv", "new/model-0.yaml", "new/model-0-arm.yaml"]]),
]
