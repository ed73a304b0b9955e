"""Tests of long work: Ctrl-C, progress, and threads."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import tubeplan
from fixtures import BENCH, MOCKUP, TRUE, readings

# A program that is interrupted in the middle of long work, after the first progress.
LONG = """
import os, pathlib, signal, sys, threading, tubeplan
def told(stage, done, total):
    if not told.is_sent:
        told.is_sent = True
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
told.is_sent = False
try:
    {call}
except KeyboardInterrupt as stopped:
    print('interrupted', stopped)
    sys.exit(130)
sys.exit('not interrupted')
"""


def interrupted(call):
    """Runs a call that Ctrl-C interrupts; returns the folder's files and what was printed."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([sys.executable, '-c', LONG.format(call=call)], cwd=folder, capture_output=True, text=True, timeout=120,
                             check=False)
        files = sorted(str(path.relative_to(folder)) for path in pathlib.Path(folder).rglob('*'))
    return run.returncode, run.stdout + run.stderr, files


class Stops(unittest.TestCase):
    def test_ctrl_c_ends_work_and_leaves_nothing_half_written(self):
        cells = {'mockup': str(MOCKUP), 'true': str(TRUE), 'bench': str(BENCH), 'readings': str(readings())}
        for call, kept in (
                ("tubeplan.Cell({mockup!r}).score(truth={true!r}, runs=100000, progress=told)", []),
                ("tubeplan.Cell({bench!r}).simulate(design='bench', readings=100000, out='out', progress=told)", []),
                ("tubeplan.Cell({mockup!r}).campaign(runs=1000000, progress=told)", []),
                ("tubeplan.Cell({mockup!r}).plan(tubes='all', out='out', progress=told)", ['out', 'out/progress.json'])):
            with self.subTest(call):
                code, said, files = interrupted(call.format(**cells))
                self.assertEqual(code, 130, said)
                self.assertIn('interrupted', said)
                self.assertTrue({*files} <= {*kept}, files)

    def test_an_interrupted_plan_says_what_is_kept(self):
        call = f"tubeplan.Cell({str(MOCKUP)!r}).plan(tubes='all', out='out', progress=told)"
        code, said, _ = interrupted(call)
        self.assertEqual(code, 130)
        self.assertRegex(said, 'interrupted stopped')

    def test_an_exception_of_progress_ends_work_and_comes_out(self):
        class Enough(Exception):
            pass

        def told(stage, done, total):
            raise Enough(stage)

        before = time.monotonic()
        with self.assertRaises(Enough):
            tubeplan.Cell(MOCKUP).plan(tubes='all', progress=told)
        self.assertLess(time.monotonic() - before, 60)

    def test_ctrl_c_between_chunks_of_postures(self):
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        cell = tubeplan.Cell(BENCH)
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(1000):
                cell.poses([[0.1, 0.2, 0.3, 0.4]] * 20000)


class Progress(unittest.TestCase):
    def test_stages_are_told_and_change_nothing(self):
        told = []
        cell = tubeplan.Cell(BENCH, units='cell')
        with_progress = cell.diagnose(readings(), progress=lambda *step: told.append(step))
        self.assertEqual(with_progress.as_dict(), cell.diagnose(readings()).as_dict())
        self.assertGreater(len({stage for stage, _, _ in told}), 1)
        self.assertTrue(all(done <= total or total == 0 for _, done, total in told))


class Threads(unittest.TestCase):
    def run_together(self, *calls):
        results, errors = [None] * len(calls), []

        def run(k):
            try:
                results[k] = calls[k]()
            except BaseException as error:  # noqa: BLE001
                errors.append(error)

        threads = [threading.Thread(target=run, args=(k,)) for k in range(len(calls))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])
        return results

    def test_two_cells_at_once_give_what_each_gives_alone(self):
        bench, mockup = tubeplan.Cell(BENCH), tubeplan.Cell(MOCKUP)
        calls = (lambda: bench.diagnose(readings()), lambda: bench.identify(readings()), lambda: mockup.plan(tubes='spread:4'),
                 lambda: mockup.touches(tubes='spread:12', candidates=14))
        alone = [call().as_dict() for call in calls]
        for _ in range(2):
            together = [result.as_dict() for result in self.run_together(*calls)]
            for one, other in zip(together, alone):
                self.assertEqual(one['inputs'], other['inputs'])
                self.assertEqual(one, other)

    def test_errors_of_one_thread_are_not_those_of_another(self):
        def wrong():
            with self.assertRaises(tubeplan.InputError):
                tubeplan.Cell(BENCH).identify('nowhere.csv')

        result = self.run_together(lambda: tubeplan.Cell(BENCH).identify(readings()), *[wrong] * 8)[0]
        self.assertEqual(result.status, 'done')

    def test_other_threads_run_meanwhile(self):
        is_over, counted = threading.Event(), [0]

        def count():
            while not is_over.is_set():
                counted[0] += 1
                time.sleep(0.005)

        thread = threading.Thread(target=count)
        thread.start()
        before = time.monotonic()
        tubeplan.Cell(BENCH).diagnose(readings())
        taken = time.monotonic() - before
        is_over.set()
        thread.join()
        self.assertGreater(counted[0], taken / 0.05)  # a tenth of the turns of an idle machine


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
