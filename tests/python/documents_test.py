"""Runs the examples of docs/python.md and the cells of the notebooks of docs one after another, and compares the
conclusions that they reach."""
import importlib.util
import json
import os
import re
import sys
import tempfile
import unittest

from fixtures import CELLS, SOURCE


class Documents(unittest.TestCase):
    def setUp(self):
        if importlib.util.find_spec('matplotlib'):
            import matplotlib
            matplotlib.use('Agg')
        self.before, self.folder = os.getcwd(), tempfile.TemporaryDirectory()
        os.chdir(self.folder.name)
        os.makedirs('app')
        os.symlink(CELLS, 'app/cells')

    def tearDown(self):
        os.chdir(self.before)
        self.folder.cleanup()

    def run_parts(self, parts):
        """Runs parts of a program; those that need what is not installed are left out."""
        names = {}
        for part in parts:
            missing = [name for name in ('matplotlib', 'pandas') if name in part and not importlib.util.find_spec(name)]
            if not missing and not (".plot(" in part and not importlib.util.find_spec('matplotlib')):
                exec(part, names)  # noqa: S102
        return names

    def notebook(self, name):
        cells = json.loads((SOURCE / 'docs' / name).read_text())['cells']
        parts = [''.join(cell['source']) for cell in cells if cell['cell_type'] == 'code']
        self.assertGreater(len(parts), 3)
        return self.run_parts(parts)

    def test_python_document(self):
        blocks = re.findall(r'```python\n(.*?)```', (SOURCE / 'docs/python.md').read_text(), re.S)
        self.assertGreater(len(blocks), 3)
        code = [line for line in blocks[0].splitlines() if line.strip()]
        self.assertLessEqual(len(code), 10)
        self.simulated_robot()
        names = self.run_parts(blocks)
        self.assertLess(names['better'].models[-1].rms.heldout, names['better'].models[0].rms.as_it_stands)
        self.assertTrue(os.path.exists('calibrated.urdf'))

    def simulated_robot(self):
        """Writes robot.urdf and tracker.csv, as the first example expects them: an arm whose joints are off."""
        import tubeplan
        tubeplan.arm('export', CELLS / 'iiwa-arm.yaml', out='robot.urdf')
        tubeplan.arm('import', 'robot.urdf', out='true-arm.yaml', cell='true.yaml')
        with open('design.yaml', 'w') as file:
            file.write('{kind: position, loads: [0], postures: 60}')
        made = tubeplan.Cell('true.yaml').simulate(design='design.yaml', hide='joint-offset@' + tubeplan.Cell('true.yaml').joints[2] + ':0.4deg',
                                                  base_error=[0.05, 0.02], sigma=5e-5, seed=3, out='made')
        made.table().drop(columns=['id', 'kind']).to_csv('tracker.csv', index=False)

    def test_diagnosis(self):
        names = self.notebook('missing_effect.ipynb')
        self.assertEqual(names['name'].effect + '@' + names['name'].at, 'joint-offset@theta3')
        self.assertEqual(names['better'].verdict, 'adequate')

    def test_calibration(self):
        names = self.notebook('calibrated_arm.ipynb')
        self.assertLess(names['error_after'], names['error_before'] / 3)

    def test_planning(self):
        names = self.notebook('planned_tour.ipynb')
        self.assertTrue(names['checked'].proved)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
