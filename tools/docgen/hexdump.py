#!/usr/bin/env python3
"""Print a trajectory file byte by byte with what the bytes mean, and check its structure.

    hexdump.py FILE.ftj [TYPE...]      TYPE: only the blocks of these types, and the header

Written from docs/trajectory-format.md alone, so it is also an example of a reader. Hashes are shown, `fagorc verify` checks them.
"""
import struct
import sys

AXES = 'XYZUVWABC'
MOVE_BODY = [('d', 'p'), ('d', 'q'), ('d', 'feed'), ('I', 'line'), ('I', 'chain'), ('I', 'state'), ('H', 'pass'), ('B', 'kind'), ('B', 'flags')]
PLAIN = [('d', 'end X'), ('d', 'end Z')] + MOVE_BODY
WIDE = [('d', f'end {a}') for a in AXES] + MOVE_BODY + [('H', 'axes that go along'), ('B', 'abscissa'), ('B', 'ordinate'), ('I', '0')]
STATE = ([('d', f'origin {a}') for a in AXES] +
         [('d', n) for n in ('speed', 'speed limit', 'nose radius', 'length X', 'length Z', 'acceleration', 'contour error', 'corner angle')] +
         [('H', 'tool'), ('H', 'offset')] +
         [('B', n) for n in ('gear', 'tip code', 'turn', 'flags', 'motion', 'plane code', 'abscissa', 'ordinate', 'distance', 'unit',
                             'X words', 'feed unit', 'speed unit', 'spindle', 'corner', 'side')] + [('I', '0')])
EVENT = [('Q', 'before move'), ('d', 'value'), ('I', 'line'), ('I', 'chain'), ('I', 'state'), ('I', 'text'), ('H', 'axes'), ('H', 'pass'),
         ('B', 'kind'), ('3s', '0')]
CHAIN = [('I', 'program'), ('I', 'caller'), ('I', 'line of the call'), ('I', '0')]
TOOL = ([('d', n) for n in ('X', 'Z', 'nose', 'wear X', 'wear Z', 'insert angle', 'insert width', 'cutting angle')] +
        [('H', n) for n in ('tool', 'offset', 'family', 'pocket')] + [('B', 'tip code'), ('7s', '0')])
INDEX = [('Q', 'offset'), ('4s', 'type'), ('I', 'count'), ('Q', 'first'), ('I', 'block'), ('I', 'flags')]
END = ([('Q', n) for n in ('offset of INDX', 'blocks', 'moves', 'events')] +
       [('I', n) for n in ('states', 'chains', 'texts', 'programs', 'flags', '0')])
BEFORE = [('d', f'before: {a}') for a in AXES]
#: by type: fields before the records, fields of a record
LAYOUT = {b'MOVE': (BEFORE, PLAIN), b'WIDE': (BEFORE, WIDE), b'STAT': ([], STATE), b'EVNT': ([], EVENT), b'CALL': ([], CHAIN),
          b'TOOL': ([], TOOL), b'INDX': ([], INDEX), b'END ': ([], END)}
HEADER = [('8s', 'magic'), ('H', 'major'), ('H', 'minor'), ('I', 'check')]
BLOCK = [('4s', 'type'), ('H', 'flags'), ('H', 'record size'), ('I', 'records'), ('I', 'payload'), ('Q', 'first record'), ('Q', 'hash')]


def shown(value):
    if isinstance(value, bytes):
        return value.decode('ascii') if value.isalpha() or value == b'END ' else ''
    return 'none' if value == 0xffffffff else f'{value:g}' if isinstance(value, float) else str(value)


class Printer:
    def __init__(self, data):
        self.data, self.quiet = data, False

    def row(self, at, size, text):
        if not self.quiet:
            print(f'{at:06x}  {self.data[at:at + size].hex(" "):<23}  {text}'.rstrip())

    def fields(self, at, fields):
        """Prints fields from `at` on; their values by name."""
        values = {}
        for code, name in fields:
            size = struct.calcsize('<' + code)
            values[name], = struct.unpack_from('<' + code, self.data, at)
            text = '' if name == 'hash' or name == 'check' else shown(values[name])
            self.row(at, size, 'zeros' if name == '0' else f'{name} {text}')
            at += size
        return values

    def text(self, at, end):
        """Bytes as text, a row of sixteen."""
        for i in range(at, end, 16):
            piece = self.data[i:min(i + 16, end)]
            self.row(i, len(piece), ''.join(chr(b) if 32 <= b < 127 else '.' for b in piece))


def block(p, at, wanted):
    """Prints the block at an offset; type of the block and the offset of the next one."""
    size = struct.unpack_from('<I', p.data, at + 12)[0]
    kind = p.data[at:at + 4]
    p.quiet = bool(wanted) and kind.decode().strip() not in wanted
    if not p.quiet:
        print()
    head = p.fields(at, BLOCK)
    place, end = at + 32, at + 32 + size
    if kind not in LAYOUT:
        p.text(place, end)
    else:
        before, record = LAYOUT[kind]
        p.fields(place, before)
        place += 8 * len(before)
        step = head['record size']
        if place + step * head['records'] != end:
            sys.exit(f'{kind}: {head["records"]} records of {step} bytes do not fill the payload')
        for i in range(head['records']):
            p.fields(place + i * step, record)
    following = end + -end % 8
    if following > end:
        p.row(end, following - end, 'padding')
    return kind, following


def main():
    with open(sys.argv[1], 'rb') as f:
        p = Printer(f.read())
    p.fields(0, HEADER)
    kind, at = b'', 16
    while kind != b'END ':
        kind, at = block(p, at, sys.argv[2:])
    if at != len(p.data):
        sys.exit('bytes after END')


if __name__ == '__main__':
    main()
