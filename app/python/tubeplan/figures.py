"""Results as frozen, typed views of the JSON documents that the commands write (docs/files.md).

No figure is named here. The classes are made from figures.json, which tests/python/figures.py writes from the documents
themselves.
"""
from __future__ import annotations

import dataclasses
import difflib
import importlib.resources
import json
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar


def read_shapes() -> dict[str, Any]:
    """Returns for each command the shape of its document."""
    text = importlib.resources.files(__package__).joinpath('figures.json').read_text(encoding='utf-8')
    shapes: dict[str, Any] = json.loads(text)
    return shapes


class Figures(Mapping[str, Any]):
    """Figures of a result: `result.rms.before` or `result['rms']['before']`. Cannot be changed.

    A figure that this document does not have, and others of its kind have, is None.
    """

    _shape: ClassVar[dict[str, Any]] = {}
    _classes: ClassVar[dict[str, Any]] = {}

    __slots__ = ('_document', '_views')

    _document: dict[str, Any]
    _views: dict[str, Any]

    def __init__(self, document: Mapping[str, Any]) -> None:
        object.__setattr__(self, '_document', dict(document))
        object.__setattr__(self, '_views', {key: self._view(key, value) for key, value in document.items()})

    @classmethod
    def _view(cls, key: str, value: Any) -> Any:
        if isinstance(value, dict):
            return cls._classes.get(key, Figures)(value)
        return tuple(cls._view(key, one) for one in value) if isinstance(value, list) else value

    def __getitem__(self, key: str) -> Any:
        return self._views[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._views)

    def __len__(self) -> int:
        return len(self._views)

    if not TYPE_CHECKING:  # results.pyi has the figures of every kind of result
        def __getattr__(self, key: str) -> Any:
            if key.startswith('_'):
                raise AttributeError(key)
            if key in self._views:
                return self._views[key]
            if key in self._shape:
                return None
            near = difflib.get_close_matches(key, {*self._shape, *self._views}, 1)
            raise AttributeError(f'{type(self).__name__} has no figure {key!r}' + (f'; did you mean {near[0]!r}?' if near else ''))

    def __setattr__(self, key: str, value: Any) -> None:
        raise dataclasses.FrozenInstanceError(f'cannot assign to figure {key!r}')

    def __delattr__(self, key: str) -> None:
        raise dataclasses.FrozenInstanceError(f'cannot delete figure {key!r}')

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(key for key in (*self._shape, *self._views) if key.isidentifier())})

    def __repr__(self) -> str:
        return f'{type(self).__name__}({self._document!r})'

    def __copy__(self) -> Figures:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Figures:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return Figures, (self._document,)

    def as_dict(self) -> dict[str, Any]:
        """Returns the document: dictionaries, lists and plain values."""
        document: dict[str, Any] = json.loads(json.dumps(self._document))
        return document


def object_of(shape: Any) -> dict[str, Any] | None:
    """Returns the shapes of the figures of an object, or of the objects of a list; None for other shapes."""
    while isinstance(shape, dict) and 'list' in shape:
        shape = shape['list']
    return shape['object'] if isinstance(shape, dict) and 'object' in shape else None


def class_name(*keys: str) -> str:
    return ''.join(part.capitalize() for key in keys for part in key.split('_'))


def figure_class(base: type[Figures], name: str, shape: dict[str, Any]) -> type[Figures]:
    """Returns the class for an object of this shape, with the classes of the objects within it."""
    inner = {key: figure_class(Figures, name + class_name(key), within)
             for key, one in shape.items() if (within := object_of(one)) is not None}
    return type(name, (base,), {'__slots__': (), '_shape': shape, '_classes': inner, '__module__': __name__})
