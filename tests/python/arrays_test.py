"""Tests of the arrays of a cell: poses, inverse kinematics and holes, and of wrong arrays."""
import math
import pickle
import sys
import unittest

import numpy as np

import tubeplan
from fixtures import BENCH, DEGREE, INCH, MOCKUP, POUND, TRUE, program


class Poses(unittest.TestCase):
    def setUp(self):
        self.cell = tubeplan.Cell(BENCH)

    def test_names_and_limits(self):
        self.assertEqual(self.cell.joints, ['theta1', 'theta2', 'theta3', 'theta4'])
        np.testing.assert_allclose(self.cell.limits[1], [0, np.pi], atol=1e-12)
        np.testing.assert_allclose(tubeplan.Cell(BENCH, units='cell').limits[1], [0, 180], atol=1e-9)

    def test_tips_are_those_of_the_program(self):
        degrees = [[10, 90, -20, 5], [-60, 40, -80, 30]]
        poses = self.cell.poses(np.array(degrees) * DEGREE, load=30 * POUND)
        in_inches = tubeplan.Cell(BENCH, units='cell').poses(degrees, load=30)
        self.assertTrue(poses.converged.all())
        self.assertEqual(np.asarray(poses).shape, (2, 4, 4))
        np.testing.assert_allclose(poses.rotations @ poses.rotations.transpose(0, 2, 1), np.tile(np.eye(3), (2, 1, 1)), atol=1e-12)
        for k, q in enumerate(degrees):
            told = program('pose', BENCH, '--joints', ','.join(map(str, q)), '--load', 30)['flexible']['position']
            np.testing.assert_allclose(poses.positions[k] / INCH, told, atol=1e-9)
            np.testing.assert_allclose(in_inches.positions[k], told, atol=1e-9)

    def test_many_postures_are_as_one_by_one(self):
        q = np.random.default_rng(1).uniform(0.2, 1.2, (9000, 4))
        loads = np.linspace(0, 200, 9000)
        poses = self.cell.poses(q, loads)
        for k in (0, 4095, 4096, 8999):
            np.testing.assert_array_equal(poses.matrices[k], self.cell.poses(q[k:k + 1], loads[k]).matrices[0])

    def test_arrays_of_any_memory_and_type(self):
        q = np.random.default_rng(2).uniform(0.2, 1.2, (20, 8))
        expected = self.cell.poses(q[::2, ::2].copy()).matrices
        np.testing.assert_array_equal(self.cell.poses(q[::2, ::2]).matrices, expected)
        np.testing.assert_array_equal(self.cell.poses(np.asfortranarray(q[::2, ::2])).matrices, expected)
        np.testing.assert_array_equal(self.cell.poses(np.ones((3, 4), int)).matrices, self.cell.poses(np.ones((3, 4))).matrices)
        np.testing.assert_allclose(self.cell.poses(q[:, ::2].astype(np.float32)).matrices, self.cell.poses(q[:, ::2]).matrices,
                                   atol=1e-5)
        self.assertEqual(self.cell.poses(np.empty((0, 4))).matrices.shape, (0, 4, 4))

    def test_wrong_arrays_are_input_errors(self):
        good = np.zeros((2, 4))
        for q, load, where, found in (
                (np.zeros((2, 3)), 0, 'q', '(2, 3)'), (np.zeros(4), 0, 'q', '(4,)'), (np.zeros((2, 2, 4)), 0, 'q', '(2, 2, 4)'),
                (np.full((2, 4), math.nan), 0, 'q', 'nan at [0, 0]'), (good > 0, 0, 'q', 'bool'), ([['a'] * 4], 0, 'q', '<U1'),
                (good, -20, 'load', '-20'), (good, [1, 2, 3], 'load', '(3,)'), (good, math.inf, 'load', 'inf')):
            with self.subTest(found), self.assertRaises(tubeplan.InputError) as raised:
                self.cell.poses(q, load)
            self.assertEqual(raised.exception.where, where)
            self.assertIn(found, raised.exception.found)
            self.assertTrue(raised.exception.expected)

    def test_a_cell_can_be_pickled(self):
        again = pickle.loads(pickle.dumps(tubeplan.Cell(BENCH, units='cell')))
        self.assertEqual((again.path, again.units), (BENCH.absolute(), 'cell'))


class Inverse(unittest.TestCase):
    def test_branches_bring_the_tip_to_the_holes(self):
        for units, loads in (('si', 100.0), ('cell', 22.0)):
            cell = tubeplan.Cell(TRUE, units=units)
            centres = cell.holes().centres[::400]
            found = cell.inverse(centres, load=loads)
            self.assertGreater(found.converged.sum(), len(centres))
            reached = cell.poses(found.q[found.converged], loads)
            np.testing.assert_allclose(reached.positions, centres[found.goal[found.converged]], atol=1e-7)
            self.assertTrue((found.of(0) == found.q[(found.goal == 0) & found.converged]).all())

    def test_poses_are_taken_and_found_again(self):
        cell = tubeplan.Cell(TRUE)
        centres = cell.holes().centres[1000:1003]
        q = np.array([cell.inverse(centres).of(k)[0] for k in range(3)])
        poses = cell.poses(q).matrices
        for k in range(3):
            self.assertLess(np.abs(cell.inverse(poses).of(k) - q[k]).max(axis=1).min(), 1e-6)

    def test_what_is_out_of_reach_is_a_value(self):
        found = tubeplan.Cell(TRUE).inverse([[50.0, 0, 0]])
        self.assertEqual((len(found.of(0)), found.goal_status), (0, ('out-of-reach',)))
        self.assertTrue(found.goal_reason[0])

    def test_no_goals(self):
        self.assertEqual(tubeplan.Cell(TRUE).inverse(np.empty((0, 3))).q.shape, (0, 4))

    def test_wrong_goals(self):
        cell = tubeplan.Cell(TRUE)
        for goals, axes in (([[0, 0]], (0, 0, 1)), ([[0, 0, math.nan]], (0, 0, 1)), ([[0, 0, 0]], (0, 0, 0)), ([[0, 0, 0]], [[0, 0]])):
            with self.subTest(goals=goals, axes=axes), self.assertRaises(tubeplan.InputError):
                cell.inverse(goals, axes)


class Holes(unittest.TestCase):
    def test_holes_of_the_sheet(self):
        holes, figures = tubeplan.Cell(MOCKUP).holes(), program('map', MOCKUP)
        self.assertLess(len(repr(holes)), 400)
        self.assertEqual(len(holes), figures['holes'])
        np.testing.assert_allclose([holes.centres[:, 0].min(), holes.centres[:, 0].max()],
                                   np.array(figures['extents']['x']) * INCH, atol=1e-9)
        self.assertEqual(holes.names[0], f'R{holes.row[0]}C{holes.column[0]}')
        self.assertEqual(set(holes.state), {'open'})

    def test_a_cell_without_a_sheet(self):
        with self.assertRaises(tubeplan.InputError):
            tubeplan.Cell(BENCH).holes()


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
