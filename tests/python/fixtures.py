"""Objects shared by the tests of the Python package: the program, the tree, readings, and one call of every command."""
import functools
import json
import pathlib
import subprocess
import sys
import tempfile

import tubeplan

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
CELLS = SOURCE / 'app/cells'
BENCH, MOCKUP, TRUE = (CELLS / name for name in ('bench.yaml', 'mockup.yaml', 'mockup-true.yaml'))
INCH, DEGREE, POUND = 0.0254, 3.141592653589793 / 180, 4.4482216152605


def program(*arguments, code=(0, 1)):
    """Returns the figures of a command of the program."""
    run = subprocess.run([PROGRAM, *map(str, arguments), '--json', '-'], capture_output=True, text=True, check=False)
    assert run.returncode in code, run.stderr
    return json.loads(run.stdout)


@functools.cache
def folder():
    """Returns a folder of this run of the tests, which is removed at its end."""
    made = tempfile.TemporaryDirectory(prefix='tubeplan-tests-')
    folder.kept = made
    return pathlib.Path(made.name)


@functools.cache
def readings():
    """Returns a file of readings of the bench arm with a hidden effect."""
    out = folder() / 'readings'
    tubeplan.Cell(BENCH).simulate(design='bench', readings=40, seed=7, spread=0.1, hide='hysteresis@theta4:0.06deg', out=out)
    return out / 'measurements.csv'


@functools.cache
def plan():
    """Returns a plan of the mock-up with three touches."""
    return tubeplan.Cell(MOCKUP).plan(tubes='spread:5', touches='auto', truth=TRUE, out=folder() / 'plan')


def job(units='si'):
    """Returns the record of a job."""
    record = folder() / f'spring-{units}.job'
    record.unlink(missing_ok=True)
    tubeplan.job('create', CELLS / 'outage/job.yaml', out=record, units=units)
    return record


def calls(units, bench=BENCH, mockup=MOCKUP, true=TRUE, made_of=None):
    """Yields the name of a command and a function that calls it, for every command with figures.

    `made_of`: the readings and touches; those of the shipped cells where left out.
    """
    arm, sheet = tubeplan.Cell(bench, units=units), tubeplan.Cell(mockup, units=units)
    table, touches = made_of or (readings(), plan().out / 'touches.csv')
    length, force = (1, 1) if units == 'si' else (1 / INCH, 1 / POUND)
    angle = 1 if units == 'si' else 1 / DEGREE
    posture = [value * DEGREE * angle for value in (10, 20, 30, 40)]
    yield 'pose', lambda: arm.pose(joints=posture, load=100 * force, all=True)
    yield 'map', lambda: sheet.map()
    yield 'calibrate', lambda: sheet.calibrate(touches)
    yield 'identify', lambda: arm.identify(table)
    yield 'compare', lambda: arm.compare(table)
    yield 'diagnose', lambda: arm.diagnose(table)
    yield 'improve', lambda: arm.improve(table)
    yield 'ladder', lambda: tubeplan.ladder(table, [bench], rigid=True, units=units)
    yield 'ladder', lambda: tubeplan.ladder(table, [bench], sheet=mockup, holes=50, units=units)
    yield 'touches', lambda: sheet.touches(tubes='spread:12', candidates=14)
    yield 'touches', lambda: arm.touches(readings=table, loads=[0, 100 * force], count=3)
    yield 'sensitivity', lambda: sheet.sensitivity(tubes='spread:5', load=50 * force)
    yield 'score', lambda: sheet.score(truth=true, tubes='spread:5')
    yield 'score', lambda: sheet.score(truth=true, runs=2, unmodelled=0.0005 * length)
    yield 'campaign', lambda: sheet.campaign(runs=3, jobs=1)
    yield 'campaign', lambda: arm.campaign(runs=2, kind='diagnose', jobs=1)
    yield 'campaign', lambda: sheet.campaign(runs=2, kind='outage', tubes='spread:40', visits=20, jobs=1)
    yield 'bases', lambda: sheet.bases(tubes='spread:10')
    yield 'effects', lambda: arm.effects()
    yield 'plan', lambda: sheet.plan(tubes='spread:3', touches=touches, padding=1)
    yield 'watch', lambda: plan().open().watch(touches)
    if bench == BENCH:
        yield 'verify', lambda: sheet.verify(plan())
        yield 'arm', lambda: tubeplan.arm('show', bench, units=units)
        record = job(units)
        yield 'job', lambda: tubeplan.job('status', record, units=units)
        yield 'job', lambda: tubeplan.job('next', record, units=units)
        yield 'job', lambda: tubeplan.job('log', record, units=units)
