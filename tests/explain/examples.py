#!/usr/bin/env python3
"""Run the programs of the explain pages through `fagorc check`.

    examples.py FAGORC PAGES [CODE...]     PAGES: ir/diag/explain

The first program of a page must raise exactly the page's code, the others must raise nothing. A program of a page marked
`example: planned` may instead raise not_yet_supported (F0201) alone, and one of them must, so that the mark has to go when the
construct comes. Lines `;@ ` of a program are, without the mark, its machine file. Prints each page that falls short; exit 0 when
none does.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

NOT_YET_SUPPORTED = 'F0201'


def codes(fagorc, program):
    """The codes that a program raises, in their order; a list with a text where the run itself fails."""
    with tempfile.TemporaryDirectory() as folder:
        part = os.path.join(folder, 'part.pit')
        pathlib.Path(part).write_text(program, encoding='utf-8')
        command = [fagorc, 'check', part, '--format', 'json', '--control', '8055']
        machine = [line[3:] for line in program.split('\n') if line.startswith(';@ ')]
        if machine:
            name = os.path.join(folder, 'machine.toml')
            pathlib.Path(name).write_text('\n'.join(machine) + '\n', encoding='utf-8')
            command += ['--machine', name]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=60)
        except subprocess.TimeoutExpired:
            return ['no end after 60 s']
    found = [json.loads(line)['code'] for line in run.stdout.splitlines()]
    if run.returncode not in (0, 1):
        return found + [f'exit {run.returncode}: {run.stderr.strip()}']
    return found


def judge(fagorc, page):
    """What is wrong with a page, a line a program."""
    section = page.read_text(encoding='utf-8').partition('\n## examples\n')[2]
    programs = re.findall(r'```\n(.*?)```', section, re.S)
    planned = 'example: planned' in section
    wrong, waiting = [], 0
    for i, program in enumerate(programs):
        wanted = [] if i > 0 else [page.stem]
        found = codes(fagorc, program)
        if planned and found == [NOT_YET_SUPPORTED]:
            waiting += 1
        elif found != wanted:
            wrong.append(f'{page.stem} program {i + 1}: {found or "nothing"} instead of {wanted or "nothing"}')
    if planned and not waiting and not wrong:
        wrong.append(f'{page.stem}: all programs do what they should, remove the mark "example: planned"')
    return wrong


def main():
    fagorc, folder, *only = sys.argv[1:]
    pages = [p for p in sorted(pathlib.Path(folder).glob('F*.md')) if not only or p.stem in only]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [line for lines in pool.map(lambda p: judge(fagorc, p), pages) for line in lines]
    for line in wrong:
        print(line)
    print(f'{len(pages)} pages, {len(wrong)} programs fall short')
    sys.exit(1 if wrong or not pages else 0)


if __name__ == '__main__':
    main()
