"""Twin cells: the text of a cell, an arm or a table of readings in millimetres, radians, newtons and seconds in place of
inches, degrees, pounds and minutes; and the differences of two documents about such twins."""
import math
import re

INCH, DEGREE, POUND = 0.0254, 3.141592653589793 / 180, 4.4482216152605
MM = INCH * 1000
IN_FILE = 'units: {length: in, angle: deg, force: lbf, temperature: degF, time: min}'


class Twin:
    """Units of a twin: millimetres and radians; also newtons and seconds unless only lengths and angles differ."""

    def __init__(self, is_of_length_and_angle=False):
        pound = 1 if is_of_length_and_angle else POUND
        torque = pound * MM
        self.units = IN_FILE.replace('in,', 'mm,').replace('deg,', 'rad,')
        self.columns = {'in': ('mm', MM), 'deg': ('rad', DEGREE)}
        if not is_of_length_and_angle:
            self.units = self.units.replace('lbf', 'N').replace('min', 's')
            self.columns |= {'lbf': ('N', POUND), 'min': ('s', 60.0)}
        # Factors from the units of the file, by the keys of arms and cells.
        self.factors = {
            **dict.fromkeys('a d position pitch first_row radius hole_diameter center diameter tolerance lengths from to point size '
                            'tip clearance'.split(), MM),
            **dict.fromkeys('alpha theta limits max_speed max_acceleration encoder_sigma rpy park'.split(), DEGREE),
            'joint_stiffness': torque / DEGREE, 'E': pound / MM ** 2, 'Iz': MM ** 4, 'distributed': pound / MM, 'end': pound}


# Numbers whose last digits depend on rounding of the input: probabilities far from one, iterations, sampled paths.
LOOSE = re.compile(r'iterations|evaluations|p_value|solver|probability|min_clearance')


def numbers(text, factor):
    return re.sub(r'-?\d+(\.\d*)?([eE][-+]?\d+)?', lambda number: repr(float(number[0]) * factor), text)


def converted(text, twin=Twin()):
    """Returns the text of a cell or an arm in the other units."""
    text = re.sub(r'#.*', '', text).replace(IN_FILE, twin.units)
    for key, factor in twin.factors.items():
        # (?!-) keeps `from:` of FACTORS apart from names such as inside_of; values are numbers, lists, or {axis: number}.
        text = re.sub(rf'\b{key}: ((?:\{{[xyz]: )?-?[\d.][\d.e+-]*\}}?|\[[^\[\]a-z]*\])(?=[,}}\s])',
                      lambda found: f'{key}: {numbers(found[1], factor)}', text)
    return text


def converted_table(text, twin=Twin()):
    """Returns the text of a table of readings in the other units."""
    heading, *rows = text.splitlines()
    names, factors = [], []
    for name in heading.split(','):
        stem, _, unit = name.rpartition('_')
        into, factor = twin.columns.get(unit, (unit, None))
        names.append(f'{stem}_{into}' if factor else name)
        factors.append(factor)
    lines = [','.join(repr(float(cell) * factor) if factor and cell else cell for cell, factor in zip(row.split(','), factors))
             for row in rows]
    return '\n'.join([','.join(names), *lines]) + '\n'


def differences(a, b, path=''):
    """Yields the places at which two documents differ by more than rounding."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in {**a, **b}:
            if key not in ('inputs', 'name', 'cell', 'words', 'sentence', 'sentences', 'found', 'add', 'fingerprint', 'text'):
                yield from differences(a.get(key), b.get(key), f'{path}/{key}')
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        # The size of a list of numbers counts: a component of rounding is not compared with itself.
        if a and all(isinstance(one, float) for one in [*a, *b]):
            size = max(map(abs, a))
            if max(abs(one - other) for one, other in zip(a, b)) > 2e-3 * size + 1e-7 and not LOOSE.search(path):
                yield f'{path}: {a} {b}'
            return
        # Equals may come in another order.
        a, b = (sorted(rows, key=lambda row: str([row.get(key) for key in ('effect', 'at', 'row', 'column')]))
                if rows and all(isinstance(row, dict) and {'effect', 'at'} <= {*row} for row in rows) else rows for rows in (a, b))
        if path == '/design':
            a, b = (sorted(rows, key=lambda row: row['name']) for rows in (a, b))
        for k, (one, other) in enumerate(zip(a, b)):
            yield from differences(one, other, f'{path}/{k}')
    elif isinstance(a, float) and isinstance(b, (int, float)) and not isinstance(b, bool):
        if not math.isclose(a, b, rel_tol=2e-3, abs_tol=1e-7) and not LOOSE.search(path):
            yield f'{path}: {a} {b}'
    elif a != b and not (isinstance(a, str) and isinstance(b, str) and path.rsplit('/', 1)[-1] not in ('unit', 'error_unit')):
        yield f'{path}: {a} {b}'
