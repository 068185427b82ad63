#!/usr/bin/env python3
"""Run a judge of the specification and compare what falls short with the list of what is known to.

    judge.py TOOL SET LIST --fagorc BIN [--shared DIR] [--update]

TOOL: `sweep` (moves of the examples) or `tsv_sweep` (snippets of the tables). LIST names what falls short now, one a line. A name that is
not in the list is a step back; a name in the list that passes must leave it: so the list only gets shorter. Exit 77: no specification here.
"""
import argparse
import collections
import os
import re
import subprocess
import sys

SKIPPED = 77


def short_of(tool, text):
    """name -> what was seen, with a count for names that occur twice, of the judge's lines."""
    pattern = r'(\S+ \[.*?\]): (.*)' if tool == 'sweep' else r'(\S+) \| (.*)'
    seen, count = {}, collections.Counter()
    for line in text.splitlines():
        m = re.fullmatch(pattern, line)
        if m:
            count[m[1]] += 1
            seen[m[1] if count[m[1]] == 1 else f'{m[1]} #{count[m[1]]}'] = m[2]
    return seen


def read_list(name):
    """(comment lines, names)."""
    with open(name, encoding='utf-8') as f:
        lines = f.read().splitlines()
    return [l for l in lines if l.startswith('#')], [l for l in lines if l and not l.startswith('#')]


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument('tool', choices=('sweep', 'tsv_sweep'))
    a.add_argument('set')
    a.add_argument('list')
    a.add_argument('--fagorc', required=True)
    a.add_argument('--shared', default=os.environ.get('FAGORC_SHARED', '../shared'))
    a.add_argument('--update', action='store_true', help='write the list anew')
    o = a.parse_args()
    judge = os.path.join(o.shared, 'tools', o.tool + '.py')
    if not os.path.exists(judge):
        print(f'SKIPPED: no specification at {o.shared}')
        sys.exit(SKIPPED)
    p = subprocess.run([sys.executable, judge, o.set, '--fagorc', os.path.abspath(o.fagorc), '-v'], capture_output=True, text=True)
    summary = p.stdout.strip().splitlines()[-1:]
    if not summary or not re.match(re.escape(o.set) + r': \d+/\d+ ', summary[0]):
        sys.exit(f'the judge did not end well:\n{p.stdout}{p.stderr}')
    print(summary[0])
    seen = short_of(o.tool, p.stdout)
    comments, known = read_list(o.list)
    if o.update and not os.environ.get('CI'):
        with open(o.list, 'w', encoding='utf-8', newline='\n') as f:
            f.write('\n'.join(comments + sorted(seen)) + '\n')
        return
    worse = [f'{name}: {why}' for name, why in seen.items() if name not in known]
    better = [name for name in known if name not in seen]
    if worse:
        print(f'{len(worse)} that passed before fall short now:', *worse, sep='\n  ')
    if better:
        print(f'{len(better)} pass now; take them out of {o.list}:', *better, sep='\n  ')
    sys.exit(1 if worse or better else 0)


if __name__ == '__main__':
    main()
