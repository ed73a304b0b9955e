"""Signatures: the part of an effect in the readings that the fitted parameters cannot absorb.

A Scene is one session on one arm: the tip at every reading, the noise, and the derivatives of the tip with respect to
every parameter of the arm (finite differences of the rod model, in one batch). It yields the Jacobian columns of the
fitted parameters, the length d of a signature orthogonal to these columns in noise sigmas, and the correlation of the
signature with the signatures of rivals.
"""
from dataclasses import dataclass, fields

import numpy as np

from arm_physics import Numbers, measured, solve, spring_turn
from rotations import turned

COARSE = 4              # pieces of a rod in this module: the tip is within 1e-6 in of that with fine rods
SPARE_RODS = ((2, 0), (2, 1), (2, 2), (4, 0), (4, 1), (4, 2), (5, 2))     # (row, axis) made compliant by effects only
USUAL_RODS = ((0, 0), (0, 1), (0, 2), (3, 0), (3, 1), (3, 2))
STEP = {"q": 1e-4, "turn": 1e-4, "alpha": 1e-4, "base_turn": 1e-4, "gravity_tilt": 1e-3, "a": 1e-3, "tip": 1e-3,
        "base_position": 1e-3, "rod": 1e-9, "distributed": 1e-2, "end_weight": 1e-1, "end_force": 1e-1,
        "payload_offset": 1e-2, "stretch": 1e-5}
STEP_TOLERANCE = 1e-7   # in: tolerance of the equilibrium; a difference step moves the tip by about 1e-2 in


def _primitives(arm):
    """Returns the parameters that effects or fits may change, as (field, index)."""
    joints, links = len(arm.joints), len(arm.links)
    plain = [("q", (j,)) for j in range(joints)] + [("gravity_tilt", (k,)) for k in range(2)] + [("stretch", (0,))]
    plain += [(name, (k,)) for name in ("tip", "payload_offset", "base_position", "base_turn") for k in range(3)]
    plain += [(name, (link,)) for name in ("a", "alpha") for link in range(1, links)] + [("distributed", (links - 1,))]
    plain += [("turn", (link, axis)) for link in range(links) for axis in range(3)]
    plain += [("end_weight", (link,)) for link in range(2, links - 1)]
    plain += [("end_force", (link, axis)) for link in range(2, links) for axis in range(3)]
    return plain + [("rod", index) for index in USUAL_RODS]


@dataclass
class Scene:
    arm: object                  # arm with the true stiffnesses
    session: object
    point: np.ndarray            # (N,): index of the touched point; None if the tip is measured or the points are known
    base_fitted: bool
    numbers: Numbers             # parameters without effects
    rest: object                 # Equilibrium without effects
    tip: np.ndarray              # (N, 3): measured tip without effects [in]
    slopes: dict                 # derivative of the tip, (N, 3), keyed by (field, index)
    whitening: np.ndarray        # (N, 3, 3): inverse Cholesky factor of each reading's covariance
    fitted: np.ndarray           # (3N, p): orthonormal basis of the fitted parameters' whitened columns

    @property
    def moments(self):
        """Moments without effects, (N, L, 3) [lbf in]."""
        return self.rest.moments

    def difference(self, changed):
        """Returns the first-order tip movement when the parameters change from `numbers` to `changed`, (N, 3)."""
        moved = np.zeros_like(self.tip)
        for name, change in self._changes(changed).items():
            for index in zip(*np.nonzero(np.any(change, axis=0))):
                moved += self.slopes[name, tuple(int(i) for i in index)] * change[(slice(None),) + index][:, None]
        return moved

    def _changes(self, changed):
        names = [f.name for f in fields(Numbers) if f.name not in ("load", "spring", "soft", "knee", "turn")]
        changes = {name: getattr(changed, name) - getattr(self.numbers, name) for name in names}
        changes["turn"] = spring_turn(changed, self.moments) - spring_turn(self.numbers, self.moments)
        return changes

    def beyond(self, tip_change):
        """Returns the whitened signature (3N,) without the part that the fitted parameters absorb; its norm is d."""
        whitened = turned(self.whitening, tip_change).ravel()
        return whitened - self.fitted @ (self.fitted.T @ whitened)

    def exact_change(self, numbers):
        """Returns the exact tip movement of the changed arm, (N, 3), or None if no equilibrium was found."""
        solution = solve(self.arm, numbers, COARSE, self.rest, tolerance=1e-7)
        return measured(numbers, solution) - self.tip if solution.converged else None


def linearise(arm, session, numbers, sigma, joint_sigma, identified, point=None, base_fitted=False):
    """Returns the Scene of a session; identified: (field, link, axis) of the stiffnesses that a fit frees."""
    base = solve(arm, numbers, COARSE)
    slopes = _slopes(arm, numbers, base, _primitives(arm))
    slopes |= _slopes(arm, numbers, base, [("rod", index) for index in SPARE_RODS])
    joints = np.stack([slopes["q", (j,)] for j in range(len(arm.joints))], axis=2)
    covariance = sigma ** 2 * np.eye(3) + joint_sigma ** 2 * joints @ joints.transpose(0, 2, 1)
    whitening = np.linalg.inv(np.linalg.cholesky(covariance))
    tip = measured(numbers, base)
    scene = Scene(arm, session, point, base_fitted, numbers, base, tip, slopes, whitening, None)
    columns = np.stack([turned(whitening, column).ravel() for column in _fitted_columns(scene, identified)], axis=1)
    if point is not None:
        columns = np.concatenate([columns, _point_columns(whitening, point)], axis=1)
    scene.fitted = orthonormal(columns)
    return scene


def _slopes(arm, numbers, base, primitives):
    batch = numbers.tiled(len(primitives))
    count = len(numbers.q)
    for k, (name, index) in enumerate(primitives):
        getattr(batch, name)[(slice(k * count, (k + 1) * count),) + index] += STEP[name]
    state = solve(arm, batch, COARSE, base.tiled(len(primitives)), STEP_TOLERANCE)
    moved, reference = measured(batch, state).reshape(len(primitives), count, 3), measured(numbers, base)
    return {primitive: (moved[k] - reference) / STEP[primitive[0]] for k, primitive in enumerate(primitives)}


def _fitted_columns(scene, identified):
    for name, link, axis in identified:
        compliance = getattr(scene.numbers, name)[:, link, axis, None]
        if name == "spring":
            yield scene.slopes["turn", (link, axis)] * compliance * scene.moments[:, link, axis, None]
        else:
            yield scene.slopes["rod", (link, axis)] * compliance
    if scene.base_fitted:
        yield from (scene.slopes[name, (k,)] for name in ("base_position", "base_turn") for k in range(3))


def _point_columns(whitening, point):
    columns = np.zeros((len(point), 3, point.max() + 1, 3))
    columns[np.arange(len(point)), :, point] = whitening
    return columns.reshape(3 * len(point), -1)


def orthonormal(columns, floor=1e-9):
    """Returns an orthonormal basis of the span of the normalised columns, without directions whose singular value
    relative to the largest is below `floor`."""
    lengths = np.linalg.norm(columns, axis=0)
    columns = columns[:, lengths > 0.] / lengths[lengths > 0.]
    left, values, _ = np.linalg.svd(columns, full_matrices=False)
    return left[:, values > floor * max(values.max(initial=0.), 1e-300)]


def effect_change(scene, effect, place, shape, size):
    """Returns the first-order tip movement of an effect, (N, 3)."""
    return scene.difference(with_effect(scene, effect, place, shape, size))


def with_effect(scene, effect, place, shape, size):
    """Returns the scene's parameters with an effect applied."""
    numbers = scene.numbers.tiled(1)
    effect.apply(numbers, scene.arm, scene.session, place, shape, size)
    return numbers


def rival_bases(scene, catalogue, kept=1e-4):
    """Yields every catalogue effect at every place as (effect, place, orthonormal columns beyond the fitted columns).

    An effect whose shape must be searched for yields several entries. Directions of which the fitted parameters leave
    a fraction below `kept` are omitted, because they are not observable.
    """
    for effect in catalogue:
        for place in effect.places(scene.arm):
            for group in effect.groups(scene.arm, place, scene):
                changes = [effect_change(scene, effect, place, shape, effect.low) for shape in group]
                raw = np.array([np.linalg.norm(turned(scene.whitening, change)) for change in changes])
                columns = np.stack([scene.beyond(change) for change in changes], axis=1) / np.maximum(raw, 1e-300)
                left, values, _ = np.linalg.svd(columns, full_matrices=False)
                if np.any(values > kept):
                    yield effect, place, left[:, values > kept]


def closest_rival(signature, rivals, without=(), most_columns=np.inf):
    """Returns the rival with the highest correlation to a projected signature, among rivals with few enough columns.

    `without` lists the (effect name, place) to omit.
    """
    best = {"effect": "", "at": "", "correlation": 0., "columns": 0}
    for effect, place, columns in rivals:
        if (effect.name, place) in without or columns.shape[1] > most_columns:
            continue
        correlation = np.linalg.norm(columns.T @ signature) / np.linalg.norm(signature)
        if correlation > best["correlation"]:
            best = {"effect": effect.name, "at": place, "correlation": float(correlation), "columns": columns.shape[1]}
    return best
