"""Table of benchmark results and goals. Values that were not measured are marked as missing."""
from dataclasses import dataclass


@dataclass
class Row:
    what: str
    figure: str | None  # formatted value; None: not measured
    goal: str = ''
    met: bool | None = None  # None: there is no goal


def scaled(seconds):
    for unit, size in (('s', 1), ('ms', 1e-3), ('µs', 1e-6)):
        if seconds >= size:
            return f'{seconds / size:.3g} {unit}'
    return f'{seconds / 1e-9:.3g} ns'


def at_most(what, value, text, goal, show):
    """Returns a row whose value must not exceed the goal, which `show` formats; without a goal, the row has no
    judgement."""
    if value is None:
        return Row(what, None)
    return Row(what, text) if goal is None else Row(what, text, f'≤ {show(goal)}', value <= goal)


class Rows:
    """Makes table rows from the raw results."""

    def __init__(self, raw):
        self.raw = raw

    def value(self, group, name, key='time'):
        return self.raw.get(group, {}).get(name, {}).get(key)

    def time(self, what, group, name, goal=None):
        value = self.value(group, name)
        return at_most(what, value, value and scaled(value), goal, scaled)

    def ratio(self, what, group, ours, theirs, goal=None):
        time, other = self.value(group, ours), self.value(group, theirs)
        if time is None or not other:
            return Row(what, None)
        return at_most(what, time / other, f'{scaled(time)}, {time / other:.3g} times', goal, lambda g: f'{g:g} times')

    def rate(self, what, group, name, goal):
        value = self.value(group, name)
        if value is None:
            return Row(what, None)
        return Row(what, f'{1 / value:,.0f} a second', f'≥ {goal:,.0f}', 1 / value >= goal)

    def counter(self, what, group, name, key, unit, goal=None):
        value = self.value(group, name, key)
        return at_most(what, value, value is not None and f'{value:.3g} {unit}', goal, lambda g: f'{g:g} {unit}')

    def efficiency(self, what, one, two):
        alone, both = self.value('commands', one, 'wall'), self.value('commands', two, 'wall')
        if alone is None or both is None:
            return Row(what, None)
        share = 50 * alone / both
        return Row(what, f'{share:.0f} %', '≥ 90 %', share >= 90)

    def kinematics(self):
        rigid, jacobian = 'rigid KDL/pose', 'flexible/pose and Jacobian by joints'
        yield self.time('KDL: rigid pose', 'kinematics', rigid)
        yield self.time('KDL: rigid pose and Jacobian', 'kinematics', f'{rigid} and Jacobian')
        yield self.ratio('flexible pose, converged', 'kinematics', 'flexible/pose', rigid, 2.0)
        yield self.ratio('the same, batched', 'kinematics', 'flexible/pose, batched', rigid, 0.7)
        yield self.ratio('flexible pose and exact Jacobian by the joints', 'kinematics', jacobian, f'{rigid} and Jacobian', 2.0)
        yield self.ratio('the same, batched', 'kinematics', f'{jacobian}, batched', f'{rigid} and Jacobian')
        yield self.rate('inverse: tubes, all branches', 'kinematics', 'inverse/tubes, all branches', 50000)
        yield self.rate('inverse: via points from their neighbours', 'kinematics', 'inverse/via points', 200000)
        for name, value in self.raw.get('instructions', {}).items():
            yield Row(f'instructions of a {name} (callgrind)', value and f'{value:,.0f}')

    def identification(self):
        for case, goal in (('6 of 93 places', None), ('11 of 45 touch points', 0.005)):
            own, ceres = f'{case}/in-turn', f'{case}/ceres'
            yield self.time(f'{case}: Ceres', 'identification', ceres)
            yield self.time(f'{case}: as `identify` does it', 'identification', own, goal)
            yield self.ratio(f'{case}: `identify` compared with Ceres', 'identification', own, ceres, 1.0)
            yield self.ratio(f'{case}: `identify` compared with Hooke-Jeeves', 'identification', own,
                             f'{case}/hooke-jeeves', 0.01)
            yield self.ratio(f'{case}: Ipopt alone, compared with Ceres', 'identification', f'{case}/ipopt', ceres, 1.0)
        whole = '11 of 45 touch points/identify'
        yield self.time('11 of 45 touch points: all of `identify`, its judgement included', 'identification', whole)

    def diagnosis(self):
        yield self.time('ranking', 'diagnosis', 'diagnosis/ranking', 0.1)
        yield self.time('verdict', 'diagnosis', 'diagnosis/verdict', 2)

    def sheet(self):
        yield self.time('reach with collision checks', 'sheet', 'sheet/and collision checks: reach')
        yield self.time('scoring a visit to each', 'sheet', 'sheet/scoring', 0.05)
        orders = self.raw.get('order', {})
        for name in sorted(orders, key=lambda name: orders[name]['visits']):
            what = name.removeprefix('order/')
            yield self.time(f'order of {what}, bound included, all cores', 'order', name, 10 if what == 'all' else 1)
            yield self.counter(f'the same: gap, at most', 'order', name, 'gap_%', '%', 1)

    def clearance(self):
        yield self.ratio('distances of a posture', 'clearance', 'posture/distances', 'posture/distances/fcl')
        yield self.ratio('the same, side by side', 'clearance', 'posture/distances/side by side', 'posture/distances/fcl')
        yield self.time('a posture checked, bent shape included', 'clearance', 'posture', 2e-6)
        yield self.ratio('the same', 'clearance', 'posture', 'posture/fcl')
        yield self.ratio('the same, side by side', 'clearance', 'posture/side by side', 'posture/fcl')
        yield self.ratio('a neighbour move proved', 'clearance', 'neighbour move', 'neighbour move/fcl')
        yield self.counter('the same: median of the moves', 'clearance', 'neighbour move', 'median_us', 'µs', 50)

    def commands(self):
        for name, figure in self.raw.get('commands', {}).items():
            yield Row(name, f'{scaled(figure["wall"])}; {scaled(figure["processor"])}')
        yield self.efficiency('campaign: efficiency of 2 workers', 'campaign, 1 worker', 'campaign, 2 workers')
        yield self.efficiency('campaign: efficiency of 2 MPI ranks', 'campaign, 1 rank', 'campaign, 2 ranks')

    def sections(self):
        runs = self.raw.get('campaign_runs', 0)
        yield 'Kinematics, compared with the rigid kinematics of Orocos KDL', self.kinematics()
        yield 'Identification, the same residuals for every method', self.identification()
        yield 'Diagnosis of the whole catalogue, 150 readings', self.diagnosis()
        yield "The mock-up's sheet, 4,674 holes", self.sheet()
        yield 'Clearance, compared with the distance library (FCL)', self.clearance()
        yield f'Whole commands: wall; CPU (campaigns of {runs:,} runs)', self.commands()


def text_of(row):
    met = {None: '', True: 'met', False: '**not met**'}[row.met]
    return f'| {row.what} | {row.figure or "not measured"} | {row.goal} | {met} |'


def plans_text(plans):
    yield '| tubes | by | CPU | travel | nearest to anything |\n|---|---|---|---|---|'
    for row in plans:
        yield (f'| {row["visits"]} | {row["by"]} | {row["processor_s"]:.1f} s | {row["travel_time_s"]:.0f} s '
               f'| {row["least_clearance_in"]:.3f} in |')


def table(raw):
    lines = ['# Benchmarks',
             f'Written by `make bench` on {raw["date"]}: {raw["machine"]}. One core unless said otherwise, medians of '
             f'{raw["repetitions"]} (whole commands: of 3), a peer in the same process and run. Raw figures: '
             '[benchmarks.json](benchmarks.json).']
    for heading, rows in Rows(raw).sections():
        lines += ['', f'## {heading}', '| | figure | goal | |', '|---|---|---|---|', *map(text_of, rows)]
    lines += ['', '## Plans, compared with OMPL and FCL alone', *plans_text(raw.get('plans', []))]
    return '\n'.join(lines) + '\n'
