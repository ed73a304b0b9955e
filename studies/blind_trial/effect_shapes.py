"""Places of effects on an arm, and their shapes: everything that defines an effect except its size.

A drawing function takes (rng, arm, place, scene), a grouping function (arm, place, scene); scene is a signatures.Scene.
A group lists shapes whose signatures together span one rival. Several groups mean that the shape must be searched for.
"""
import numpy as np

DEG = np.pi / 180.
AXES = "xyz"


def row_and_axis(arm, place):
    """Returns the indices of row and axis, such as (5, 2) for `tool.z`."""
    row, axis = place.split(".")
    return arm.row(row), AXES.index(axis)


# Places

def at(*places):
    return lambda arm: list(places)


def all_joints(arm):
    return list(arm.joints)


def couplings(arm):
    """Returns the couplings of each joint to all joints nearer the base, whose motion affects it through cables and
    shafts."""
    return [f"{arm.joints[i]}<-{arm.joints[j]}" for i in range(len(arm.joints)) for j in range(i)]


def rigid_axes(arm):
    return [f"{arm.links[row]}.{AXES[axis]}" for row, axis in zip(*np.nonzero(arm.spring == 0.))]


def springs(arm):
    return [f"{arm.links[row]}.{AXES[axis]}" for row, axis in zip(*np.nonzero(arm.spring > 0.))]


def clearances(arm):
    return springs(arm) + ["latch-link.z", "base-link.z", "base-link.y", "forearm.y"]


# Drawing functions of random shapes

def sign(rng, *_):
    return float(rng.choice([-1., 1.]))


def mostly_more(rng, *_):
    return float(rng.choice([-1., 1.], p=[.25, .75]))


def positive(*_):
    return 1.


def direction(size):
    """Returns a drawing function of random unit vectors with `size` components."""
    def draw(rng, *_):
        vector = rng.normal(size=size)
        return vector / np.linalg.norm(vector)
    return draw


def phase(rng, *_):
    return rng.uniform(0., 2. * np.pi)


def knee(rng, arm, place, scene):
    """Returns a knee moment [lbf in] that is not exceeded in 15 to 70 % of the readings."""
    return float(np.quantile(_moment_sizes(arm, place, scene), rng.uniform(.15, .7)))


def slip(rng, *_):
    """Returns a base slip: the fraction of the session at which it occurs, its direction, and its yaw [rad/in]. Half of
    the slips are horizontal."""
    shift = direction(3)(rng) * [1., 1., rng.choice([0., 1.])]
    return {"at": rng.uniform(.2, .8), "shift": shift, "yaw": rng.uniform(-.3, .3) * DEG}


def _moment_sizes(arm, place, scene):
    row, axis = row_and_axis(arm, place)
    return np.abs(scene.moments[:, row, axis])


# Grouping functions: shapes that span a rival

def single(*_):
    return [[1.]]


def span(size):
    return lambda *_: [list(np.eye(size))]


def two_phases(*_):
    return [[0., np.pi / 2.]]


def knees(arm, place, scene):
    return [[float(moment)] for moment in np.quantile(_moment_sizes(arm, place, scene), (.1, .25, .4, .55, .7, .85))]


def slips(*_):
    ways = [(unit, 0.) for unit in np.eye(3)] + [(np.zeros(3), DEG)]
    return [[{"at": moment, "shift": shift, "yaw": yaw} for shift, yaw in ways] for moment in np.linspace(.05, .95, 19)]
