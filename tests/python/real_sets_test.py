"""real_sets_test.py TUBEPLAN SOURCE FOLDER: from a URDF and measured points to a corrected URDF, on three robots: the
held-out error is the one that `tubeplan improve` prints. Skipped if the sets are not next to the tree."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import tubeplan

PROGRAM, REAL = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3])
ROBOTS = ('wam', 'motoman', 'ur5')


def corrected(folder, table):
    """Runs the lines of docs/python.md on robot.urdf of a folder."""
    before = os.getcwd()
    os.chdir(folder)
    try:
        tubeplan.arm('import', 'robot.urdf', out='robot-arm.yaml', cell='robot.yaml')
        with open('robot.yaml', 'a', encoding='utf-8') as cell:
            cell.write('identify: [tool.tip, geometry]\n')
        better = tubeplan.Cell('robot.yaml', units='cell').improve(table, out='better.yaml')
        exported = tubeplan.arm('export', 'better.yaml', measurements=table, into='robot.urdf', out='calibrated.urdf')
    finally:
        os.chdir(before)
    return better, exported


class RealSets(unittest.TestCase):
    def test_held_out_error_is_that_of_the_program(self):
        for robot in ROBOTS:
            with self.subTest(robot), tempfile.TemporaryDirectory() as name:
                folder, table = pathlib.Path(name), REAL / robot / 'measurements.csv'
                tubeplan.arm('export', REAL / robot / 'arm.yaml', out=folder / 'robot.urdf')
                better, exported = corrected(folder, table)
                run = subprocess.run([PROGRAM, 'improve', 'robot.yaml', table, '--out', 'again.yaml'], cwd=folder,
                                     capture_output=True, text=True, check=False)
                printed = re.findall(r'held-out error ([\d.e+-]+) (\w+)', run.stdout)[len(better.models) - 1]
                error = better.models[-1].rms.heldout
                print(f'{robot}: {better.models[0].rms.as_it_stands:.4g} -> held out {error:.4g} {better.error_unit}, printed {printed}')
                self.assertEqual((f'{error:.4g}', better.error_unit), (f'{float(printed[0]):.4g}', printed[1]))
                self.assertLess(error, better.models[0].rms.as_it_stands)
                self.assertNotEqual((folder / 'calibrated.urdf').read_text(), (folder / 'robot.urdf').read_text())
                self.check_exported(folder, table, exported.text)

    def check_exported(self, folder, table, text):
        """The file alone errs by what `arm export` printed, or by what the model does where nothing was left out."""
        stated = re.search(r'exported model fitted again: ([\d.e+-]+) ', text)
        tubeplan.arm('import', folder / 'calibrated.urdf', out=folder / 'alone-arm.yaml', cell=folder / 'alone.yaml')
        alone = tubeplan.Cell(folder / 'alone.yaml', units='cell').identify(table, stage=['tool.tip']).rms.after_base
        print(f'  the exported file: {alone:.4g}; {text.strip() or "states the whole model"}')
        if stated:
            self.assertAlmostEqual(alone / float(stated[1]), 1, delta=0.02)


if __name__ == '__main__':
    if not REAL.is_dir():
        print(f'skipped: the measured sets are not in {REAL}')
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
