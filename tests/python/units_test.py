"""Tests of the rule of units: the same arm and sheet in two systems of units give the same figures in SI units, and
figures in the cell's units are those of the program."""
import math
import pathlib
import re
import sys
import tempfile
import unittest

import tubeplan
from fixtures import BENCH, CELLS, DEGREE, INCH, POUND, calls, plan, readings

MM = INCH * 1000
TORQUE = POUND * MM  # N mm
# Factors from inches, degrees, pounds, and minutes to millimetres, radians, newtons and seconds, by the keys
# of arms and cells.
FACTORS = {
    **dict.fromkeys('a d position pitch first_row radius hole_diameter center diameter tolerance lengths from to point size tip '
                    'clearance'.split(), MM),
    **dict.fromkeys('alpha theta limits max_speed max_acceleration encoder_sigma rpy park'.split(), DEGREE),
    'joint_stiffness': TORQUE / DEGREE, 'E': POUND / MM ** 2, 'Iz': MM ** 4, 'distributed': POUND / MM, 'end': POUND}
COLUMNS = {'in': ('mm', MM), 'deg': ('rad', DEGREE), 'lbf': ('N', POUND), 'min': ('s', 60.0)}
# Numbers whose last digits depend on rounding of the input: probabilities far from one, iterations, sampled paths.
LOOSE = re.compile(r'iterations|evaluations|p_value|solver|probability|min_clearance')


def numbers(text, factor):
    return re.sub(r'-?\d+(\.\d*)?([eE][-+]?\d+)?', lambda number: repr(float(number[0]) * factor), text)


def converted(text):
    """Returns the text of a cell or an arm in the other units."""
    text = re.sub(r'#.*', '', text).replace('units: {length: in, angle: deg, force: lbf, temperature: degF, time: min}',
                                            'units: {length: mm, angle: rad, force: N, temperature: degF, time: s}')
    for key, factor in FACTORS.items():
        # (?!-) keeps `from:` of FACTORS apart from names such as inside_of; values are numbers, lists, or {axis: number}.
        text = re.sub(rf'\b{key}: ((?:\{{[xyz]: )?-?[\d.][\d.e+-]*\}}?|\[[^\[\]a-z]*\])(?=[,}}\s])',
                      lambda found: f'{key}: {numbers(found[1], factor)}', text)
    return text


def converted_table(text):
    """Returns the text of a table of readings in the other units."""
    heading, *rows = text.splitlines()
    names, factors = [], []
    for name in heading.split(','):
        stem, _, unit = name.rpartition('_')
        into, factor = COLUMNS.get(unit, (unit, None))
        names.append(f'{stem}_{into}' if factor else name)
        factors.append(factor)
    lines = [','.join(repr(float(cell) * factor) if factor and cell else cell for cell, factor in zip(row.split(','), factors))
             for row in rows]
    return '\n'.join([','.join(names), *lines]) + '\n'


def differences(a, b, path=''):
    """Yields the places at which two documents differ by more than rounding."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in {**a, **b}:
            if key not in ('inputs', 'name', 'cell', 'words', 'sentence', 'sentences', 'found', 'add', 'fingerprint', 'text'):
                yield from differences(a.get(key), b.get(key), f'{path}/{key}')
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        # The size of a list of numbers counts: a component of rounding is not compared with itself.
        if a and all(isinstance(one, float) for one in [*a, *b]):
            size = max(map(abs, a))
            if max(abs(one - other) for one, other in zip(a, b)) > 2e-3 * size + 1e-7 and not LOOSE.search(path):
                yield f'{path}: {a} {b}'
            return
        # Equals may come in another order.
        a, b = (sorted(rows, key=lambda row: str([row.get(key) for key in ('effect', 'at', 'row', 'column')]))
                if rows and all(isinstance(row, dict) and {'effect', 'at'} <= {*row} for row in rows) else rows for rows in (a, b))
        if path == '/design':
            a, b = (sorted(rows, key=lambda row: row['name']) for rows in (a, b))
        for k, (one, other) in enumerate(zip(a, b)):
            yield from differences(one, other, f'{path}/{k}')
    elif isinstance(a, float) and isinstance(b, (int, float)) and not isinstance(b, bool):
        if not math.isclose(a, b, rel_tol=2e-3, abs_tol=1e-7) and not LOOSE.search(path):
            yield f'{path}: {a} {b}'
    elif a != b and not (isinstance(a, str) and isinstance(b, str) and path.rsplit('/', 1)[-1] not in ('unit', 'error_unit')):
        yield f'{path}: {a} {b}'


class Units(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.kept.name)
        for name in ('bench.yaml', 'mockup.yaml', 'mockup-true.yaml', 'cobra-arm.yaml', 'cobra-arm-true.yaml'):
            (folder / name).write_text(converted((CELLS / name).read_text()))
        for name, table in (('readings.csv', readings()), ('touches.csv', plan().out / 'touches.csv')):
            (folder / name).write_text(converted_table(table.read_text()))
        cls.cells = [folder / name for name in ('bench.yaml', 'mockup.yaml', 'mockup-true.yaml')]
        cls.tables = folder / 'readings.csv', folder / 'touches.csv'

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def test_two_systems_of_units_give_the_same_figures(self):
        others = list(calls('si', *self.cells, made_of=self.tables))
        ours = [one for one in calls('si') if one[0] not in ('verify', 'arm', 'job')]
        self.assertEqual([name for name, _ in ours], [name for name, _ in others])
        for (name, call), (_, other) in zip(ours, others):
            if name == 'watch':
                continue  # its cell is that of the plan in both
            with self.subTest(name):
                a, b = call().as_dict(), other().as_dict()
                found = list(differences(a, b))
                self.assertEqual(found, [], f'{name}: {len(found)}')

    def test_figures_in_the_units_of_the_cell(self):
        si, cell = (tubeplan.Cell(BENCH, units=units).identify(readings()) for units in ('si', 'cell'))
        self.assertEqual(dict(cell.units), {'length': 'in', 'angle': 'deg', 'force': 'lbf', 'temperature': 'degF', 'time': 'min'})
        self.assertEqual(dict(si.units), {'length': 'm', 'angle': 'rad', 'force': 'N', 'temperature': 'degF', 'time': 's'})
        self.assertAlmostEqual(si.rms.after / cell.rms.after, INCH)
        self.assertAlmostEqual(si.parameters[0].value / cell.parameters[0].value, POUND * INCH / DEGREE)
        self.assertEqual((cell.parameters[0].unit, si.parameters[0].unit), ('lbf*in/deg', 'N*m/rad'))

    def test_arrays_of_both(self):
        q = [[0.1, 0.9, -0.4, 0.2]]
        inches, millimetres = tubeplan.Cell(BENCH), tubeplan.Cell(self.cells[0])
        self.assertLess(abs(inches.poses(q, 100).matrices - millimetres.poses(q, 100).matrices).max(), 1e-9)
        in_cell = tubeplan.Cell(self.cells[0], units='cell').poses(q, 100)
        self.assertLess(abs(in_cell.positions / 1000 - inches.poses(q, 100).positions).max(), 1e-9)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
