"""Laws of the catalogue's effects: `law(numbers, arm, session, place, shape, size)` changes the arm's parameters.

The laws are written from the catalogue's public description alone. Every law is linear in `size`. Conventions: the true
joint angle is reading + error; forces are in world axes, offsets in the tool's frame; the length and twist of a link
are those from the link's frame to the next row's frame.
"""
import numpy as np

from effect_shapes import DEG, row_and_axis
from rotations import cross

REFERENCE_TEMPERATURE = 68.     # degF
SEATING_MOMENT = 5.             # lbf in: moment below which a joint with clearance is not seated on a side


def joint_index(arm, place):
    return arm.joints.index(place)


def reading_error(error):
    """Returns the law that adds size times error(q, direction of motion, shape) [rad] to the angle of a joint."""
    def law(numbers, arm, session, place, shape, size):
        joint = joint_index(arm, place)
        numbers.q[:, joint] += size * error(session.q[:, joint], session.direction[:, joint], shape)
    return law


offset = reading_error(lambda q, sense, sign: sign * DEG)
scale = reading_error(lambda q, sense, sign: sign * q)
eccentricity = reading_error(lambda q, sense, phase: np.sin(q + phase) * DEG)
transmission = reading_error(lambda q, sense, phase: np.sin(2. * q + phase) * DEG)
hysteresis = reading_error(lambda q, sense, sign: sign * sense * DEG)


def couple_joints(numbers, arm, session, place, shape, size):
    to, source = (joint_index(arm, name) for name in place.split("<-"))
    numbers.q[:, to] += size * shape * session.q[:, source]


def lengthen(numbers, arm, session, place, shape, size):
    numbers.a[:, arm.row(place) + 1] += size * shape


def twist(numbers, arm, session, place, shape, size):
    numbers.alpha[:, arm.row(place) + 1] += size * shape * DEG


def lean(numbers, arm, session, place, shape, size):
    """Rotates the next frame about the frame's y axis before the joint rotation. The row must have d = 0, because the
    origin is not moved."""
    row = arm.row(place) + 1
    theta = arm.theta[row] + numbers.q[:, list(arm.joint_rows).index(row)]
    numbers.turn[:, row, 0] += size * shape * DEG * np.sin(theta)
    numbers.turn[:, row, 1] += size * shape * DEG * np.cos(theta)


def move_tip(numbers, arm, session, place, shape, size):
    numbers.tip += size * shape


def weigh_link(numbers, arm, session, place, shape, size):
    numbers.end_weight[:, arm.row(place)] += size * shape


def weigh_tool(numbers, arm, session, place, shape, size):
    numbers.distributed[:, -1] *= 1. + size * shape


def offset_payload(numbers, arm, session, place, shape, size):
    numbers.payload_offset += size * shape


def lean_gravity(numbers, arm, session, place, shape, size):
    numbers.gravity_tilt += size * shape * DEG


def pull(numbers, arm, session, place, shape, size):
    numbers.end_force[:, arm.row(place)] += size * shape


def press(numbers, arm, session, place, shape, size):
    numbers.end_force[:, -1, 2] += size * shape


def give(numbers, arm, session, place, shape, size):
    """Adds compliance to an axis; size in deg per 1,000 lbf in."""
    row, axis = row_and_axis(arm, place)
    numbers.spring[:, row, axis] += size * 1e-3 * DEG


def bend(numbers, arm, session, place, shape, size):
    """Adds bending compliance to a rod; size is 1 / I in 1/in^4, with the modulus of the arm file."""
    row, axis = row_and_axis(arm, place)
    numbers.rod[:, row, axis] += size / arm.modulus


def twist_rod(numbers, arm, session, place, shape, size):
    """Adds torsional compliance to a rod; size in 1e-6 / (lbf in^2)."""
    numbers.rod[:, arm.row(place), 0] += size * 1e-6


def soften(numbers, arm, session, place, shape, size):
    """Makes an axis softer below the knee moment `shape` [lbf in]: K1 = K2 / (1 + size)."""
    row, axis = row_and_axis(arm, place)
    numbers.soft[:, row, axis] = size * arm.spring[row, axis]
    numbers.knee[:, row, axis] = shape


def loosen(numbers, arm, session, place, shape, size):
    """Adds a clearance of `size` deg to an axis, half of it to each side."""
    row, axis = row_and_axis(arm, place)
    numbers.soft[:, row, axis] = .5 * size * DEG / SEATING_MOMENT
    numbers.knee[:, row, axis] = SEATING_MOMENT


def grow(numbers, arm, session, place, shape, size):
    """Expands the tool and the moving links, whose lengths are in the row after the link; size in 1e-6 per degF."""
    growth = size * 1e-6 * (session.temperature - REFERENCE_TEMPERATURE)[:, None]
    numbers.a[:, arm.joint_rows[0] + 1:] *= 1. + growth
    numbers.tip *= 1. + growth


def slip_base(numbers, arm, session, place, shape, size):
    after = (session.elapsed > shape["at"])[:, None] * size
    yaw = np.array([0., 0., shape["yaw"]])
    numbers.base_position += after * (shape["shift"] + cross(yaw, numbers.base_position))
    numbers.base_turn += after * yaw


def creep_base(numbers, arm, session, place, shape, size):
    numbers.base_position += size * session.elapsed[:, None] * shape


def stretch_scale(numbers, arm, session, place, shape, size):
    numbers.stretch += size * shape
