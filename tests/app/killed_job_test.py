"""killed_job_test.py TUBEPLAN SOURCE: marks of a job survive a kill at any instant, and no mark is lost if several
processes write to the same job.

The program makes a mark before it prints the mark's event.
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, SOURCE = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
JOB = f'''job: test
units: {{length: in, angle: deg, force: lbf}}
steam_generators: [{{name: A, hot: {SOURCE}/app/cells/mockup.yaml}}]
tools: [{{name: bobbin}}]
packages: [{{name: rows, tubes: R5-20C30-80, tool: bobbin, confirm: none}}]
'''
TUBES = [f'A/hot/R{row}C{column}' for row in range(5, 21) for column in range(30, 81)]


class Job(unittest.TestCase):
    def setUp(self):
        self.made = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.made.name)
        (self.folder / 'job.yaml').write_text(JOB)
        self.answer('create', 'job.yaml', '--out', 'a.job')

    def tearDown(self):
        self.made.cleanup()

    def begin(self, *words):
        return subprocess.Popen([PROGRAM, 'job', *words], cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def answer(self, *words):
        process = self.begin(*words, '--json', '-')
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, err)
        return json.loads(out)

    def marks(self):
        return {event['tube'] for event in self.answer('log', 'a.job')['events'] if event['kind'] == 'mark'}

    def test_killed_at_50_instants(self):
        draw = random.Random(50)
        start = time.time()
        self.answer('mark', 'a.job', TUBES[0], '--as', 'done', '--by', 'Tom')
        usual = time.time() - start
        acknowledged = {TUBES[0]}
        for tube in TUBES[1:51]:
            process = self.begin('mark', 'a.job', tube, '--as', 'done', '--by', 'Tom')
            time.sleep(draw.uniform(0, 1.2 * usual))
            process.kill()
            if 'event' in process.communicate()[0]:
                acknowledged.add(tube)
            usual *= 0.9 if tube in acknowledged else 1.1  # as fast as the machine is now
            self.assertLessEqual(acknowledged, self.marks())
        made = self.marks()
        self.assertLessEqual(made, set(TUBES[:51]))
        status = self.answer('status', 'a.job')['total']
        self.assertEqual(status['done'], len(made))
        self.assertEqual(status['planned'], status['done'] + status['excluded'] + status['unresolved'])
        self.assertGreater(len(made), 5)
        self.assertLess(len(made), 51)

    def test_three_desks_at_once(self):
        desks = [[self.begin('mark', 'a.job', tube, '--as', 'done', '--by', f'desk {k}') for tube in TUBES[k:60:3]]
                 for k in range(3)]
        for desk in desks:
            for process in desk:
                err = process.communicate(timeout=120)[1]
                self.assertEqual(process.returncode, 0, err)
        self.assertEqual(self.marks(), set(TUBES[:60]))

    def test_two_desks_at_one_tube(self):
        last = self.answer('next', 'a.job')['last_event']
        desks = [self.begin('mark', 'a.job', TUBES[0], '--as', mark, '--by', mark, '--after', str(last))
                 for mark in ('done', 'obstructed')]
        codes = sorted(process.wait(timeout=60) for process in desks)
        for process in desks:
            process.communicate()
        self.assertEqual(codes, [0, 2])
        self.assertEqual(len(self.answer('log', 'a.job')['events']), 1)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
