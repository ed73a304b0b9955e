"""Three measurement designs: the arm on a bench of known position, known holes from an unknown base, unknown points.

Postures are those of normal work, with the tool about level, so that its tip points up into a hole. A design does not
depend on effects; `reach` moves an arm with effects until the tip is at the target.
"""
from dataclasses import dataclass, replace

import numpy as np

from arm_physics import Numbers, measured, solve
from effect_shapes import DEG, row_and_axis
from rotations import cross
from session import Session, draw_session

# stiffnesses in the `identify` list of the bench cell and of the bowl cell
IDENTIFIED = (("spring", "tool.z"), ("spring", "forearm.z"), ("rod", "latch-link.z"), ("rod", "mezzanine-beam.z"),
              ("spring", "mezzanine-beam.z"), ("spring", "mezzanine-platform.x"))
FACE = 47.              # in: height of the tube sheet's face above the base
PITCH = 1.0625          # in
SIGMA = {"bench": .003, "bowl": .005, "touch": .005}      # in
STRETCHED = 15. * DEG
ROUGHLY, NEARLY, EXACTLY = 1e-2, 1e-5, 1e-8      # tolerances for the distance of the tip from a target in `reach` [in]


@dataclass
class Design:
    kind: str                   # bench, bowl, touch
    arm: object                 # arm with the true stiffnesses
    session: Session            # session at the nominal readings
    targets: np.ndarray         # (N, 3): target of each posture in the world frame [in]; None on the bench
    tilt: np.ndarray            # (N,): theta2 + theta3 + theta4 of the readings [rad]
    point: np.ndarray           # (N,): index of the posture, hole or point
    base_position: np.ndarray   # (3,) position of the true base in the cell's nominal base frame
    base_turn: np.ndarray       # (3,) rotation vector of the true base

    def numbers(self, session):
        """Returns the parameters of the true arm without effects at a session's readings."""
        numbers = Numbers.nominal(self.arm, session.q, session.load)
        numbers.base_position += self.base_position
        numbers.base_turn += self.base_turn
        return numbers


def identified(arm):
    """Returns the stiffnesses that a fit frees, as (field, link, axis)."""
    return [(name, *row_and_axis(arm, place)) for name, place in IDENTIFIED]


def true_arm(arm, rng, spread=.1):
    """Returns the arm with random errors of up to 10 % in every identified stiffness."""
    spring, rod = arm.spring.copy(), arm.rod.copy()
    for name, link, axis in identified(arm):
        (spring if name == "spring" else rod)[link, axis] /= 1. + spread * rng.uniform(-1., 1.)
    return replace(arm, spring=spring, rod=rod)


def draw_design(kind, drawn, rng):
    """Returns a random Design of the given kind for the nominal arm."""
    arm = true_arm(drawn, rng)
    return {"bench": _bench, "bowl": _bowl, "touch": _touch}[kind](arm, rng)


def _work_postures(arm, rng, count, tilt_spread):
    """Returns joint readings, (count, 4), with the tool about level and the tip above the base at a distance between 20
    and 95 in."""
    postures = np.empty((0, len(arm.joints)))
    while len(postures) < count:
        q = rng.uniform([-80., 30., -125., 0.], [80., 140., -20., 0.], (8 * count, 4)) * DEG
        tilt = np.clip(rng.normal(0., tilt_spread, len(q)), -2. * tilt_spread, 2. * tilt_spread) * DEG
        q[:, 3] = tilt - q[:, 1] - q[:, 2]
        height = arm.a[4] * np.sin(q[:, 1]) + arm.a[5] * np.sin(q[:, 1] + q[:, 2])
        ahead = arm.a[4] * np.cos(q[:, 1]) + arm.a[5] * np.cos(q[:, 1] + q[:, 2])
        postures = np.concatenate([postures, q[within_limits(arm, q) & (height > -8.) & (ahead > -22.)]])
    return postures[:count]


def within_limits(arm, q, margin=3. * DEG):
    """Returns for each posture whether all joints are within their limits by the margin, (N,)."""
    return np.all((q > arm.limits[:, 0] + margin) & (q < arm.limits[:, 1] - margin), axis=1)


def _workable(arm, q):
    """Returns for each posture whether it is within the limits and has a clearly bent elbow, because a stretched arm
    cannot reach a point under every load."""
    return within_limits(arm, q) & (np.abs(q[:, 2]) > STRETCHED)


def _bench(arm, rng, postures=40, loads=(0., 20., 40.)):
    tilt_spread = rng.choice([8., 30.], p=[.75, .25])      # deg: on a bench the tool may tilt freely
    q = _work_postures(arm, rng, postures, tilt_spread).repeat(len(loads), axis=0)
    session = draw_session(q, np.tile(loads, postures), rng)
    point = np.arange(postures).repeat(len(loads))
    return Design("bench", arm, session, None, q[:, 1:].sum(1), point, np.zeros(3), np.zeros(3))


def _bowl(arm, rng, holes=45, loads=(0., 30.)):
    base_position, base_turn = rng.normal(0., .16, 3), rng.normal(0., .004, 3)       # 4 mm, 4 mrad
    azimuth, radius = rng.uniform(-66., 66., 2 * holes) * DEG, np.sqrt(rng.uniform(24. ** 2, 76. ** 2, 2 * holes))
    places = np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth)], axis=1)
    sheet = np.unique(np.round(places / PITCH), axis=0) * PITCH
    targets = np.concatenate([sheet, np.full((len(sheet), 1), FACE)], axis=1).round(4)
    tilt = np.clip(rng.normal(0., 8., len(sheet)), -16., 16.) * DEG
    def design(chosen):
        point = np.arange(len(chosen)).repeat(len(loads))
        goals, tilts = targets[chosen], tilt[chosen]
        session = draw_session(guess(arm, goals, tilts)[point], np.tile(loads, len(chosen)), rng)
        return Design("bowl", arm, session, goals[point], tilts[point], point, base_position, base_turn)
    reachable = np.flatnonzero(np.all(np.isfinite(guess(arm, targets, tilt)), axis=1))
    everything = design(reachable)
    held = _workable(arm, reach(everything, [], closeness=ROUGHLY)).reshape(-1, len(loads)).all(1)
    chosen = design(rng.permutation(reachable[held])[:holes])
    chosen.session.q = reach(chosen, [])
    return chosen


def _touch(arm, rng, points=31):
    """Returns a design that touches each point without load and under one or two loads. For about half of the points,
    the touch under the first load has another elbow side or tilt."""
    first = _work_postures(arm, rng, 2 * points, 8.)
    tip = solve(arm, Numbers.nominal(arm, first, np.zeros(len(first))), 4).tip
    tilt = first[:, 1:].sum(1)
    rows = []       # (point, load, tilt, elbow)
    for k in range(len(first)):
        rows.append((k, 0., tilt[k], -1.))
        again, loads = rng.uniform(), rng.permutation([20., 30., 40.])
        lean = rng.choice([-1., 1.]) * rng.uniform(8., 25.) * DEG
        way = (tilt[k], -1.) if again > .5 else (tilt[k] + lean, -1.) if again > .25 else (tilt[k], 1.)
        rows.append((k, loads[0], *way))
        if k % 3 == 0:
            rows.append((k, loads[1], tilt[k], -1.))
    point, load, tilt, elbow = (np.array(column) for column in zip(*rows))
    def design(keep):
        _, index = np.unique(point[keep], return_inverse=True)
        session = draw_session(guess(arm, tip[point[keep]], tilt[keep], elbow[keep]), load[keep], rng)
        return Design("touch", arm, session, tip[point[keep]], tilt[keep], index, np.zeros(3), np.zeros(3))
    finite = np.all(np.isfinite(guess(arm, tip[point], tilt, elbow)), axis=1)
    held = np.zeros(len(point), bool)
    held[finite] = _workable(arm, reach(design(finite), [], closeness=ROUGHLY))
    whole = [k for k in range(len(first)) if held[point == k].all()][:points]
    chosen = design(np.isin(point, whole))
    chosen.session.q = reach(chosen, [])
    return chosen


def guess(arm, targets, tilt, elbow=-1.):
    """Returns readings that bring the rigid arm's tip near the targets, (N, 4); NaN where out of reach. `elbow` is the
    sign of theta3."""
    ahead = targets[:, 0] - arm.a[1]
    radius, height = np.hypot(ahead, targets[:, 1]) - arm.a[3], targets[:, 2] - arm.d[2]
    wrist_r = radius - arm.tip[0] * np.cos(tilt) + arm.tip[1] * np.sin(tilt)
    wrist_z = height - arm.tip[0] * np.sin(tilt) - arm.tip[1] * np.cos(tilt)
    upper, fore = arm.a[4], arm.a[5]
    cosine = (wrist_r ** 2 + wrist_z ** 2 - upper ** 2 - fore ** 2) / (2. * upper * fore)
    theta3 = elbow * np.arccos(np.where(np.abs(cosine) < .985, cosine, np.nan))
    theta2 = np.arctan2(wrist_z, wrist_r) - np.arctan2(fore * np.sin(theta3), upper + fore * np.cos(theta3))
    return np.stack([np.arctan2(targets[:, 1], ahead), theta2, theta3, tilt - theta2 - theta3], axis=1)


def reach(design, effects, targets=None, closeness=NEARLY, pieces=4, most=40):
    """Returns readings (N, 4) that bring the measured tip of the arm with effects to the targets at the design's tilts.

    effects: [(effect, place, shape, size)]; closeness: tolerance [in]. Newton's method with the geometric Jacobian of
    the deflected arm, starting from the session's readings. Rows that do not converge are NaN.
    """
    targets = design.targets if targets is None else targets
    session, state = replace(design.session, q=design.session.q.copy()), None
    for _ in range(most):
        numbers = design.numbers(session)
        for effect, place, shape, size in effects:
            effect.apply(numbers, design.arm, session, place, shape, size)
        state = solve(design.arm, numbers, pieces, state, .1 * closeness)
        missing = targets - measured(numbers, state)
        if np.abs(missing).max() < closeness:
            break
        lean = design.tilt - session.q[:, 1:].sum(1)
        wanted = np.concatenate([missing, lean[:, None]], axis=1)
        step = np.linalg.solve(_joint_columns(design.arm, state), wanted[..., None])[..., 0]
        session.q = session.q + np.clip(step, -.3, .3)
    return np.where(np.abs(missing).max(1, keepdims=True) < closeness, session.q, np.nan)


def _joint_columns(arm, state):
    """Returns the derivatives of tip and tilt with respect to each joint at constant deflections, (N, 4, 4)."""
    columns = np.zeros((len(state.tip), 4, 4))
    for joint, row in enumerate(arm.joint_rows):
        columns[:, :3, joint] = cross(state.R_W[row][..., 2], state.tip - state.p_W[row])
    columns[:, 3, 1:] = 1.
    return columns
