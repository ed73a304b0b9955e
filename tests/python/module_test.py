"""Tests that the Python module agrees with the program in tips and results, and raises Python exceptions."""
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import tubeplan

PROGRAM, SOURCE = sys.argv[1:3]
BENCH = os.path.join(SOURCE, 'app/cells/bench.yaml')
INCH, DEGREE, POUND = 0.0254, np.pi / 180, 4.4482216152605


def program(*arguments):
    return json.loads(subprocess.run([PROGRAM, *arguments, '--json', '-'], capture_output=True, text=True).stdout)


class Poses(unittest.TestCase):
    def setUp(self):
        self.cell = tubeplan.Cell(BENCH)

    def test_names_and_limits(self):
        self.assertEqual(self.cell.joints, ['theta1', 'theta2', 'theta3', 'theta4'])
        np.testing.assert_allclose(self.cell.limits[1], [0, np.pi], atol=1e-12)

    def test_tips_are_those_of_the_program(self):
        degrees = [[10, 90, -20, 5], [-60, 40, -80, 30]]
        places, turns, converged = self.cell.poses(np.array(degrees) * DEGREE, load=30 * POUND)
        self.assertTrue(converged.all())
        for q, place, turn in zip(degrees, places, turns):
            told = program('pose', BENCH, '--joints', ','.join(map(str, q)), '--load', '30')
            np.testing.assert_allclose(place / INCH, told['flexible']['position'], atol=1e-9)
            np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-12)

    def test_many_postures_are_as_one_by_one(self):
        q = np.random.default_rng(1).uniform(0.2, 1.2, (1000, 4))
        places = self.cell.poses(q)[0]
        for k in (0, 500, 999):
            np.testing.assert_array_equal(places[k], self.cell.poses(q[k:k + 1])[0][0])

    def test_wrong_input_is_a_value_error(self):
        with self.assertRaisesRegex(ValueError, 'no such file'):
            tubeplan.Cell('nowhere.yaml')
        with self.assertRaisesRegex(ValueError, '4 joints'):
            self.cell.poses(np.zeros((2, 3)))
        with self.assertRaisesRegex(ValueError, 'row for each posture'):
            self.cell.poses(np.zeros(4))
        with self.assertRaisesRegex(ValueError, 'load is -20'):
            self.cell.poses(np.zeros((2, 4)), load=-20)
        with self.assertRaisesRegex(ValueError, 'no such file'):
            self.cell.identify(['nowhere.csv'])

    def test_a_path_is_kept_where_the_program_goes(self):
        before = os.getcwd()
        os.chdir(os.path.dirname(BENCH))
        try:
            cell = tubeplan.Cell(pathlib.Path('bench.yaml'))
        finally:
            os.chdir(before)
        with self.assertRaisesRegex(ValueError, 'robust: found .Huber., expected none, huber or cauchy'):
            cell.identify([os.path.join(SOURCE, 'tests/fuzz/corpus/measurements/all.csv')], robust='Huber')


class Readings(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        subprocess.run([PROGRAM, 'simulate', BENCH, '--design', 'bench', '--readings', '60', '--seed', '4', '--hide',
                        'joint-offset@theta3:0.1', '--out', self.folder.name], check=True, capture_output=True)
        self.readings = os.path.join(self.folder.name, 'measurements.csv')
        self.cell = tubeplan.Cell(BENCH)

    def tearDown(self):
        self.folder.cleanup()

    def test_figures_are_those_of_the_program(self):
        for name in ('identify', 'diagnose', 'compare'):
            self.assertEqual(getattr(self.cell, name)([self.readings]), program(name, BENCH, self.readings), name)

    def test_what_is_found_is_written(self):
        out = os.path.join(self.folder.name, 'found.yaml')
        found = self.cell.identify([self.readings], free=['tool.joint_stiffness.z'], out=out)
        self.assertEqual(found['status'], 'done')
        self.assertEqual(tubeplan.Cell(out).joints, self.cell.joints)


class Plans(unittest.TestCase):
    def test_a_plan_visits_its_tubes(self):
        plan = tubeplan.Cell(os.path.join(SOURCE, 'app/cells/mockup.yaml')).plan('spread:5')
        self.assertEqual(len(plan['tubes']), 5)

    def test_a_plan_says_for_which_base_it_is(self):
        cells = os.path.join(SOURCE, 'app/cells')
        mockup, true = (os.path.join(cells, name) for name in ('mockup.yaml', 'mockup-true.yaml'))
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, 'plan')
            subprocess.run([PROGRAM, 'plan', mockup, '--touches', 'auto', '--truth', true, '--tubes', 'spread:2', '--out', out],
                           check=True, capture_output=True)
            cells = {mockup: 'nominal', true: 'stated', os.path.join(out, 'cell.yaml'): 'calibrated'}
            for path, status in cells.items():
                with self.subTest(status):
                    cell = tubeplan.Cell(path)
                    plan = cell.plan('spread:2')
                    self.assertEqual(cell.base_standing['status'], status)
                    self.assertEqual({key: plan['base'][key] for key in cell.base_standing}, cell.base_standing)
                    self.assertIn(cell.base_standing['words'], plan['sentence'])
                    self.assertEqual(any('hold only if' in word for word in plan['warnings']), status == 'nominal')


class Document(unittest.TestCase):
    """Runs the code blocks of docs/python.md one after another."""

    def test_examples_run(self):
        with open(os.path.join(SOURCE, 'docs/python.md')) as file:
            text = file.read()
        blocks = re.findall(r'```python\n(.*?)```', text, re.S)
        self.assertGreater(len(blocks), 2)
        os.chdir(SOURCE)
        with tempfile.TemporaryDirectory() as folder:
            names = {'folder': folder}
            for block in blocks:
                exec(block.replace('out/', folder + '/').replace("'tubeplan'", repr(PROGRAM)), names)


class Notebook(unittest.TestCase):
    """Runs the cells of docs/missing_effect.ipynb one after another, with the plots if matplotlib is installed."""

    def test_cells_run(self):
        with open(os.path.join(SOURCE, 'docs/missing_effect.ipynb')) as file:
            cells = [''.join(cell['source']) for cell in json.load(file)['cells'] if cell['cell_type'] == 'code']
        self.assertGreater(len(cells), 4)
        os.chdir(SOURCE)
        names = {}
        for cell in cells:
            if 'matplotlib' not in cell or importlib.util.find_spec('matplotlib'):
                exec(cell.replace("'tubeplan'", repr(PROGRAM)), names)
        self.assertEqual(names['name']['effect'] + '@' + names['name']['at'], 'joint-offset@theta3')
        self.assertEqual(names['better']['verdict'], 'adequate')


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
