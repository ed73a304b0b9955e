"""The program's commands as functions, made from its own table: a new command needs no line of Python."""
from __future__ import annotations

import contextlib
import inspect
import json
import keyword
import pathlib
from collections.abc import Callable, Iterator
from typing import Any

from . import _core
from .errors import InputError
from .figures import class_name, figure_class, read_shapes
from .result import Folder, Result
from .words import UNITS, Option, Words, read_commands

Progress = Callable[[str, int, int], object]

COMMANDS = read_commands()
_SHAPES = read_shapes()
_CLASSES: dict[str, type[Result]] = {}


def result_class(command: str) -> type[Result]:
    """Returns the class of a command's results."""
    if command not in _CLASSES:
        made = figure_class(Result, class_name(command) + 'Result', _SHAPES.get(command, {}))
        _CLASSES[command] = made  # type: ignore[assignment]  # figure_class returns a subclass of its base
    return _CLASSES[command]


def takes_cell(command: str) -> bool:
    """Returns True for a command on a cell, which is a method of Cell."""
    options = COMMANDS[command][2]
    return bool(options) and options[0].word == 'CELL' and not options[0].several


@contextlib.contextmanager
def _in_folder(folder: str) -> Iterator[None]:
    """Names files of the temporary folder without it in errors: they are DataFrames of the caller."""
    try:
        yield
    except InputError as error:
        if folder not in str(error):
            raise
        parts = [part.replace(folder + '/', 'DataFrame ') for part in (error.where, error.found, error.expected, error.remedy)]
        raise type(error)(*parts) from None


def _cell_of(options: list[Option], given: dict[str, Any]) -> str:
    """Returns the file whose units an argument without a unit has: the first cell, or the record of a job."""
    for option in options:
        value = given.get(option.argument)
        if option.positional and option.word in ('CELL', 'FILE') and value is not None:
            first = list(value)[0] if option.several and isinstance(value, (list, tuple)) else value
            return str(pathlib.Path(first))
    return ''


def _units_of(file: str, units: str) -> dict[str, Any] | None:
    if units not in UNITS:
        raise InputError('units', repr(units), ' or '.join(UNITS))
    if units == 'cell' or not pathlib.Path(file).is_file():
        return None
    with contextlib.suppress(InputError):  # an arm or a URDF file; options with a unit are of cells and jobs
        factors: dict[str, Any] = json.loads(_core.units_of(file))
        return factors
    return None


def call(command: str, given: dict[str, Any], units: str = 'si', progress: Progress | None = None) -> Result:
    """Calls a command with arguments by their names in Python and returns its result."""
    options = COMMANDS[command][2]
    file = _cell_of(options, given)
    kept = Folder()
    words = Words(kept.path, _units_of(file, units))
    out = given.get('out')
    for option in options:
        if option.word == '--out' and option.required and out is None:
            out = kept.path / ('out' if option.kinds == ['FOLDER'] else 'out.yaml')
    line = [command]
    for option in sorted(options, key=lambda option: not option.positional):
        line += words.of(option, out if option.word == '--out' else given.get(option.argument))
    with _in_folder(str(kept.path)):
        code, text, remarks, document = _core.call(line, file, units == 'si', progress)
    is_written = out is not None and pathlib.Path(out).exists()
    return result_class(command)(json.loads(document) if document else {}, command=command, answer=code == 0, text=text,
                                 remarks=remarks, out=pathlib.Path(out) if out is not None and is_written else None,
                                 units=units, kept=kept)


def _parameters(options: list[Option], is_method: bool) -> list[inspect.Parameter]:
    kinds = inspect.Parameter
    made = [kinds('self', kinds.POSITIONAL_ONLY)] if is_method else []
    given = [option for option in options[is_method:] if option.positional]
    for option in given:
        default = kinds.empty if option.required else None
        made.append(kinds(option.argument, kinds.POSITIONAL_OR_KEYWORD, default=default))
    for option in options:
        if not option.positional:
            is_needed = option.required and option.word != '--out'
            made.append(kinds(option.argument, kinds.KEYWORD_ONLY, default=kinds.empty if is_needed else None))
    return made


def _described(summary: str, example: str, options: list[Option], is_method: bool) -> str:
    lines = [summary[0].upper() + summary[1:] + '.', '']
    for option in options[is_method:]:
        initial = f' (default: {option.initial})' if option.initial else ''
        lines.append(f'{option.argument}: {option.description}{initial}')
    return '\n'.join([*lines, '', 'On the command line:', *('    ' + line for line in example.splitlines())])


def function_of(command: str) -> Callable[..., Result]:
    """Returns the command as a function or, if it is one on a cell, as a method of Cell."""
    summary, example, options = COMMANDS[command]
    is_method = takes_cell(command)
    parameters = _parameters(options, is_method)
    named = inspect.Parameter('progress', inspect.Parameter.KEYWORD_ONLY, default=None)
    units = [] if is_method else [inspect.Parameter('units', inspect.Parameter.KEYWORD_ONLY, default='si')]
    signature = inspect.Signature([*parameters, *units, named])

    def run(*args: Any, **kwargs: Any) -> Result:
        given = dict(signature.bind(*args, **kwargs).arguments)
        progress = given.pop('progress', None)
        units = given.pop('units', 'si') if not is_method else ''
        if is_method:
            cell = given.pop('self')
            return call(command, {**given, 'cell': cell.path}, cell.units, progress)
        return call(command, given, units, progress)

    run.__name__ = run.__qualname__ = command + '_' if keyword.iskeyword(command) else command
    run.__doc__ = _described(summary, example, options, is_method)
    run.__signature__ = signature  # type: ignore[attr-defined]
    return run


METHODS = {name: function_of(name) for name in COMMANDS if takes_cell(name)}
FUNCTIONS = {name: function_of(name) for name in COMMANDS if not takes_cell(name)}
