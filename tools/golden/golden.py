#!/usr/bin/env python3
"""Run golden files: texts that hold a program, its machine and what fagorc must say about it (tests/golden/README.md).

    golden.py [--fagorc BIN] [--update] [--with OPTION]... FILE...
"""
import argparse
import difflib
import os
import re
import shlex
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field

MARK = '=== '
FORMS = ('ftj', 'iso', 'csv', 'json')          # `expect csv` is short for `expect compile --to csv -o -`
TIMEOUT = 60                                   # seconds a run may take


class Malformed(Exception):
    """The golden file itself is wrong."""


@dataclass
class Section:
    words: list                                # what stands after the mark
    line: int                                  # of the mark, from 1
    body: str = ''


@dataclass
class Run:
    """One `expect` section with the `stderr` and `exit` sections that follow it."""
    command: list
    sections: dict = field(default_factory=dict)     # 'stdout' | 'stderr' | 'exit' -> Section


def parse(text):
    """(head comment, sections) of a golden file."""
    head, sections = [], []
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        if line.startswith(MARK):
            words = shlex.split(line[len(MARK):])
            if not words:
                raise Malformed(f'line {number}: a section needs a name')
            sections.append(Section(words, number))
        elif sections:
            sections[-1].body += line
        else:
            head.append(line)
    return ''.join(head), sections


def unescape(text):
    r"""Bytes of an `escaped` body: \xA0 \r \n \t \\, and a backslash at the end of a line joins it to the next."""
    simple = {'n': b'\n', 'r': b'\r', 't': b'\t', '0': b'\0', '\\': b'\\', '\n': b''}
    out, at = b'', 0
    for m in re.finditer(r'\\(x[0-9A-Fa-f]{2}|[^x])', text, re.S):
        if m[1][0] != 'x' and m[1] not in simple:
            raise Malformed(f'unknown escape \\{m[1]}')
        out += text[at:m.start()].encode() + (bytes([int(m[1][1:], 16)]) if m[1][0] == 'x' else simple[m[1]])
        at = m.end()
    return out + text[at:].encode()


def shown(output):
    r"""Output as a body: bytes that are no UTF-8 as \xNN, a missing last line end as a backslash."""
    text = output.decode('utf-8', 'backslashreplace').replace('\r', '\\r')
    return text if text.endswith('\n') or not text else text + '\\\n'


class Golden:
    """One golden file: writes its inputs into a folder and runs its expectations there."""

    def __init__(self, text, fagorc, extra):
        self.head, self.sections = parse(text)
        self.fagorc, self.extra = fagorc, extra
        self.options, self.files, self.main, self.runs = [], {}, None, []
        for s in self.sections:
            self.take(s)
        if not self.runs:
            raise Malformed('nothing is expected')

    def take(self, s):
        kind, *words = s.words
        if kind == 'options':
            self.options += words
        elif kind in ('input', 'machine', 'library', 'table'):
            self.take_file(s, kind, words)
        elif kind == 'expect' and words and words[0] != 'stderr':
            self.runs.append(Run(self.command(words), {'stdout': s}))
        elif kind in ('expect', 'exit') and words and self.runs:
            self.runs[-1].sections['exit' if kind == 'exit' else 'stderr'] = s
        else:
            raise Malformed(f'line {s.line}: no section `{" ".join(s.words)}` can stand here')

    def take_file(self, s, kind, words):
        if not words or words[1:] not in ([], ['escaped']):
            raise Malformed(f'line {s.line}: `{kind} NAME [escaped]` is expected')
        folder = {'library': 'library', 'table': 'tables'}.get(kind, '')
        if folder and f'--{folder}' not in self.options:
            self.options += [f'--{folder}', folder]
        if kind == 'machine':
            self.options += ['--machine', words[0]]
        if kind == 'input' and self.main is None:
            self.main = words[0]
        self.files[os.path.join(folder, words[0])] = unescape(s.body) if words[1:] else s.body.encode()

    def command(self, words):
        if words[0] in FORMS:
            words = ['compile', '--to', words[0], '-o', '-'] + words[1:]
        subject = [self.main] if self.main else []
        return [words[0]] + subject + words[1:]

    def run(self, run, folder):
        """What the run's sections should hold."""
        environment = dict(os.environ, LC_ALL='C.UTF-8', LANG='C.UTF-8', LANGUAGE='', NO_COLOR='1')
        command = [self.fagorc] + run.command + self.options + self.extra
        p = subprocess.run(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=TIMEOUT)
        return {'stdout': shown(p.stdout), 'stderr': shown(p.stderr), 'exit': str(p.returncode)}

    def differences(self, update):
        """Lines that say how the runs differ from the file; with `update` the sections take what was seen."""
        out = []
        with tempfile.TemporaryDirectory() as folder:
            for name, content in self.files.items():
                path = os.path.join(folder, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, 'wb') as f:
                    f.write(content)
            for run in self.runs:
                out += self.compare(run, self.run(run, folder), update)
        return out

    def compare(self, run, seen, update):
        title = 'fagorc ' + ' '.join(run.command + self.options + self.extra)
        wanted = {kind: s.words[1] if kind == 'exit' else s.body for kind, s in run.sections.items()}
        wanted.setdefault('exit', '0')
        out = []
        for kind, want in wanted.items():
            if want != seen[kind]:
                out += [f'{title}: {kind}'] + list(difflib.unified_diff(
                    want.splitlines(), seen[kind].splitlines(), 'expected', 'seen', lineterm='', n=2))
        if wanted['exit'] != seen['exit'] and seen['stderr']:
            out += ['standard error:', seen['stderr']]
        if update:
            self.update(run, seen)
        return out

    def update(self, run, seen):
        code = run.sections.pop('exit', None)
        if code:
            self.sections.remove(code)
        for kind, s in run.sections.items():
            s.body = seen[kind]
        if seen['exit'] != '0':                   # 0 is what a run without the section must end with
            run.sections['exit'] = Section(['exit', seen['exit']], 0)
            last = max(self.sections.index(s) for s in run.sections.values() if s in self.sections)
            self.sections.insert(last + 1, run.sections['exit'])

    def text(self):
        return self.head + ''.join(MARK + shlex.join(s.words) + '\n' + s.body for s in self.sections)


def check(name, arguments):
    """Whether the file holds; says on standard output how not."""
    with open(name, encoding='utf-8', newline='\n') as f:
        text = f.read()
    try:
        golden = Golden(text, arguments.fagorc, arguments.extra)
        differences = golden.differences(arguments.update)
    except (Malformed, ValueError) as error:
        print(f'{name}: {error}')
        return False
    except subprocess.TimeoutExpired:
        print(f'{name}: no end after {TIMEOUT} s')
        return False
    if differences and arguments.update:
        with open(name, 'w', encoding='utf-8', newline='\n') as f:
            f.write(golden.text())
        print(f'{name}: updated')
        return True
    if differences:
        print(f'{name}: differs', *differences, sep='\n')
    return not differences


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument('files', nargs='+', metavar='FILE')
    a.add_argument('--fagorc', default=os.environ.get('FAGORC', 'fagorc'))
    a.add_argument('--update', action='store_true', help='write what was seen into the files; read the diff before you commit')
    a.add_argument('--with', dest='extra', action='append', default=[], metavar='OPTION',
                   help='one more option for every run: the same must come out (--with=--no-shape-cache)')
    arguments = a.parse_args()
    if arguments.update and (os.environ.get('CI') or arguments.extra):
        a.error('--update is for a person at a desk: not where CI is set, not together with --with')
    arguments.fagorc = os.path.abspath(arguments.fagorc) if os.sep in arguments.fagorc else arguments.fagorc
    good = [check(name, arguments) for name in arguments.files]
    if len(good) > 1:
        print(f'{sum(good)} of {len(good)} golden files hold')
    sys.exit(0 if all(good) else 1)


if __name__ == '__main__':
    main()
