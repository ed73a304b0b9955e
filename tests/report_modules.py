"""How app/report/join_modules.cmake joins ES modules to one script, and that it refuses what it cannot join.
python3 tests/report_modules.py [TREE]"""
import pathlib
import subprocess
import sys
import tempfile

tree = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else '.').resolve()
DRIVER = f'''cmake_minimum_required(VERSION 3.25)
include("{tree}/app/report/join_modules.cmake")
join_modules(script files "${{FOLDER}}/page.js")
file(WRITE "${{FOLDER}}/script" "${{script}}")
'''


def joined(files):
    """The script, and what was said against it."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / 'driver.cmake').write_text(DRIVER)
        for file, text in files.items():
            (folder / file).write_text(text)
        run = subprocess.run(['cmake', f'-DFOLDER={folder}', '-P', folder / 'driver.cmake'], capture_output=True, text=True)
        script = folder / 'script'
        return (script.read_text() if script.exists() else ''), ' '.join(run.stderr.split())


A = 'import {b} from "./b.js";\nimport {\n  c,\n} from "./c.js";\n\nexport const a = [b, c];\n'
script, said = joined({
    'page.js': 'import {a} from "./a.js";\nimport {c} from "./c.js";\n\nfunction show() { return [a, c]; }\n\nshow();\n',
    'a.js': A, 'b.js': 'import {c} from "./c.js";\nexport function b() { return `;${c}]`; }\n', 'c.js': 'export let c = 1;\n'})
assert said == '', said
assert script.split('\n\n')[0].strip().startswith('let c = 1;'), script
assert script.index('let c') < script.index('function b') < script.index('const a') < script.index('function show'), script
assert script.count('let c = 1;') == 1 and 'import' not in script and 'export' not in script, script
assert 'return `;${c}]`;' in script and 'const a = [b, c];' in script, script

REFUSED = {
    'b is declared by': {'page.js': 'import {a} from "./a.js";\nconst b = a;\n',
                         'a.js': 'export const a = 1;\nfunction b() {}\n'},
    'which does not export it': {'page.js': 'import {a} from "./a.js";\n', 'a.js': 'const a = 1;\nexport const ab = a;\n'},
    'which is not there': {'page.js': 'import {a} from "./a.js";\n'},
    'in a circle': {'page.js': 'import {a} from "./a.js";\n', 'a.js': 'import {b} from "./b.js";\nexport const a = 1;\n',
                    'b.js': 'import {a} from "./a.js";\nexport const b = a;\n'},
    'only ASCII': {'page.js': 'const a = "\u2212";\n'},
    'not a form that reports can join': {'page.js': 'import * as a from "./a.js";\n', 'a.js': 'export const a = 1;\n'},
    'not a form that reports can join: export': {'page.js': 'export default 1;\n'},
}
for message, files in REFUSED.items():
    script, said = joined(files)
    assert script == '' and message.split(':')[0] in said, f'{message}: {said}'
print(f'modules are joined; {len(REFUSED)} faults are refused')
