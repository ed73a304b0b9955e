"""Flexible robot arms under tube sheets: posed, identified, diagnosed, planned.

    cell = tubeplan.Cell('cell.yaml')
    print(cell.diagnose('readings.csv'))

Every command of the program on a cell is a method of Cell, every other one a function here.
"""
from typing import TYPE_CHECKING

from . import _core
from .cell import Branches, Cell, Holes, Poses
from .commands import FUNCTIONS as _FUNCTIONS
from .errors import InputError, MissingFileError
from .figures import Figures
from .result import Result

__version__: str = _core.version
if TYPE_CHECKING:
    from ._methods import *  # noqa: F403
else:
    globals().update(_FUNCTIONS)

__all__ = ['Branches', 'Cell', 'Figures', 'Holes', 'InputError', 'MissingFileError', 'Poses', 'Result', *_FUNCTIONS]
