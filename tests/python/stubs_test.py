"""Compares the stubs with the module (mypy's stubtest) and type-checks code that uses them; skipped without mypy."""
import importlib.util
import os
import subprocess
import sys
import tempfile

USE = """
import numpy as np
import tubeplan

cell = tubeplan.Cell('bench.yaml')
places, turns, converged = cell.poses(np.zeros((2, 4)), load=10.0)
sag: float = float(places[0, 2])
found = cell.diagnose(['readings.csv'])
print(found['verdict'], cell.joints[0].upper(), converged.all())
"""
WRONG = "import tubeplan\ntubeplan.Cell(3)\n"


def mypy(text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'use.py')
        with open(path, 'w') as file:
            file.write(text)
        environment = dict(os.environ, MYPYPATH=os.environ['PYTHONPATH'])
        return subprocess.run([sys.executable, '-m', 'mypy', '--strict', '--cache-dir', folder, path], env=environment,
                              capture_output=True, text=True)


def main():
    if not importlib.util.find_spec('mypy'):
        print('skipped: mypy is not installed')
        return 77
    environment = dict(os.environ, MYPYPATH=os.environ['PYTHONPATH'])
    with tempfile.NamedTemporaryFile('w', suffix='.txt') as allowed:
        allowed.write('tubeplan.Cell\n')  # its metaclass is pybind11's; stubtest still checks the members of Cell
        allowed.flush()
        held = subprocess.run([sys.executable, '-m', 'mypy.stubtest', 'tubeplan', '--allowlist', allowed.name], env=environment,
                              capture_output=True, text=True)
    used, wrong = mypy(USE), mypy(WRONG)
    print(held.stdout, held.stderr, used.stdout, used.stderr)
    return held.returncode or used.returncode or (0 if 'incompatible type' in wrong.stdout else 'a wrong argument passes')


if __name__ == '__main__':
    sys.exit(main())
