#!/usr/bin/python3
"""Times `drawbead check` over a folder of many decks against `wc -l` over the same files.

The decks are made first (bench/make_decks.py; about 1 MB each, in mesh order and shuffled in turn) and stay in the folder
for the next time. Runs are interleaved (wc, -j2, -j1, wc, ...) on warm files; medians, their ratios to wc and the peak
resident size are printed. With --same the bytes of the JSON report are compared between -j1, -j2 and seven merged shards.
"""
import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from whole_process import DEFAULT_TOOL, run

HERE = Path(__file__).resolve().parent


def make_decks(folder, count, nodes, beads, bead_nodes):
    """`count` decks in folders of a hundred; files of the same name and size are left as they are."""
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([sys.executable, HERE / "make_decks.py", "--out", made, "--nodes", str(nodes),
                        "--beads", str(beads), "--bead-nodes", str(bead_nodes)], check=True, stderr=subprocess.DEVNULL)
        kinds = [Path(made) / f"{kind}_0000.rad" for kind in ("natural", "shuffled")]
        decks = []
        for i in range(count):
            deck = folder / f"{i // 100:03d}" / f"deck{i:05d}_0000.rad"
            source = kinds[i % 2]
            deck.parent.mkdir(parents=True, exist_ok=True)
            if not deck.exists() or deck.stat().st_size != source.stat().st_size:
                shutil.copyfile(source, deck)
            decks.append(str(deck))
    return decks


def same_bytes(tool, folder, options):
    """Whether -j1, -j2 and seven merged shards give the same JSON."""
    with tempfile.TemporaryDirectory() as out:
        def report(name, *arguments):
            path = os.path.join(out, name)
            subprocess.run([tool, *arguments, "--quiet", "--output", f"json={path}"], check=False)
            return path

        paths = [report("j1", "check", "-j1", *options, str(folder)), report("j2", "check", "-j2", *options, str(folder))]
        shards = [report(f"shard{k}", "check", "--shard", f"{k}/7", *options, str(folder)) for k in range(1, 8)]
        paths.append(report("merged", "merge", *shards))
        contents = [Path(path).read_bytes() for path in paths]
        return contents[0] == contents[1] == contents[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="where the decks are, or are to be made")
    parser.add_argument("--tool", default=str(DEFAULT_TOOL), help="drawbead to run (default: of preset release)")
    parser.add_argument("--decks", type=int, default=2000)
    parser.add_argument("--nodes", type=int, default=8000, help="of each deck's blank; 8000 make about 1 MB")
    parser.add_argument("--beads", type=int, default=2, help="of each deck")
    parser.add_argument("--bead-nodes", type=int, default=50, help="of each bead")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--same", action="store_true", help="compare the bytes of the reports, too")
    parser.add_argument("--option", action="append", default=[], help="passed on to `drawbead check`; may be repeated")
    arguments = parser.parse_args()
    if not os.access(arguments.tool, os.X_OK):
        print(f"{arguments.tool}: no such program; build it first (cmake --build --preset release)", file=sys.stderr)
        return 2
    decks = make_decks(arguments.folder, arguments.decks, arguments.nodes, arguments.beads, arguments.bead_nodes)
    size = sum(os.path.getsize(deck) for deck in decks)
    commands = {"wc": ["wc", "-l", *decks]}
    for threads in (2, 1):
        commands[f"j{threads}"] = [arguments.tool, "check", f"-j{threads}", *arguments.option, str(arguments.folder)]
    samples = {name: [] for name in commands}
    run(commands["wc"])
    for _ in range(arguments.runs):
        for name, command in commands.items():
            samples[name].append(run(command))
    wc = statistics.median(seconds for seconds, _, _ in samples["wc"])
    print(f"{len(decks)} decks, {size / 1e6:.0f} MB, median of {arguments.runs} runs on {os.cpu_count()} cores")
    print(f"  wc -l             {wc:8.2f} s")
    for name in ("j2", "j1"):
        seconds = sorted(sample[0] for sample in samples[name])
        middle = statistics.median(seconds)
        print(f"  drawbead check -{name} {middle:7.2f} s  {middle / wc:5.2f} x wc  ({seconds[0]:.2f} to {seconds[-1]:.2f} s)"
              f"  peak {max(sample[1] for sample in samples[name]):.0f} MB"
              f"  exit {','.join(str(status) for status in sorted({sample[2] for sample in samples[name]}))}")
    if arguments.same:
        same = same_bytes(arguments.tool, arguments.folder, arguments.option)
        print("  -j1, -j2 and 7 merged shards: " + ("the same bytes" if same else "OTHER BYTES"))
        return 0 if same else 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
