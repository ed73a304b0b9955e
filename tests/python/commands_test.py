"""Tests that commands of the package give what the program gives, take what Python has, and raise what Python expects."""
import copy
import dataclasses
import json
import os
import pathlib
import pickle
import sys
import unittest

import numpy as np

import tubeplan
from fixtures import BENCH, MOCKUP, PROGRAM, SOURCE, TRUE, calls, folder, plan, program, readings
from tubeplan.commands import COMMANDS, FUNCTIONS, METHODS
from tubeplan.figures import Figures, read_shapes
from tubeplan.result import Result


class Everything(unittest.TestCase):
    def test_every_command_is_here(self):
        self.assertEqual({*METHODS, *FUNCTIONS}, set(COMMANDS))
        self.assertGreater(len(COMMANDS), 25)
        for name in METHODS:
            self.assertTrue(callable(getattr(tubeplan.Cell, name)))
        for name in FUNCTIONS:
            self.assertTrue(callable(getattr(tubeplan, name)))

    def test_no_argument_has_two_meanings(self):
        for name, (_, _, options) in COMMANDS.items():
            named = [option.argument for option in options] + ['progress'] + ([] if name in METHODS else ['units'])
            self.assertEqual(len(named), len(set(named)), name)

    def test_options_in_the_units_of_the_cell_say_of_which_kind_they_are(self):
        words = {"the cell's unit of force": 'FORCE', "the cell's unit of length": 'LENGTH'}
        for name, (_, _, options) in COMMANDS.items():
            for option in options:
                for text, kind in words.items():
                    if text in option.description and 'NAME=' not in option.description:
                        self.assertIn(kind, option.kinds, f'{name} {option.word}')

    def test_every_command_draws_and_prints(self):
        seen = set()
        for name, call in calls('si'):
            with self.subTest(name):
                result = call()
                self.assertTrue(result.answer or name in ('compare', 'improve', 'touches', 'watch', 'calibrate', 'job'), str(result))
                self.assertIn(f'tubeplan {name}', result._repr_html_())
                self.assertTrue(str(result))
                self.assertEqual(result.figures().empty, False)
                seen.add(name)
        # These have no figures: tests below.
        self.assertEqual(set(COMMANDS) - seen, {'add', 'completion', 'man', 'readings', 'report', 'serve', 'simulate'})


class Same(unittest.TestCase):
    def test_figures_are_those_of_the_program(self):
        cell = tubeplan.Cell(BENCH, units='cell')
        for name in ('identify', 'diagnose', 'compare'):
            result = getattr(cell, name)(readings())
            self.assertEqual(result.as_dict(), program(name, BENCH, readings()), name)

    def test_text_is_that_of_the_program(self):
        import subprocess
        run = subprocess.run([PROGRAM, 'identify', BENCH, readings()], capture_output=True, text=True, check=False)
        result = tubeplan.Cell(BENCH).identify(readings())
        self.assertEqual(str(result), run.stdout)
        self.assertEqual(result.answer, run.returncode == 0)

    def test_man_and_completion(self):
        self.assertIn('.SH NAME', str(tubeplan.man()))
        self.assertIn('tubeplan', str(tubeplan.completion('bash')))


class Inputs(unittest.TestCase):
    def test_names_and_paths_of_files_alike(self):
        for kind in (str, pathlib.Path):
            cell = tubeplan.Cell(kind(BENCH))
            self.assertEqual(cell.identify(kind(readings())).status, 'done')
            self.assertEqual(cell.identify([kind(readings())]).status, 'done')

    def test_a_cell_is_kept_where_the_program_goes(self):
        before = os.getcwd()
        os.chdir(BENCH.parent)
        try:
            cell = tubeplan.Cell('bench.yaml')
        finally:
            os.chdir(before)
        self.assertTrue(cell.map is not None and cell.effects().effects)

    def test_postures_with_units_and_words_without(self):
        degrees = [10, 20, 30, 40]
        told = program('pose', BENCH, '--joints=10,20,30,40', '--load', 30)['flexible']['position']
        cell = tubeplan.Cell(BENCH)
        si = cell.pose(joints=np.radians(degrees), load=30 * 4.4482216152605)
        np.testing.assert_allclose(np.array(si.flexible.position) / 0.0254, told, rtol=1e-9)
        text = cell.pose(joints='10,20,30,40', load='30')
        np.testing.assert_allclose(np.array(text.flexible.position) / 0.0254, told, rtol=1e-9)
        in_cell = tubeplan.Cell(BENCH, units='cell').pose(joints=degrees, load=30)
        np.testing.assert_allclose(in_cell.flexible.position, told, rtol=1e-9)

    def test_what_is_wrong(self):
        cell = tubeplan.Cell(BENCH)
        for call, where in (
                (lambda: cell.identify(readings(), robust='Huber'), 'robust'), (lambda: cell.identify(readings(), folds=-1), 'folds'),
                (lambda: cell.pose(joints=[0, 0, 0]), 'joints'), (lambda: cell.pose(joints=[0, 0, 0, float('nan')]), 'joints'),
                (lambda: cell.pose(joints=[0, 0, 0, 0], load=-1), 'load'), (lambda: cell.pose(joints=[0, 0, 0, 0], load='abc'), 'load'), (lambda: tubeplan.Cell(BENCH, units='mm'), 'units'),
                (lambda: cell.touches(held_out=1), None), (lambda: cell.identify(), None), (lambda: cell.pose(joints={1}, all='yes'), None)):
            with self.subTest(where=where), self.assertRaises((tubeplan.InputError, TypeError)) as raised:
                call()
            self.assertIsInstance(raised.exception, tubeplan.InputError if where else TypeError)
            if where:
                self.assertEqual(raised.exception.where, where)
                self.assertIsInstance(raised.exception, ValueError)
                self.assertTrue(raised.exception.found)

    def test_a_file_that_is_missing(self):
        cell = tubeplan.Cell(BENCH)
        for call in (lambda: tubeplan.Cell('nowhere.yaml'), lambda: cell.identify('nowhere.csv'), lambda: cell.verify('nowhere'),
                     lambda: tubeplan.arm('show', 'nowhere.urdf'), lambda: tubeplan.ladder('nowhere.csv', [BENCH])):
            with self.assertRaises(FileNotFoundError) as raised:
                call()
            self.assertIsInstance(raised.exception, tubeplan.InputError)
            self.assertIn('nowhere', raised.exception.where)
            self.assertTrue(raised.exception.remedy)

    def test_a_wrong_file_names_the_key(self):
        wrong = folder() / 'wrong.yaml'
        wrong.write_text(BENCH.read_text().replace('arm: ', f'arm: {BENCH.parent}/').replace('known: true', 'known: maybe'))
        with self.assertRaises(tubeplan.InputError) as raised:
            tubeplan.Cell(wrong)
        self.assertIn('known', raised.exception.where)
        self.assertEqual(pickle.loads(pickle.dumps(raised.exception)).args, raised.exception.args)


class Results(unittest.TestCase):
    def test_a_negative_answer_is_a_value(self):
        result = tubeplan.Cell(BENCH).compare(readings())
        self.assertEqual((result.answer, result.verdict), (False, 'falls-short'))

    def test_figures_cannot_be_changed(self):
        result = tubeplan.Cell(BENCH).identify(readings())
        with self.assertRaises(dataclasses.FrozenInstanceError):
            result.rms = 0
        with self.assertRaises(dataclasses.FrozenInstanceError):
            result.rms.after = 0
        with self.assertRaises(TypeError):
            result['rms'] = 0
        with self.assertRaisesRegex(AttributeError, "did you mean 'parameters'"):
            result.parameter
        document = result.as_dict()
        document['rms'].clear()
        self.assertTrue(result.rms.after)

    def test_figures_as_attributes_items_and_classes(self):
        result = tubeplan.Cell(BENCH).identify(readings())
        self.assertEqual(type(result).__name__, 'IdentifyResult')
        self.assertEqual(type(result.parameters[0]).__name__, 'IdentifyResultParameters')
        self.assertEqual(result.rms.after, result['rms']['after'])
        self.assertIn('rms', dir(result))
        self.assertEqual(json.loads(json.dumps(result.as_dict())), result.as_dict())
        again = pickle.loads(pickle.dumps(result))
        self.assertEqual((again.as_dict(), str(again), type(again)), (result.as_dict(), str(result), type(result)))
        self.assertIs(copy.deepcopy(result), result)

    def test_no_figure_is_hidden_by_a_method(self):
        taken = {name for name in {*dir(Figures), *dir(Result)} if not name.startswith('_')}
        for name, shape in read_shapes().items():
            self.assertEqual({*shape} & taken, set(), name)

    def test_what_is_written_can_be_opened(self):
        cell = tubeplan.Cell(BENCH)
        out = folder() / 'found.yaml'
        self.assertEqual(cell.identify(readings(), out=out).open().path, out)
        added = cell.add(['hysteresis@theta4'])
        self.assertEqual(added.open().compare(readings()).verdict, 'adequate')
        self.assertEqual(plan().open().base_standing.status, 'calibrated')
        self.assertTrue(tubeplan.Cell(MOCKUP).verify(plan()).proved)
        with self.assertRaises(TypeError):
            cell.compare(readings()).open()

    def test_a_file_of_its_own_ends_with_the_result(self):
        added = tubeplan.Cell(BENCH).add(['hysteresis@theta4'])
        path = added.out
        self.assertTrue(path.exists())
        del added
        self.assertFalse(path.exists())

    def test_a_plan_says_for_which_base_it_is(self):
        for path, status in {MOCKUP: 'nominal', TRUE: 'stated', plan().out / 'cell.yaml': 'calibrated'}.items():
            with self.subTest(status):
                cell = tubeplan.Cell(path)
                made = cell.plan(tubes='spread:2')
                self.assertEqual(cell.base_standing.status, status)
                self.assertEqual({key: made.base[key] for key in cell.base_standing}, dict(cell.base_standing))
                self.assertEqual(any('are valid only if' in word for word in made.warnings), status == 'nominal')


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
