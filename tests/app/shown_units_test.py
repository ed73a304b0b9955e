"""shown_units_test.py TUBEPLAN SOURCE: the workbench shows a cell in inches and degrees, and its twin in millimetres and
radians, with the same figures at every address once the request names the units of the other. What is typed in the
units shown is taken as that."""
import contextlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.parse
import urllib.request

PROGRAM, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / 'tests'))
from twin_cells import DEGREE, LOOSE, MM, Twin, converted, converted_table, differences  # noqa: E402

CELLS, TWIN = SOURCE / 'app/cells', Twin(is_of_length_and_angle=True)
INCHES, MILLIMETRES = 'in,deg', 'mm,rad'
POSTURE = [-20.0, 150.0, -130.0, -20.0]
IN_RADIANS = [angle * DEGREE for angle in POSTURE]
JOINTS = ('theta1', 'theta2', 'theta3', 'theta4')
FOREIGN = [{'name': 'log.csv', 'text': 'Name;J1;J2;J3;J4;X;Y;Z\nP1;-20;150;-130;-20;1;2;3\nP2;-21;149;-128;-22;4;5;6\n'}]
FOREIGN_COLUMNS = [f'{joint}_deg=log.csv:J{k}' for k, joint in enumerate(JOINTS, 1)] + \
                  [f'{axis.lower()}_in=log.csv:{axis}' for axis in 'XYZ']

# The requests to each address, in order, with bodies for a page in inches and degrees and for one in millimetres and
# radians.
SAME = object()
ASKED = [
    ('GET', 'state', SAME), ('GET', 'sheet', SAME), ('GET', 'scene', SAME), ('GET', 'catalogue', SAME),
    ('GET', 'measurements', SAME), ('GET', 'moments', SAME), ('GET', 'confounding', SAME),
    ('GET', 'leverage?at=theta3,forearm.z', SAME),
    ('GET', 'signature?effect=hysteresis&at=theta4', SAME), ('GET', 'signature?effect=backlash&at=tool.z', SAME),
    ('POST', 'pose', ({'joints': POSTURE, 'load': 0, 'hole': 20}, {'joints': IN_RADIANS, 'load': 0, 'hole': 20})),
    ('POST', 'live/encoders', ({'joints': POSTURE}, {'joints': IN_RADIANS})),
    ('POST', 'inverse', ({'hole': 20},) * 2), ('POST', 'select', ({'text': 'R1-2C1-4'},) * 2),
    ('POST', 'tubes', ({'name': 'list.csv', 'text': 'row,column\n4,2\n4,5\n'},) * 2),
    ('POST', 'measurements/columns', ({'tables': FOREIGN},) * 2),
    ('POST', 'tubes/columns', ({'tables': [{'name': 'list.csv', 'text': 'Reihe,Spalte\n4,2\n'}]},) * 2),
    ('POST', 'compare', ({'ladder': True},) * 2), ('GET', 'results/compare', SAME), ('GET', 'results/ladder', SAME),
    ('POST', 'diagnose', ({'effects': 1, 'next': 2, 'seed': 1},) * 2), ('GET', 'results/diagnose', SAME),
    ('POST', 'add', ({'causes': ['hysteresis@theta4:half_width=0.05deg']},
                     {'causes': [f'hysteresis@theta4:half_width={0.05 * DEGREE!r}rad']})),
    ('GET', 'results/identify', SAME), ('GET', 'state', SAME),
    ('POST', 'reach', ({},) * 2), ('GET', 'results/reach', SAME),
    ('POST', 'field', ({'of': 'sag'},) * 2), ('GET', 'results/field', SAME),
    ('POST', 'field', ({'of': 'centring'},) * 2), ('GET', 'results/field', SAME),
    ('POST', 'touches', ({'goal': 'base', 'tubes': 'R4-4C2-9'},) * 2), ('GET', 'results/touches', SAME),
    ('POST', 'touch', ({'hole': 20},) * 2), ('POST', 'touch', ({'hole': 27},) * 2), ('POST', 'touch', ({'hole': 60},) * 2),
    ('POST', 'touch', ({'hole': 66, 'joints': POSTURE}, {'hole': 66, 'joints': IN_RADIANS})),
    ('GET', 'touches', SAME), ('DELETE', 'touch/3', SAME),
    ('POST', 'calibrate', ({},) * 2), ('GET', 'results/calibrate', SAME),
    ('POST', 'plan', ({'tubes': 'R4C2,R4C5', 'standoff': 1.5, 'insertion': 0.25, 'start': '-20,150,-130,-20', 'end': 'park'},
                      {'tubes': 'R4C2,R4C5', 'standoff': 1.5 * MM, 'insertion': 0.25 * MM,
                       'start': ','.join(map(repr, IN_RADIANS)), 'end': 'park'})),
    ('GET', 'results/plan', SAME), ('GET', 'plan/path', SAME), ('GET', 'plan/clearance?from=0&count=20', SAME),
    ('POST', 'measurements/foreign', ({'tables': FOREIGN, 'columns': FOREIGN_COLUMNS, 'sigma': 0.01},
                                      {'tables': FOREIGN, 'columns': FOREIGN_COLUMNS, 'sigma': 0.01 * MM})),
    ('GET', 'measurements', SAME), ('GET', 'state', SAME),
]
# Addresses without a figure that has a unit, or whose answer is the state that another one answers.
WITHOUT_FIGURES = """files cell/open cell/save arm/import project/open project/save export/* jobs/*/cancel undo redo models/go
    models/rename measurements measurements/open measurements/assume measurements/part measurements/set-aside
    measurements/hold-out identify remove ladder improve simulate live/readings outage outage/totals outage/log outage/plan
    outage/report outage/next outage/confirm outage/mark outage/undo""".split()
# Text, and what depends on the last digits of a fit.
APART = re.compile(r'/(file|folder|file_units|moment|revision|version|path_fingerprint|fingerprint|add|run_sheet|inputs|jobs|kept)\b')
# A number in inches or degrees; "in" may also be the word.
IN_INCHES = re.compile(r'\d (in|deg)\b(?! (\d|the|all|this|these|every|each|a|an|any)\b)')

# A number without a unit, for which a clause stays as it is.
BARE = re.compile(r'\d\.\d+ (than|with)\b')


class Server:
    """A workbench of its own folder, asked in the units of `units`; those of the cell's file where they are empty."""

    def __init__(self, folder, cell, units=''):
        self.units = units
        self.program = subprocess.Popen([PROGRAM, 'serve', folder / cell, folder / 'readings.csv', '--port', '0', '--state', folder / 'state'],
                                        stdout=subprocess.PIPE, text=True)
        self.address = re.search(r'http://\S+', self.program.stdout.readline())[0]

    def ask(self, method, path, body=None, units=None):
        units = self.units if units is None else units
        if units:
            path += f'{"&" if "?" in path else "?"}units={units}'
        request = urllib.request.Request(f'{self.address}api/{path}', method=method,
                                         data=None if body is None else json.dumps(body).encode(),
                                         headers={} if body is None else {'Content-Type': 'application/json'})
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)
        except urllib.error.HTTPError as error:
            raise AssertionError(f'{path}: {error.read().decode()}') from None

    def ended(self, job):
        while True:
            found = next(one for one in self.ask('GET', 'state')['jobs'] if one['id'] == job['id'])
            if found['status'] != 'running':
                assert found['status'] == 'done', found
                return
            time.sleep(0.1)

    def answer(self, method, path, body):
        found = self.ask(method, path, body)
        if 'stage' in found:
            self.ended(found)
            return {}
        return found

    def stop(self):
        self.program.terminate()
        self.program.wait()
        self.program.stdout.close()


def figures(document):
    """Returns a document without what is not compared."""
    if isinstance(document, dict):
        return {key: figures(inner) for key, inner in document.items() if not APART.search('/' + key)}
    return [figures(inner) for inner in document] if isinstance(document, list) else document


def texts(document):
    """Returns all text of a document."""
    if isinstance(document, str):
        return [document]
    inner = document.values() if isinstance(document, dict) else document if isinstance(document, list) else []
    return [text for one in inner for text in texts(one)]


class ShownUnits(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.kept = contextlib.ExitStack()
        cls.folders = [pathlib.Path(cls.kept.enter_context(tempfile.TemporaryDirectory())) for _ in range(2)]
        ours, twins = cls.folders
        for name in ('mockup.yaml', 'cobra-arm.yaml'):
            text = (CELLS / name).read_text().replace('rows: 49, columns: 114', 'rows: 8, columns: 12')
            (ours / name).write_text(text)
            (twins / name).write_text(converted(text, TWIN))
        subprocess.run([PROGRAM, 'simulate', ours / 'mockup.yaml', '--design', 'bowl', '--readings', '40', '--seed', '7', '--hide',
                        'hysteresis@theta4:0.06deg', '--out', ours / 'made'], check=True, capture_output=True)
        table = (ours / 'made/measurements.csv').read_text()
        (ours / 'readings.csv').write_text(table)
        (twins / 'readings.csv').write_text(converted_table(table, TWIN))

    @classmethod
    def tearDownClass(cls):
        cls.kept.close()

    def server(self, folder, units=''):
        server = Server(folder, 'mockup.yaml', units)
        self.addCleanup(server.stop)
        return server

    def test_every_address_is_asked(self):
        addresses = {path for file in (SOURCE / 'app/workbench').glob('*_routes.cpp')
                     for path in re.findall(r'\{"(?:GET|POST|DELETE)", "([^"]+)"', file.read_text())}
        asked = [path.split('?')[0] for _, path, _ in ASKED]
        for path in addresses:
            fits = re.compile(path.replace('*', '[^/]+') + '$')
            self.assertTrue(path in WITHOUT_FIGURES or any(map(fits.match, asked)), path)

    def compare(self, first, second, which):
        """Compares what two servers answer in the same units; `which`: the body of the page."""
        for method, path, bodies in ASKED:
            with self.subTest(f'{method} {path}', units=first.units or second.units):
                body = None if bodies is SAME else bodies[which]
                own_body = body
                a, b = (figures(server.answer(method, path, own_body)) for server in (first, second))
                found = [one for one in differences(a, b) if not LOOSE.search(one)]
                self.assertEqual(found, [], f'{len(found)} differ')
                if second.units == MILLIMETRES:
                    self.assertEqual([text for text in texts(b) if IN_INCHES.search(text) and not BARE.search(text)], [])

    def test_a_twin_in_inches_and_degrees(self):
        self.compare(self.server(self.folders[0]), self.server(self.folders[1], INCHES), 0)

    def test_a_twin_in_millimetres_and_radians(self):
        self.compare(self.server(self.folders[1]), self.server(self.folders[0], MILLIMETRES), 1)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
