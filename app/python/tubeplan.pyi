"""Flexible robot arms under tube sheets: posed, identified, diagnosed, planned."""
import os
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

__version__: str

class Cell:
    """A cell's file and the arm's beside it. A wrong file raises ValueError."""

    def __init__(self, path: str | os.PathLike[str]) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def joints(self) -> list[str]: ...
    @property
    def limits(self) -> npt.NDArray[np.float64]: ...
    @property
    def base(self) -> npt.NDArray[np.float64]: ...
    @property
    def base_standing(self) -> dict[str, Any]: ...
    def poses(
        self, q: npt.ArrayLike, load: float = 0.0
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], npt.NDArray[np.bool_]]: ...
    def identify(
        self,
        measurements: Sequence[str],
        free: Sequence[str] = (),
        robust: str = "none",
        folds: int = 5,
        seed: int = 1,
        out: str = "",
    ) -> dict[str, Any]: ...
    def diagnose(self, measurements: Sequence[str], seed: int = 1) -> dict[str, Any]: ...
    def compare(self, measurements: Sequence[str], seed: int = 1) -> dict[str, Any]: ...
    def plan(
        self, tubes: str = "all", compensation: str = "via-point", load: float = 0.0, seed: int = 1
    ) -> dict[str, Any]: ...
