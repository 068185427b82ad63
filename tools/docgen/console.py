#!/usr/bin/env python3
"""Keep the outputs that documents show true.

    console.py --fagorc BIN [--update] DOCUMENT...

In a fenced block ```console a line `$ COMMAND` is run and the lines below it are what it prints, standard error included. The
commands of a document run one after the other in a folder of their own that shows the project's files; `fagorc` is BIN.
Without --update, a document that shows something else makes the exit code 1.
"""
import argparse
import difflib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r'(?<=^```console\n).*?(?=^```$)', re.M | re.S)


def run(command, folder, environment):
    """What a command prints, without the blanks at the ends of lines."""
    done = subprocess.run(['bash', '-c', command], cwd=folder, env=environment, stdin=subprocess.DEVNULL, timeout=60,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    text = done.stdout.decode('utf-8', 'replace')
    return ''.join(line.rstrip() + '\n' for line in text.splitlines())


def renewed(document, fagorc):
    """The text of a document with the outputs of today."""
    with tempfile.TemporaryDirectory() as folder:
        for entry in ROOT.iterdir():
            if not entry.name.startswith('.'):
                os.symlink(entry, os.path.join(folder, entry.name))
        environment = dict(os.environ, LC_ALL='C.UTF-8', NO_COLOR='1', PATH=f'{fagorc.parent}:{os.environ["PATH"]}')

        def block(match):
            commands = [line for line in match[0].splitlines() if line.startswith('$ ')]
            return ''.join(f'{line}\n{run(line[2:], folder, environment)}' for line in commands)

        return BLOCK.sub(block, document.read_text(encoding='utf-8'))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument('--fagorc', required=True, type=pathlib.Path)
    options.add_argument('--update', action='store_true')
    options.add_argument('documents', nargs='+', type=pathlib.Path)
    given = options.parse_args()
    good = True
    for document in given.documents:
        new, old = renewed(document, given.fagorc.resolve()), document.read_text(encoding='utf-8')
        if new == old:
            continue
        if given.update:
            document.write_text(new, encoding='utf-8')
            print(f'{document}: renewed')
            continue
        good = False
        sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), new.splitlines(True), str(document), 'printed today'))
    if not good:
        print('run `tools/dev docs` and read the difference')
    sys.exit(0 if good else 1)


if __name__ == '__main__':
    main()
