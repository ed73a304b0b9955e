#!/usr/bin/env python3
"""make_site.py TUBEPLAN OUT: the documents, every command's help, the catalogue of effects and the libraries'
headers as a site in OUT/html.

The texts about the commands come from the program itself, so they cannot differ from it. Warnings of Sphinx are
errors.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import urllib.parse
import urllib.request

from reference import reference_pages

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DOCS, CELL = SOURCE / "docs", SOURCE / "app/cells/bench.yaml"
NOTEBOOKS = ["missing_effect", "calibrated_arm", "planned_tour"]
PAGES = ["tutorial", "recipes", "files", "workbench", "planning", "campaign", "python", *NOTEBOOKS, "trust", "limits", "design", "kernel", "blind_trial", "benchmarks",
         "workbench_api", "glossary"]
CONF = """project = "Tubeplan"
extensions = ["myst_parser"]
html_theme = "sphinx_rtd_theme"
myst_heading_anchors = 3
suppress_warnings = ["misc.highlighting_failure"]
html_static_path = ["static"]
html_css_files = ["tables.css"]
"""
# The theme neither breaks the lines of cells nor uses a wide window.
STYLE = """.wy-table-responsive table td, .wy-table-responsive table th {white-space: normal; vertical-align: top}
.wy-nav-content {max-width: 1200px}
"""


def said(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def command_names(program):
    return re.findall(r"^  (\w+) {2,}\S", said(program, "--help"), re.M)


def commands_page(program):
    parts = ["# Commands\n"]
    for name in command_names(program):
        parts.append(f"## {name}\n```text\n{said(program, name, '--help').strip()}\n```\n")
    return "\n".join(parts)


class Server:
    """The workbench, asked for what it draws of each effect."""

    def __init__(self, program, state):
        self.process = subprocess.Popen([program, "serve", str(CELL), "--port", "0", "--state", str(state)], stdout=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()

    def signature(self, effect, at):
        query = urllib.parse.urlencode({"effect": effect, "at": at})
        with urllib.request.urlopen(f"{self.address}api/signature?{query}", timeout=60) as answer:
            return json.load(answer)

    def stop(self):
        self.process.terminate()
        self.process.wait(10)


def picture(signature):
    """The shift of the tip over what it follows, as SVG."""
    xs, ys = signature["values"], signature["shift"]
    points = [(x, y) for x, y in zip(xs, ys) if y is not None]
    if len(points) < 2:
        return None
    width, height, pad = 420, 150, 28
    low, high = min(y for _, y in points), max(y for _, y in points)
    low, high = min(low, 0), max(high, 0)
    left, right = min(xs), max(xs)

    def at(x, y):
        return (pad + (width - 2 * pad) * (x - left) / (right - left or 1), height - pad - (height - 2 * pad) * (y - low) / (high - low or 1))

    line = " ".join(f"{a:.1f},{b:.1f}" for a, b in (at(*point) for point in points))
    zero = at(left, 0)[1]
    unit = signature["unit"]
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" font-family="sans-serif" font-size="11">'
            f'<rect width="{width}" height="{height}" fill="white"/>'
            f'<line x1="{pad}" x2="{width - pad}" y1="{zero:.1f}" y2="{zero:.1f}" stroke="#bbb"/>'
            f'<polyline points="{line}" fill="none" stroke="#1f5fa8" stroke-width="2"/>'
            f'<text x="{pad}" y="14">tip: {low:.3g} to {high:.3g} {signature["shift_unit"]}</text>'
            f'<text x="{width - pad}" y="{height - 8}" text-anchor="end">{signature["variable"]}: {left:.3g} to {right:.3g} {unit}</text></svg>\n')


def effects_page(program, out):
    entries = json.loads(said(program, "effects", str(CELL), "--json", "-"))["effects"]
    kinds = {}
    for entry in entries:
        kinds.setdefault(entry["effect"], []).append(entry)
    server = Server(program, out / "state")
    parts = ["# Effects\nOf the catalogue, those that the shipped bench's arm can have; pictures of half the usual size at the first place named.\n"]
    try:
        for name, places in kinds.items():
            first = places[0]
            numbers = "".join(f"| {p['name']} | {p['unit']} | {p['neutral']:g} | {p['plausible']:.3g} |\n" if p.get("plausible") is not None else
                              f"| {p['name']} | {p['unit']} | {p['neutral']:g} | |\n" for p in first["parameters"])
            parts.append(f"## {name}\n`{first['law']}`\n\nValid: {first['validity']}. Source: {first['source']}.\n\n"
                         f"| number | unit | neutral | usually up to |\n|---|---|---|---|\n{numbers}\nAt: {', '.join(p['at'] for p in places)}.\n")
            drawn = picture(server.signature(name, first["at"]))
            if drawn:
                (out / "source" / f"effect-{name}.svg").write_text(drawn)
                parts.append(f"![What {name} at {first['at']} does to the tip](effect-{name}.svg)\n")
    finally:
        server.stop()
    return "\n".join(parts)


def run_notebooks(program, out):
    """The notebooks run where they were written for, beside app/cells, as Markdown with what they printed and drew."""
    place = out / "notebook"
    place.mkdir()
    (place / "app").symlink_to(SOURCE / "app")
    for name in NOTEBOOKS:
        shutil.copy(DOCS / f"{name}.ipynb", place)
    folder = pathlib.Path(program).parent
    environment = dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}", PYTHONPATH=str(folder / "python"))
    subprocess.run(["jupyter-nbconvert", "--log-level=ERROR", "--to", "markdown", "--execute", "--output-dir", str(out / "source"),
                    *(f"{name}.ipynb" for name in NOTEBOOKS)],
                   cwd=place, env=environment, check=True)


def index_page(references):
    readme = (SOURCE / "README.md").read_text()
    readme = re.sub(r"\]\(docs/([^)]*)\)", r"](\1)", readme)
    readme = re.sub(r"\[([^\]]*)\]\((?!https?:|[\w-]+\.(?:md|png|svg))[^)]*\)", r"\1", readme)
    readme = re.sub(r"\[((?:CONTRIBUTING|CHANGELOG)\.md)\]\(\1\)", r"\1", readme)
    listed = "\n".join(["commands", "effects", *PAGES, *references])
    return f"{readme}\n```{{toctree}}\n:hidden:\n:maxdepth: 2\n\n{listed}\n```\n"


def main():
    program, out = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    source = out / "source"
    shutil.rmtree(out, ignore_errors=True)
    source.mkdir(parents=True)
    for file in [*DOCS.glob("*.png"), *DOCS.glob("*.json")]:
        shutil.copy(file, source)
    shutil.copytree(DOCS / "diagrams", source / "diagrams", ignore=shutil.ignore_patterns("*.dot", "*.py"))
    run_notebooks(program, out)
    for name in PAGES:
        if name in NOTEBOOKS:
            continue
        shutil.copy(DOCS / f"{name}.md", source)
    references = reference_pages(SOURCE)
    for name, text in references.items():
        (source / f"{name}.md").write_text(text)
    (source / "index.md").write_text(index_page(references))
    (source / "commands.md").write_text(commands_page(program))
    (source / "effects.md").write_text(effects_page(program, out))
    (source / "conf.py").write_text(CONF)
    (source / "static").mkdir()
    (source / "static/tables.css").write_text(STYLE)
    began = time.monotonic()
    subprocess.run(["sphinx-build", "-q", "-W", "--keep-going", "-b", "html", source, out / "html"], check=True)
    print(f"{out / 'html/index.html'}: {len(list((out / 'html').glob('*.html')))} pages in {time.monotonic() - began:.0f} s")


if __name__ == "__main__":
    main()
