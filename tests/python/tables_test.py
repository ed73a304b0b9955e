"""Tests of pandas DataFrames in and out, and of pictures; skipped without pandas or matplotlib."""
import importlib.util
import sys
import unittest

import tubeplan
from fixtures import BENCH, MOCKUP, folder, plan, readings

PANDAS, MATPLOTLIB = (importlib.util.find_spec(name) for name in ('pandas', 'matplotlib'))


@unittest.skipUnless(PANDAS, 'pandas is not installed')
class Tables(unittest.TestCase):
    def setUp(self):
        import pandas
        self.pandas = pandas
        self.cell = tubeplan.Cell(BENCH)
        self.frame = pandas.read_csv(readings())

    def test_a_table_is_taken_as_its_file_is(self):
        by_file, by_frame = self.cell.compare(readings()), self.cell.compare(self.frame)
        self.assertEqual(by_frame.rms, by_file.rms)
        self.assertEqual(self.cell.compare([self.frame[:20], self.frame[20:]]).rms.before, by_file.rms.before)

    def test_missing_and_wrong_columns(self):
        for frame, words in ((self.frame.drop(columns='theta1_deg'), 'theta1'), (self.frame.rename(columns={'x_in': 'x'}), 'x'),
                             (self.frame.assign(theta2_deg='abc'), 'abc'), (self.frame[:0], '')):
            with self.subTest(words), self.assertRaises(tubeplan.InputError) as raised:
                self.cell.compare(frame)
            self.assertIn(words, str(raised.exception))
            self.assertIn('DataFrame measurements.csv', raised.exception.where)

    def test_what_is_not_known_is_empty(self):
        frame = self.frame.assign(sigma_in=[float('nan')] * len(self.frame))
        result = self.cell.compare(frame, sigma=0.003 * 0.0254)
        self.assertAlmostEqual(result.rms.before, self.cell.compare(self.frame).rms.before)

    def test_tables_of_results(self):
        made = self.cell.simulate(design='bench', readings=12)
        table = made.table()
        self.assertEqual((len(table), table['id'].dtype.kind), (12, 'O'))
        self.assertEqual(len(self.cell.compare(table).readings), 12)
        numbers = self.cell.identify(readings()).frame('parameters')
        self.assertEqual(list(numbers['name'])[0], 'tool.joint_stiffness.z')
        self.assertIn('prior/sigma', numbers.columns)
        with self.assertRaises(KeyError):
            self.cell.identify(readings()).frame('parametres')
        sheet = self.cell.touches(readings=readings(), count=3, csv=folder() / 'next.csv')
        self.assertEqual(len(self.pandas.read_csv(folder() / 'next.csv')), len(sheet.next_readings))
        self.assertTrue({'row', 'column', 'x', 'state'} <= {*tubeplan.Cell(MOCKUP).holes().frame().columns})

    def test_readings_of_another_program(self):
        converted = self.cell.readings(self.frame.drop(columns=['id', 'kind']))
        self.assertEqual(len(converted.table()), len(self.frame))
        self.assertIn(f'{len(self.frame)} readings', converted.remarks)


@unittest.skipUnless(MATPLOTLIB, 'matplotlib is not installed')
class Pictures(unittest.TestCase):
    def setUp(self):
        import matplotlib
        matplotlib.use('Agg')

    def test_results_are_drawn(self):
        from matplotlib import pyplot
        cell = tubeplan.Cell(BENCH)
        for result in (tubeplan.ladder(readings(), [BENCH], rigid=True), cell.improve(readings()), cell.identify(readings()),
                       cell.compare(readings()), cell.diagnose(readings()), plan()):
            with self.subTest(result.command):
                figure = result.plot()
                drawn = figure.axes[0]
                self.assertTrue(drawn.lines or drawn.patches or drawn.collections)
                file = folder() / f'{result.command}.png'
                figure.savefig(file)
                self.assertGreater(file.stat().st_size, 5000)
                pyplot.close(figure)

    def test_the_law_is_drawn_by_what_it_follows(self):
        figure = tubeplan.Cell(BENCH).diagnose(readings()).plot()
        self.assertEqual(figure.axes[0].get_xlabel(), 'sense of theta4')

    def test_what_has_no_picture_says_so(self):
        with self.assertRaises(TypeError):
            tubeplan.Cell(BENCH).effects().plot()


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
