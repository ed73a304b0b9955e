"""Catalogue of hidden effects: places on the Cobra, physical sizes, law and shapes of each effect.

An effect acts through `apply(numbers, arm, session, place, shape, size)`, with size in [low, high] in the unit `unit`.
The size of a compliance is the inverse of the stiffness, so that size 0 always means no effect.
"""
from dataclasses import dataclass
from typing import Callable

import effect_laws as laws
from effect_shapes import (DEG, all_joints, at, clearances, couplings, direction, knee, knees, mostly_more, phase,
                           positive, rigid_axes, row_and_axis, sign, single, slip, slips, span, springs, two_phases)

EVERYWHERE, ABSOLUTE = ("bench", "bowl", "touch"), ("bench", "bowl")      # designs


@dataclass(frozen=True)
class Effect:
    name: str
    places: Callable            # arm -> possible places of the effect
    low: float
    high: float
    unit: str
    apply: Callable             # law: changes the arm's parameters in place
    parameters: Callable        # (arm, place, shape, size) -> names and values for the truth file
    shapes: Callable            # (rng, arm, place, scene) -> a random shape
    groups: Callable = None     # (arm, place, scene) -> groups of shapes, each spanning one rival
    designs: tuple = EVERYWHERE


def _signed(name, factor=1.):
    return lambda arm, place, shape, size: {name: factor * size * shape}


def _vector(name):
    return lambda arm, place, shape, size: {name: (size * shape).tolist()}


def _inverse(name, unit):
    return lambda arm, place, shape, size: {name: unit / size}


def _harmonic(arm, place, shape, size):
    return {"amplitude_deg": size, "phase_deg": shape / DEG}


def _stiffening(arm, place, shape, size):
    stiff = DEG / arm.spring[row_and_axis(arm, place)]
    return {"K1": stiff / (1. + size), "K2": stiff, "M1_inlb": shape}


def _slipping(arm, place, shape, size):
    shift = (size * shape["shift"]).tolist()
    return {"at_fraction": shape["at"], "shift_in": shift, "yaw_deg": size * shape["yaw"] / DEG}


MOVING = ("base-link", "latch-link", "forearm")
LONG = at("mezzanine-beam", *MOVING)
JOINED = at("mezzanine-beam", "mezzanine-platform", *MOVING)
LEANING = at("latch-link", "forearm")
BENT = at("mezzanine-beam.y", "base-link.y", "base-link.z", "latch-link.y", "forearm.y", "forearm.z", "tool.z")
HARMONIC, SHARE, VECTOR = (_harmonic, phase, two_phases), (_signed("share"), sign, single), (direction(3), span(3))

# Sizes: angle errors of a few to a hundred times the noise of a reading; lengths 0.1 to 2 mm; weights and forces of a
# hose or a fitting; K 1,500 to 300,000 lbf in/deg; I 0.1 to 10 in^4; GJ 2e5 to 4e7 lbf in^2; stiffening K2/K1 - 1 of
# 0.6 for a harmonic drive, more for a worn drive; thermal expansion of 0.2 to 2 times that of aluminium.
CATALOGUE = (
    Effect("joint-offset", all_joints, .01, .3, "deg", laws.offset, _signed("offset_deg"), sign, single),
    Effect("joint-scale", all_joints, 2e-4, 5e-3, "1", laws.scale, *SHARE),
    Effect("encoder-eccentricity", all_joints, .01, .2, "deg", laws.eccentricity, *HARMONIC),
    Effect("transmission-error", all_joints, .005, .12, "deg", laws.transmission, *HARMONIC),
    Effect("hysteresis", all_joints, .005, .15, "deg", laws.hysteresis, _signed("half_width_deg"), positive, single),
    Effect("joint-coupling", couplings, 2e-4, 5e-3, "1", laws.couple_joints, *SHARE),
    Effect("link-length", LONG, .004, .08, "in", laws.lengthen, _signed("delta_in"), sign, single),
    Effect("link-twist", JOINED, .01, .25, "deg", laws.twist, _signed("delta_deg"), sign, single),
    Effect("link-lean", LEANING, .01, .25, "deg", laws.lean, _signed("delta_deg"), sign, single),
    Effect("tool-offset", at("tool"), .005, .15, "in", laws.move_tip, _vector("delta_in"), *VECTOR),
    Effect("link-weight", at(*MOVING), .3, 8., "lbf", laws.weigh_link, _signed("extra_lbf"), mostly_more, single),
    Effect("tool-weight", at("tool"), .02, .3, "1", laws.weigh_tool, *SHARE),
    Effect("payload-offset", at("payload"), .1, 4., "in", laws.offset_payload, _vector("offset_in"), *VECTOR),
    Effect("gravity-tilt", at("base"), .05, 2., "deg", laws.lean_gravity, _vector("lean_deg"), direction(2), span(2)),
    Effect("hose-pull", at(*MOVING, "tool"), .3, 8., "lbf", laws.pull, _vector("force_lbf"), *VECTOR),
    Effect("contact-force", at("tip"), .5, 10., "lbf", laws.press, _signed("force_lbf"), sign, single),
    Effect("joint-compliance", rigid_axes, 1. / 300., 1. / 1.5, "deg/klbfin", laws.give,
           _inverse("K_inlb_per_deg", 1e3), positive, single),
    Effect("link-bending", BENT, .1, 10., "1/in4", laws.bend, _inverse("I_in4", 1.), positive, single),
    Effect("link-torsion", LONG, .025, 5., "1e-6/lbfin2", laws.twist_rod, _inverse("GJ_lbfin2", 1e6), positive, single),
    Effect("stiffening", springs, .2, 4., "1", laws.soften, _stiffening, knee, knees),
    Effect("backlash", clearances, .01, .3, "deg", laws.loosen, _signed("gap_deg"), positive, single),
    Effect("thermal-growth", at("arm"), 3., 26., "1e-6/degF", laws.grow, _signed("per_degF", 1e-6), positive, single),
    Effect("base-slip", at("base"), .004, .15, "in", laws.slip_base, _slipping, slip, slips),
    Effect("base-drift", at("base"), .005, .15, "in", laws.creep_base, _vector("over_session_in"), *VECTOR),
    Effect("scale-error", at("measurement"), 3e-5, 2e-3, "1", laws.stretch_scale, *SHARE, ABSOLUTE),
)
