"""figures.py TUBEPLAN SOURCE [--write]: compares app/python/tubeplan/figures.json, from which the types of results are
made, with the documents of all commands. --write renews the file after a change of a document."""
import json
import sys

from tubeplan.commands import COMMANDS
from tubeplan.shapes import merged, shape_of

from fixtures import SOURCE, calls

FILE = SOURCE / 'app/python/tubeplan/figures.json'


def main():
    shapes = {}
    for name, call in calls('cell'):
        shapes.setdefault(name, []).append(shape_of(call().as_dict()))
    found = {name: merged(shapes[name])['object'] for name in COMMANDS if name in shapes}
    text = '{\n' + ',\n'.join(f'{json.dumps(name)}: {json.dumps(shape)}' for name, shape in found.items()) + '\n}\n'
    if '--write' in sys.argv:
        FILE.write_text(text, encoding='utf-8')
        return 0
    kept = json.loads(FILE.read_text(encoding='utf-8'))
    wrong = [name for name in {**found, **kept} if found.get(name) != kept.get(name)]
    print(f'figures of {", ".join(wrong)} have changed: python3 tests/python/figures.py TUBEPLAN SOURCE --write' if wrong
          else f'{len(found)} commands, as figures.json has them')
    return bool(wrong)


if __name__ == '__main__':
    sys.exit(main())
