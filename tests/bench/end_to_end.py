#!/usr/bin/env python3
"""Whole-process speed of `fagorc compile` beside LinuxCNC's `rs274 -g` and the tokenise-only floor.

  tests/bench/end_to_end.py [--bin build/release/bin] [--runs 5] [--small] [--only i,iv] [-o docs/performance.md]

All runs of one round follow each other, round after round, so that a busy moment of the machine hits every peer; the
best of all rounds counts. Each run is one process on one thread that writes a regular file. `rs274` comes with Debian's
linuxcnc-uspace; without it its columns stay empty. Exit 1 when a target of the table is missed.
"""
import argparse
import itertools
import math
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time

POINTS = 100_000


def lines(count, control):
    """(i): numbered lines, each with a feed of its own."""
    yield from start(control)
    for i in range(count):
        yield f"N{i % 100000} G1 X{20 + i % 997 * 0.0101:.4f} Z{-1 - i % 991 * 0.1007:.4f} F{100 + i % 7 * 12.5:.1f}"
    yield "M30"


def arcs(count, control):
    """(ii): a line, a quarter to the right, a line, a quarter to the left; all arcs are exact."""
    yield from start(control)
    for i in range(count):
        d = i // 4 % 1000 / 1000
        x, z = 20 + d, -20 - d
        yield (f"N{i % 100000} " + (
            f"G1 X{x:.3f} Z{z:.3f} F{100 + i % 7}",
            f"G2 X{x + 2:.3f} Z{z - 2:.3f} I2.000 K0.000",
            f"G1 X{x + 4:.3f} Z{z - 5:.3f} F{200 + i % 7}",
            f"G3 X{x + 6:.3f} Z{z - 7:.3f} I0.000 K-2.000")[i % 4])
    yield "M30"


def start(control):
    return ("G152 G18 G90 G94 G1 X20 Z0 F100",) if control == "8055" else ("G8 G21 G18 G90 G94", "G1 X20 Z0 F100")


def loop(count, control, joined=False):
    """(iv): per point six assignments with one sine, one move, one jump."""
    yield from start(control)
    if control == "rs274":
        yield "#1=0"
        yield f"o1 while [#1 LT {count}]"
        yield from ("#2=[#1*0.1]", "#3=SIN[#2]", "#4=[#3*10]", "#5=[20+#4]", "#6=[0-#1/1000]", "#1=[#1+1]")
        yield from ("G1 X#5 Z#6 F200", "o1 endwhile", "M2")
        return
    assignments = ("P1=P0*0.1", "P2=SIN P1", "P3=P2*10", "P4=20+P3", "P5=0-P0/1000", "P0=P0+1")
    yield "(P0=0)"
    body = [f"({','.join(assignments)})"] if joined else [f"({a})" for a in assignments]
    yield "N10 " + body[0]
    yield from body[1:]
    yield from ("G1 XP4 ZP5 F200", f"(IF P0 LT {count} GOTO N10)", "M30")


def shapes(count, control):
    """(v): no two blocks of one shape: orders of G codes, and words that are there or not."""
    yield from start(control)
    codes = ("G90", "G94", "G97", "G71", "G152", "G5")
    orders = [o for n in range(1, len(codes) + 1) for o in itertools.permutations(codes, n)]
    tails = [f"{z}{f}{s}{m}" for z in ("", " Z-{d}") for f in ("", " F{f}") for s in ("", " S500") for m in ("", " M5", " M8", " M9")]
    heads = ("", "N{n} ")
    number = 0
    for order in orders:
        for head in heads:
            for tail in tails:
                if number == count:
                    yield "M30"
                    return
                text = head + " ".join(order) + " G1 X{x}" + tail
                yield text.format(n=number, x=20 + number % 97 / 10, d=number % 89 / 10, f=100 + number % 13)
                number += 1
    raise SystemExit(f"only {number} shapes")


class Case:
    def __init__(self, key, text, blocks, program, rs274=True, floor=False, least_rs274=0.0, least_floor=0.0, least=0.0):
        self.key, self.text, self.blocks, self.program = key, text, blocks, program
        self.rs274, self.floor = rs274, floor
        self.least_rs274, self.least_floor, self.least = least_rs274, least_floor, least
        self.best = {"fagorc": math.inf, "rs274": math.inf, "floor": math.inf}


def cases(small):
    sizes = (10_000, 50_000) if small else (100_000, 1_000_000)
    every = POINTS // 10 if small else POINTS
    for n in sizes:
        name = f"{n // 1000}k" if n < 1_000_000 else f"{n // 1_000_000}M"
        yield Case("i", f"(i) lines, {name} blocks", n, lines, floor=True, least_rs274=20, least_floor=0.25)
        yield Case("ii", f"(ii) lines and arcs, {name} blocks", n, arcs, floor=True, least_rs274=20, least_floor=0.25)
    yield Case("iv", f"(iv) loop of {every} points, six blocks", every, loop, least_rs274=40)
    yield Case("iv", f"(iv) loop of {every} points, one block", every,
               lambda n, control: loop(n, control, joined=True), least_rs274=40)
    yield Case("v", f"(v) {every} blocks, all of different shape", every, shapes, rs274=False, least=80_000)


def run(command, folder, environment):
    """Seconds of one process. It writes a new file: to replace one costs the file system's time, not ours."""
    for output in ("part.ftj", "part.txt"):
        if os.path.exists(os.path.join(folder, output)):
            os.unlink(os.path.join(folder, output))
    began = time.perf_counter()
    child = subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    messages = child.stderr.read().decode(errors="replace")
    _, status = os.waitpid(child.pid, 0)
    took = time.perf_counter() - began
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: exit {child.returncode}\n{messages[-2000:]}")
    return took


def measure(case, binaries, folder, rounds):
    commands = {"fagorc": [f"{binaries}/fagorc", "compile", "part.pit", "-o", "part.ftj"]}
    if case.floor:
        commands["floor"] = [f"{binaries}/bench_floor", "part.pit"]
    if case.rs274 and shutil.which("rs274"):
        commands["rs274"] = ["rs274", "-g", "part.ngc", "part.txt"]
    for name, control in (("part.pit", "8055"), ("part.ngc", "rs274")):
        with open(os.path.join(folder, name), "w") as out:
            out.writelines(line + "\n" for line in case.program(case.blocks, control))
    environment = dict(os.environ, HOME=folder, LC_ALL="C")
    for _ in range(rounds):
        for name, command in commands.items():
            case.best[name] = min(case.best[name], run(command, folder, environment))


def rate(case, name):
    return case.blocks / case.best[name]


def shown(value):
    return f"{value / 1e6:.2f} M" if value >= 1e6 else f"{value / 1e3:.0f} k"


def missed(case):
    """The targets that a case misses."""
    if case.best["rs274"] < math.inf and rate(case, "fagorc") < case.least_rs274 * rate(case, "rs274"):
        yield f"{case.least_rs274:.0f} x rs274"
    if case.floor and rate(case, "fagorc") < case.least_floor * rate(case, "floor"):
        yield "1/4 of the floor"
    if rate(case, "fagorc") < case.least:
        yield f"{shown(case.least)}/s"


def table(measured):
    yield "| program | fagorc, blocks/s | rs274 | ratio | floor | share | targets |"
    yield "|---|---|---|---|---|---|---|"
    for case in measured:
        ratio = f"{rate(case, 'fagorc') / rate(case, 'rs274'):.1f} x" if case.best["rs274"] < math.inf else ""
        share = f"{rate(case, 'fagorc') / rate(case, 'floor'):.2f}" if case.floor else ""
        peers = [shown(rate(case, p)) if case.best[p] < math.inf else "" for p in ("rs274", "floor")]
        verdict = ", ".join(f"misses {m}" for m in missed(case)) or "met"
        yield (f"| {case.text} | {shown(rate(case, 'fagorc'))} | {peers[0]} | {ratio} | {peers[1]} | {share} | "
               f"{verdict} |")


def machine():
    with open("/proc/cpuinfo") as info:
        model = next((l.split(":")[1].strip() for l in info if l.startswith("model name")), platform.machine())
    return f"{model}, {os.cpu_count()} logical processors, Linux {platform.release()}"


def page(measured, arguments):
    command = " ".join(["tests/bench/end_to_end.py", *arguments])
    return "\n".join(["# Speed", "", f"Measured on: {machine()}. Best of the rounds; all peers in turn in each round.", "",
                      "```", "cmake --preset release && cmake --build --preset release", command, "```", "", *table(measured),
                      "",
                      "For (iv) a block is a point. *floor* is a program that maps the text and reads its letters and numbers",
                      "(`tests/bench/floor.cpp`), *rs274* is LinuxCNC's interpreter on the same work in its own dialect. Targets:",
                      "(i), (ii) 20 times `rs274` and a quarter of the floor, (iv) 40 times `rs274`, (v) 80 000 blocks/s.",
                      "The phases by themselves: `build/release/bin/bench_phases`.", ""])


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--bin", default="build/release/bin")
    options.add_argument("--runs", type=int, default=5)
    options.add_argument("--small", action="store_true", help="a tenth of the work, to see that all runs")
    options.add_argument("--only", default="i,ii,iv,v")
    options.add_argument("-o", "--output", help="write the page there")
    options.add_argument("--keep", help="write the generated programs there and run nothing")
    o = options.parse_args()
    chosen = [c for c in cases(o.small) if c.key in o.only.split(",")]
    if o.keep:
        os.makedirs(o.keep, exist_ok=True)
        for i, case in enumerate(chosen):
            for suffix, control in (("pit", "8055"), ("ngc", "rs274")):
                with open(os.path.join(o.keep, f"{case.key}_{i}.{suffix}"), "w") as out:
                    out.writelines(line + "\n" for line in case.program(case.blocks, control))
        return 0
    with tempfile.TemporaryDirectory() as folder:
        for case in chosen:
            measure(case, os.path.abspath(o.bin), folder, o.runs)
            print(f"{case.text}: {shown(rate(case, 'fagorc'))}/s", file=sys.stderr)
    print("\n".join(table(chosen)))
    if o.output:
        with open(o.output, "w") as out:
            out.write(page(chosen, sys.argv[1:]))
    return 1 if any(list(missed(c)) for c in chosen) else 0


if __name__ == "__main__":
    sys.exit(main())
