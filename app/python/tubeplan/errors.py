"""Exceptions for input that cannot be used."""
from __future__ import annotations


class InputError(ValueError):
    """Input that cannot be used: `where` it is, what was `found` there, what was `expected`, and the `remedy`.

    `where` names the file with line and key, or the argument. Parts that the message does not have are empty.
    """

    def __init__(self, where: str, found: str, expected: str = '', remedy: str = '') -> None:
        core = f'{where}: found {found}, expected {expected}' if expected else f'{where}: {found}'
        super().__init__(f'{core}; {remedy}' if remedy else core)
        self.where, self.found, self.expected, self.remedy = where, found, expected, remedy

    def __reduce__(self) -> tuple[type[InputError], tuple[str, str, str, str]]:
        return type(self), (self.where, self.found, self.expected, self.remedy)


class MissingFileError(InputError, FileNotFoundError):
    """An input file that does not exist."""


def input_error(where: str, found: str, expected: str, remedy: str, is_missing_file: bool) -> InputError:
    """Returns the exception for an error of the program. An option such as --held-out is the argument held_out."""
    if where.startswith('--'):
        where = ', '.join(part.removeprefix('--').replace('-', '_') for part in where.split(', '))
    return (MissingFileError if is_missing_file else InputError)(where, found, expected, remedy)
