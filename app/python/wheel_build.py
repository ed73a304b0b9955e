"""Builds the wheel of the package, as PEP 517 asks: CMake builds and installs it, and its files are zipped.

Debian bookworm has no scikit-build-core, and this needs nothing but CMake. TUBEPLAN_BUILD names an existing build
folder; otherwise build-wheel is made. The wheel does not contain the libraries of packages.txt, so it is for machines
that have them.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sysconfig
import tempfile
import tomllib
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
EPOCH = (1980, 1, 1, 0, 0, 0)  # time of all files, so that the same sources make the same wheel


def get_requires_for_build_wheel(config_settings=None):
    return []


def _installed(folder):
    """Builds the package and installs it below a folder."""
    build = pathlib.Path(os.environ.get('TUBEPLAN_BUILD', SOURCE / 'build-wheel'))
    if not (build / 'CMakeCache.txt').exists():
        subprocess.run(['cmake', '-S', SOURCE, '-B', build, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release', '-DTUBEPLAN_TESTS=OFF'],
                       check=True)
    subprocess.run(['cmake', '--build', build, '--target', 'tubeplan_package'], check=True)
    subprocess.run(['cmake', '--install', build, '--component', 'python', '--prefix', folder, '--strip'], check=True)
    return next(pathlib.Path(folder).rglob('tubeplan/__init__.py')).parent


def _version():
    text = (SOURCE / 'CMakeLists.txt').read_text(encoding='utf-8')
    return re.search(r'project\(\w+\s+VERSION\s+([\d.]+)', text)[1]


def _metadata(version):
    project = tomllib.loads((SOURCE / 'pyproject.toml').read_text(encoding='utf-8'))['project']
    lines = ['Metadata-Version: 2.1', f'Name: {project["name"]}', f'Version: {version}', f'Summary: {project["description"]}',
             f'Requires-Python: {project["requires-python"]}', *(f'Requires-Dist: {name}' for name in project['dependencies'])]
    for extra, names in project['optional-dependencies'].items():
        lines += [f'Provides-Extra: {extra}', *(f'Requires-Dist: {name} ; extra == "{extra}"' for name in names)]
    return '\n'.join([*lines, 'Description-Content-Type: text/markdown', '', (SOURCE / 'docs/python.md').read_text(encoding='utf-8')])


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    abi = f'cp{sysconfig.get_config_var("py_version_nodot")}'
    tag = f'{abi}-{abi}-{sysconfig.get_platform().replace("-", "_").replace(".", "_")}'
    with tempfile.TemporaryDirectory() as folder:
        package = _installed(folder)
        version = _version()
        files = {f'tubeplan/{path.relative_to(package)}': path.read_bytes()
                 for path in sorted(package.rglob('*')) if path.is_file()}
    about = f'tubeplan-{version}.dist-info'
    files[f'{about}/METADATA'] = _metadata(version).encode()
    files[f'{about}/WHEEL'] = f'Wheel-Version: 1.0\nGenerator: tubeplan\nRoot-Is-Purelib: false\nTag: {tag}\n'.encode()
    files[f'{about}/entry_points.txt'] = b'[console_scripts]\ntubeplan = tubeplan.__main__:main\n'
    files[f'{about}/LICENSE'] = (SOURCE / 'LICENSE').read_bytes()
    record = [f'{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()},{len(data)}'
              for name, data in files.items()]
    files[f'{about}/RECORD'] = '\n'.join([*record, f'{about}/RECORD,,', '']).encode()
    name = f'tubeplan-{version}-{tag}.whl'
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, 'w', zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path, EPOCH)
            entry.external_attr = (0o755 if path.endswith('.so') else 0o644) << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return name
