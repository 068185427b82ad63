#!/usr/bin/python3
"""Whole programs: `--to iso` through LinuxCNC's interpreter makes the moves of `--to csv`, within 1e-4 mm.

    programs.py FAGORC PROJECT [NAME...]

The programs of tests/examples and of the golden files that have a table of moves. What the neutral ISO cannot say (F0920) and the
interpreter's six axes cannot (U V W) is named and left out.
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import rs274_moves

FAGORC, PROJECT, NAMES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3:]
sys.path.insert(0, str(PROJECT / 'tools' / 'golden'))
import golden  # noqa: E402  (found by the line before)


class LeftOut(Exception):
    """A program that cannot be compared, and why."""


def example(path, folder):
    """(program, options) of an example."""
    shutil.copy(path, folder)
    return path.name, []


def golden_file(path, folder):
    """(program, options) of a golden file, whose files are written into the folder; None where it shows no moves."""
    g = golden.Golden(path.read_text(encoding='utf-8'), FAGORC, [])
    if not any(run.command[0] == 'compile' and 'csv' in run.command and 'exit' not in run.sections for run in g.runs):
        return None
    for name, content in g.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)
    return g.main, g.options


def make(folder, program, options, form, name):
    command = [FAGORC, 'compile', program, '--to', form, '-o', name, '--format', 'short', *options]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, errors='replace', timeout=120)


def wrong(path):
    """What is wrong with a program: None where nothing is."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found = (golden_file if path.suffix == '.golden' else example)(path, folder)
        if not found:
            raise LeftOut('it shows no moves')
        if make(folder, *found, 'csv', 'moves.csv').returncode:
            raise LeftOut('it does not compile')
        if re.search(r'[,;"][UVW]=', (folder / 'moves.csv').read_text()):
            raise LeftOut('U V W')
        iso = make(folder, *found, 'iso', 'moves.ngc')
        if iso.returncode:
            if 'F0920' in iso.stderr + iso.stdout:
                raise LeftOut(iso.stderr.strip())
            return f'--to iso: {iso.stderr}'
        try:
            return rs274_moves.compare(rs274_moves.table(folder / 'moves.csv'), rs274_moves.moves(str(folder / 'moves.ngc')))
        except rs274_moves.Refused as why:
            return str(why)


def outcome(path):
    try:
        what = wrong(path)
    except LeftOut as why:
        return path, 'left out', str(why)
    return path, 'equal' if what is None else 'differs', what


def main():
    if not shutil.which('rs274'):
        print('skipped: rs274 is not installed (Debian package linuxcnc-uspace)')
        sys.exit(rs274_moves.SKIP)
    paths = [*sorted((PROJECT / 'tests/examples').glob('*.pit')), *sorted((PROJECT / 'tests/golden').rglob('*.golden'))]
    paths = [p for p in paths if not NAMES or p.stem in NAMES]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        outcomes = list(pool.map(outcome, paths))
    for path, kind, what in outcomes:
        if kind == 'differs' or (kind == 'left out' and ('F0920' in what or 'U V W' in what)):
            print(f'{path.relative_to(PROJECT)}: {kind}: {what}')
    count = {kind: sum(k == kind for _, k, _ in outcomes) for kind in ('equal', 'differs', 'left out')}
    print(', '.join(f'{n} {kind}' for kind, n in count.items()))
    sys.exit(1 if count['differs'] or not count['equal'] else 0)


if __name__ == '__main__':
    main()
