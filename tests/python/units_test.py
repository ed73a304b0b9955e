"""Tests of the rule of units: the same arm and sheet in two systems of units give the same figures in SI units, and
figures in the cell's units are those of the program."""
import pathlib
import sys
import tempfile
import unittest

import tubeplan
from fixtures import BENCH, CELLS, SOURCE, calls, plan, readings

sys.path.insert(0, str(SOURCE / 'tests'))
from twin_cells import DEGREE, INCH, POUND, converted, converted_table, differences  # noqa: E402


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
