"""The hidden truth of a set: effects with place, shape, and a size at which the signature has a wanted length d."""
from dataclasses import dataclass
import itertools

import numpy as np

from designs import SIGMA, draw_design, identified
from effects import CATALOGUE
from signatures import closest_rival, linearise, orthonormal, rival_bases, with_effect

DESIGN_SHARES = {"bench": .45, "bowl": .35, "touch": .2}
SMALLEST = .05              # smallest size after scaling, as a fraction of the effect's low size
LEAST_PHYSICAL_D = 2.       # an effect of physical size with a smaller d is not observable and is drawn again
D_AIM, D_CLOSENESS = 1.005, .004        # target and tolerance, as factors of the wanted d, so that d is not below it
PAIR_LIKENESS = .9          # two hidden effects with a higher correlation are drawn again
PLACES_TRIED, DESIGNS_TRIED = 5, 12


class NoPlace(RuntimeError):
    """Raised if no design and place gives the effects the wanted lengths d."""


@dataclass
class Hidden:
    effect: object
    place: str
    shape: object
    size: float
    scale: float                # ratio of the size to the size drawn first
    signature: np.ndarray       # (3N,) whitened signature, orthogonal to the fitted parameters
    d: float

    @property
    def parts(self):
        """Returns (effect, place, shape, size), the arguments of `apply`."""
        return self.effect, self.place, self.shape, self.size

    def entry(self, arm):
        """Returns the effect in the format of the truth file."""
        parameters = self.effect.parameters(arm, self.place, self.shape, self.size)
        return {"effect": self.effect.name, "at": self.place, "parameters": parameters}


@dataclass
class Truth:
    design: object
    scene: object
    hidden: list                # of Hidden
    stratum: str


def draw_scene(drawn_arm, designs, rng):
    """Returns a random design of one of the given kinds, and its Scene."""
    shares = np.array([DESIGN_SHARES[kind] for kind in designs])
    kind = str(rng.choice(designs, p=shares / shares.sum()))
    design = draw_design(kind, drawn_arm, rng)
    point = design.point if kind == "touch" else None
    scene = linearise(design.arm, design.session, design.numbers(design.session), SIGMA[kind], drawn_arm.encoder_sigma,
                      identified(drawn_arm), point, kind == "bowl")
    return design, scene


def draw_truth(drawn_arm, effects, wanted, stratum, rng):
    """Returns a truth with 0 to 3 effects hidden in a design; wanted: their lengths d, or None for a physical size.

    If no design and place allows the wanted d, physical sizes are used instead, and the stratum of the set states this.
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
    """Returns a Hidden with the wanted d, or None if no size in the effect's range gives that d."""
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
    """Returns the tip movement due to all hidden effects at the nominal readings, (N, 3)."""
    scene, numbers = truth.scene, truth.scene.numbers.tiled(1)
    for part in truth.hidden:
        part.effect.apply(numbers, scene.arm, scene.session, part.place, part.shape, part.size)
    return scene.exact_change(numbers)


def rivals_of(truth):
    """Returns the rival_bases of the whole catalogue, for `lengths_beside` and `twins`."""
    return list(rival_bases(truth.scene, CATALOGUE))


def lengths_beside(truth, rivals):
    """Returns for each of two or more hidden effects the length d that remains if the other effects are fitted."""
    lengths = []
    for part in truth.hidden:
        others = {(other.effect.name, other.place) for other in truth.hidden if other is not part}
        columns = [base for effect, place, base in rivals if (effect.name, place) in others]
        columns += [other.signature[:, None] for other in truth.hidden if other is not part]
        base = orthonormal(np.concatenate(columns, axis=1))
        lengths.append(float(np.linalg.norm(part.signature - base @ (base.T @ part.signature))))
    return lengths


def twins(truth, rivals):
    """Returns (twin, peer) for each hidden effect, with the other hidden effects known.

    The twin is the rival of the catalogue with the highest correlation to the effect; the peer is the rival with the
    highest correlation among those without more parameters. A twin that is no peer contains the truth as a special case
    and should lose because of the penalty for additional parameters.
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
    """Returns the number of columns of the effect's signature; 1 for an effect outside the catalogue."""
    groups = part.effect.groups
    return len(groups(truth.design.arm, part.place, truth.scene)[0]) if groups else 1
