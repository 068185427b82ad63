#!/usr/bin/env python3
"""Bad input and bad output, through the binary: the exit code, the message, no output file, nothing temporary left behind.

    bad_input_test.py FAGORC [Class.test...]
"""
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
import unittest

FAGORC = os.path.abspath(sys.argv.pop(1))
SOUND = 'G91 G01 F100\nX1\nM30\n'
SECONDS = 120                       # that any run may take, a build with sanitizers on a slow machine too
MEGABYTES = 512                     # peak of any run: the texts here have at most 100
FORMS = ('ftj', 'iso', 'csv', 'json')


class Run:
    """One run of fagorc: `code`, `out` and `err` as texts."""

    def __init__(self, folder, *words, stdin=None, stdout=subprocess.PIPE, environment=()):
        variables = dict(os.environ, LC_ALL='C.UTF-8', LANGUAGE='', NO_COLOR='1', **dict(environment))
        process = subprocess.Popen([FAGORC, *words], cwd=folder, env=variables, stdout=stdout, stderr=subprocess.PIPE,
                                   stdin=subprocess.PIPE if stdin is not None else subprocess.DEVNULL)
        try:
            out, err = process.communicate(stdin, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            raise
        self.code, self.out, self.err = process.returncode, (out or b'').decode('utf-8', 'replace'), err.decode('utf-8', 'replace')

    def codes(self):
        return re.findall(r'\b(?:error|warning) (F\d{4})\b', self.out + self.err)


def tearDownModule():
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024
    if peak > MEGABYTES:
        raise AssertionError(f'a run took {peak} MB, {MEGABYTES} are allowed')


class Case(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = pathlib.Path(keeper.name)

    def write(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())

    def expect(self, run, code, *findings):
        """The exit code and the codes of the findings, in their order; and the folder holds what the test wrote."""
        self.assertEqual((run.code, run.codes()), (code, list(findings)), run.err[-600:] + run.out[-600:])

    def refused(self, words, code, *findings, **more):
        """The run ends so, and leaves the folder as it was."""
        before = {p.name: p.stat().st_mtime_ns for p in self.folder.iterdir()}
        run = Run(self.folder, *words, **more)
        self.expect(run, code, *findings)
        self.assertEqual({p.name: p.stat().st_mtime_ns for p in self.folder.iterdir()}, before)
        return run


class Files(Case):
    def each_command(self, name, code, finding):
        for words in (['check', name], ['compile', name, '-o', 'x.ftj'], ['dump', name]):
            with self.subTest(words[0]):
                run = self.refused(words, code, finding)
                self.assertIn(name, run.err + run.out)

    def test_missing(self):
        self.each_command('nothing.pit', 2, 'F0001')
        self.refused(['verify', 'nothing.ftj'], 2, 'F0001')
        self.refused(['dump', 'nothing.ftj'], 2, 'F0001')

    def test_folder(self):
        (self.folder / 'folder.pit').mkdir()
        self.each_command('folder.pit', 2, 'F0002')
        self.refused(['verify', 'folder.pit'], 2, 'F0002')

    def test_unreadable(self):
        self.each_command('/proc/self/mem', 2, 'F0001')      # may be opened, not read
        if os.geteuid() != 0:                                # root reads anything
            self.write('secret.pit', SOUND)
            os.chmod(self.folder / 'secret.pit', 0)
            self.each_command('secret.pit', 2, 'F0001')

    def test_missing_companions(self):
        self.write('part.pit', SOUND)
        self.refused(['compile', 'part.pit', '-o', 'x.ftj', '--machine', 'nothing.toml'], 2, 'F0001')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj', '--library', 'nothing'], 2, 'F0003')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj', '--tables', 'nothing'], 2, 'F0003')

    def test_others_are_still_checked(self):
        self.write('part.pit', 'X1 X2\nM30\n')
        self.refused(['check', 'nothing.pit', 'part.pit', '--format', 'short'], 2, 'F0001', 'F0118')

    def test_binary(self):
        self.write('part.pit', bytes(range(256)) * 400)
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 2, 'F0004')

    def test_utf16(self):
        self.write('part.pit', SOUND.encode('utf-16'))
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 2, 'F0005')

    def test_empty(self):
        self.write('part.pit', '')
        self.assertEqual(Run(self.folder, 'check', 'part.pit').code, 0)

    def test_no_room_to_keep_a_pipe(self):
        run = Run(self.folder, 'compile', '-', '-o', 'x.ftj', stdin=b'N10 G91 G01 X1 F100\n(P1=P1+1)\n(IF P1 LT 3 GOTO N10)\nM30\n',
                  environment={'TMPDIR': str(self.folder / 'nothing')})
        self.assertEqual((run.code, run.codes(), list(self.folder.iterdir())), (2, ['F0011'], []), run.err)


class Outputs(Case):
    def setUp(self):
        super().setUp()
        self.write('part.pit', SOUND)

    def test_full_disk(self):
        for form in FORMS:
            with self.subTest(form), open('/dev/full', 'wb') as full:
                self.refused(['compile', 'part.pit', '--to', form, '-o', '/dev/full'], 2, 'F0902')
                self.refused(['compile', 'part.pit', '--to', form, '-o', '-'], 2, 'F0902', stdout=full)

    def test_closed_pipe(self):
        self.write('long.pit', 'G91 G01 F100\n' + 'X1\nX-1\n' * 50000 + 'M30\n')
        for form in FORMS:
            with self.subTest(form):
                read, write = os.pipe()
                os.close(read)
                try:
                    self.refused(['compile', 'long.pit', '--to', form, '-o', '-'], 2, 'F0903', stdout=write)
                finally:
                    os.close(write)

    def test_a_reader_that_has_seen_enough(self):
        self.write('long.pit', 'G91 G01 F100\n' + 'X1\nX-1\n' * 50000 + 'M30\n')
        with subprocess.Popen([FAGORC, 'compile', 'long.pit', '--to', 'csv', '-o', '-'], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            self.assertTrue(process.stdout.readline().startswith(b'line,kind,'))
            process.stdout.close()
            message = process.stderr.read()
            self.assertEqual(process.wait(SECONDS), 2)
        self.assertIn(b'F0903', message)

    def test_missing_folder(self):
        run = self.refused(['compile', 'part.pit', '-o', 'nothing/x.ftj'], 2, 'F0901')
        self.assertIn('nothing/x.ftj', run.err)

    def test_folder_as_output(self):
        (self.folder / 'x.ftj').mkdir()
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 2, 'F0901')

    def test_an_error_leaves_the_output_of_before(self):
        self.assertEqual(Run(self.folder, 'compile', 'part.pit', '-o', 'x.ftj').code, 0)
        self.write('part.pit', 'G91 G01 F100\nX1\nX2 X3\nM30\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 1, 'F0118')
        self.write('part.pit', 'G01 F100\n(P1=APOSX)\nXP1\nM30\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 1, 'F0322')

    def test_a_suffix_that_says_nothing(self):
        run = self.refused(['compile', 'part.pit', '-o', 'x.docx'], 2)
        self.assertIn('x.docx', run.err)

    def test_damaged_trajectory(self):
        self.assertEqual(Run(self.folder, 'compile', 'part.pit', '-o', 'x.ftj').code, 0)
        whole = (self.folder / 'x.ftj').read_bytes()
        self.assertEqual(Run(self.folder, 'verify', 'x.ftj').code, 0)
        for damaged, finding in ((whole[:-1], 'F0913'), (b'G' + whole[1:], 'F0910'),
                                 (whole[:100] + bytes([whole[100] ^ 1]) + whole[101:], 'F0912')):
            self.write('y.ftj', damaged)
            self.refused(['verify', 'y.ftj'], 1, finding)
            self.refused(['dump', 'y.ftj', '--to', 'csv'], 1, finding)


class Sizes(Case):
    def test_more_errors_than_are_shown(self):
        self.write('part.pit', 'X1 X2\n' * 1000 + 'M30\n')
        few = Run(self.folder, 'check', 'part.pit', '--format', 'short', '--max-errors', '3')
        self.assertEqual(few.out.splitlines()[3:], ['fagorc: 997 not shown'])
        self.assertEqual(few.code, 1)
        people = Run(self.folder, 'check', 'part.pit')
        self.assertEqual(len(people.codes()), 200)
        self.assertEqual(people.out.splitlines()[-1], '1000 errors, 800 not shown')

    def test_a_block_over_64_kib(self):
        limit = 65536
        comment = lambda size: 'X1 ;' + '.' * (size - 4)
        self.write('part.pit', f'G91 G01 F100\n{comment(limit)}\nM30\n')
        self.assertEqual(Run(self.folder, 'check', 'part.pit').code, 0)
        self.write('part.pit', f'G91 G01 F100\n{comment(limit + 1)}\nX1 X2\nM30\n')
        run = self.refused(['check', 'part.pit', '--format', 'short'], 1, 'F0006', 'F0118')
        self.assertIn('part.pit:2:1: error F0006: the block is longer than 65536 bytes\npart.pit:3:4: ', run.out)

    def test_a_line_of_100_mb(self):
        with open(self.folder / 'part.pit', 'wb') as f:
            f.write(b'G91 G01 F100\n')
            for _ in range(100):
                f.write(b'X1 Z-2.5 ' * (1000000 // 9))
            f.write(b'\nX1 X2\nM30\n')
        self.refused(['check', 'part.pit', '--format', 'short'], 1, 'F0006', 'F0118')

    def test_a_line_of_20_mb_through_a_pipe(self):
        text = b'G91 G01 F100\n' + b'X1 Z-2.5 ' * (20000000 // 9) + b'\nX1 X2\nM30\n'
        run = Run(self.folder, 'check', '-', '--format', 'short', stdin=text)
        self.expect(run, 1, 'F0006', 'F0118')

    def test_a_block_of_too_many_words(self):
        self.write('part.pit', 'G91 G01 F100\n(P1=1' + '+1' * 30000 + ')\nX1 X2\nM30\n')
        self.refused(['check', 'part.pit', '--format', 'short'], 1, 'F0151', 'F0118')

    def test_parentheses_without_end(self):
        self.write('part.pit', 'G91 G01 F100\n(P1=' + '(' * 30000 + '\n(P1=' + '-' * 30000 + '1)\nM30\n')
        run = Run(self.folder, 'check', 'part.pit', '--format', 'short')
        self.assertEqual(run.code, 1, run.err)

    def test_more_than_100_local_subroutines(self):
        for count, findings in ((100, []), (101, ['F0424']), (102, ['F0424'])):
            subroutines = ''.join(f'(LSUB {n})\nX1\n(RET)\n' for n in range(count))
            self.write('part.pit', f'{subroutines}%\nG91 G01 F100\n(LL 99)\nM30\n')
            run = self.refused(['check', 'part.pit', '--format', 'short'], 1 if findings else 0, *findings)
            if findings:
                self.assertIn('part.pit:301:', run.out)

    def test_a_million_labels(self):
        with open(self.folder / 'part.pit', 'w') as f:
            f.write('G91 G01 F100\n(GOTO N1000000)\n')
            f.writelines(f'N{i} X1\n' for i in range(1, 1000001))
            f.write('M30\n')
        run = Run(self.folder, 'compile', 'part.pit', '--to', 'csv', '-o', '-')
        self.expect(run, 0)
        self.assertEqual(run.out.splitlines()[1:], ['1000002,line,0.500000,0.000000,,,100.000000,mm/min,,'])


class Endless(Case):
    def test_a_loop_that_moves(self):
        self.write('part.pit', 'G91 G01 F100\nN10 X1\n(GOTO N10)\nM30\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 1, 'F0443')

    def test_a_loop_that_counts_and_moves(self):
        self.write('part.pit', 'G91 G01 F100\nN10 X1\n(P100=P100+1)\n(GOTO N10)\nM30\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj', '--max-blocks', '100000'], 1, 'F0427')

    def test_a_loop_that_only_counts(self):
        self.write('part.pit', 'N10 (P100=P100+1)\n(GOTO N10)\nM30\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj', '--max-blocks', '100000'], 1, 'F0427')

    def test_recursion(self):
        self.write('part.pit', 'G91 G01 F100\n(CALL 1)\nM30\n(SUB 1)\nX1\n(CALL 1)\n(RET)\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj'], 1, 'F0409')

    def test_a_section_that_repeats_itself(self):
        self.write('part.pit', 'G91 G01 F100\nN10 X1\nN20 (RPT N10, N20)\nM30\n')
        run = Run(self.folder, 'compile', 'part.pit', '-o', 'x.ftj')
        self.assertEqual((run.code, len(run.codes())), (1, 1), run.err)

    def test_a_program_that_writes_itself_for_ever(self):
        self.write('part.pit', '(OPEN P150)\nN10 (WRITE X1)\n(P100=P100+1)\n(GOTO N10)\nM30\n')
        self.refused(['compile', 'part.pit', '-o', 'x.ftj', '--max-blocks', '100000'], 1, 'F0427')


if __name__ == '__main__':
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    unittest.main()
