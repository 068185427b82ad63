#!/usr/bin/env python3
"""Programs of a working machine hold no syntax error: `fagorc check` may refuse a mill's codes by name, never a block's form.

    real_programs.py --fagorc BIN [--shared DIR]         Exit 77: no such programs here.
"""
import argparse
import glob
import json
import os
import subprocess
import sys

SKIPPED = 77


# What is no matter of syntax: a program without the attribute X, company rules of codes that mean something else on a mill, and words of
# the mill, which are named as such.
NOT_SYNTAX = ('F0010', 'F0113', 'F0155')


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument('--fagorc', required=True)
    a.add_argument('--shared', default=os.environ.get('FAGORC_SHARED', '../shared'))
    o = a.parse_args()
    programs = sorted(glob.glob(os.path.join(o.shared, 'real', '*', '[0-9]*.PIM')))
    if not programs:
        print(f'SKIPPED: no programs at {o.shared}/real')
        sys.exit(SKIPPED)
    wrong = []
    for program in programs:
        p = subprocess.run([o.fagorc, 'check', program, '--format', 'json', '--library', os.path.dirname(program)],
                           capture_output=True, text=True, errors='replace', timeout=120)
        if p.returncode not in (0, 1):
            wrong.append(f'{program}: exit {p.returncode}: {p.stderr.strip()[:200]}')
        for line in p.stdout.splitlines():
            finding = json.loads(line)
            if finding['code'].startswith(('F00', 'F01')) and finding['code'] not in NOT_SYNTAX and finding['severity'] == 'error':
                wrong.append(f'{program}:{finding["line"]}: {finding["code"]} {finding["message"]}')
    print(f'{len(programs)} programs, {len(wrong)} with errors of form', *wrong[:40], sep='\n')
    sys.exit(1 if wrong else 0)


if __name__ == '__main__':
    main()
