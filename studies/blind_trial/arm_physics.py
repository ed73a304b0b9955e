"""Static equilibrium of the arm: joints, springs and geometrically exact rods under dead loads, many postures at once.

A rod is inextensible and unshearable. Its curvature in its own turned section frame is the section's compliance times
the moment there (Kirchhoff); the moment is that of every load beyond the section on the *deformed* arm. Section frames
follow by composing the exact rotations of the pieces (fourth-order exponent), positions by integrating the tangent. A
spring turns its frame about the frame's own axes by compliance times moment, plus a soft part that stops at a knee,
plus a given turn.

The outer loop is a fixed point: moments of the last shape give turns and curvatures, these give the next shape. A sweep
shrinks the error by about the ratio of load times lever to stiffness; the Cobra takes some ten.

Symbols: R_W*, p_W*: pose of a frame in the world; N postures; L links; K pieces of a rod. Units as in arm_description.
"""
from dataclasses import dataclass, fields
import functools

import numpy as np

from rotations import cross, exponential, link_rotation, turned, turned_back

PIECES = 32
TOLERANCE = 1e-10       # in, the tip's movement in the last sweep


@dataclass
class Numbers:
    """Everything that may differ from posture to posture; effects change these. All arrays have N as first axis."""
    q: np.ndarray                 # (N, J) true joint angles
    load: np.ndarray              # (N,) hung at the tip
    a: np.ndarray                 # (N, L)
    alpha: np.ndarray             # (N, L)
    tip: np.ndarray               # (N, 3)
    spring: np.ndarray            # (N, L, 3) compliance
    soft: np.ndarray              # (N, L, 3) extra compliance up to the knee moment
    knee: np.ndarray              # (N, L, 3) lbf in
    turn: np.ndarray              # (N, L, 3) given rotation of the frame
    rod: np.ndarray               # (N, L, 3) compliance per length
    distributed: np.ndarray       # (N, L)
    end_weight: np.ndarray        # (N, L)
    end_force: np.ndarray         # (N, L, 3) at the link's end, world axes
    payload_offset: np.ndarray    # (N, 3) of the hung load from the tip, in the tool's frame
    gravity_tilt: np.ndarray      # (N, 2) lean of gravity about world x and y
    base_position: np.ndarray     # (N, 3)
    base_turn: np.ndarray         # (N, 3) rotation vector of the base in the world
    stretch: np.ndarray           # (N, 1) measured coordinates are times 1 + stretch

    @staticmethod
    def nominal(arm, q, load):
        """The arm as drawn, base at the world's origin."""
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
        """The same postures again and again, times copies in a row."""
        return Numbers(**{f.name: np.concatenate([getattr(self, f.name)] * times) for f in fields(self)})


@dataclass
class Equilibrium:
    tip: np.ndarray               # (N, 3) in, world frame
    R_tip: np.ndarray             # (N, 3, 3)
    moments: np.ndarray           # (N, L, 3) lbf in, at each frame in its own axes
    curvature: dict               # link -> (N, K + 1, 3) 1/in
    R_W: list = None              # per link (N, 3, 3)
    p_W: list = None              # per link (N, 3)
    sweeps: int = 0
    converged: bool = False

    def tiled(self, times):
        """A start for Numbers.tiled."""
        def again(array): return np.concatenate([array] * times)
        return Equilibrium(again(self.tip), again(self.R_tip), again(self.moments),
                           {link: again(kappa) for link, kappa in self.curvature.items()})


def solve(arm, numbers, pieces=PIECES, start=None, tolerance=TOLERANCE, most_sweeps=80):
    """The Equilibrium of every posture; start (an Equilibrium of like postures with the same pieces) saves sweeps."""
    count, links = numbers.a.shape
    rods = [link for link in range(links) if np.any(numbers.rod[:, link])]
    state = start or Equilibrium(np.full((count, 3), np.inf), None, np.zeros((count, links, 3)), {})
    straight = np.zeros((count, pieces + 1, 3))
    curvature = {link: state.curvature.get(link, straight) for link in rods}
    moments, tip, converged = state.moments, state.tip, False
    for sweep in range(1, most_sweeps + 1):
        shape = _shape(arm, numbers, moments, curvature, pieces)
        moved = np.abs(shape.p_WTip - tip).max()
        tip, converged = shape.p_WTip, sweep > 1 and bool(moved <= tolerance)      # the first sweep has a start's loads
        if converged:
            break
        moments, curvature = _loads(numbers, arm, shape, pieces)
    return Equilibrium(tip, shape.R_WTip, moments, curvature, shape.R_W, shape.p_W, sweep, converged)


def measured(numbers, equilibrium):
    """The tip as the measuring instrument gives it, (N, 3)."""
    return (1. + numbers.stretch) * equilibrium.tip


@dataclass
class _Shape:
    R_W: list        # per link (N, 3, 3), springs turned
    p_W: list        # per link (N, 3)
    end: list        # per link, the point where it ends
    rods: dict       # link -> (length, Q, rho): section frames (N, K+1, 3, 3) and points (N, K+1, 3) in it
    R_WTip: np.ndarray = None
    p_WTip: np.ndarray = None


def spring_turn(numbers, moments):
    """Rotation of each frame about its own axes under these moments, (N, L, 3)."""
    return numbers.turn + numbers.spring * moments + numbers.soft * np.clip(moments, -numbers.knee, numbers.knee)


def _chords(arm, numbers):
    """From each frame to where its link ends, in that frame: (N, L, 3)."""
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
    """A rod of the chord's length and first direction with curvature kappa at its nodes, as in _Shape.rods."""
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
    """Moments at every frame and the rods' curvatures, from the loads on this shape."""
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
    """Moments at the rod's nodes, (N, K + 1, 3), under end force, end moment and weight per length; link's frame."""
    length, _, rho = rod
    gathered = np.matmul(_quadrature(pieces)[1], rho) * length[:, None, None]     # the points' integral up to each node
    left = length[:, None, None] * np.linspace(1., 0., pieces + 1)[:, None]
    beyond = gathered[:, -1:] - gathered - left * rho
    return M[:, None] + cross(rho[:, -1:] - rho, F[:, None]) + cross(beyond, weight[:, None])


@functools.lru_cache
def _quadrature(pieces):
    """Integrals of a function known at the nodes of [0, 1] in equal pieces, exact for cubics.

    Returns the matrices (K, K + 1) to the integral over each piece and (K + 1, K + 1) to that up to each node.
    """
    steps = np.zeros((pieces, pieces + 1))
    for k in range(pieces):
        nodes = np.arange(4) + min(max(k - 1, 0), pieces - 3)
        powers = np.vander(nodes - k, 4, increasing=True).T.astype(float)
        steps[k, nodes] = np.linalg.solve(powers, 1. / np.arange(1, 5)) / pieces
    return steps, np.concatenate([np.zeros((1, pieces + 1)), np.cumsum(steps, axis=0)])
