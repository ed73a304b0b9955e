"""A cell: its arm and sheet as arrays, and the program's commands on it as methods."""
from __future__ import annotations

import dataclasses
import json
import os
import pathlib
import reprlib
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _core, commands
from .errors import InputError
from .figures import Figures

if TYPE_CHECKING:
    import pandas

    from ._methods import CellCommands as _Commands
else:
    _Commands = type('CellCommands', (), dict(commands.METHODS))

Array = npt.NDArray[np.float64]
_AT_ONCE = 4096  # postures or goals between two moments at which Ctrl-C is seen


class _Brief:
    """Prints the fields of a dataclass with long arrays and tuples cut short."""

    def __repr__(self) -> str:
        fields = (f'{name}={reprlib.repr(value)}' for name, value in vars(self).items())
        return f"{type(self).__name__}({', '.join(fields)})"


@dataclasses.dataclass(frozen=True, repr=False)
class Poses(_Brief):
    """Poses of the tool frame at the deflected tip, in the world."""

    matrices: Array  # n x 4 x 4
    converged: npt.NDArray[np.bool_]  # of each posture; the pose of one that did not converge is NaN

    @property
    def positions(self) -> Array:
        return self.matrices[:, :3, 3]

    @property
    def rotations(self) -> Array:
        return self.matrices[:, :3, :3]

    def __len__(self) -> int:
        return len(self.matrices)

    def __array__(self, dtype: Any = None) -> Array:
        return np.asarray(self.matrices, dtype)


@dataclasses.dataclass(frozen=True, repr=False)
class Branches(_Brief):
    """All branches of the inverse kinematics of n goals, one entry for each branch; those that converged come first."""

    goal: npt.NDArray[np.int64]  # index of the goal
    q: Array  # readings of the joints
    status: tuple[str, ...]
    error: Array  # distance of the tip from the goal
    tilt: Array  # angle that remains between the tool's axis and the goal's
    goal_status: tuple[str, ...]  # of each goal: converged, or why no branch is
    goal_reason: tuple[str, ...]

    @property
    def converged(self) -> npt.NDArray[np.bool_]:
        return np.array([status == 'converged' for status in self.status], dtype=bool)

    def of(self, goal: int) -> Array:
        """Returns the postures that reach a goal, k x joints."""
        chosen: Array = self.q[(self.goal == goal) & self.converged]
        return chosen

    def __len__(self) -> int:
        return len(self.goal)


@dataclasses.dataclass(frozen=True, repr=False)
class Holes(_Brief):
    """Holes of a tube sheet, in its order."""

    row: npt.NDArray[np.int32]
    column: npt.NDArray[np.int32]
    centres: Array  # n x 3, on the lower face, in the world
    state: tuple[str, ...]

    @property
    def names(self) -> list[str]:
        return [f'R{row}C{column}' for row, column in zip(self.row, self.column)]

    def __len__(self) -> int:
        return len(self.row)

    def frame(self) -> pandas.DataFrame:
        import pandas
        x, y, z = self.centres.T
        return pandas.DataFrame({'row': self.row, 'column': self.column, 'x': x, 'y': y, 'z': z, 'state': self.state})


class Cell(_Commands):
    """A cell file and its arm file.

    units='si': all numbers and arrays are in m, rad, N and s, as arguments and as figures. units='cell': they are in the
    units of the cell's file. Text is always in the units of the file, as on the command line.
    """

    def __init__(self, path: str | os.PathLike[str], *, units: str = 'si') -> None:
        if units not in ('si', 'cell'):
            raise InputError('units', repr(units), 'si or cell')
        given = os.fspath(path)
        # A Python program may change its working directory.
        self._path = pathlib.Path(given).absolute() if given else pathlib.Path()
        self._units = units
        self._kept: object = None
        self._arrays = _core.CellArrays(str(self._path) if given else '')
        factors = json.loads(_core.units_of(str(self._path)))
        self._length, self._angle, self._force = ((factors[kind] if units == 'cell' else 1.0)
                                                  for kind in ('LENGTH', 'ANGLE', 'FORCE'))
        self._joint = np.array([self._length if kind == 'LENGTH' else self._angle for kind in factors['joints']])

    def __fspath__(self) -> str:
        return str(self._path)

    def __repr__(self) -> str:
        return f'Cell({str(self._path)!r}, units={self._units!r})'

    def __reduce__(self) -> tuple[Any, ...]:
        return _reopened, (str(self._path), self._units)

    @property
    def path(self) -> pathlib.Path:
        return self._path

    @property
    def units(self) -> str:
        return self._units

    @property
    def name(self) -> str:
        return self._arrays.name

    @property
    def joints(self) -> list[str]:
        """Names of the joints, in the order of every q."""
        return self._arrays.joints

    @property
    def limits(self) -> Array:
        """Lowest and highest reading of each joint."""
        limits: Array = self._arrays.limits / self._joint[:, None]
        return limits

    @property
    def tool_axis(self) -> Array:
        """Direction in which the tool enters a hole, in the tool frame."""
        return self._arrays.tool_axis

    @property
    def base(self) -> Array:
        """Pose of the base in the world, 4 x 4."""
        return _in_length(self._arrays.base, self._length)

    @property
    def base_standing(self) -> Figures:
        """Source of the base pose: status, words, whether it is placed, number of touches."""
        return Figures(json.loads(self._arrays.base_standing))

    def poses(self, q: npt.ArrayLike, load: npt.ArrayLike = 0.0) -> Poses:
        """Returns the poses of the deflected tip in the postures q, n x joints; `load` is one, or one for each posture."""
        postures = _table('q', q, len(self.joints), 'one for each joint') * self._joint
        loads = _numbers('load', load) * self._force
        if loads.ndim > 1 or loads.size not in (1, len(postures)):
            raise InputError('load', f'an array of shape {loads.shape}', f'one load, or {len(postures)}')
        if (loads < 0).any():
            raise InputError('load', f'{loads.min() / self._force:g}', 'loads of zero or more')
        loads = np.broadcast_to(loads.ravel(), len(postures))
        parts = [self._arrays.poses(postures[k:k + _AT_ONCE], loads[k:k + _AT_ONCE])
                 for k in range(0, len(postures), _AT_ONCE)] or [(np.empty((0, 4, 4)), np.empty(0, bool))]
        matrices, converged = (np.concatenate(part) for part in zip(*parts))
        return Poses(_in_length(matrices, self._length), converged)

    def inverse(self, goals: npt.ArrayLike, axes: npt.ArrayLike = (0.0, 0.0, 1.0), load: float = 0.0) -> Branches:
        """Returns all branches that bring the deflected tip to goals.

        goals: places (n x 3) with the direction of the tool's axis in `axes` (one, or n x 3), or poses (n x 4 x 4), of
        which the z axis counts: how the tool is turned about it stays free.
        """
        given = _numbers('goals', goals)
        if given.ndim == 3 and given.shape[1:] == (4, 4):
            places, directions = given[:, :3, 3], given[:, :3, :3] @ self.tool_axis
        else:
            places = _table('goals', goals, 3, 'x, y and z, or poses n x 4 x 4')
            directions = np.broadcast_to(_numbers('axes', axes), places.shape) if np.ndim(axes) == 1 and np.size(axes) == 3 \
                else _table('axes', axes, 3, 'x, y and z')
        if directions.shape != places.shape or not np.linalg.norm(directions, axis=1).all():
            raise InputError('axes', f'an array of shape {np.shape(axes)}', 'one direction other than zero, or one for each goal')
        force = float(_numbers('load', load)) * self._force
        if force < 0:
            raise InputError('load', f'{load:g}', 'a load of zero or more')
        at_once = _AT_ONCE // 64
        parts = [self._arrays.inverse(places[k:k + at_once] * self._length, directions[k:k + at_once], force)
                 for k in range(0, len(places), at_once)]
        goal = [part[0] + at_once * k for k, part in enumerate(parts)]
        q, error, tilt = ([part[k] for part in parts] for k in (1, 3, 4))
        status, goal_status, goal_reason = (tuple(one for part in parts for one in part[k]) for k in (2, 5, 6))
        return Branches(np.concatenate([np.empty(0, np.int64), *goal]).astype(np.int64),
                        np.concatenate([np.empty((0, len(self.joints))), *q]) / self._joint, status,
                        np.concatenate([np.empty(0), *error]) / self._length, np.concatenate([np.empty(0), *tilt]) / self._angle,
                        goal_status, goal_reason)

    def holes(self) -> Holes:
        """Returns the holes of the tube sheet."""
        row, column, centres, state = self._arrays.holes()
        return Holes(row, column, centres / self._length, tuple(state))


def _reopened(path: str, units: str) -> Cell:
    return Cell(path, units=units)


def _numbers(name: str, values: npt.ArrayLike) -> Array:
    """Returns finite numbers as a contiguous array of floats. Whole numbers are accepted; booleans and text are not."""
    given = np.asarray(values)
    if given.dtype.kind not in 'iuf' and given.size:
        raise InputError(name, f'values of type {given.dtype}', 'numbers')
    numbers = np.ascontiguousarray(given, dtype=np.float64).reshape(given.shape)
    if not np.isfinite(numbers).all():
        at = tuple(int(k) for k in np.argwhere(~np.isfinite(numbers))[0])
        raise InputError(name, f'{numbers[at]} at {list(at)}', 'finite numbers')
    return numbers


def _table(name: str, values: npt.ArrayLike, columns: int, what: str) -> Array:
    numbers = _numbers(name, values)
    if numbers.ndim != 2 or numbers.shape[1] != columns:
        remedy = f'give {name}[None, :] for a single row' if numbers.ndim == 1 else ''
        raise InputError(name, f'an array of shape {numbers.shape}', f'n rows of {columns} columns, {what}', remedy)
    return numbers


def _in_length(poses: Array, length: float) -> Array:
    scaled = np.array(poses)
    scaled[..., :3, 3] /= length
    return scaled
