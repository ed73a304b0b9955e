"""Parameters of a hidden effect under the program's names, in the units of the program's answers (inch, degree,
pound-force, degF)."""
import math

from arm_description import read_arm


def true_numbers(effect, of):
    """Returns the parameters that have a counterpart in the program, keyed by the program's names. Components of
    vectors in the generator's frames have no counterpart."""
    if effect in ("encoder-eccentricity", "transmission-error"):
        phase = math.radians(of["phase_deg"])
        return {"sine": of["amplitude_deg"] * math.cos(phase), "cosine": of["amplitude_deg"] * math.sin(phase)}
    if effect in ("tool-offset", "payload-offset"):
        return dict(zip("xyz", next(iter(of.values()))))
    return {name: make(of) for name, make in SCALARS.get(effect, {}).items()}


SCALARS = {
    "backlash": {"gap": lambda of: of["gap_deg"]},
    "contact-force": {"force": lambda of: of["force_lbf"]},
    "hysteresis": {"half_width": lambda of: of["half_width_deg"]},
    "joint-compliance": {"compliance": lambda of: 1 / of["K_inlb_per_deg"]},
    "joint-coupling": {"share": lambda of: of["share"]},
    "joint-offset": {"offset": lambda of: of["offset_deg"]},
    "joint-scale": {"scale": lambda of: of["share"]},
    "link-bending": {"compliance": lambda of: 1 / (read_arm().modulus * of["I_in4"])},
    "link-lean": {"lean": lambda of: of["delta_deg"]},
    "link-length": {"length": lambda of: of["delta_in"]},
    "link-torsion": {"compliance": lambda of: 1 / of["GJ_lbfin2"]},
    "link-twist": {"twist": lambda of: of["delta_deg"]},
    "link-weight": {"weight": lambda of: of["extra_lbf"]},
    "scale-error": {"scale": lambda of: of["share"]},
    "thermal-growth": {"expansion": lambda of: of["per_degF"]},
    "tool-weight": {"scale": lambda of: of["share"]},
}
