#!/usr/bin/env python3
"""Runs every benchmark, then whole commands, and writes the results as a table and as raw figures.

Ratios compare medians of one run, in which reference libraries are timed in the same process. Times are for one core
unless the row says otherwise.
"""
import argparse
import json
import os
import pathlib
import platform
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

from table import table

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARIES = ['kinematics', 'identification', 'diagnosis', 'clearance', 'sheet', 'order']
POSTURES_PER_ROUND = 64  # postures solved by kernel_instructions per round


def machine():
    model = next((line.split(':')[1].strip() for line in open('/proc/cpuinfo') if line.startswith('model name')), '?')
    return f'{model}, {os.cpu_count()} cores, {platform.system()} {platform.release()}'


def run_library(folder, name, repetitions):
    """Returns the medians keyed by benchmark: {'name': {'time': CPU time [s] (wall time if parallel), counters...}}."""
    with tempfile.NamedTemporaryFile(suffix='.json') as out:
        subprocess.run([folder / f'{name}_benchmark', f'--benchmark_repetitions={repetitions}',
                        '--benchmark_enable_random_interleaving=true', '--benchmark_report_aggregates_only=true',
                        '--benchmark_counters_tabular=true', f'--benchmark_out={out.name}'], check=True)
        raw = json.load(open(out.name))
    unit = {'ns': 1e-9, 'us': 1e-6, 'ms': 1e-3, 's': 1}
    known = {'cpu_time', 'real_time', 'name', 'run_name', 'run_type', 'family_index', 'per_family_instance_index',
             'repetitions', 'threads', 'aggregate_name', 'aggregate_unit', 'time_unit', 'iterations'}
    wall = '/real_time'  # suffix of benchmarks that use all cores

    def figures(row):
        time_of = 'real_time' if row['run_name'].endswith(wall) else 'cpu_time'
        return {'time': row[time_of] * unit[row['time_unit']], **{key: row[key] for key in row.keys() - known}}

    return {row['run_name'].removesuffix(wall): figures(row)
            for row in raw['benchmarks'] if row.get('aggregate_name') == 'median'}


def run_command(command, repetitions):
    """Returns the median wall and CPU times [s]; the folder named by --out, if any, is removed before each run."""
    walls, processors = [], []
    for _ in range(repetitions):
        if '--out' in command:
            shutil.rmtree(command[command.index('--out') + 1], ignore_errors=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        start = time.monotonic()
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        walls.append(time.monotonic() - start)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        processors.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return {'wall': statistics.median(walls), 'processor': statistics.median(processors)}


def instructions(folder, jacobian):
    """Returns the instructions per posture counted by callgrind: the cost of additional rounds divided by the number of
    postures in them. None without valgrind."""
    if not shutil.which('valgrind'):
        return None

    def counted(rounds):
        words = ['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', folder / 'kernel_instructions',
                 '--rounds', str(rounds)] + (['--jacobian'] if jacobian else [])
        listing = subprocess.run(words, capture_output=True, text=True).stderr
        return int(re.search(r'Collected : (\d+)', listing).group(1))

    return (counted(21) - counted(1)) / (20 * POSTURES_PER_ROUND)


def plans(folder):
    with tempfile.NamedTemporaryFile(suffix='.json') as out:
        subprocess.run([folder / 'ompl_fcl_plan', '--json', out.name], check=True)
        return json.load(open(out.name))


def commands(program, runs):
    """Times whole commands on the shipped cell one after another, because concurrent commands would share the cores."""
    cell = ROOT / 'app/cells/mockup.yaml'
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch)
        plan = [program, 'plan', cell, '--tubes']
        campaign = [program, 'campaign', cell, '--seed', 1, '--runs', runs, '--out']
        ways = {'plan 500': (3, [*plan, 'spread:500', '--out', out / '500']),
                'plan all': (1, [*plan, 'all', '--out', out / 'all']),
                'verify all': (1, [program, 'verify', cell, out / 'all']),
                'campaign, 1 worker': (3, [*campaign, out / 'one', '--jobs', 1]),
                'campaign, 2 workers': (3, [*campaign, out / 'two', '--jobs', 2])}
        if shutil.which('mpirun'):
            ranks = ['mpirun', '--allow-run-as-root', '-n']
            ways['campaign, 1 rank'] = (3, [*ranks, 1, *campaign, out / 'rank', '--jobs', 1])
            ways['campaign, 2 ranks'] = (3, [*ranks, 2, *campaign, out / 'ranks', '--jobs', 1])
        done = {}
        for name, (times, words) in ways.items():
            done[name] = run_command(words, times)
            print(name, done[name], flush=True)
    return done


def write_text(path, text):
    part = path.with_suffix(path.suffix + '.part')
    part.write_text(text)
    part.replace(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--build', type=pathlib.Path, default=ROOT / 'build-bench', help='the build folder')
    parser.add_argument('--repetitions', type=int, default=9)
    parser.add_argument('--runs', type=int, default=60000, help='of the campaigns')
    parser.add_argument('--out', type=pathlib.Path, default=ROOT / 'docs')
    parser.add_argument('--only', nargs='+', choices=[*LIBRARIES, 'instructions', 'plans', 'commands'],
                        help='these alone; the other figures stay as the last run on this machine left them')
    options = parser.parse_args()
    folder, program = options.build / 'studies/benchmarks', options.build / 'tubeplan'
    runs = {name: lambda name=name: run_library(folder, name, options.repetitions) for name in LIBRARIES}
    runs['instructions'] = lambda: {'pose': instructions(folder, False),
                                    'pose and Jacobian': instructions(folder, True)}
    runs['plans'] = lambda: plans(folder)
    runs['commands'] = lambda: commands(program, options.runs)

    raw = options.out / 'benchmarks.json'
    figures = json.loads(raw.read_text()) if options.only and raw.exists() else {}
    if figures.get('machine', machine()) != machine():
        sys.exit(f'{raw} is of another machine: run all benchmarks')
    figures |= {'machine': machine(), 'date': time.strftime('%Y-%m-%d'), 'repetitions': options.repetitions,
                'campaign_runs': options.runs}
    for name in options.only or runs:
        figures[name] = runs[name]()
        write_text(raw, json.dumps(figures, indent=1, sort_keys=True) + '\n')
        write_text(options.out / 'benchmarks.md', table(figures))
    print(f'wrote {options.out / "benchmarks.md"} and benchmarks.json')


if __name__ == '__main__':
    sys.exit(main())
