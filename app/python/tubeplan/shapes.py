"""Shapes of JSON documents: which figures there are, and of which type.

A shape is the name of a type ('float', 'null|str'), {'list': shape}, {'object': {figure: shape}}, or {'map': shape} for
an object whose keys are names of the data, such as joints. {..., 'null': True} may be null or missing as well.
"""
from __future__ import annotations

from typing import Any

_NAMES = {bool: 'bool', int: 'int', float: 'float', str: 'str', type(None): 'null'}
ANY = 'any'


def shape_of(value: Any) -> Any:
    """Returns the shape of a value."""
    if isinstance(value, dict):
        return {'object': {key: shape_of(one) for key, one in value.items()}}
    if isinstance(value, list):
        return {'list': merged([shape_of(one) for one in value])}
    return _NAMES[type(value)]


def merged(shapes: list[Any]) -> Any:
    """Returns the shape that covers all of these; 'null' if there are none."""
    found: Any = shapes[0] if shapes else 'null'
    for shape in shapes[1:]:
        found = _both(found, shape)
    return found


def _both(a: Any, b: Any) -> Any:
    if a == b:
        return a
    if isinstance(a, str) and isinstance(b, str):
        return _both_names(a, b)
    for one, other in ((a, b), (b, a)):
        if one == 'null':
            return {**other, 'null': True}
    if isinstance(a, str) or isinstance(b, str):
        return ANY
    null = {'null': True} if a.get('null') or b.get('null') else {}
    if 'list' in a and 'list' in b:
        return {'list': merged([a['list'], b['list']]), **null}
    if 'map' in a or 'map' in b:
        return {'map': merged([*_values(a), *_values(b)]), **null}
    return {'object': _both_objects(a['object'], b['object']), **null} if 'object' in a and 'object' in b else ANY


def _both_names(a: str, b: str) -> str:
    names = {*a.split('|'), *b.split('|')}
    if 'float' in names:
        names.discard('int')
    return ANY if len(names - {'null'}) > 1 or ANY in names else '|'.join(sorted(names))


def _values(shape: Any) -> list[Any]:
    return [shape['map']] if 'map' in shape else list(shape['object'].values())


def optional(shape: Any) -> Any:
    """Returns the shape of a figure that may be missing."""
    return _both_names(shape, 'null') if isinstance(shape, str) and shape != ANY else shape if isinstance(shape, str) \
        else {**shape, 'null': True}


def _both_objects(a: dict[str, Any], b: dict[str, Any]) -> dict[str, Any]:
    both = {}
    for key in [*a, *(key for key in b if key not in a)]:
        both[key] = _both(a[key], b[key]) if key in a and key in b else optional(a.get(key, b.get(key)))
    return both
