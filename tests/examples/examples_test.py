#!/usr/bin/env python3
"""Programs of the manual as tests: `fagorc check` has nothing to say about them and they move as their tables say.

    examples_test.py --fagorc BIN [NAME...]

NAME.pit is the program. NAME.moves, where there is one, is the table of its moves, computed from the formulas of the language by a model
of its own: `kind,x,z,cx,cz`, millimetres, X as a radius, from the part zero. NAME.refused instead is a program that must be refused, with the
control's alarm number. Moves of no length do not count.
"""
import argparse
import csv
import io
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TOLERANCE = 1.5e-3               # of a table that is printed with four decimals after formulas with rounded words
KINDS = ('rapid', 'line', 'cw', 'ccw', 'thread')


def run(fagorc, *words):
    return subprocess.run([fagorc, *words], capture_output=True, text=True, errors='replace', timeout=60, cwd=HERE)


def rows(text):
    """(kind, x, z, cx, cz) of the moves of a table; a cell that is empty says nothing."""
    number = lambda cell: float(cell) if cell else None
    return [(r['kind'], *(number(r[c]) for c in ('x', 'z', 'cx', 'cz'))) for r in csv.DictReader(io.StringIO(text)) if r['kind'] in KINDS]


def moving(moves):
    """Without the moves of no length; all programs start at the part zero."""
    at, kept = (0.0, 0.0), []
    for m in moves:
        if m[0] in ('cw', 'ccw') or max(abs(m[1] - at[0]), abs(m[2] - at[1])) > 1e-6:
            kept.append(m)
        at = m[1:3]
    return kept


def difference(want, got):
    for i, (w, g) in enumerate(zip(want, got), 1):
        if w[0] != g[0]:
            return f'move {i} is {g[0]}, {w[0]} expected'
        for name, a, b in zip(('x', 'z', 'cx', 'cz'), w[1:], g[1:]):
            if a is not None and (b is None or abs(a - b) > TOLERANCE):
                return f'move {i}: {name} is {b}, {a} expected'
    return None if len(want) == len(got) else f'{len(got)} moves, {len(want)} expected'


def read(name):
    with open(os.path.join(HERE, name), encoding='utf-8') as f:
        return f.read()


def wrong(fagorc, name):
    """What is wrong with one example; None where nothing is."""
    checked = run(fagorc, 'check', name + '.pit', '--format', 'json', '--control', '8055')
    if os.path.exists(os.path.join(HERE, name + '.refused')):
        alarm = read(name + '.refused').strip()
        found = [json.loads(line).get('alarm') for line in checked.stdout.splitlines()]
        return None if checked.returncode == 1 and alarm in found else f'alarm {alarm} expected, exit {checked.returncode}, {found}'
    if checked.returncode != 0:
        return f'check: exit {checked.returncode}: {checked.stdout}{checked.stderr}'
    if not os.path.exists(os.path.join(HERE, name + '.moves')):
        return None
    made = run(fagorc, 'compile', name + '.pit', '--to', 'csv', '-o', '-', '--frame', 'part', '--control', '8055')
    if made.returncode != 0:
        return f'compile: exit {made.returncode}: {made.stderr}'
    return difference(moving(rows(read(name + '.moves'))), moving(rows(made.stdout)))


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument('names', nargs='*')
    a.add_argument('--fagorc', required=True)
    o = a.parse_args()
    o.fagorc = os.path.abspath(o.fagorc)
    names = o.names or sorted(f[:-4] for f in os.listdir(HERE) if f.endswith('.pit'))
    failed = [f'{n}: {w}' for n in names if (w := wrong(o.fagorc, n))]
    print(f'{len(names) - len(failed)} of {len(names)} examples', *failed, sep='\n')
    sys.exit(1 if failed or not names else 0)


if __name__ == '__main__':
    main()
