"""make_stubs.py PACKAGE: writes the types of the commands and their results into the folder of the package, of which
mypy and editors learn them. The build calls it."""
import keyword
import pathlib
import sys

package = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(package.parent))

from tubeplan.commands import COMMANDS, takes_cell  # noqa: E402
from tubeplan.figures import Figures, class_name, object_of, read_shapes  # noqa: E402
from tubeplan.result import Result  # noqa: E402

HEAD = '# Written by make_stubs.py.\n'
TYPES = {'any': 'Any', 'null': 'None'}
VALUES = {'FLOAT': 'float', 'INT': 'int', 'UINT': 'int', 'FORCE': 'float', 'LENGTH': 'float', 'ANGLE': 'float', 'TORQUE': 'float'}
TAKEN = {*dir(Figures), *dir(Result)}


def type_of(shape, name):
    """Returns the type of a figure whose own object, if it has one, is the class `name`."""
    if isinstance(shape, str):
        return ' | '.join(sorted((TYPES.get(part, part) for part in shape.split('|')), key=lambda part: part == 'None'))
    null = ' | None' if shape.get('null') else ''
    if 'list' in shape:
        inner = type_of(shape['list'], name)
        return f'tuple[{"Any" if inner == "None" else inner}, ...]{null}'
    return (f'Mapping[str, {type_of(shape["map"], name)}]' if 'map' in shape else name) + null


def map_of(shape):
    """Returns the shape of the values of a map, or of the maps of a list."""
    while isinstance(shape, dict) and ('list' in shape or 'map' in shape):
        shape = shape.get('list', shape.get('map'))
    return shape


def classes(base, name, shape):
    """Yields the classes of the objects within a shape, then its own."""
    lines = []
    for key, one in shape.items():
        inner = object_of(map_of(one))
        within = name + class_name(key)
        if inner is not None and within.isidentifier():
            yield from classes('Figures', within, inner)
        if key.isidentifier() and not keyword.iskeyword(key) and key not in TAKEN:
            lines.append(f'    @property\n    def {key}(self) -> {type_of(one, within)}: ...')
    yield f'class {name}({base}):\n' + ('\n'.join(lines) or '    ...')


def results():
    shapes = read_shapes()
    text = [HEAD + 'from collections.abc import Mapping\nfrom typing import Any\n\nfrom .figures import Figures\nfrom .result import Result']
    for command in COMMANDS:
        text += classes('Result', class_name(command) + 'Result', shapes.get(command, {}))
    return '\n\n'.join(text) + '\n'


def argument_type(option):
    if not option.value and not option.positional:
        return 'bool'
    if option.choices:
        one = f'Literal[{", ".join(map(repr, option.choices))}]'
    elif option.kinds == ['POSTURE']:
        return 'Text | Sequence[float] | npt.NDArray[Any]'
    else:
        one = VALUES.get(option.kinds[0], 'Text' if 'TEXT' in option.value or option.positional else 'Text')
    if option.kinds[0] == 'TEXT' and not option.choices and not option.several:
        return 'Text | Sequence[Text] | pandas.DataFrame'
    many = 'npt.NDArray[Any] | ' if VALUES.get(option.kinds[0]) else 'pandas.DataFrame | '
    return f'{one} | {many}Sequence[{one}]' if option.several else one


def function(command):
    options = COMMANDS[command][2]
    is_method = takes_cell(command)
    needed, given, named = ['self'] if is_method else [], [], []
    for option in options[is_method:]:
        kind, is_required = argument_type(option), option.required and option.word != '--out'
        text = f'{option.argument}: {kind}' if is_required else f'{option.argument}: {kind} | None = None'
        (named if not option.positional else needed if is_required else given).append(text)
    if not is_method:
        named.append("units: Literal['si', 'cell'] = 'si'")
    named.append('progress: Callable[[str, int, int], object] | None = None')
    name = command + '_' if keyword.iskeyword(command) else command
    arguments = ',\n    '.join([*needed, *given, '*', *named])
    return f'def {name}(\n    {arguments},\n) -> {class_name(command)}Result: ...'


def methods():
    head = (HEAD + 'import os\nfrom collections.abc import Callable, Sequence\nfrom typing import Any, Literal\n\nimport numpy.typing as npt\n'
            'import pandas\n\nfrom .results import ' + ', '.join(class_name(command) + 'Result' for command in COMMANDS) +
            '\n\nText = str | os.PathLike[str]')
    functions = [function(command) for command in COMMANDS if not takes_cell(command)]
    inner = ['\n'.join('    ' + line for line in function(command).splitlines()) for command in COMMANDS if takes_cell(command)]
    return '\n\n'.join([head, *functions, 'class CellCommands:\n' + '\n\n'.join(inner)]) + '\n'


(package / 'results.pyi').write_text(results(), encoding='utf-8')
(package / '_methods.pyi').write_text(methods(), encoding='utf-8')
