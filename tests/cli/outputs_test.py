#!/usr/bin/env python3
"""Outputs of the command line are whole or absent: on errors, full disks, closed pipes and signals. outputs_test.py FAGORC"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / 'examples'
LATHE = EXAMPLES / 'lathe.toml'
GOOD = '%GOOD,MX,\nN10 G1 X10 Z-5 F200\nX20\nM30\n'
# The error is found when its block is executed, after moves that fill more than one buffer.
BAD = '%BAD,MX,\n(P100=0)\nN10 (P100=P100+1)\nG1 X10 F200\nX20\n(IF P100 LT 2000 GOTO N10)\n(P101=1/(P100-2000))\nX30\nM30\n'
ENDLESS = '%ENDLESS,MX,\n(P100=0)\nN10 (P100=P100+1)\nG1 X10 Z-5 F200\nX20\n(IF P100 GE 0 GOTO N10)\nM30\n'
FAGORC = ''


class Outputs(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        self.folder = pathlib.Path(self.place.name)

    def part(self, text, name='part.pit'):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def run_it(self, *arguments, **more):
        return subprocess.run([FAGORC, *map(str, arguments)], capture_output=True, timeout=120, **more)

    def test_a_trajectory_file_prints_what_the_compilation_prints(self):
        for part in sorted(EXAMPLES.glob('*.pit')):
            file = self.folder / 'part.ftj'
            self.assertEqual(self.run_it('compile', part, '--machine', LATHE, '-o', file).returncode, 0)
            for form in (['csv'], ['csv', '--frame', 'part', '--events'], ['json'], ['iso'], ['iso', '--map', '--events']):
                with self.subTest(part=part.name, form=form):
                    direct = self.run_it('compile', part, '--machine', LATHE, '-o', '-', '--to', *form)
                    again = self.run_it('dump', file, '--to', *form)
                    self.assertEqual((direct.returncode, again.returncode), (0, 0))
                    self.assertTrue(direct.stdout)
                    self.assertEqual(again.stdout, direct.stdout)

    def test_the_map_names_labels(self):
        out = self.run_it('compile', self.part(GOOD), '--to', 'iso', '--map', '-o', '-').stdout.decode()
        self.assertIn('(line 2 N10)\n', out)
        self.assertIn('(line 3)\n', out)

    def test_an_error_leaves_standard_output_empty(self):
        for form in ('ftj', 'iso', 'csv', 'json'):
            run = self.run_it('compile', self.part(BAD), '--to', form, '-o', '-')
            self.assertEqual((run.returncode, run.stdout), (1, b''), form)
        streamed = self.run_it('compile', self.part(BAD), '--to', 'csv', '-o', '-', '--stream')
        self.assertEqual(streamed.returncode, 1)
        self.assertTrue(streamed.stdout.startswith(b'line,kind,'), 'the program does move before its error')

    def test_an_error_leaves_no_file(self):
        old = self.folder / 'part.csv'
        old.write_text('old')
        self.assertEqual(self.run_it('compile', self.part(BAD), '-o', old).returncode, 1)
        self.assertEqual(old.read_text(), 'old')
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ['part.csv', 'part.pit'])

    def test_the_program_is_not_replaced(self):
        path = self.folder / 'part.iso'
        path.write_text(GOOD)
        run = self.run_it('compile', path, '--to', 'iso')
        self.assertEqual(run.returncode, 2)
        self.assertEqual(path.read_text(), GOOD)

    def stops_at_once(self, *command):
        begin = time.monotonic()
        with subprocess.Popen([FAGORC, *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            if '--stream' in command or command[0] == 'dump':
                self.assertTrue(run.stdout.readline())
            run.stdout.close()
            message = run.stderr.read().decode()
            self.assertEqual(run.wait(timeout=120), 2)
        self.assertIn('F0903', message)
        self.assertLess(time.monotonic() - begin, 60, 'the program never ends by itself')

    def test_a_reader_that_goes_stops_the_run(self):
        part = self.part(ENDLESS)
        self.stops_at_once('compile', part, '--to', 'csv', '-o', '-')
        self.stops_at_once('compile', part, '--to', 'csv', '-o', '-', '--stream')
        self.stops_at_once('dump', part, '--stage', 'operations')

    def test_a_long_output_does_not_wait_for_the_end(self):
        with subprocess.Popen([FAGORC, 'compile', self.part(ENDLESS), '--to', 'json', '-o', '-'], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as run:
            self.assertTrue(run.stdout.readline().startswith(b'{"type":"header"'))
            run.stdout.close()
            self.assertEqual(run.wait(timeout=120), 2)

    def test_a_full_disk_stops_the_run(self):
        run = self.run_it('compile', self.part(ENDLESS), '--to', 'csv', '-o', '/dev/full')
        self.assertEqual(run.returncode, 2)
        self.assertIn(b'F0902', run.stderr)
        for command in (['compile', self.part(GOOD), '-o', '-'], ['dump', self.part(GOOD)], ['check', self.part(BAD, 'bad.pit')],
                        ['explain', 'G33'], ['manual'], ['completions', 'bash'], ['--help']):
            with open('/dev/full', 'wb') as full:
                run = subprocess.run([FAGORC, *command], stdout=full, stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(run.returncode, 2, command)
            self.assertTrue(run.stderr, command)

    def test_a_signal_leaves_no_temporary(self):
        part = self.part(ENDLESS)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            run = subprocess.Popen([FAGORC, 'compile', part, '-o', str(self.folder / 'part.csv')], stderr=subprocess.DEVNULL)
            while len(list(self.folder.iterdir())) < 2:
                self.assertIsNone(run.poll(), 'the program never ends by itself')
                time.sleep(0.01)
            time.sleep(0.1)  # the temporary exists a moment before the handler does
            run.send_signal(number)
            self.assertEqual(run.wait(timeout=60), -number)
            self.assertEqual([p.name for p in self.folder.iterdir()], ['part.pit'])


if __name__ == '__main__':
    FAGORC = os.path.abspath(sys.argv.pop(1))
    unittest.main()
