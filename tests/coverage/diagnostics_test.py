#!/usr/bin/env python3
"""Each diagnostic that something reports is seen by a test.

    diagnostics_test.py PROJECT

Seen: the explain page has a program, which raises it (tests/explain); or a golden file expects its code; or a test names it, by
code or by name. A row that no source reports yet (constructs to come) has nothing to be seen.
"""
import pathlib
import re
import sys


def texts(folder, *patterns):
    return [p.read_text(encoding='utf-8', errors='replace') for pattern in patterns for p in sorted(folder.rglob(pattern))]


def main():
    project = pathlib.Path(sys.argv[1])
    rows = re.findall(r'^DIAG\((F\d{4}), \w+, (\w+),', (project / 'ir/diag/diagnostics.def').read_text(encoding='utf-8'), re.M)
    sources = '\n'.join(t for layer in ('ir', 'frontend', 'passes', 'backends', 'runtime', 'tools') for t in texts(project / layer, '*.?pp'))
    reported = set(re.findall(r'\bId::(\w+)', sources))
    goldens = ''.join(t.partition('\n=== ')[2] for t in texts(project / 'tests/golden', '*.golden'))
    tests = '\n'.join(t for t in texts(project / 'tests', '*.?pp', '*.py'))
    named = set(re.findall(r'\w+', goldens + tests))
    unseen = []
    for code, name in rows:
        page = project / 'ir/diag/explain' / f'{code}.md'
        has_program = '\n```\n' in page.read_text(encoding='utf-8')
        if name in reported and not has_program and code not in named and name not in named:
            unseen.append(f'{code} {name}: no explain page has a program for it, no golden file expects it, no test names it')
    for line in unseen:
        print(line)
    print(f'{len(rows)} diagnostics, {len(unseen)} unseen')
    sys.exit(1 if unseen or not rows or not reported else 0)


if __name__ == '__main__':
    main()
