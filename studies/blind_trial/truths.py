"""What is hidden in a set: effects with a place, a shape and a size that gives their signature a wanted length d."""
from dataclasses import dataclass
import itertools

import numpy as np

from designs import SIGMA, draw_design, identified
from effects import CATALOGUE
from signatures import closest_rival, linearise, orthonormal, rival_bases, with_effect

DESIGN_SHARES = {"bench": .45, "bowl": .35, "touch": .2}
SMALLEST = .05              # times an effect's low size: how far scaling may go down
LEAST_PHYSICAL_D = 2.       # an effect of physical size that leaves less is drawn again: nothing could be said of it
D_AIM, D_CLOSENESS = 1.005, .004        # a little above the wanted d, so that a set of d 8 is not one below 8
PAIR_LIKENESS = .9          # two hidden effects more alike than this are drawn again
PLACES_TRIED, DESIGNS_TRIED = 5, 12


class NoPlace(RuntimeError):
    """No design and place shows these effects together as long as wanted."""


@dataclass
class Hidden:
    effect: object
    place: str
    shape: object
    size: float
    scale: float                # size over the size first drawn
    signature: np.ndarray       # (3N,) whitened, beyond what is fitted
    d: float

    @property
    def parts(self):
        """As `apply` wants them."""
        return self.effect, self.place, self.shape, self.size

    def entry(self, arm):
        """As the truth file has it."""
        parameters = self.effect.parameters(arm, self.place, self.shape, self.size)
        return {"effect": self.effect.name, "at": self.place, "parameters": parameters}


@dataclass
class Truth:
    design: object
    scene: object
    hidden: list                # of Hidden
    stratum: str


def draw_scene(drawn_arm, designs, rng):
    """A random design among those named, and its Scene."""
    shares = np.array([DESIGN_SHARES[kind] for kind in designs])
    kind = str(rng.choice(designs, p=shares / shares.sum()))
    design = draw_design(kind, drawn_arm, rng)
    point = design.point if kind == "touch" else None
    scene = linearise(design.arm, design.session, design.numbers(design.session), SIGMA[kind], drawn_arm.encoder_sigma,
                      identified(drawn_arm), point, kind == "bowl")
    return design, scene


def draw_truth(drawn_arm, effects, wanted, stratum, rng):
    """Effects (0 to 3 of them) hidden in a design; wanted: their lengths d, None for a size as it comes.

    Where no design and place lets the size reach d, the set falls back to physical size, and its stratum says so.
    """
    designs = [kind for kind in DESIGN_SHARES if all(kind in effect.designs for effect in effects)]
    for attempt in range(2 * DESIGNS_TRIED):
        if attempt == DESIGNS_TRIED:
            wanted, stratum = [None] * len(effects), stratum.split("-d")[0] + "-physical"
        design, scene = draw_scene(drawn_arm, designs, rng)
        hidden = [_hide(scene, effect, d, rng) for effect, d in zip(effects, wanted)]
        if all(hidden) and _distinct(hidden):
            return Truth(design, scene, hidden, stratum)
    raise NoPlace(f"no place found for {[effect.name for effect in effects]}")


def _hide(scene, effect, wanted, rng):
    places = rng.permutation(effect.places(scene.arm))[:PLACES_TRIED]
    for place in places:
        hidden = _sized(scene, effect, str(place), wanted, rng)
        if hidden and (wanted or hidden.d >= LEAST_PHYSICAL_D):
            return hidden
    return None


def _sized(scene, effect, place, wanted, rng):
    """Hidden with d as wanted, or None where no size in the effect's range does."""
    shape = effect.shapes(rng, scene.arm, place, scene)
    size = drawn = float(np.exp(rng.uniform(np.log(effect.low), np.log(effect.high))))
    for _ in range(8):
        if not SMALLEST * effect.low <= size <= effect.high:
            return None
        change = scene.exact_change(with_effect(scene, effect, place, shape, size))
        if change is None:
            return None
        signature = scene.beyond(change)
        d = float(np.linalg.norm(signature))
        if wanted is None or abs(d / wanted - D_AIM) < D_CLOSENESS:
            return Hidden(effect, place, shape, size, size / drawn, signature, d)
        size *= D_AIM * wanted / max(d, 1e-9)
    return None


def _distinct(hidden):
    units = [part.signature / part.d for part in hidden]
    return all(abs(one @ other) < PAIR_LIKENESS for one, other in itertools.combinations(units, 2))


def joint_change(truth):
    """The tip's movement by all hidden effects at the nominal readings, (N, 3)."""
    scene, numbers = truth.scene, truth.scene.numbers.tiled(1)
    for part in truth.hidden:
        part.effect.apply(numbers, scene.arm, scene.session, part.place, part.shape, part.size)
    return scene.exact_change(numbers)


def rivals_of(truth):
    """What `lengths_beside` and `twins` compare with: rival_bases of the whole catalogue."""
    return list(rival_bases(truth.scene, CATALOGUE))


def lengths_beside(truth, rivals):
    """Of each hidden effect, two or more, the length d that the others leave of it, all their parameters free."""
    lengths = []
    for part in truth.hidden:
        others = {(other.effect.name, other.place) for other in truth.hidden if other is not part}
        columns = [base for effect, place, base in rivals if (effect.name, place) in others]
        columns += [other.signature[:, None] for other in truth.hidden if other is not part]
        base = orthonormal(np.concatenate(columns, axis=1))
        lengths.append(float(np.linalg.norm(part.signature - base @ (base.T @ part.signature))))
    return lengths


def twins(truth, rivals):
    """For each hidden effect its (twin, peer), the other hidden effects being known.

    The twin is the rival of the catalogue most like it; the peer the same among rivals with no more parameters than it
    has itself. A twin that is no peer holds the truth as a part and should lose by its parameters' price.
    """
    without = [(part.effect.name, part.place) for part in truth.hidden]
    found = []
    for part in truth.hidden:
        signature = part.signature
        others = [other.signature for other in truth.hidden if other is not part]
        if others:
            basis, _ = np.linalg.qr(np.column_stack(others))
            signature = signature - basis @ (basis.T @ signature)
        found.append((closest_rival(signature, rivals, without),
                      closest_rival(signature, rivals, without, _parameter_count(truth, part))))
    return found


def _parameter_count(truth, part):
    """How many columns the effect's own signature has; one for an effect outside the catalogue."""
    groups = part.effect.groups
    return len(groups(truth.design.arm, part.place, truth.scene)[0]) if groups else 1
