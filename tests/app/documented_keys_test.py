"""documented_keys_test.py TUBEPLAN SOURCE: docs/files.md names the keys that the commands write, and the CSV and
Markdown output of the commands holds all figures."""
import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
CELLS = SOURCE / "app/cells"
COMMON = {"version", "inputs", "units", "checks", "missing_columns"}


def documented():
    """Returns the documented keys of every command, without the nested keys in parentheses."""
    section = (SOURCE / "docs/files.md").read_text().split("## JSON of the commands")[1].split("\n## ")[0]
    rows = {}
    for names, words in re.findall(r"^\| (`.*?) \| (.*) \|$", section, re.M):
        keys = set(re.findall(r"`(\w+)`", re.sub(r"\([^()]*\)", "", words)))
        for name in re.findall(r"`(\w+)`", names):
            rows[name] = keys
    return rows


def is_plain(value):
    return all(map(is_plain, value)) if isinstance(value, list) else not (isinstance(value, dict) and value)


def leaves(value, path=()):
    """Returns the paths of all figures of a document; a list of plain values counts as one figure."""
    if is_plain(value):
        return [path]
    inner = value.items() if isinstance(value, dict) else enumerate(value)
    return [leaf for key, one in inner for leaf in leaves(one, (*path, key))]


def in_markdown(text):
    """Returns the keys of the first table, and (list, number of rows, column) for each column of the other tables."""
    first, *others = re.split(r"^## ", text, flags=re.M)
    cells = [re.split(r"(?<!\\) ?\| ?", line)[1:-1] for line in first.splitlines()[2:] if line]
    keys = {row[0] for row in cells}
    for other in others:
        name, _, heading, _, *rows = other.rstrip().splitlines()
        columns = [re.sub(r" \[[^]]*\]$", "", cell) for cell in re.split(r" ?\| ?", heading)[1:-1]]
        keys.update((name, len(rows), column) for column in columns)
    return keys


class DocumentedKeys(unittest.TestCase):
    def expect_all(self, figures, as_csv, as_markdown):
        keys = {row["key"] for row in csv.DictReader(io.StringIO(as_csv))}
        tables = in_markdown(as_markdown)
        for leaf in leaves(figures):
            self.assertIn("/".join(map(str, leaf)), keys)
            place = next((k for k, part in enumerate(leaf) if isinstance(part, int)), None)
            if place is None:
                self.assertIn("/".join(leaf), tables)
                continue
            name, column = "/".join(leaf[:place]), "/".join(map(str, leaf[place + 1:]))
            self.assertTrue(any(t[0] == name and t[1] > leaf[place] and t[2] == column for t in tables if len(t) == 3), leaf)

    def test_every_key_that_is_written_is_named(self):
        rows = documented()
        with tempfile.TemporaryDirectory() as folder:
            def run(words):
                return subprocess.run([PROGRAM, *words.split()], cwd=folder, capture_output=True, text=True, timeout=240,
                                      check=False).stdout

            bench, mockup = CELLS / "bench.yaml", CELLS / "mockup.yaml"
            run(f"simulate {bench} --design bench --readings 40 --seed 7 --spread 0.1 --hide hysteresis@theta4:0.06deg --out s")
            run(f"plan {mockup} --truth {CELLS / 'mockup-true.yaml'} --touches auto --tubes spread:5 --out p")
            asked = [f"pose {bench} --joints=10,20,30,40", f"map {mockup}", f"calibrate {mockup} p/touches.csv",
                     f"identify {bench} s/measurements.csv", f"compare {bench} s/measurements.csv",
                     f"diagnose {bench} s/measurements.csv", f"ladder s/measurements.csv {bench}",
                     f"improve {bench} s/measurements.csv --out better.yaml",
                     f"touches {mockup} --tubes spread:12 --candidates 14", f"sensitivity {mockup} --tubes spread:5",
                     f"score {mockup} --truth {mockup} --tubes spread:5", f"score {mockup} --truth {mockup} --runs 2",
                     f"campaign {mockup} --runs 3", f"campaign {mockup} --kind outage --runs 2 --tubes spread:40 --visits 20", f"verify {mockup} p", f"effects {bench}"]
            seen = {}
            for words in asked:
                command = words.split()[0]
                as_csv = run(words + " --json figures.json --format csv")
                document = json.loads((pathlib.Path(folder) / "figures.json").read_text())
                figures = set(document)
                with self.subTest(words):
                    self.expect_all(document, as_csv, run(words + " --format markdown"))
                    self.assertEqual(figures - rows[command] - COMMON, set(), "written and not named")
                seen.setdefault(command, set()).update(figures)
            self.assertEqual(set(rows), set(seen))
            # Two commands that share a row each write only some of its keys; some keys of a diagnosis depend on the
            # verdict.
            shared = {"calibrate": {"model_error"}, "ladder": {"end", "steps"}, "improve": {"step_table"}, "touches": {"parameters"},
                      "diagnose": {"remainder", "run_sheet", "splitting", "warnings", "reason", "verdict_words"}}
            for command, keys in seen.items():
                self.assertEqual(rows[command] - keys - shared.get(command, set()), set(), f"{command}: named and not written")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
