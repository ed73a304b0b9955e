"""damaged_files_test.py TUBEPLAN SOURCE: damages every kind of file that the program reads in every applicable way.
Each damaged file is refused with exit code 2 and one line in the program's own words; nothing is written."""
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
CELLS, CORPUS = SOURCE / "app/cells", SOURCE / "tests/fuzz/corpus"

# Phrases of library messages, which mean nothing to the author of a file.
LIBRARY_WORDS = re.compile(r"exception|json\.|parse_error|type_error|yaml-cpp|basic_string|std::|filesystem error|"
                           r"bad conversion|internal error|invalid literal|terminate|what\(\)", re.I)
CONTROL = re.compile(rb"[\x00-\x09\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")

MEASUREMENTS = ("id,kind,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in\n"
                "a,position,0,10,90,-20,5,1,2,3,0.003\nb,position,0,20,80,-10,5,2,3,4,0.003\n"
                "c,position,0,30,70,-30,5,2,1,4,0.003\n")
TOUCHES = ("id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,sigma_in\n"
           "1,touch,R10C20,10,90,-20,5,0.01\n2,touch,R30C30,30,80,-10,5,0.01\n3,touch,R20C60,12,92,-22,7,0.01\n")
FOREIGN = ("Name;J1 [deg];J2 [deg];J3 [deg];J4 [deg];X [mm];Y [mm];Z [mm]\n"
           "P1;10;45;-35;12,5;1,5;2,5;3,5\nP2;20;45;-35;12;4;5;6\n")
STL = b"\0" * 80 + struct.pack("<I", 4) + b"".join(
    struct.pack("<12fH", 0, 0, 0, *[c for corner in face for c in corner], 0)
    for face in [((0, 0, 0), (0, 1, 0), (1, 0, 0)), ((0, 0, 0), (1, 0, 0), (0, 0, 1)),
                 ((0, 0, 0), (0, 0, 1), (0, 1, 0)), ((1, 0, 0), (0, 1, 0), (0, 0, 1))])


def fingerprint(content):
    """Returns the FNV-1a hash of the content, as in the program's checksums."""
    found = 0xcbf29ce484222325
    for byte in content:
        found = (found ^ byte) * 0x100000001b3 % 2**64
    return f"{found:016x}"


def mockup():
    return (CELLS / "mockup.yaml").read_text()


def mapped():
    return re.sub(r"layout: \{[^}]*\}", "map: file.csv\n  pitch: 1.0625", mockup())


def meshed(name):
    return re.sub(r"cylinder: \{from: \[30, 30, -50\][^}]*\}", "mesh: {file: %s, position: [30, 30, -47]}" % name, mockup())


class Kind:
    """A file, the other files that it needs, the command that reads it, and a piece of text with a replacement of
    another type."""

    def __init__(self, name, file, content, command, wrong, beside=None, is_text=True, is_sealed=False):
        self.name, self.file, self.command, self.wrong = name, file, command, wrong
        self.content = content if isinstance(content, bytes) else content.encode()
        self.beside, self.is_text, self.is_sealed = beside or {}, is_text, is_sealed

    def sealed(self, content):
        """Returns the content with a checksum that matches the altered payload: a damaged file may have a valid
        checksum."""
        if not self.is_sealed:
            return content
        head, payload = content.split(b"\n", 1)
        found = json.loads(head)
        return head.replace(found["checksum"].encode(), fingerprint(payload.rstrip(b"\n")).encode()) + b"\n" + payload

    def damages(self):
        """Returns the damaged contents of the file, keyed by the name of the damage."""
        half = len(self.content) // 2
        changed = self.content.replace(self.wrong[0].encode(), self.wrong[1].encode(), 1)
        assert changed != self.content, self.name
        found = {"empty": b"", "wrong type": self.sealed(changed)}
        if not self.is_text:
            return found | {"truncated": self.content[:half]}
        found["truncated"] = self.sealed(self.content[:half].rstrip(b"\n"))
        found["binary"] = self.content[:half] + b"\0\xff\xfe" + self.content[half:]
        found["control characters"] = self.content[:half] + b"\x1b[31m\x9b" + self.content[half:]
        return found


def yaml_kinds():
    arm = (CELLS / "cobra-arm.yaml").read_text()
    beside = {"cobra-arm.yaml": arm}
    yield Kind("cell", "file.yaml", mockup(), "map file.yaml --csv out.csv", ("pitch: 1.0625", "pitch: [a, b]"), beside)
    yield Kind("cell with an escape", "file.yaml", mockup(), "map file.yaml --csv out.csv",
               ("arm: cobra-arm.yaml", 'arm: "\\e[31m.yaml"'), beside)
    yield Kind("arm", "cobra-arm.yaml", arm, "map cell.yaml --csv out.csv", ("length: in", "length: {a: 1}"),
               {"cell.yaml": mockup()})
    yield Kind("arm with an escape", "cobra-arm.yaml", arm, "map cell.yaml --csv out.csv",
               ("name: forearm", 'name: "fore\\x1b[31marm"'), {"cell.yaml": mockup()})
    yield Kind("truth", "file.yaml", mockup(), "score cell.yaml --truth file.yaml --tubes R10C20 --json out.json",
               ("pitch: 1.0625", "pitch: x"), {"cell.yaml": mockup()} | beside)
    yield Kind("campaign", "file.yaml", (CORPUS / "campaign/bench.yaml").read_text(),
               f"simulate {CELLS}/bench.yaml --design file.yaml --out out", ("kind: ", "kind: [a] #"))


def table_kinds():
    arm = {"cobra-arm.yaml": (CELLS / "cobra-arm.yaml").read_text()}
    yield Kind("measurements", "file.csv", MEASUREMENTS, f"compare {CELLS}/bench.yaml file.csv --json out.json",
               ("20,80", "20,many"))
    yield Kind("touches", "file.csv", TOUCHES, f"calibrate {CELLS}/mockup.yaml file.csv --out out.yaml", ("30,80", "30,x"))
    yield Kind("foreign", "file.csv", FOREIGN, f"readings {CELLS}/bench.yaml file.csv --out out.csv", ("2,5", "two"))
    yield Kind("hole map", "file.csv", "row,column,x_in,y_in\n1,1,0,10\n1,2,1.0625,10\n2,1,0,11.0625\n2,2,1.0625,11.0625\n",
               "map cell.yaml --csv out.csv", ("1,2,1.0625", "1,two,1.0625"), {"cell.yaml": mapped()} | arm)
    yield Kind("work list", "file.csv", "row,column,priority\n10,20,1\n30,30,2\n20,60,3\n",
               f"plan {CELLS}/mockup.yaml --tubes file.csv --out out", ("30,30", "30,x"))


def other_kinds():
    arm = {"cobra-arm.yaml": (CELLS / "cobra-arm.yaml").read_text()}
    yield Kind("URDF", "file.urdf", (SOURCE / "tests/app/urdf/irb120.urdf").read_text(),
               "arm import file.urdf --out out.yaml", ('xyz="', 'xyz="a b c" was="'))
    yield Kind("URDF with an escape", "file.urdf", (SOURCE / "tests/app/urdf/irb120.urdf").read_text(),
               "arm import file.urdf --out out.yaml", ('<link name="', '<link name="&#27;[31m'))
    yield Kind("STL", "file.stl", STL, "map cell.yaml --csv out.csv", ("\x04\0\0\0", "\x05\0\0\0"),
               {"cell.yaml": meshed("file.stl")} | arm, is_text=False)
    yield Kind("OBJ", "file.obj", (CORPUS / "obj/tetrahedron.obj").read_bytes(), "map cell.yaml --csv out.csv",
               ("f ", "f x"), {"cell.yaml": meshed("file.obj")} | arm, is_text=False)
    plan, rest = (CORPUS / "plan/two_tubes").read_text().split("time_s,", 1)
    verify = f"verify {CELLS}/mockup.yaml p --json out.json"
    path = "time_s," + rest
    yield Kind("plan", "p/plan.json", plan, verify, ('"min_clearance": 0.', '"min_clearance": "\\u001b[31m", "was": 0.'), {"p/path.csv": path})
    yield Kind("plan with a key of another kind", "p/plan.json", plan, verify, ('"tubes": [', '"tubes": {}, "were": ['),
               {"p/path.csv": path})
    yield Kind("path", "p/path.csv", path, verify, ("\n0,1,", "\nsoon,1,"), {"p/plan.json": plan})


def kept_kinds(folder):
    """Yields the files that the program writes for its own later use."""
    subprocess.run([PROGRAM, *f"plan {CELLS}/mockup.yaml --tubes R10C20,R30C30 --out p".split()], cwd=folder, check=True,
                   capture_output=True)
    subprocess.run([PROGRAM, *f"campaign {CELLS}/mockup.yaml --runs 2 --out c".split()], cwd=folder, check=True,
                   capture_output=True)
    memory, tally = (folder / "p/memory.json").read_bytes(), (folder / "c/tally.json").read_bytes()
    yield Kind("memory", "p/memory.json", memory, f"plan {CELLS}/mockup.yaml --tubes R10C20 --from p --out out",
               ('"reach":[', '"reach":["x",'), is_sealed=True)
    yield Kind("tally", "c/tally.json", tally, f"campaign {CELLS}/mockup.yaml --runs 4 --resume --out c",
               ('"total":[', '"total":[2.5,'), is_sealed=True)
    project = (SOURCE / "tests/app/written_by_0_1/bench.tubeplan").read_bytes()
    yield Kind("project", "file.tubeplan", project, "report file.tubeplan --out out.html", ('"models":[', '"models":[7,'),
               is_sealed=True)


def contents(folder):
    return {str(path): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class DamagedFiles(unittest.TestCase):
    def refuse(self, kind, damage, content, folder):
        for name, text in {**kind.beside, kind.file: content}.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        before = contents(folder)
        done = subprocess.run([PROGRAM, *kind.command.split()], cwd=folder, capture_output=True, timeout=120, check=False)
        said = done.stderr.decode(errors="replace")
        with self.subTest(kind=kind.name, damage=damage):
            self.assertEqual(done.returncode, 2, said)
            self.assertEqual(said.count("\n"), 1, said)
            self.assertIsNone(LIBRARY_WORDS.search(said), said)
            self.assertIsNone(CONTROL.search(done.stderr + done.stdout), said)
            self.assertEqual(contents(folder), before, "something was written")

    def test_every_kind_in_every_way(self):
        with tempfile.TemporaryDirectory() as made:
            root = pathlib.Path(made)
            (root / "kept").mkdir()
            kinds = [*yaml_kinds(), *table_kinds(), *other_kinds(), *kept_kinds(root / "kept")]
            for kind in kinds:
                for damage, content in kind.damages().items():
                    shutil.rmtree(root / "tried", ignore_errors=True)
                    (root / "tried").mkdir()
                    self.refuse(kind, damage, content, root / "tried")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
