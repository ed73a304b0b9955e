"""Fails if a page's source names an effect: names, descriptions and variables of effects come from deflection/effects
with the documents. Fails also if a page converts text to markup: text from files must stay text.
python3 tests/page_words.py [TREE]"""
import pathlib
import re
import sys

tree = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.')
# The effect `formula` may be named, because pages have an input for a user's formula.
OF_PAGES = {'formula'}

headers = sorted((tree / 'deflection/effects').glob('*.hpp'))
names = {name for header in headers for name in re.findall(r'\.name = "([a-z-]+)",\s+\.words', header.read_text())} - OF_PAGES
if len(names) < 25:
    sys.exit(f'only {len(names)} effects were found in deflection/effects: is their form another one now?')
named = re.compile(r'(?<![\w-])(' + '|'.join(sorted(names)) + r')(?![\w-])')
markup = re.compile(r'innerHTML|outerHTML|insertAdjacentHTML|dangerouslySetInnerHTML|document\.write')
found = []
for folder in ('app/drawing', 'app/web/source'):
    for file in sorted((tree / folder).rglob('*')):
        if file.suffix not in ('.js', '.ts', '.tsx'):
            continue
        for number, line in enumerate(file.read_text().splitlines(), 1):
            for name in named.findall(line):
                found.append(f'{file.relative_to(tree)}:{number}: names the effect {name}')
            if markup.search(line):
                found.append(f'{file.relative_to(tree)}:{number}: makes markup of text')
print('\n'.join(found) or f'{len(names)} effects, and no page names one or makes markup of text')
sys.exit(bool(found))
