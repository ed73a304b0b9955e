"""The nominal arm as arrays, read from an arm file (YAML, see the cells beside the program).

Only what the Cobra's file uses is understood: Denavit-Hartenberg rows (modified, Craig), revolute joints, axis
stiffnesses, one beam per row, distributed and end weights. Units from here on in this folder, which must share nothing
with the program: inch, pound-force, radian; temperatures degF, times minutes.
"""
from dataclasses import dataclass
import pathlib

import numpy as np
import yaml

CELLS = pathlib.Path(__file__).resolve().parents[2] / "app" / "cells"
AXES = "xyz"


@dataclass(frozen=True)
class Arm:
    """L links (rows), J joints. Compliances are zero where the axis is rigid."""
    links: tuple                # L names
    joints: tuple               # J names
    joint_rows: np.ndarray      # (J,) the row each joint turns
    limits: np.ndarray          # (J, 2) rad
    encoder_sigma: float        # rad, of every joint reading
    alpha: np.ndarray           # (L,) rad: twist from the previous frame to this one
    a: np.ndarray               # (L,) in: distance from the previous frame to this one
    d: np.ndarray               # (L,) in
    theta: np.ndarray           # (L,) rad: the angle, or a joint's offset
    tip: np.ndarray             # (3,) in, in the last frame
    spring: np.ndarray          # (L, 3) rad per in lbf, about the frame's own axes
    rod: np.ndarray             # (L, 3) 1 / (in^2 lbf): twist about x, bending about y, bending about z
    distributed: np.ndarray     # (L,) lbf/in from this frame to the next
    end_weight: np.ndarray      # (L,) lbf at the next frame (the last link: at the tip)
    gravity: np.ndarray         # (3,) unit vector, world frame
    modulus: float              # lbf/in^2, of the beams

    def row(self, name):
        """The index of a link or of a joint's row."""
        return self.links.index(name) if name in self.links else int(self.joint_rows[self.joints.index(name)])


def read_arm(path=CELLS / "cobra-arm.yaml"):
    """The arm in a YAML file as an Arm."""
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
    modulus = float(beam.get("E", 0.))      # YAML 1.1 takes 1.0121e7 for a word
    return [0.] + [1. / (modulus * beam[name]) if name in beam else 0. for name in ("Iy", "Iz")]
