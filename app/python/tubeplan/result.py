"""Result of a command: its figures, its text, and what it has written."""
from __future__ import annotations

import html
import json
import os
import pathlib
import shutil
import tempfile
import weakref
from typing import TYPE_CHECKING, Any

from . import _core
from .figures import Figures

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

    from .cell import Cell


class Folder:
    """Folder that is removed with this object."""

    def __init__(self) -> None:
        self.path = pathlib.Path(tempfile.mkdtemp(prefix='tubeplan-'))
        weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)


class Result(Figures):
    """Result of a command. Its figures are attributes; `print(result)` shows the command's own text and then its remarks,
    as a terminal does.

    A work that found no solution or did not converge is a result with `answer` False, not an exception; `status`,
    `reason`, `verdict` and `remarks` say why. Text is always in the units of the file.
    """

    __slots__ = ('command', 'answer', 'text', 'remarks', 'out', '_units', '_kept')

    command: str
    answer: bool  # False where the exit code of the command is 1
    text: str
    remarks: str
    out: pathlib.Path | None  # file or folder that the command has written
    _units: str
    _kept: Folder | None

    def __init__(self, document: dict[str, Any], *, command: str = '', answer: bool = True, text: str = '', remarks: str = '',
                 out: pathlib.Path | None = None, units: str = 'si', kept: Folder | None = None) -> None:
        super().__init__(document)
        for name, value in (('command', command), ('answer', answer), ('text', text), ('remarks', remarks), ('out', out),
                            ('_units', units), ('_kept', kept)):
            object.__setattr__(self, name, value)

    def __str__(self) -> str:
        return self.text + self.remarks

    def __fspath__(self) -> str:
        if self.out is None:
            raise TypeError(f'the result of {self.command} has no file: give it out=')
        return os.fspath(self.out)

    def __reduce__(self) -> tuple[Any, ...]:
        said = (self.command, self.answer, self.text, self.remarks, self.out, self._units)
        return _restored, (self._document, *said)

    def open(self) -> Cell:
        """Returns the cell that the command has written."""
        from .cell import Cell
        path = pathlib.Path(self)
        cell = Cell(path / 'cell.yaml' if path.is_dir() else path, units=self._units)
        cell._kept = self._kept  # the folder of the file lives as long as the cell
        return cell

    def figures(self) -> pandas.DataFrame:
        """Returns all figures as a table: key, description, value, unit and note."""
        import pandas
        columns = ['key', 'description', 'value', 'unit', 'note']
        return pandas.DataFrame(self._figure_list(), columns=columns)

    def frame(self, key: str) -> pandas.DataFrame:
        """Returns a list of figures as a table with one row for each entry: `result.frame('parameters')`."""
        import pandas
        entries = self._document
        for part in key.split('/'):
            if not isinstance(entries, dict) or part not in entries:
                raise KeyError(key)
            entries = entries[part]
        return pandas.json_normalize(entries, sep='/')

    def table(self) -> pandas.DataFrame:
        """Returns the table of readings that the command has made: its file, its run sheet or its text.

        Columns have their units in their names, whatever the units of the figures.
        """
        from .tables import frame_of
        if self.out is not None and (self.out / 'measurements.csv').is_file():
            return frame_of(self.out / 'measurements.csv')
        if self.out is not None and self.out.suffix == '.csv':
            return frame_of(self.out)
        text = self._document.get('run_sheet') or self.text
        if not text.startswith('id,'):
            raise TypeError(f'the result of {self.command} has no table of readings')
        return frame_of(text)

    def plot(self, ax: Any = None) -> Figure:
        """Draws the result by matplotlib and returns the figure; the kinds of pictures are listed in plots.PLOTS."""
        from .plots import plot
        return plot(self, ax)

    def _figure_list(self) -> list[dict[str, Any]]:
        listed: list[dict[str, Any]] = json.loads(_core.figure_list(json.dumps(self._document)))
        return listed

    def _repr_html_(self) -> str:
        """Returns the command's text, and all figures with their units to be unfolded."""
        rows = ''.join(f'<tr><td>{html.escape(one["key"])}</td><td>{html.escape(_cell(one["value"]))}</td>'
                       f'<td>{html.escape(one["unit"])}</td></tr>' for one in self._figure_list())
        return (f'<div><b>tubeplan {html.escape(self.command)}</b><pre>{html.escape(str(self))}</pre><details><summary>all '
                f'figures</summary><table><tr><th>figure</th><th>value</th><th>unit</th></tr>{rows}</table></details></div>')


def _cell(value: Any) -> str:
    return f'{value:.6g}' if isinstance(value, float) else '' if value is None else str(value)


def _restored(document: dict[str, Any], command: str, answer: bool, text: str, remarks: str, out: pathlib.Path | None,
              units: str) -> Result:
    from .commands import result_class
    return result_class(command)(document, command=command, answer=answer, text=text, remarks=remarks, out=out, units=units)
