#!/usr/bin/env python3
"""The rules of the house that no compiler checks: who includes whom, who names a control, how long files may be.

    arch_test.py ROOT        ROOT: the project's folder
"""
import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 and os.path.isdir(sys.argv[1]) else os.getcwd()
CODE = ('.hpp', '.cpp')

# Layer -> layers whose headers it may include besides its own (docs/adr). The longest prefix of a path is its layer.
ALLOWED = {
    'ir': (),
    'frontend': ('ir',),
    'passes': ('ir',),
    'backends': ('ir',),
    'runtime/player': (),
    'runtime/preprocessor': ('ir', 'frontend', 'passes'),
    'tools': ('ir', 'frontend', 'passes', 'backends', 'runtime'),
    'tests': ('ir', 'frontend', 'passes', 'backends', 'runtime', 'tools'),
}

# Headers that cost seconds, and where alone they may be included: (pattern, files that may).
FENCED = (
    (r'antlr4-runtime|Fagor\w+\.h', r'frontend/antlr/'),
    (r'nlohmann/|toml\+\+/|fmt/|CLI/|xxhash|gtest/|benchmark/', r'tests/|.*\.cpp$'),
)

# Shared code knows no control by name. Paths whose content is by control, with the reason.
SHARED = ('ir/', 'passes/', 'backends/', 'runtime/')
NAMED = {
    'ir/diag/catalogue.cpp': 'the catalogue has a column of alarm numbers for each control',
}

LINES = {'.hpp': 150, '.cpp': 400, '.py': 400}


def files(*endings):
    """The project's own files, as git knows them, committed or not."""
    listed = subprocess.run(['git', '-C', ROOT, 'ls-files', '-co', '--exclude-standard'], capture_output=True, text=True, check=True)
    return [f for f in listed.stdout.splitlines() if f.endswith(endings) and os.path.isfile(os.path.join(ROOT, f))]


def lines(name):
    with open(os.path.join(ROOT, name), encoding='utf-8', errors='replace') as f:
        return f.read().split('\n')


def layer(path):
    return max((l for l in ALLOWED if path.startswith(l + '/')), key=len, default=None)


def includes():
    """(file, line, header) of every include."""
    for name in files(*CODE):
        for number, line in enumerate(lines(name), 1):
            m = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
            if m:
                yield name, number, m[1]


def code_of(name):
    """(line number, text) without comments: those may cite a manual."""
    inside = False
    for number, line in enumerate(lines(name), 1):
        if inside:
            inside = '*/' not in line
            continue
        line = re.sub(r'/\*.*?\*/', '', line)
        inside = '/*' in line
        yield number, re.split(r'//|/\*', line)[0]


class Architecture(unittest.TestCase):
    def none(self, found, rule):
        self.assertFalse(found, rule + '\n  ' + '\n  '.join(found))

    def test_layers_include_only_what_lies_below(self):
        found = []
        for name, number, header in includes():
            own, other = layer(name), layer(header)
            if own and other and other != own and not any(other == a or other.startswith(a + '/') for a in ALLOWED[own]):
                found.append(f'{name}:{number}: {own} includes {header}')
        self.none(found, 'the layers are one-way')

    def test_includes_are_written_from_the_root(self):
        found = []
        for name, number, header in includes():
            beside = os.path.join(os.path.dirname(name), header)
            if header.startswith('.') or (not layer(header) and os.path.isfile(os.path.join(ROOT, beside))):
                found.append(f'{name}:{number}: {header}')
        self.none(found, 'an include names the file from the root')

    def test_heavy_headers_stay_behind_their_fence(self):
        found = [f'{name}:{number}: {header}' for name, number, header in includes() for pattern, may in FENCED
                 if re.match(pattern, header) and not re.match(may, name)]
        self.none(found, 'the parser generator stays in frontend/antlr, heavy headers in .cpp files')

    def test_shared_code_names_no_control(self):
        found = [f'{name}:{number}: {text.strip()}' for name in files(*CODE) if name.startswith(SHARED) and name not in NAMED
                 for number, text in code_of(name) if re.search(r'\b(8055|8025|8037|1060|[Ff]agor80\d\d|[Nn]um ?1060)\b', text)]
        self.none(found, 'differences between controls are rows of their tables or policies')

    def test_sources_include_their_own_header_first(self):
        first = {}
        for name, number, header in includes():
            first.setdefault(name, (number, header))
        found = [f'{name}:{number}: {header}' for name, (number, header) in first.items()
                 if name.endswith('.cpp') and os.path.isfile(os.path.join(ROOT, name[:-4] + '.hpp')) and header != name[:-4] + '.hpp']
        self.none(found, 'so that each header is compiled alone somewhere')

    def test_generated_code_is_not_committed(self):
        self.none([f for f in files('.cpp', '.hpp', '.h') if re.search(r'(Parser|Lexer|BaseVisitor|Listener)\.(cpp|h|hpp)$', f)],
                  'the parsers are generated at build time')

    def test_files_are_short(self):
        found = []
        for name in files(*LINES):
            count, most = len(lines(name)) - 1, LINES[os.path.splitext(name)[1]]
            if count > most:
                found.append(f'{name}: {count} lines, {most} at most')
        self.none(found, 'a file that is longer does more than one thing')

    def test_nothing_points_outside_the_project(self):
        # Where this checkout lies, and where people keep theirs.
        elsewhere = re.escape(os.path.abspath(ROOT)) + r'/|/(home|root|Users)/\w'
        found = []
        for name in files('.hpp', '.cpp', '.def', '.py', '.md', '.txt', '.cmake', '.toml', '.g4', '.tsv', '.golden', 'dev', 'run'):
            if name == 'tests/arch/arch_test.py':
                continue
            found += [f'{name}:{number}: {line.strip()[:100]}' for number, line in enumerate(lines(name), 1)
                      if re.search(elsewhere + r'|\b(TODO|FIXME|XXX)\b', line)]
        self.none(found, 'no path of somebody\'s machine, no work left for later')

    def test_files_begin_by_saying_what_they_are(self):
        found = []
        for name in files(*CODE):
            first = lines(name)[0]
            header = name[:-4] + '.hpp'
            with_header = name.endswith('.cpp') and os.path.isfile(os.path.join(ROOT, header))
            if not first.startswith('// ') and not (with_header and first == f'#include "{header}"'):
                found.append(f'{name}: {first[:60]}')
        self.none(found, 'the first line says what the file is for, or includes the header that does')


if __name__ == '__main__':
    unittest.main()
