"""The nominal arm as arrays, read from an arm file (YAML, see the cells shipped with the program).

Only the features of the Cobra's file are supported: Denavit-Hartenberg rows (modified, Craig), revolute joints, axis
stiffnesses, one beam per row, distributed and end weights. This folder must share no code with the program. All its
modules use these units: inch, pound-force, radian, degF for temperatures, minutes for times.
"""
from dataclasses import dataclass
import pathlib

import numpy as np
import yaml

CELLS = pathlib.Path(__file__).resolve().parents[2] / "app" / "cells"
AXES = "xyz"


@dataclass(frozen=True)
class Arm:
    """Arm with L links (rows) and J joints. Compliances are zero about rigid axes."""
    links: tuple                # names of the L links
    joints: tuple               # names of the J joints
    joint_rows: np.ndarray      # (J,): row that each joint rotates
    limits: np.ndarray          # (J, 2): lower and upper joint limits [rad]
    encoder_sigma: float        # standard deviation of every joint reading [rad]
    alpha: np.ndarray           # (L,): twist from the previous frame to this one [rad]
    a: np.ndarray               # (L,): distance from the previous frame to this one [in]
    d: np.ndarray               # (L,): offset along z [in]
    theta: np.ndarray           # (L,): fixed angle, or offset of the joint angle [rad]
    tip: np.ndarray             # (3,): tip in the last frame [in]
    spring: np.ndarray          # (L, 3): compliance about the axes of the frame [rad/(in lbf)]
    rod: np.ndarray             # (L, 3): compliance in torsion about x, in bending about y and z [1/(in^2 lbf)]
    distributed: np.ndarray     # (L,): weight per length from this frame to the next [lbf/in]
    end_weight: np.ndarray      # (L,): weight at the next frame, or at the tip for the last link [lbf]
    gravity: np.ndarray         # (3,): direction of gravity in the world frame, a unit vector
    modulus: float              # elastic modulus of the beams [lbf/in^2]

    def row(self, name):
        """Returns the row index of a link or of a joint."""
        return self.links.index(name) if name in self.links else int(self.joint_rows[self.joints.index(name)])


def read_arm(path=CELLS / "cobra-arm.yaml"):
    """Returns the arm described by a YAML file."""
    content = yaml.safe_load(pathlib.Path(path).read_text())
    rows = content["links"]
    dh = {key: np.array([row["dh"].get(key, 0.) for row in rows], float) for key in ("alpha", "a", "d", "theta")}
    with_joint = [index for index, row in enumerate(rows) if "joint" in row]
    joints = [rows[index]["joint"] for index in with_joint]
    for index, joint in zip(with_joint, joints):
        dh["theta"][index] = joint.get("offset", 0.)
    modulus = next(float(row["beam"]["E"]) for row in rows if "beam" in row)
    return Arm(
        links=tuple(row["name"] for row in rows), joints=tuple(joint["name"] for joint in joints),
        joint_rows=np.array(with_joint), limits=np.radians([joint["limits"] for joint in joints]),
        encoder_sigma=np.radians(joints[0]["encoder_sigma"]),
        alpha=np.radians(dh["alpha"]), a=dh["a"], d=dh["d"], theta=np.radians(dh["theta"]),
        tip=np.array(content["tool"]["tip"], float), spring=np.array([_spring(row) for row in rows]),
        rod=np.array([_rod(row) for row in rows]),
        distributed=np.array([row.get("weight", {}).get("distributed", 0.) for row in rows], float),
        end_weight=np.array([row.get("weight", {}).get("end", 0.) for row in rows], float),
        gravity=np.array(content["gravity"], float) / np.linalg.norm(content["gravity"]), modulus=modulus)


def _spring(row):
    stiffness = row.get("joint_stiffness", {})     # lbf in / deg
    return [np.pi / 180. / stiffness[axis] if axis in stiffness else 0. for axis in AXES]


def _rod(row):
    beam = row.get("beam", {})
    modulus = float(beam.get("E", 0.))      # YAML 1.1 reads 1.0121e7 as a string
    return [0.] + [1. / (modulus * beam[name]) if name in beam else 0. for name in ("Iy", "Iz")]
