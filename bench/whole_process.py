#!/usr/bin/python3
"""Times the whole process `drawbead check DECK` against `wc -l DECK`.

Runs are interleaved (wc, -j2, -j1, wc, ...) on a warm file; medians, their ratios to wc and the peak resident size are
printed as text, and as JSON with --json FILE.
"""
import argparse
import json
import os
import statistics
import sys
import time
from pathlib import Path

DEFAULT_TOOL = Path(__file__).resolve().parent.parent / "build" / "release" / "src" / "cli" / "drawbead"


def run(command):
    """Runs a command with its output thrown away; returns seconds, peak resident MB and exit status."""
    null = os.open(os.devnull, os.O_RDWR)
    actions = [(os.POSIX_SPAWN_DUP2, null, target) for target in (0, 1, 2)]
    started = time.perf_counter()
    pid = os.posix_spawnp(command[0], command, os.environ, file_actions=actions)
    _, status, usage = os.wait4(pid, 0)
    seconds = time.perf_counter() - started
    os.close(null)
    return seconds, usage.ru_maxrss / 1024.0, os.waitstatus_to_exitcode(status)


def measure(tool, deck, runs, options):
    commands = {"wc": ["wc", "-l", deck]}
    for threads in (2, 1):
        commands[f"j{threads}"] = [tool, "check", f"-j{threads}", *options, deck]
    samples = {name: [] for name in commands}
    run(commands["wc"])
    for _ in range(runs):
        for name, command in commands.items():
            samples[name].append(run(command))
    wc = statistics.median(seconds for seconds, _, _ in samples["wc"])
    result = {"deck": deck, "bytes": os.path.getsize(deck), "runs": runs, "wc_seconds": wc}
    for name, values in samples.items():
        if name == "wc":
            continue
        seconds = sorted(value[0] for value in values)
        result[name] = {
            "seconds": statistics.median(seconds),
            "fastest": seconds[0],
            "slowest": seconds[-1],
            "times_wc": statistics.median(seconds) / wc,
            "peak_mb": max(value[1] for value in values),
            "exit": sorted({value[2] for value in values}),
        }
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("decks", nargs="+", metavar="DECK")
    parser.add_argument("--tool", default=str(DEFAULT_TOOL), help="drawbead to run (default: of preset release)")
    parser.add_argument("--runs", type=int, default=11)
    parser.add_argument("--option", action="append", default=[], help="passed on to `drawbead check`; may be repeated")
    parser.add_argument("--json", type=Path, help="also write the numbers to this file")
    arguments = parser.parse_args()
    if not os.access(arguments.tool, os.X_OK):
        print(f"{arguments.tool}: no such program; build it first (cmake --build --preset release)", file=sys.stderr)
        return 2
    results = []
    for deck in arguments.decks:
        result = measure(arguments.tool, deck, arguments.runs, arguments.option)
        results.append(result)
        print(f"{deck}: {result['bytes'] / 1e6:.1f} MB, median of {arguments.runs} runs on {os.cpu_count()} cores")
        print(f"  wc -l             {1e3 * result['wc_seconds']:8.1f} ms")
        for name in ("j2", "j1"):
            row = result[name]
            print(f"  drawbead check -{name} {1e3 * row['seconds']:7.1f} ms  {row['times_wc']:5.2f} x wc"
                  f"  ({1e3 * row['fastest']:.1f} to {1e3 * row['slowest']:.1f} ms)"
                  f"  peak {row['peak_mb']:.0f} MB  exit {','.join(map(str, row['exit']))}")
    if arguments.json:
        arguments.json.write_text(json.dumps({"cores": os.cpu_count(), "results": results}, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
