#!/usr/bin/python3
"""check_physics.py: compares rods and chain with closed forms and independent poses. Exit code 0 if all agree.

The poses (200 postures computed by another rod solver) are in shared/reference/poses.csv next to the repository;
without this file, that comparison is omitted.
"""
import argparse
import pathlib
import sys

import numpy as np
from scipy.integrate import quad
from scipy.special import ellipk, ellipkinc

from arm_description import Arm, read_arm
from arm_physics import Numbers, solve
from rotations import cross, exponential, turned

SHARED = pathlib.Path(__file__).resolve().parents[3] / "shared"


def cantilever(length, modulus_inertia, weight=0., isotropic=False):
    """Returns an arm that is one rod along world x, clamped at the origin, with gravity along -y."""
    compliance = 1. / modulus_inertia
    nought = np.zeros(1)
    return Arm(links=("rod",), joints=("clamp",), joint_rows=np.array([0]), limits=np.array([[-1., 1.]]),
               encoder_sigma=0., alpha=nought, a=nought, d=nought, theta=nought, tip=np.array([length, 0., 0.]),
               spring=np.zeros((1, 3)), rod=np.array([[compliance if isotropic else 0.] * 2 + [compliance]]),
               distributed=np.array([weight]), end_weight=nought, gravity=np.array([0., -1., 0.]), modulus=1.)


def tip_of(arm, load, pieces=32):
    return solve(arm, Numbers.nominal(arm, np.zeros((1, 1)), [load]), pieces, most_sweeps=400)


def small_deflection_error():
    """Returns the relative error from F L^3 / 3EI + w L^4 / 8EI at a deflection so small that beam theory is exact."""
    length, stiffness, load, weight = 26.406, 4e6, 1e-3, 1e-4
    want = -(load * length ** 3 / 3. + weight * length ** 4 / 8.) / stiffness
    return abs(tip_of(cantilever(length, stiffness, weight), load).tip[0, 1] / want - 1.)


def elastica_error(pieces):
    """Returns the tip error relative to the length, against the elastica with F L^2 / EI = 1 (tip slope 26 deg).

    With k^2 = (1 + sin slope) / 2 and sin phi = 1 / (k sqrt 2): sqrt(F L^2 / EI) = K(k) - F(phi, k). One quadrature
    gives the deflection of the tip.
    """
    def root_load(slope):
        m = .5 * (1. + np.sin(slope))
        return ellipk(m) - ellipkinc(np.arcsin(1. / np.sqrt(2. * m)), m)
    low, high = 1e-6, 1.5
    for _ in range(200):
        middle = .5 * (low + high)
        low, high = (middle, high) if root_load(middle) < 1. else (low, middle)
    slope = .5 * (low + high)
    # ds = d(theta) / sqrt(2 (sin slope - sin theta)); theta = slope - u^2 removes the singularity at the end
    def drop(u):
        theta = slope - u * u
        gap = np.sin(slope) - np.sin(theta)
        return np.sin(theta) * (2. * u / np.sqrt(2. * gap) if u > 0. else np.sqrt(2. / np.cos(slope)))
    want = np.array([np.sqrt(2. * np.sin(slope)), -quad(drop, 0., np.sqrt(slope), epsabs=1e-13)[0]])
    got = tip_of(cantilever(10., 100., 0.), 1., pieces).tip[0, :2] / 10.
    return np.abs(got - want).max()


def pure_couple_error():
    """Returns the error of combined bending and torsion: the end of a rod with equal stiffness about all axes rotates
    under an end couple M by exactly exp(L M / EI)."""
    length, stiffness = 10., 100.
    arm = cantilever(length, stiffness, isotropic=True)
    numbers = Numbers.nominal(arm, np.zeros((1, 1)), [1.])
    numbers.payload_offset[:] = [4., 1., 5.]
    numbers.end_force[:, 0] = [0., 1., 0.]              # cancels the load, so that only its couple remains
    state = solve(arm, numbers, most_sweeps=400)
    couple = cross(turned(state.R_tip, numbers.payload_offset), np.array([[0., -1., 0.]]))
    fine = np.linspace(0., 1., 20001)
    tangents = exponential(fine[:, None] * couple * length / stiffness)[:, :, 0]
    want = length * np.trapz(tangents, fine, axis=0)
    turn = exponential(length * couple / stiffness)
    return max(np.abs(state.R_tip - turn).max(), np.abs(state.tip - want).max() / length)


def poses_error(path):
    """Returns the largest tip distance [in] and the largest tip rotation [rad] from the 200 independent poses."""
    arm, poses = read_arm(), np.genfromtxt(path, delimiter=",", names=True)
    def columns(*names): return np.stack([poses[name] for name in names], axis=1)
    q = np.radians(columns(*(f"{joint}_deg" for joint in arm.joints)))
    state = solve(arm, Numbers.nominal(arm, q, poses["load_lbf"]))
    gamma, beta, alpha = np.radians(columns("gamma_deg", "beta_deg", "alpha_deg")).T
    def about(axis, angle): return exponential(angle[:, None] * np.eye(3)[axis])
    R = about(2, alpha) @ about(1, beta) @ about(0, gamma)
    distance = np.linalg.norm(state.tip - columns("x_in", "y_in", "z_in"), axis=1).max()
    return distance, np.abs(R.transpose(0, 2, 1) @ state.R_tip - np.eye(3)).max()


def pieces_error():
    """Returns the largest tip difference [in] between rods of 4 and of 64 pieces over random postures under 40 lbf."""
    arm, rng = read_arm(), np.random.default_rng(1)
    q = rng.uniform(arm.limits[:, 0], arm.limits[:, 1], (100, len(arm.joints)))
    numbers = Numbers.nominal(arm, q, np.full(100, 40.))
    return np.abs(solve(arm, numbers, 4).tip - solve(arm, numbers, 64).tip).max()


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--poses", type=pathlib.Path, default=SHARED / "reference" / "poses.csv")
    path = parser.parse_args(arguments).poses
    results = [("small deflection of a cantilever, relative", small_deflection_error(), 1e-7),
               ("elastica, 128 pieces, per length", elastica_error(128), 1e-9),
               ("error left by twice the pieces (order 4: 1/16)", elastica_error(128) / elastica_error(64), 1. / 14.),
               ("bending and twist under a couple, per length", pure_couple_error(), 1e-7),
               ("4 against 64 pieces of a rod, in", pieces_error(), 2e-6)]
    if path.exists():
        position, turn = poses_error(path)
        results += [("tip against independent poses, in", position, 1e-4),
                    ("tip frame against independent poses, rad", turn, 2e-5)]
    else:
        print(f"{path}: not there, so the independent poses are not compared")
    for label, error, bound in results:
        print(f"{'holds' if error <= bound else 'FAILS'}  {label:48s} {error:.2e} (to hold: {bound:.0e})")
    return int(any(not error <= bound for _, error, bound in results))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
