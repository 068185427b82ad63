#!/usr/bin/env python3
"""How much memory a long program takes: one from a pipe a constant, a loaded one its text and 8 bytes a label.

    memory_test.py FAGORC [BLOCKS]

Each bound is on what a long program takes beyond a short one, so it holds for every build and machine. The figures are printed.
"""
import os
import subprocess
import sys
import tempfile
import threading
import time

SHORT = 1_000
MIB = 1 << 20


def blocks(count):
    """A tenth of a mebibyte at a time, each block with a label."""
    for first in range(0, count, 3000):
        yield ''.join(f'N{i} G1 X{20 + i % 997 * 0.0101:.4f} Z-{i % 991 * 0.1007:.4f} F{100 + i % 7}\n'
                      for i in range(first, min(first + 3000, count))).encode()


def peak(command, feed=None):
    """Peak resident memory in bytes of a command that succeeds; `feed` yields what it reads from its standard input."""
    process = subprocess.Popen(command, stdin=subprocess.PIPE if feed else subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    if feed:
        def write():
            with process.stdin as pipe:
                for part in feed:
                    pipe.write(part)
        threading.Thread(target=write).start()
    # Not ru_maxrss of a child: that counts the interpreter it was forked from. The peak of a program that reads on and on
    # grows until its end, so the last look before that is near enough.
    most = 0
    while process.poll() is None:
        with open(f'/proc/{process.pid}/status') as status:
            most = max([most] + [int(line.split()[1]) * 1024 for line in status if line.startswith('VmHWM')])
        time.sleep(0.001)
    if process.returncode != 0:
        sys.exit(f'{command} ended with {process.returncode}')
    return most


def more_than_short(measure, count):
    return measure(count) - measure(SHORT)


def main():
    fagorc, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 300_000
    failures = []

    def demand(what, got, most):
        print(f'{what}: {got / MIB:.1f} MiB more than a short program, at most {most / MIB:.1f} MiB')
        if got > most:
            failures.append(what)

    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, 'out.ftj')

        def piped(n):
            def feed():
                yield from blocks(n)
                yield b'M30\n'
            return peak([fagorc, 'compile', '-', '--quiet', '-o', out], feed())

        def loaded(last):
            def measure(n):
                part = os.path.join(folder, 'part.pit')
                with open(part, 'wb') as f:
                    for text in blocks(n):
                        f.write(text)
                    f.write(last(n))
                size[n] = os.path.getsize(part)
                return peak([fagorc, 'compile', part, '--quiet', '-o', out])
            return measure

        size = {}
        # 16 MiB: what the pages behind the reader may keep until they are given back, and the file that is written.
        demand('a pipe that nothing jumps back in', more_than_short(piped, count), 16 * MIB)
        plain = more_than_short(loaded(lambda n: b'M30\n'), count)
        demand('a loaded program', plain, size[count] + 8 * MIB)
        # (GOTO N999999) behind the blocks goes to the block before M30, past all labels.
        labelled = more_than_short(loaded(lambda n: b'(GOTO N99999999)\nN99999999 M30\n'), count)
        demand('a loaded program whose labels are all looked through', labelled, size[count] + 8 * count + 8 * MIB)
    sys.exit(f'too much: {failures}' if failures else 0)


if __name__ == '__main__':
    main()
