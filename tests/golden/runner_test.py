#!/usr/bin/env python3
"""The golden runner itself: it sees a difference, and it updates only where it may."""
import os
import subprocess
import sys
import tempfile
import unittest

RUNNER = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'tools', 'golden', 'golden.py')
# Stands for fagorc: prints its arguments and the bytes of the input, complains, and ends with 3 when it may say no.
STAND_IN = '#!/bin/sh\necho "$@"\nod -An -tx1 "$2"\necho careful >&2\n[ "$1" = check ] && exit 3\nexit 0\n'
GOOD = r'''# A file that holds.
=== options --lang fr
=== machine m.toml
=== library 000100.PIT
=== input part.pit escaped
G1\xA0\r\
X
=== expect csv
compile part.pit --to csv -o - --lang fr --machine m.toml --library library
 47 31 a0 0d 58 0a
=== expect check --format short
check part.pit --format short --lang fr --machine m.toml --library library
 47 31 a0 0d 58 0a
=== expect stderr
careful
=== exit 3
'''


class Runner(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.fagorc = os.path.join(self.folder.name, 'fagorc')
        with open(self.fagorc, 'w') as f:
            f.write(STAND_IN)
        os.chmod(self.fagorc, 0o755)

    def run_on(self, text, *options, ci=False):
        """(exit code, standard output, the file afterwards)."""
        name = os.path.join(self.folder.name, 'a.golden')
        with open(name, 'w') as f:
            f.write(text)
        environment = {k: v for k, v in os.environ.items() if k != 'CI'} | ({'CI': 'true'} if ci else {})
        p = subprocess.run([sys.executable, RUNNER, '--fagorc', self.fagorc, *options, name], capture_output=True, text=True,
                           env=environment)
        with open(name) as f:
            return p.returncode, p.stdout, f.read()

    def test_holds(self):
        self.assertEqual(self.run_on(GOOD), (0, '', GOOD))

    def test_sees_each_difference(self):
        for old, new in ((' 58 0a', ' 59 0a'), ('careful', 'careless'), ('=== exit 3', '=== exit 1'), ('=== exit 3\n', '')):
            code, said, after = self.run_on(GOOD.replace(old, new))
            self.assertEqual(code, 1, new)
            self.assertIn('differs', said)
            self.assertEqual(after, GOOD.replace(old, new), 'nothing is written without --update')

    def test_update_writes_what_was_seen(self):
        for wrong in (GOOD.replace('careful', 'careless').replace(' 58 0a', ''), GOOD.replace('=== exit 3\n', '')):
            self.assertEqual(self.run_on(wrong, '--update')[2], GOOD)

    def test_update_is_refused_in_ci_and_with_other_options(self):
        wrong = GOOD.replace('careful', 'careless')
        self.assertEqual(self.run_on(wrong, '--update', ci=True), (2, '', wrong))
        self.assertEqual(self.run_on(wrong, '--update', '--with=--no-shape-cache')[0], 2)

    def test_option_for_every_run(self):
        code, said, _ = self.run_on(GOOD, '--with=--no-shape-cache')
        self.assertEqual(code, 1)      # the stand-in prints the option
        self.assertIn('library --no-shape-cache', said)

    def test_malformed_files_are_named(self):
        for text in ('nothing', '=== input p\n=== what\n', '=== exit 1\n', '=== input p escaped\n\\q\n=== expect csv\n'):
            code, said, _ = self.run_on(text)
            self.assertEqual(code, 1)
            self.assertIn('a.golden: ', said)
            self.assertNotIn('Traceback', said)


if __name__ == '__main__':
    unittest.main()
