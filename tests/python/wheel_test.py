"""wheel_test.py BUILD SOURCE: a wheel is built offline of the build that is there, installed in an environment of its
own, and used; skipped without pip and venv."""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import zipfile

BUILD, SOURCE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
USE = """
import sys, tubeplan
cell = tubeplan.Cell(sys.argv[1])
assert 'site-packages' in tubeplan.__file__, tubeplan.__file__
print(tubeplan.__version__, cell.poses([[0.1, 0.5, 0.2, 0.1]]).converged, cell.effects().answer)
"""


def run(*words, **environment):
    done = subprocess.run([*map(str, words)], env={**{k: v for k, v in os.environ.items() if k != 'PYTHONPATH'}, **environment},
                          capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(done.stdout + done.stderr)
    return done.stdout


def main():
    if not all(importlib.util.find_spec(name) for name in ('pip', 'ensurepip')):
        print('skipped: pip or venv is not installed')
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run(sys.executable, '-m', 'pip', 'wheel', '--no-index', '--no-build-isolation', '--no-deps', '--wheel-dir', folder, SOURCE,
            TUBEPLAN_BUILD=str(BUILD))
        wheel, = folder.glob('tubeplan-*.whl')
        files = zipfile.ZipFile(wheel).namelist()
        assert {'tubeplan/py.typed', 'tubeplan/results.pyi', 'tubeplan/figures.json'} <= {*files}, files
        assert not [file for file in files if '__pycache__' in file]
        run(sys.executable, '-m', 'venv', '--system-site-packages', folder / 'env')
        run(folder / 'env/bin/pip', 'install', '--no-index', '--no-deps', '--force-reinstall', wheel)
        print(wheel.name, run(folder / 'env/bin/python', '-c', USE, SOURCE / 'app/cells/bench.yaml'))
        print(run(folder / 'env/bin/tubeplan', '--version'))
    return 0


if __name__ == '__main__':
    sys.exit(main())
