"""Static equilibrium of the arm: joints, springs and geometrically exact rods under dead loads, many postures at once.

A rod is inextensible and unshearable. Its curvature in the rotated section frame is the section's compliance times the
moment at the section (Kirchhoff), where the moment is that of all loads beyond the section on the *deformed* arm.
Section frames are products of the exact rotations of the rod's pieces (fourth-order exponent); positions are integrals
of the tangent. A spring rotates its frame about the frame's axes by three terms: compliance times moment, a soft part
that is limited at a knee moment, and a prescribed rotation.

The outer loop is a fixed-point iteration: the moments on the last shape give rotations and curvatures, which give the
next shape. An iteration (sweep) reduces the error by about the ratio of load times lever to stiffness; the Cobra needs
about ten iterations.

Symbols: R_W*, p_W*: pose of a frame in the world; N postures; L links; K pieces of a rod. Units as in arm_description.
"""
from dataclasses import dataclass, fields
import functools

import numpy as np

from rotations import cross, exponential, link_rotation, turned, turned_back

PIECES = 32
TOLERANCE = 1e-10       # largest movement of the tip in the last sweep [in]


@dataclass
class Numbers:
    """Parameters that may differ between postures and that effects change. Comments begin with the array's shape."""
    q: np.ndarray                 # (N, J): true joint angles [rad]
    load: np.ndarray              # (N,): weight suspended at the tip [lbf]
    a: np.ndarray                 # (N, L): distance from the previous frame to this one [in]
    alpha: np.ndarray             # (N, L): twist from the previous frame to this one [rad]
    tip: np.ndarray               # (N, 3): tip in the last frame [in]
    spring: np.ndarray            # (N, L, 3): compliance about each axis [rad/(lbf in)]
    soft: np.ndarray              # (N, L, 3): additional compliance up to the knee moment [rad/(lbf in)]
    knee: np.ndarray              # (N, L, 3): knee moment [lbf in]
    turn: np.ndarray              # (N, L, 3): prescribed rotation of the frame [rad]
    rod: np.ndarray               # (N, L, 3): curvature per moment [1/(lbf in^2)]
    distributed: np.ndarray       # (N, L): weight per length from this frame to the next [lbf/in]
    end_weight: np.ndarray        # (N, L): weight at the next frame, or at the tip for the last link [lbf]
    end_force: np.ndarray         # (N, L, 3): force at the link's end, in world axes [lbf]
    payload_offset: np.ndarray    # (N, 3): offset of the suspended load from the tip, in the tool's frame [in]
    gravity_tilt: np.ndarray      # (N, 2): tilt of gravity about world x and y [rad]
    base_position: np.ndarray     # (N, 3): position of the base in the world [in]
    base_turn: np.ndarray         # (N, 3): rotation vector of the base in the world [rad]
    stretch: np.ndarray           # (N, 1): scale error; measured coordinates are multiplied by 1 + stretch

    @staticmethod
    def nominal(arm, q, load):
        """Returns the parameters of the nominal arm with the base at the world's origin."""
        count = len(q)
        def each(value): return np.repeat(np.asarray(value, float)[None], count, axis=0)
        def zero(*shape): return np.zeros((count,) + shape)
        links = len(arm.links)
        return Numbers(
            q=np.array(q, float), load=np.array(load, float),
            a=each(arm.a), alpha=each(arm.alpha), tip=each(arm.tip),
            spring=each(arm.spring), soft=zero(links, 3), knee=zero(links, 3), turn=zero(links, 3),
            rod=each(arm.rod),
            distributed=each(arm.distributed), end_weight=each(arm.end_weight), end_force=zero(links, 3),
            payload_offset=zero(3), gravity_tilt=zero(2), base_position=zero(3), base_turn=zero(3), stretch=zero(1))

    def tiled(self, times):
        """Returns the postures repeated `times` times."""
        return Numbers(**{f.name: np.concatenate([getattr(self, f.name)] * times) for f in fields(self)})


@dataclass
class Equilibrium:
    tip: np.ndarray               # (N, 3): tip in the world frame [in]
    R_tip: np.ndarray             # (N, 3, 3): axes of the tool in the world frame
    moments: np.ndarray           # (N, L, 3): moment at each frame, in the axes of that frame [lbf in]
    curvature: dict               # keyed by link index, (N, K + 1, 3): curvature at the ends of the pieces [1/in]
    R_W: list = None              # for each link, (N, 3, 3): axes of the link's frame in the world
    p_W: list = None              # for each link, (N, 3): origin of the link's frame in the world [in]
    sweeps: int = 0
    converged: bool = False

    def tiled(self, times):
        """Returns the equilibrium repeated `times` times, as a start for Numbers.tiled."""
        def again(array): return np.concatenate([array] * times)
        return Equilibrium(again(self.tip), again(self.R_tip), again(self.moments),
                           {link: again(kappa) for link, kappa in self.curvature.items()})


def solve(arm, numbers, pieces=PIECES, start=None, tolerance=TOLERANCE, most_sweeps=80):
    """Returns the Equilibrium of every posture; `start` (an Equilibrium of similar postures with equally many rod
    pieces) saves sweeps."""
    count, links = numbers.a.shape
    rods = [link for link in range(links) if np.any(numbers.rod[:, link])]
    state = start or Equilibrium(np.full((count, 3), np.inf), None, np.zeros((count, links, 3)), {})
    straight = np.zeros((count, pieces + 1, 3))
    curvature = {link: state.curvature.get(link, straight) for link in rods}
    moments, tip, converged = state.moments, state.tip, False
    for sweep in range(1, most_sweeps + 1):
        shape = _shape(arm, numbers, moments, curvature, pieces)
        moved = np.abs(shape.p_WTip - tip).max()
        tip, converged = shape.p_WTip, sweep > 1 and bool(moved <= tolerance)      # sweep 1 has the loads of `start`
        if converged:
            break
        moments, curvature = _loads(numbers, arm, shape, pieces)
    return Equilibrium(tip, shape.R_WTip, moments, curvature, shape.R_W, shape.p_W, sweep, converged)


def measured(numbers, equilibrium):
    """Returns the tip position as the measuring instrument reports it, (N, 3)."""
    return (1. + numbers.stretch) * equilibrium.tip


@dataclass
class _Shape:
    R_W: list        # for each link, (N, 3, 3): axes of the link's frame in the world, after the rotation of the spring
    p_W: list        # for each link, (N, 3): origin of the link's frame in the world [in]
    end: list        # for each link, (N, 3): end point of the link in the world [in]
    rods: dict       # link -> (length, Q, rho): section frames (N, K+1, 3, 3), points (N, K+1, 3), in the link's frame
    R_WTip: np.ndarray = None
    p_WTip: np.ndarray = None


def spring_turn(numbers, moments):
    """Returns the rotation of each frame about the axes of that frame under the given moments, (N, L, 3)."""
    return numbers.turn + numbers.spring * moments + numbers.soft * np.clip(moments, -numbers.knee, numbers.knee)


def _chords(arm, numbers):
    """Returns the vector from each frame to the end of its link, in that frame, (N, L, 3)."""
    to_next = np.stack([numbers.a, -np.sin(numbers.alpha) * arm.d, np.cos(numbers.alpha) * arm.d], axis=-1)
    return to_next[:, 0], np.concatenate([to_next[:, 1:], numbers.tip[:, None]], axis=1)


def _shape(arm, numbers, moments, curvature, pieces):
    links = len(arm.links)
    theta = np.tile(arm.theta, (len(numbers.q), 1))
    theta[:, arm.joint_rows] += numbers.q
    first, chords = _chords(arm, numbers)
    turns = exponential(spring_turn(numbers, moments))
    R_WB = exponential(numbers.base_turn)
    R, p = R_WB, numbers.base_position + turned(R_WB, first)
    shape = _Shape([], [], [], {})
    for link in range(links):
        R = R @ link_rotation(numbers.alpha[:, link], theta[:, link]) @ turns[:, link]
        shape.R_W.append(R)
        shape.p_W.append(p)
        if link in curvature:
            length, Q, rho = shape.rods[link] = _bent(chords[:, link], curvature[link], pieces)
            p, R = p + turned(R, rho[:, -1]), R @ Q[:, -1]
        else:
            p = p + turned(R, chords[:, link])
        shape.end.append(p)
    shape.R_WTip, shape.p_WTip = R, p
    return shape


def _bent(chord, kappa, pieces):
    """Returns a rod as in _Shape.rods, with the length and initial direction of the chord and curvature kappa at the
    nodes."""
    length = np.sqrt((chord * chord).sum(-1))
    steps, cumulative = _quadrature(pieces)
    step = (length / pieces)[:, None, None]
    exponent = length[:, None, None] * np.matmul(steps, kappa) + step ** 2 / 12. * cross(kappa[:, :-1], kappa[:, 1:])
    pieces_R = exponential(exponent)
    Q = np.empty((len(chord), pieces + 1, 3, 3))
    Q[:, 0] = np.eye(3)
    for k in range(pieces):
        np.matmul(Q[:, k], pieces_R[:, k], out=Q[:, k + 1])
    return length, Q, np.matmul(cumulative, np.matmul(Q, chord[:, None, :, None])[..., 0])


def _loads(numbers, arm, shape, pieces):
    """Returns the moments at every frame and the curvatures of the rods under the loads on a shape."""
    links = len(arm.links)
    lean = np.concatenate([numbers.gravity_tilt, np.zeros((len(numbers.q), 1))], axis=1)
    down = turned(exponential(lean), np.broadcast_to(arm.gravity, lean.shape))
    F = numbers.load[:, None] * down
    M = cross(turned(shape.R_WTip, numbers.payload_offset), F)
    moments, curvature = np.empty((len(F), links, 3)), {}
    for link in reversed(range(links)):
        F = F + numbers.end_weight[:, link, None] * down + numbers.end_force[:, link]
        weight = numbers.distributed[:, link, None]
        R, reach = shape.R_W[link], shape.end[link] - shape.p_W[link]
        if link in shape.rods:
            rod = shape.rods[link]
            local = _rod_moments(rod, turned_back(R, F), turned_back(R, M), weight * turned_back(R, down), pieces)
            curvature[link] = numbers.rod[:, None, link] * turned_back(rod[1], local)
            M, F = turned(R, local[:, 0]), F + weight * rod[0][:, None] * down
        else:
            own = weight * np.sqrt((reach * reach).sum(-1, keepdims=True)) * down
            M, F = M + cross(reach, F + .5 * own), F + own
        moments[:, link] = turned_back(R, M)
    return moments, curvature


def _rod_moments(rod, F, M, weight, pieces):
    """Returns the moments at the rod's nodes, (N, K + 1, 3), in the link's frame, under end force, end moment and
    weight per length."""
    length, _, rho = rod
    gathered = np.matmul(_quadrature(pieces)[1], rho) * length[:, None, None]     # integral of rho up to each node
    left = length[:, None, None] * np.linspace(1., 0., pieces + 1)[:, None]
    beyond = gathered[:, -1:] - gathered - left * rho
    return M[:, None] + cross(rho[:, -1:] - rho, F[:, None]) + cross(beyond, weight[:, None])


@functools.lru_cache
def _quadrature(pieces):
    """Quadrature on [0, 1] from values at the nodes of K equal pieces, exact for cubics.

    Returns two matrices to multiply by the values: (K, K + 1) gives the integral over each piece, (K + 1, K + 1) the
    integral from 0 up to each node.
    """
    steps = np.zeros((pieces, pieces + 1))
    for k in range(pieces):
        nodes = np.arange(4) + min(max(k - 1, 0), pieces - 3)
        powers = np.vander(nodes - k, 4, increasing=True).T.astype(float)
        steps[k, nodes] = np.linalg.solve(powers, 1. / np.arange(1, 5)) / pieces
    return steps, np.concatenate([np.zeros((1, pieces + 1)), np.cumsum(steps, axis=0)])
