"""types_test.py TUBEPLAN SOURCE: mypy --strict over the package, over code that uses it, and over wrong uses, each of
which it must refuse; skipped without mypy."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

USE = """
import pathlib

import numpy as np
import tubeplan
from tubeplan.results import DiagnoseResult, IdentifyResult

cell = tubeplan.Cell(pathlib.Path('bench.yaml'), units='cell')
poses = cell.poses(np.zeros((2, 4)), load=10.0)
sag: float = float(poses.positions[0, 2])
branches = cell.inverse(cell.holes().centres, load=0.0)
found: DiagnoseResult = cell.diagnose(['readings.csv'], seed=2, progress=lambda stage, done, total: None)
verdict: str = found.verdict or ''
fit: IdentifyResult = cell.identify('readings.csv', free=['tool.tip'], robust='huber', folds=3)
values: list[float | None] = [number.value for number in fit.parameters or ()]
error: float | None = fit.rms.after
better: tubeplan.Cell = cell.improve('readings.csv', out='better.yaml').open()
tubeplan.ladder('readings.csv', [cell, better], rigid=True, units='cell').plot()
tubeplan.arm('export', better, measurements=['readings.csv'], into='robot.urdf', out=pathlib.Path('calibrated.urdf'))
print(found['verdict'], fit.open().joints[0].upper(), poses.converged.all(), branches.of(0), error, sag, verdict, values)
"""
WRONG = {
    'tubeplan.Cell(3)': 'arg-type', "tubeplan.Cell('a').identify('b', robust='Huber')": 'arg-type',
    "tubeplan.Cell('a').identify('b', fold=3)": 'call-arg', "tubeplan.Cell('a').identify('b').parametersx": 'attr-defined',
    "tubeplan.Cell('a').identify('b').rms.afterwards": 'attr-defined', "tubeplan.Cell('a', units='cell').identify('b').rms = 3": 'misc',
    "tubeplan.Cell('a').diagnose()": 'call-arg', "x: int = tubeplan.Cell('a').diagnose('b').sentence": 'assignment'}


def mypy(*arguments):
    with tempfile.TemporaryDirectory() as cache:
        path = os.environ['PYTHONPATH'].split(os.pathsep)[0]
        return subprocess.run([sys.executable, '-m', 'mypy', '--strict', '--ignore-missing-imports', '--cache-dir', cache, *arguments],
                              env=dict(os.environ, MYPYPATH=path), capture_output=True, text=True, check=False)


def main():
    if not importlib.util.find_spec('mypy'):
        print('skipped: mypy is not installed')
        return 77
    package = pathlib.Path(os.environ['PYTHONPATH'].split(os.pathsep)[0], 'tubeplan')
    with tempfile.TemporaryDirectory() as folder:
        use, wrong = pathlib.Path(folder, 'use.py'), pathlib.Path(folder, 'wrong.py')
        use.write_text(USE, encoding='utf-8')
        wrong.write_text('import tubeplan\n' + '\n'.join(WRONG) + '\n', encoding='utf-8')
        inside, used, refused = mypy('-p', 'tubeplan'), mypy(use), mypy(wrong)
    print(inside.stdout, inside.stderr, used.stdout, used.stderr, refused.stdout)
    passed = [line for k, (line, code) in enumerate(WRONG.items(), 2) if f'wrong.py:{k}: ' not in refused.stdout or f'[{code}]' not in refused.stdout]
    if passed:
        print('not refused: ' + '; '.join(passed))
    return inside.returncode or used.returncode or len(passed)


if __name__ == '__main__':
    sys.exit(main())
