#!/usr/bin/python3
"""Times `drawbead fix` on a big deck of which a tenth of the shells is the wrong way round.

Takes a deck of bench/make_decks.py, writes a damaged twin of it beside, and prints the median times of `check` and of
`fix -o` on the twin, of writing the repaired bytes with fsync, and what is allowed: 4 x check + 1.2 x writing.
"""
import argparse
import os
import statistics
import subprocess
import time
from pathlib import Path


def damage(source, target):
    """Every tenth run of 137 shells turned 1432."""
    shells = turned = 0
    in_table = False
    with open(source, "rb") as lines, open(target, "wb") as out:
        for line in lines:
            if line.startswith(b"/"):
                in_table = line.startswith(b"/SHELL/")
            elif in_table and not line.startswith(b"#"):
                shells += 1
                if shells // 137 % 10 == 3:
                    line = line[:20] + line[40:50] + line[30:40] + line[20:30] + line[50:]
                    turned += 1
            out.write(line)
    return shells, turned


def timed(command):
    begin = time.perf_counter()
    status = subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode
    if status > 1:
        raise SystemExit(f"{' '.join(command)} left with status {status}")
    return time.perf_counter() - begin


def written(data, path):
    begin = time.perf_counter()
    with open(path, "wb") as out:
        out.write(data)
        out.flush()
        os.fsync(out.fileno())
    return time.perf_counter() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("deck", type=Path)
    parser.add_argument("--program", default="build/release/src/cli/drawbead")
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    twin = arguments.deck.with_name("damaged_0000.rad")
    fixed = arguments.deck.with_name("fixed_0000.rad")
    shells, turned = damage(arguments.deck, twin)
    check, fix = [], []
    for _ in range(arguments.repeat):
        check.append(timed([arguments.program, "check", "-q", str(twin)]))
        fix.append(timed([arguments.program, "fix", "-q", str(twin), "-o", str(fixed)]))
    data = fixed.read_bytes()
    write = [written(data, fixed) for _ in range(arguments.repeat)]
    check, fix, write = (statistics.median(times) for times in (check, fix, write))
    print(f"{turned} of {shells} shells turned: check {check:.2f} s, fix {fix:.2f} s, writing {write:.2f} s; "
          f"allowed {4 * check + 1.2 * write:.2f} s")
    for path in (twin, fixed):
        path.unlink()


if __name__ == "__main__":
    main()
