"""outage_document_test.py TUBEPLAN SOURCE: every command of docs/outage.md ends with 0, one after the other in one folder,
and leaves a job whose totals balance."""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

PROGRAM, SOURCE = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()


def run(words, folder):
    done = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True, timeout=400)
    if done.returncode != 0:
        sys.exit(f"{shlex.join(words)}: {done.returncode} {done.stdout[-500:]} {done.stderr}")
    return done.stdout


def main():
    commands = re.findall(r"^    tubeplan (.*)$", (SOURCE / "docs/outage.md").read_text(), re.M)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(SOURCE / "app/cells", folder / "app/cells")
        cell = str(folder / "app/cells/mockup.yaml")
        # The cell and the readings that the commands name: a calibrated cell, and its own touches as visits.
        run(["plan", cell, "--truth", cell, "--touches", "auto", "--tubes", "R10C40", "--out", "p"], folder)
        shutil.copy(folder / "p/touches.csv", folder / "visits.csv")
        for file in (folder / "p").glob("*.yaml"):
            shutil.copy(file, folder / ("calibrated.yaml" if file.name == "cell.yaml" else file.name))
        text = (folder / "p/cell.yaml").read_text()
        (folder / "calibrated.yaml").write_text(re.sub(r'^arm: .*$', f'arm: "{folder / "app/cells/cobra-arm.yaml"}"', text, flags=re.M))
        for command in commands:
            run(shlex.split(command), folder)
        total = json.loads(run(["job", "status", "spring.job", "--json", "-"], folder))["total"]
        if total["done"] != 1 or total["planned"] != total["done"] + total["excluded"] + total["unresolved"]:
            sys.exit(f"the totals do not balance: {total}")
    print(f"{len(commands)} commands of docs/outage.md")


if __name__ == "__main__":
    main()
