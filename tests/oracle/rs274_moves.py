#!/usr/bin/python3
"""Runs an ISO program through LinuxCNC's interpreter and prints its moves, or compares them with a table of moves.

    rs274_moves.py PROGRAM.ngc                  the moves as CSV: kind,x,z,cx,cz and other axes, doubles
    rs274_moves.py PROGRAM.ngc MOVES.csv        compares them with a table of `fagorc compile --to csv`

Exit 0: equal, or printed; 1: refused by the interpreter, or different; 77: no interpreter on this machine (skip).

Two things run. `rs274 -g`, the stand-alone interpreter, gives every canonical call in four decimals: thread leads,
dwells, planes. LinuxCNC's Python module gives the same moves in full doubles (in inches, of whatever the program uses).
Both must tell the same moves.
"""
import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIP = 77
TOLERANCE = 1e-4            # mm: what our moves and the interpreter's may differ by
TEXT_TOLERANCE = 6e-5       # of the four decimals that rs274 prints
MOVES = ('STRAIGHT_TRAVERSE', 'STRAIGHT_FEED', 'ARC_FEED')
CALL = re.compile(r'^\s*\d+\s+N[\d.]+\s*([A-Z_0-9]+)\((.*)\)\s*$')
AXES = 'XYZABCUVW'

# The interpreter as a module needs tool data in memory; an empty table will do. Its moves come in inches.
WORKER = r"""
import ctypes, json, sys
program, variables = sys.argv[1:3]
tools = ctypes.CDLL('libtooldata.so.0', mode=ctypes.RTLD_GLOBAL)
table = ctypes.create_string_buffer(1 << 16)
tools._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(table, 0)
tools._Z13tooldata_initb(False)
import gcode
class Canon:
    parameter_file = variables
    def __init__(self): self.moves = []
    def __getattr__(self, name):
        if name.startswith('__'): raise AttributeError(name)
        return lambda *a: None
    def check_abort(self): return False
    def get_external_length_units(self): return 1 / 25.4
    def get_external_angular_units(self): return 1.0
    def get_axis_mask(self): return 0x1ff
    def get_block_delete(self): return 0
    def get_tool(self, i): return (0,) + (0.0,) * 12 + (0,)
    def straight_traverse(self, *a): self.moves.append(['STRAIGHT_TRAVERSE', *a[:9]])
    def straight_feed(self, *a): self.moves.append(['STRAIGHT_FEED', *a[:9]])
    def arc_feed(self, *a): self.moves.append(['ARC_FEED', *a])
canon = Canon()
status, line = gcode.parse(program, canon, 'G21', '')
json.dump([status, line, gcode.strerror(status) if status > 1 else '', canon.moves], sys.stdout)
"""


class Refused(Exception):
    """The interpreter does not take the program, or its two faces tell different moves."""


def run(program):
    """(canonical calls as (name, arguments) texts, exact moves of the module)."""
    with tempfile.TemporaryDirectory() as home:          # it leaves files in HOME
        environment = dict(os.environ, HOME=home)
        variables = os.path.join(home, 'rs274.var')
        open(variables, 'w').close()
        p = subprocess.run(['rs274', '-g', '-v', variables, program], capture_output=True, text=True, env=environment,
                           cwd=home)
        if p.returncode:
            raise Refused('rs274 refuses the program:\n' + '\n'.join(p.stderr.splitlines()[-4:]))
        calls = [m.groups() for m in map(CALL.match, p.stdout.splitlines()) if m]
        p = subprocess.run(['/usr/bin/python3', '-c', WORKER, program, variables], capture_output=True, text=True,
                           env=environment, cwd=home)
        if p.returncode:
            raise Refused('the module refuses the program:\n' + p.stderr[-400:])
        status, line, why, exact = json.loads(p.stdout[p.stdout.index('['):])
        if status > 1:
            raise Refused(f'the module refuses line {line}: {why}')
        return calls, exact


def numbers(text):
    return [float(v) for v in re.findall(r'[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?', text)]


def in_millimetres(name, values):
    """A move of the module, in inches and degrees, in millimetres and degrees."""
    if name == 'ARC_FEED':      # end 1 2, centre 1 2, turns, end of the third axis, A B C, U V W
        linear = [True] * 4 + [False, True] + [False] * 3 + [True] * 3
    else:
        linear = [c not in 'ABC' for c in AXES]
    return [v * 25.4 if is_length else v for v, is_length in zip(values, linear)]


def moves(program):
    """Dictionaries: kind, the nine axes, cu cv (centre), lead, seconds."""
    calls, exact = run(program)
    exact = iter(exact)
    plane, lead, at, out = 'XZ', 0.0, dict.fromkeys(AXES, 0.0), []
    # Axes of an arc in the order of its arguments: first, second, third.
    order = {'XY': 'XYZ', 'XZ': 'ZXY', 'YZ': 'YZX'}
    for name, text in calls:
        if name in MOVES:
            kind, *values = next(exact)
            values = in_millimetres(kind, values)
            rough = numbers(text)
            if kind != name or any(abs(a - b) > TEXT_TOLERANCE for a, b in zip(rough, values)):
                raise Refused(f'rs274 and the module disagree: {name}({text}), {kind} {values}')
            move = {'lead': lead}
            if name == 'ARC_FEED':
                first, second, third = order[plane]
                at.update({first: values[0], second: values[1], third: values[5]})
                at.update(zip('ABCUVW', values[6:12]))
                move.update(kind='ccw' if values[4] > 0 else 'cw', plane=first + second, cu=values[2], cv=values[3])
            else:
                at.update(zip(AXES, values))
                move['kind'] = 'rapid' if name == 'STRAIGHT_TRAVERSE' else 'thread' if lead else 'line'
            out.append(dict(move, **at))
        elif name == 'SELECT_PLANE':
            plane = text.replace('CANON_PLANE_', '')
        elif name == 'START_SPEED_FEED_SYNC':
            lead = numbers(text)[0]
        elif name == 'STOP_SPEED_FEED_SYNCH':
            lead = 0.0
        elif name == 'DWELL':
            out.append(dict(at, kind='dwell', seconds=numbers(text)[0]))
    return out


def table(path):
    """The rows of our table of moves, in the same form."""
    out, at = [], dict.fromkeys(AXES, 0.0)
    with open(path, newline='') as f:
        for row in csv.DictReader(f):
            others = dict(e.split('=') for e in row['axes'].split(';') if e)
            at.update(X=float(row['x']), Z=float(row['z']))
            at.update({k: float(v) for k, v in others.items() if k in AXES})
            move = dict(at, kind=row['kind'])
            if row['kind'] in ('cw', 'ccw'):
                centre = {'X': row['cx'], 'Z': row['cz'], 'Y': others.get('cy', '')}
                plane = 'ZX' if centre['X'] and centre['Z'] else 'XY' if centre['X'] else 'YZ'
                move.update(plane=plane, cu=float(centre[plane[0]]), cv=float(centre[plane[1]]))
            elif row['kind'] == 'dwell':
                move['seconds'] = float(row['feed'])
            if row['kind'] == 'thread':
                move['lead'] = float(row['lead'])
            out.append(move)
    return out


def moving(moves):
    """Without the straight moves that go nowhere: ISO leaves them out where it knows the position."""
    at, out = dict.fromkeys(AXES, 0.0), []
    for move in moves:
        if move['kind'] in ('cw', 'ccw', 'dwell') or any(abs(move[a] - at[a]) >= 1e-6 for a in AXES):
            out.append(move)
        at = move
    return out


def compare(ours, theirs):
    """None where two lists of moves are equal, else what differs first."""
    ours, theirs = moving(ours), moving(theirs)
    for i, pair in enumerate(zip(ours, theirs), 1):
        if what := difference(*pair):
            return f'move {i}: {what}'
    return f'{len(ours)} moves became {len(theirs)}' if len(ours) != len(theirs) else None


def difference(ours, theirs):
    """None where two moves are equal, else what differs."""
    if ours['kind'] != theirs['kind']:
        return f"{ours['kind']} became {theirs['kind']}"
    for key, value in ours.items():
        other = theirs.get(key)
        if isinstance(value, str):
            if value != other:
                return f'{key}: {value} became {other}'
        elif other is None or not math.isfinite(other) or abs(value - other) > TOLERANCE:
            return f'{key}: {value} became {other}'
    return None


def main():
    if not shutil.which('rs274'):
        print('skipped: rs274 is not installed (Debian package linuxcnc-uspace)')
        sys.exit(SKIP)
    try:
        got = moves(os.path.abspath(sys.argv[1]))
    except Refused as why:
        sys.exit(str(why))
    if len(sys.argv) < 3:
        writer = csv.DictWriter(sys.stdout, ['kind', *AXES, 'plane', 'cu', 'cv', 'lead', 'seconds'])
        writer.writeheader()
        writer.writerows(got)
        return
    if what := compare(table(sys.argv[2]), got):
        sys.exit(what)
    print(f'{len(got)} moves are equal')


if __name__ == '__main__':
    main()
