"""Rotations of stacked arrays: any number of leading axes; the last axis or two are those of the vector or matrix."""
import numpy as np


def cross(u, v):
    """Returns u x v, broadcast over the leading axes."""
    u, v = np.broadcast_arrays(u, v)
    out = np.empty(u.shape)
    out[..., 0] = u[..., 1] * v[..., 2] - u[..., 2] * v[..., 1]
    out[..., 1] = u[..., 2] * v[..., 0] - u[..., 0] * v[..., 2]
    out[..., 2] = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return out


def turned(R, v):
    """Returns R v."""
    return np.matmul(R, v[..., None])[..., 0]


def turned_back(R, v):
    """Returns R^T v."""
    return np.matmul(v[..., None, :], R)[..., 0, :]


def exponential(phi):
    """Returns the rotation matrix about phi by |phi| rad (Rodrigues), (..., 3) -> (..., 3, 3)."""
    angle = np.sqrt((phi * phi).sum(-1))
    sine = np.sinc(angle / np.pi)                       # sin(angle) / angle
    versed = .5 * np.sinc(angle / (2. * np.pi)) ** 2    # (1 - cos(angle)) / angle^2
    x, y, z = phi[..., 0], phi[..., 1], phi[..., 2]
    R = versed[..., None, None] * phi[..., :, None] * phi[..., None, :]
    cosine = np.cos(angle)
    for axis in range(3):
        R[..., axis, axis] += cosine
    for row, column, part in ((0, 1, -z), (0, 2, y), (1, 2, -x)):
        R[..., row, column] += sine * part
        R[..., column, row] -= sine * part
    return R


def link_rotation(alpha, theta):
    """Returns the rotation by alpha about x, then by theta about the new z: (N,), (N,) -> (N, 3, 3)."""
    ca, sa, ct, st = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    R = np.empty(alpha.shape + (3, 3))
    R[..., 0, 0], R[..., 0, 1], R[..., 0, 2] = ct, -st, 0.
    R[..., 1, 0], R[..., 1, 1], R[..., 1, 2] = ca * st, ca * ct, -sa
    R[..., 2, 0], R[..., 2, 1], R[..., 2, 2] = sa * st, sa * ct, ca
    return R
