"""Tables of readings as pandas DataFrames. pandas is imported where a DataFrame is given or asked for."""
from __future__ import annotations

import io
import pathlib
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas


def frame_of(table: str | pathlib.Path) -> pandas.DataFrame:
    """Returns a CSV file, or CSV text, as a DataFrame; names of points and set-ups stay text."""
    import pandas
    source = io.StringIO(table) if isinstance(table, str) else table
    return pandas.read_csv(source, dtype={name: str for name in ('id', 'point', 'setup', 'kind', 'split')})


def is_frame(value: Any) -> bool:
    """Returns True for a DataFrame. A program that has not imported pandas has none."""
    pandas = sys.modules.get('pandas')
    return pandas is not None and isinstance(value, pandas.DataFrame)


def write_frame(frame: Any, path: pathlib.Path) -> None:
    """Writes a DataFrame as CSV. Its index is not written; unknown values (NaN) are empty."""
    frame.to_csv(path, index=False)
