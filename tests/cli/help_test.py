#!/usr/bin/env python3
"""Help, completions and manual page speak of the same commands and options; colours are for terminals. help_test.py FAGORC"""
import os
import pty
import re
import subprocess
import sys
import tempfile
import unittest

FAGORC = ''


def output(*words):
    return subprocess.run([FAGORC, *words], check=True, capture_output=True, text=True, timeout=60).stdout


def on_terminal(*words, **environment):
    """What a command prints where standard output and standard error are a terminal."""
    try:
        terminal, other = pty.openpty()
    except OSError as error:  # a container without pseudo-terminals
        raise unittest.SkipTest(str(error)) from error
    variables = {k: v for k, v in os.environ.items() if k != 'NO_COLOR'}
    with subprocess.Popen([FAGORC, *words], stdout=other, stderr=other, stdin=subprocess.DEVNULL, env={**variables, **environment}):
        os.close(other)
        text = b''
        try:
            while piece := os.read(terminal, 4096):
                text += piece
        except OSError:  # how Linux tells that the other side is closed
            pass
    os.close(terminal)
    return text


class Help(unittest.TestCase):
    def setUp(self):
        listed = output('--help').partition('Subcommands:\n')[2].partition('\n\n')[0]
        self.commands = re.findall(r'^  (\w+) ', listed, re.M)
        self.assertIn('compile', self.commands)

    def test_every_command_has_examples_that_name_it(self):
        for command in self.commands:
            self.assertRegex(output(command, '--help'), rf'(?s)Examples:\n.*fagorc {command}\b')

    def test_completions_and_manual_know_every_option(self):
        manual = output('manual').replace('\\-', '-')
        shells = {shell: output('completions', shell) for shell in ('bash', 'zsh', 'fish')}
        for command in self.commands:
            self.assertIn(f'.SS fagorc {command}', manual)
            for option in re.findall(r'^  (?:-\w,)?--([\w-]+)', output(command, '--help'), re.M):
                self.assertIn(f'--{option}', manual)
                for shell, text in shells.items():
                    self.assertIn(f'-l {option}' if shell == 'fish' else f'--{option}', text)

    def test_version(self):
        self.assertRegex(output('--version'), r'^fagorc \d+\.\d+\.\d+\n$')

    def test_colours_are_for_terminals_and_no_color_is_heard(self):
        with tempfile.TemporaryDirectory() as folder:
            part = os.path.join(folder, 'part.pit')
            with open(part, 'w', encoding='ascii') as f:
                f.write('G94 G95 X1\nM30\n')
            self.assertIn(b'\x1b[', on_terminal('check', part))
            self.assertNotIn(b'\x1b[', on_terminal('check', part, NO_COLOR='1'))
            piped = subprocess.run([FAGORC, 'check', part], capture_output=True, timeout=60)
            self.assertEqual(piped.returncode, 1)
            self.assertNotIn(b'\x1b[', piped.stdout)


if __name__ == '__main__':
    FAGORC = os.path.abspath(sys.argv.pop(1))
    unittest.main()
