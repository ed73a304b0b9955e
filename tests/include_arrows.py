"""Fails if an include between folders has no arrow in ARROWS. python3 tests/include_arrows.py [TREE]

ARROWS alone states which folder may include which. A file belongs to the longest entry that its path begins with. An
arrow to a folder allows all files of the folder that have no entry of their own. Files of one entry may include one
another."""
import pathlib
import re
import sys

LIBRARIES = 'planner calibration deflection tubesheets'.split()
ARROWS = {
    'tubesheets': '',
    'deflection': '',
    'deflection/inverse': 'deflection',
    # The files directly in calibration are used by all of its folders: measurement, placed_arm, hooks, statistics.
    'calibration': 'deflection deflection/inverse tubesheets',
    'calibration/measurements': 'calibration',
    'calibration/simulation': 'calibration calibration/measurements',
    'calibration/estimation': 'calibration calibration/measurements',
    'calibration/design': 'calibration calibration/measurements calibration/estimation calibration/simulation',
    'calibration/forecast': 'calibration calibration/measurements calibration/estimation',
    'calibration/watch': 'calibration calibration/measurements calibration/estimation calibration/diagnosis/causes '
                         'calibration/diagnosis/evidence tubesheets',
    'calibration/measurement_checks': 'calibration calibration/measurements calibration/estimation',
    'calibration/patterns': 'calibration calibration/measurements calibration/estimation',
    # The stages of a diagnosis; each uses earlier stages, and the function `diagnose` uses all of them (docs/design.md).
    'calibration/diagnosis/causes': 'calibration calibration/measurements calibration/estimation',
    'calibration/diagnosis/discrepancy': 'calibration calibration/measurements calibration/estimation',
    'calibration/diagnosis/evidence': 'calibration calibration/estimation',
    'calibration/diagnosis/explanations': 'calibration calibration/measurements calibration/estimation '
                                          'calibration/diagnosis/causes',
    'calibration/diagnosis/model_selection': 'calibration calibration/measurements calibration/estimation '
                                             'calibration/diagnosis/causes calibration/diagnosis/discrepancy '
                                             'calibration/diagnosis/evidence calibration/diagnosis/explanations',
    'calibration/diagnosis/judgement': 'calibration calibration/measurements calibration/estimation calibration/patterns '
                                       'calibration/diagnosis/explanations calibration/diagnosis/model_selection',
    'calibration/diagnosis/discrimination': 'calibration calibration/measurements calibration/design '
                                            'calibration/estimation calibration/diagnosis/explanations '
                                            'calibration/diagnosis/judgement',
    'calibration/diagnosis': 'calibration calibration/measurements calibration/estimation '
                             'calibration/diagnosis/explanations calibration/diagnosis/model_selection '
                             'calibration/diagnosis/judgement',
    # The files directly in planner use all of its folders; most of the folders use the work cell.
    'planner/scene': 'deflection tubesheets',
    'planner/workcell': 'planner/scene',
    'planner/visit_conditions': '',
    'planner/collision': 'planner/workcell planner/scene deflection/inverse',
    'planner/timing': '',
    'planner/motion': 'planner/collision planner/timing',
    'planner/reach': 'planner/motion planner/collision planner/timing planner/workcell planner/scene deflection/inverse',
    'planner/order': 'planner/timing',
    'planner/positions': '',
    'planner': 'planner/order planner/reach planner/motion planner/collision planner/timing planner/workcell '
               'planner/visit_conditions planner/scene',
    'planner/verification': 'planner planner/collision planner/scene planner/workcell',
    'app/report': '',
    'app/studies': 'LIBRARIES',
    'app/studies/measurements': 'app/studies LIBRARIES',
    'app/studies/positioning': 'app/studies app/studies/measurements LIBRARIES',
    'app/studies/model': 'app/studies app/studies/positioning LIBRARIES',
    'app/studies/monte_carlo': 'app/studies app/studies/measurements app/studies/positioning LIBRARIES',
    'app/storage': 'tubesheets',
    'app/formats': 'app/storage STUDIES LIBRARIES',
    'app/documents': 'app/report app/formats app/storage STUDIES LIBRARIES',
    'app/jobs': 'app/documents app/report app/formats app/storage STUDIES LIBRARIES',
    'app/outage': 'app/jobs app/documents app/formats app/storage STUDIES LIBRARIES',
    'app/cli': 'app/formats app/storage STUDIES LIBRARIES',
    'app/workbench': 'app/outage app/jobs app/documents app/report app/formats app/storage STUDIES LIBRARIES',
    'app/commands': 'app/cli app/workbench app/outage app/jobs app/documents app/report app/formats app/storage STUDIES LIBRARIES',
    # Python calls the commands, as main.cpp does.
    'app/python': 'app/commands app/cli app/outage app/documents app/formats app/storage STUDIES LIBRARIES',
    'app/main.cpp': 'app/commands app/cli app/formats app/storage STUDIES',
}
ANYWHERE = {'app/version.hpp'}  # generated
# External headers, and the folders that may include them.
FOREIGN = {
    'nlohmann/': ['app/'], 'yaml-cpp/': ['app/formats/'], 'CLI/': ['app/cli/', 'app/commands/'],
    'httplib.h': ['app/workbench/'], 'ompl/': ['planner/motion/'], 'fcl/': ['planner/'], 'sqlite3.h': ['app/outage/'], 'mpi.h': ['app/studies/monte_carlo/'],
}
NOT_IN_STUDIES = ['nlohmann/', 'yaml-cpp/', 'app/storage/input_error.hpp']


def allowed(entry):
    """Returns the entries that an entry may include, with the entry itself."""
    names = {entry}
    for name in ARROWS[entry].split():
        if name == 'LIBRARIES':
            names.update(e for e in ARROWS if e.split('/')[0] in LIBRARIES)
        elif name == 'STUDIES':
            names.update(e for e in ARROWS if e.startswith('app/studies'))
        else:
            names.add(name)
    if entry.startswith(('calibration', 'planner')):
        names.update(('deflection', 'deflection/inverse', 'tubesheets'))
    return names


def entry_of(path):
    fits = [e for e in ARROWS if path == e or path.startswith((e + '/', e + '.'))]
    return max(fits, key=len, default=None)


def problems_of(path, included):
    entry = entry_of(path)
    if entry is None:
        return [f'{path}: its folder has no entry in {pathlib.Path(__file__).name}']
    found = []
    for name in included:
        target = entry_of(name)
        if target is not None and name not in ANYWHERE and target not in allowed(entry):
            found.append(f'{path} includes {name}: {entry} may not include {target}')
        if path.startswith('app/studies/') and name.startswith(tuple(NOT_IN_STUDIES)):
            found.append(f'{path} includes {name}: studies know no files and no JSON')
        if name.startswith('tests/'):
            found.append(f'{path} includes {name}: the program does not know its tests')
        for header, places in FOREIGN.items():
            if name.startswith(header) and not path.startswith(tuple(places)):
                found.append(f'{path} includes {name}, which has its place in {", ".join(places)}')
    return found


def circle_in_arrows():
    """Returns an entry that a chain of arrows leads back to; None if there is no such circle."""
    def reaches(entry, seen):
        for name in allowed(entry) - {entry}:
            if name == start:
                return True
            if name not in seen and (seen.add(name) or reaches(name, seen)):
                return True
        return False
    for start in ARROWS:
        if reaches(start, set()):
            return start
    return None


def main():
    tree = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    if not problems_of('calibration/a.cpp', ['planner/b.hpp']) or problems_of('app/formats/a.cpp', ['planner/workcell.hpp']):
        sys.exit('the check itself is broken')
    if circle := circle_in_arrows():
        sys.exit(f'the arrows lead from {circle} back to it')
    problems, count = [], 0
    for folder in [*LIBRARIES, 'app']:
        for path in sorted((tree / folder).rglob('*.[hc]pp')):
            if 'node_modules' in path.parts:
                continue
            count += 1
            included = re.findall(r'^[ \t]*#[ \t]*include [<"]([^">]+)[">]', path.read_text(), re.M)
            problems += problems_of(str(path.relative_to(tree)), included)
    if count < 100:
        sys.exit(f'only {count} sources under {tree}')
    print('\n'.join(problems) or f'{count} sources, no include that points back')
    sys.exit(1 if problems else 0)


if __name__ == '__main__':
    main()
