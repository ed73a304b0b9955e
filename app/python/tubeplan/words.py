"""Python arguments as words of a command line, by the program's own table of options."""
from __future__ import annotations

import dataclasses
import json
import math
import numbers
import os
import pathlib
import re
from collections.abc import Iterable
from typing import Any

from . import _core
from .errors import InputError
from .tables import is_frame, write_frame

UNITS = ('si', 'cell')
# Options that are arguments of Python's own: figures are returned.
OF_TERMINAL = {'--json', '--format', '--help'}


@dataclasses.dataclass(frozen=True)
class Option:
    """An option or positional argument of a command."""

    names: list[str]
    value: str  # FORCE, LENGTH, FLOAT, TEXT:{none,huber,cauchy}; empty for a flag
    description: str
    initial: str
    positional: bool
    required: bool
    several: bool
    delimiter: str

    @property
    def word(self) -> str:
        return self.names[-1]

    @property
    def argument(self) -> str:
        """Returns the name in Python: held_out of --held-out, measurements of MEASUREMENTS, from_ of --from."""
        name = re.sub(r'\W', '_', self.word.lstrip('-')).lower()
        return name + '_' if name in ('from', 'as') else name

    @property
    def kinds(self) -> list[str]:
        """Returns the kinds of value: one, or one for each of several values."""
        return self.value.split(':')[0].split(' ')[0].split(',')

    @property
    def choices(self) -> list[str]:
        found = re.search(r'\{(.*)\}', self.value)
        return found[1].split(',') if found else []


def read_commands() -> dict[str, tuple[str, str, list[Option]]]:
    """Returns for each command its summary, its example and its options."""
    return {command['name']: (command['summary'], command['example'],
                              [Option(**one) for one in command['options'] if one['names'][-1] not in OF_TERMINAL])
            for command in json.loads(_core.commands())}


class Words:
    """Words of a command line for the arguments of one call.

    Numbers of options with a unit are in SI units or in those of the cell; text is as on the command line. DataFrames
    become files of `folder`.
    """

    def __init__(self, folder: pathlib.Path, units: dict[str, Any] | None) -> None:
        self._folder, self._units = folder, units

    def of(self, option: Option, value: Any) -> list[str]:
        if value is None or value is False:
            return []
        if not option.value and not option.positional:
            if value is not True:
                raise TypeError(f'{option.argument}: expected True or False, found {value!r}')
            return [option.word]
        texts = self._texts(option, value)
        if option.positional:
            return ['./' + text if text.startswith('-') else text for text in texts]
        if option.several and option.delimiter:
            texts = [option.delimiter.join(texts)]
        return [f'{option.word}={text}' for text in texts]

    def _texts(self, option: Option, value: Any) -> list[str]:
        values = [value] if _is_one(value) else list(value)
        texts = [self._text(option, one, k, len(values)) for k, one in enumerate(values)]
        return texts if option.several or _is_one(value) else [','.join(texts)]

    def _text(self, option: Option, value: Any, k: int, count: int) -> str:
        if is_frame(value):
            path = self._folder / f'{option.argument}{"" if count == 1 else k + 1}.csv'
            write_frame(value, path)
            return str(path)
        if isinstance(value, (str, os.PathLike)):
            return os.fsdecode(value)
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f'{option.argument}: expected text, a path, a number or a list of these, found {value!r}')
        if isinstance(value, numbers.Integral) and not self._factor(option, k):
            return str(int(value))
        if not math.isfinite(value):
            raise InputError(option.argument, str(float(value)), 'a finite number')
        return repr(float(value) / (self._factor(option, k) or 1))

    def _factor(self, option: Option, k: int) -> float | None:
        """Returns the SI units in one unit of the cell for value k; None if values are used unchanged."""
        if self._units is None:
            return None
        kind = option.kinds[min(k, len(option.kinds) - 1)]
        if kind == 'POSTURE' and k < len(self._units.get('joints', [])):
            kind = self._units['joints'][k]
        factor: float | None = self._units.get(kind)
        return factor


def _is_one(value: Any) -> bool:
    return is_frame(value) or isinstance(value, (str, os.PathLike)) or not isinstance(value, Iterable)
