"""Effects outside the catalogue, with the interface of effects.Effect but no groups, because no model fits them."""
import numpy as np

from effect_laws import REFERENCE_TEMPERATURE, joint_index
from effect_shapes import DEG, all_joints, at, direction, phase, positive, row_and_axis, sign
from effects import ABSOLUTE, EVERYWHERE, Effect

TWO_PI = 2. * np.pi


def _arm_joints(arm):
    return list(arm.joints[1:])


# Shapes

def _bump_shape(rng, arm, place, scene):
    centre = np.quantile(scene.session.q[:, joint_index(arm, place)], rng.uniform(.25, .75)) / DEG
    return {"sign": sign(rng), "centre_deg": centre, "width_deg": rng.uniform(7., 14.)}


def _middle(rng, arm, place, scene):
    return {"beyond_deg": float(np.median(scene.session.q[:, joint_index(arm, place)]) / DEG)}


def _cycles(rng, *_):
    return {"cycles": float(rng.choice([1., 2.])), "phase": phase(rng)}


def _wave(rng, *_):
    return {"phase": phase(rng), "direction": direction(3)(rng), "cycles": rng.uniform(1.3, 3.)}


def _tip_wave(rng, *_):
    return {"phase": phase(rng), "direction": direction(3)(rng)}


# Laws

def _bump(numbers, arm, session, place, shape, size):
    """Worn tooth: error of the reading near one angle only."""
    joint = joint_index(arm, place)
    away = (session.q[:, joint] / DEG - shape["centre_deg"]) / shape["width_deg"]
    numbers.q[:, joint] += size * DEG * shape["sign"] * np.exp(-.5 * away ** 2)


def _product(numbers, arm, session, place, shape, size):
    """Error of a reading proportional to the product of two joint angles (equal to size at 60 deg each)."""
    to, source = (joint_index(arm, name) for name in place.split("*"))
    numbers.q[:, to] += size * DEG * shape * session.q[:, to] * session.q[:, source] / (60. * DEG) ** 2


def _third_harmonic(numbers, arm, session, place, shape, size):
    joint = joint_index(arm, place)
    numbers.q[:, joint] += size * DEG * np.sin(3. * session.q[:, joint] + shape)


def _azimuth_stiffness(numbers, arm, session, place, shape, size):
    """Mount whose compliance varies with the azimuth of the arm, once or twice per turn."""
    row, axis = row_and_axis(arm, place)
    numbers.spring[:, row, axis] *= 1. + size * np.cos(shape["cycles"] * session.q[:, 0] - shape["phase"])


def _memory(numbers, arm, session, place, shape, size):
    """Memory of a joint: an error that saturates with the last change of the reading."""
    joint = joint_index(arm, place)
    before = np.concatenate([session.q[:1, joint], session.q[:-1, joint]])
    numbers.q[:, joint] += size * DEG * shape * np.tanh((before - session.q[:, joint]) / (20. * DEG))


def _load_squared(numbers, arm, session, place, shape, size):
    """Rotation of an axis with the square of the suspended load (equal to size at 40 lbf)."""
    row, axis = row_and_axis(arm, place)
    numbers.turn[:, row, axis] += size * DEG * shape * (session.load / 40.) ** 2


def _wandering_tip(numbers, arm, session, place, shape, size):
    """Displacement of the tool in its holder that depends on the angle of the forearm."""
    numbers.tip += size * np.sin(3. * session.q[:, 2] + shape["phase"])[:, None] * shape["direction"]


def _sway(numbers, arm, session, place, shape, size):
    """Slow oscillation of the base."""
    wave = np.sin(TWO_PI * shape["cycles"] * session.elapsed + shape["phase"])
    numbers.base_position += size * wave[:, None] * shape["direction"]


def _warm_softening(numbers, arm, session, place, shape, size):
    """Axis whose compliance increases with temperature (by size at 10 degF)."""
    row, axis = row_and_axis(arm, place)
    numbers.spring[:, row, axis] *= 1. + size * (session.temperature - REFERENCE_TEMPERATURE) / 10.


def _lens(numbers, arm, session, place, shape, size):
    """Scale error of the measuring instrument that varies periodically with the reach, with a period of 30 in."""
    elbow, wrist = session.q[:, 1], session.q[:, 1] + session.q[:, 2]
    reach = arm.a[3] + arm.a[4] * np.cos(elbow) + arm.a[5] * np.cos(wrist) + arm.tip[0]
    numbers.stretch += (size * shape * np.sin(TWO_PI * reach / 30.))[:, None]


def _half_range_hysteresis(numbers, arm, session, place, shape, size):
    """Error depending on the direction of motion, in only one half of a joint's range."""
    joint = joint_index(arm, place)
    far = session.q[:, joint] > shape["beyond_deg"] * DEG
    numbers.q[:, joint] += size * DEG * session.direction[:, joint] * far


def _parameters(arm, place, shape, size):
    listed = shape if isinstance(shape, dict) else {"shape": shape}
    return {"size": size, **{name: np.asarray(value).tolist() for name, value in listed.items()}}


def _row(name, places, low, high, unit, law, shapes, designs=EVERYWHERE):
    return Effect("odd-" + name, places, low, high, unit, law, _parameters, shapes, None, designs)


PRODUCTS = at("theta4*theta1", "theta3*theta1", "theta2*theta1", "theta4*theta3")
MOUNT = at("mezzanine-platform.x", "mezzanine-beam.z")

ODD = (
    _row("joint-bump", _arm_joints, .01, .5, "deg", _bump, _bump_shape),
    _row("joint-product", PRODUCTS, .005, .3, "deg", _product, sign),
    _row("third-harmonic", all_joints, .005, .2, "deg", _third_harmonic, phase),
    _row("azimuth-stiffness", MOUNT, .005, .3, "1", _azimuth_stiffness, _cycles),
    _row("memory", _arm_joints, .005, .2, "deg", _memory, sign),
    _row("load-squared", at("tool.z", "forearm.z", "latch-link.z"), .005, .3, "deg", _load_squared, sign),
    _row("wandering-tip", at("tool"), .003, .15, "in", _wandering_tip, _tip_wave, ABSOLUTE),
    _row("sway", at("base"), .003, .15, "in", _sway, _wave),
    _row("warm-softening", at("tool.z", "mezzanine-platform.x"), .005, .2, "1", _warm_softening, positive),
    _row("lens", at("measurement"), 3e-5, 5e-3, "1", _lens, sign, ABSOLUTE),
    _row("half-range-hysteresis", _arm_joints, .005, .2, "deg", _half_range_hysteresis, _middle),
)
