#!/usr/bin/python3
"""Writes the two big decks that the speed of the whole process is measured on.

natural_0000.rad   ids and lines in mesh order, eight decimals
shuffled_0000.rad  node and element ids and the order of their lines shuffled, 15 significant digits, every other line
                   in E format, so that cells touch

Both hold the same gently waved blank of quads, one part, and beads (four by default) over it that /BCS keeps in place.
Nothing in them is wrong: a checker has to look at everything and find nothing. The same arguments give the same bytes.
"""
import argparse
import math
import random
import sys
import time
from array import array
from itertools import chain, cycle, islice
from pathlib import Path

HEAD = """#RADIOSS STARTER
#---1----|----2----|----3----|----4----|----5----|----6----|----7----|----8----|----9----|---10----|
# Benchmark deck: {nodes} nodes, {shells} shells, {beads} beads of {bead_nodes} nodes
/BEGIN
{name}
      2022         0
                  Mg                  mm                   s
                  Mg                  mm                   s
/MAT/ELAST/1
steel
#              RHO_I
            7.85E-09
#                  E                  nu
            210000.0                 0.3
/PROP/SHELL/1
blank
#   Ishell    Ismstr     Ish3n    Idrill
        24         0         0         0
#                 hm                  hf                  hr                  dm                  dn
                 0.0                 0.0                 0.0                 0.0                 0.0
#        N   Istrain               Thick              Ashear              Ithick     Iplas
         5         0                 1.0                 0.0                   1         1
/PART/1
blank
         1         1         0
"""

BEAD = """/BCS/{ident}
bead {ident} held
#  Tra rot   skew_ID  grnod_ID
   111 111         0{group:10d}
/INTER/TYPE8/{ident}
bead {ident}
# grnd_IDs  surf_IDm               Iform
{group:10d}         1                   2
#                 Fn                  Ft               Depth              Tstart               Tstop
                60.0                80.0                 2.0                 0.0                 0.0
#            Fn_last             Ft_last
                 0.0{ft_last:20.1f}
"""

LINES_AT_ONCE = 50000


class Blank:
    """nx by ny nodes about 1 mm apart, then the nodes of the beads 3 mm above them."""

    def __init__(self, nodes, beads=4, bead_nodes=None):
        self.nx = max(4, round(math.sqrt(1.25 * nodes)))
        self.ny = max(6, nodes // self.nx)
        self.count = self.nx * self.ny
        self.x, self.y, self.z = array("d"), array("d"), array("d")
        sine, cosine = math.sin, math.cos
        for j in range(self.ny):
            waved = [20.0 + 5.0 * sine(i / 97.0) * cosine(j / 83.0) for i in range(self.nx)]
            self.x.extend(10.0 + i + 0.05 * sine(0.013 * i + 0.7 * j) for i in range(self.nx))
            self.y.extend(10.0 + j + 0.05 * cosine(0.7 * i + 0.011 * j) for i in range(self.nx))
            self.z.extend(waved)
        # At most 0.97 mm from node to node; a bead of more nodes than the blank is long has them closer.
        self.bead_nodes = bead_nodes or min(500, self.nx - 3)
        self.step = min(0.97, (self.nx - 3.5) / self.bead_nodes)
        self.bead_count = beads
        self.beads = [self.add_bead(b) for b in range(beads)]

    def add_bead(self, bead):
        """A line along x, slightly bent, with equal steps; returns the indices of its nodes."""
        first = len(self.x)
        middle_x, middle_y = self.nx / 2.0, (bead + 1) * self.ny / (self.bead_count + 1.0)
        for k in range(self.bead_nodes):
            i = middle_x + self.step * (k - (self.bead_nodes - 1) / 2.0)
            j = middle_y + 0.5 * math.sin(i / 40.0)
            slope_x = 5.0 / 97.0 * math.cos(i / 97.0) * math.cos(j / 83.0)
            slope_y = -5.0 / 83.0 * math.sin(i / 97.0) * math.sin(j / 83.0)
            length = math.sqrt(slope_x**2 + slope_y**2 + 1.0)
            self.x.append(10.0 + i - 3.0 * slope_x / length)
            self.y.append(10.0 + j - 3.0 * slope_y / length)
            self.z.append(20.0 + 5.0 * math.sin(i / 97.0) * math.cos(j / 83.0) + 3.0 / length)
        return range(first, len(self.x))

    def shells(self):
        """The index of the lower left node of every shell."""
        return [j * self.nx + i for j in range(self.ny - 1) for i in range(self.nx - 1)]


def write_lines(out, pattern, columns):
    """Writes the columns line by line; `pattern` may hold several lines, taken in turn."""
    patterns = cycle(pattern.splitlines(keepends=True))
    for start in range(0, len(columns[0]), LINES_AT_ONCE):
        piece = [column[start : start + LINES_AT_ONCE] for column in columns]
        text = "".join(islice(patterns, len(piece[0])))
        out.write((text % tuple(chain.from_iterable(zip(*piece)))).encode())


def write_deck(path, blank, shuffled):
    node_order = list(range(len(blank.x)))
    node_id = list(range(1, len(blank.x) + 1))
    shells = blank.shells()
    shell_id = list(range(1, len(shells) + 1))
    node_lines = "%10d%20.8f%20.8f%20.8f\n"
    if shuffled:
        generator = random.Random(20260801)
        for column in (node_order, node_id, shells, shell_id):
            generator.shuffle(column)
        node_lines = "%10d%#20.15g%#20.15g%#20.15g\n%10d%20.14E%20.14E%20.14E\n"

    def gather(column, rows):
        return list(map(column.__getitem__, rows))

    with open(path, "wb") as out:
        out.write(HEAD.format(name=path.name[:-9], nodes=len(blank.x), shells=len(shells), beads=len(blank.beads),
                              bead_nodes=blank.bead_nodes).encode())
        out.write(b"/NODE\n#  node_ID                   X                   Y                   Z\n")
        write_lines(out, node_lines, [gather(c, node_order) for c in (node_id, blank.x, blank.y, blank.z)])
        out.write(b"/SHELL/1\n# shell_ID  node_ID1  node_ID2  node_ID3  node_ID4\n")
        corners = [gather(node_id, (s + step for s in shells)) for step in (0, 1, blank.nx + 1, blank.nx)]
        write_lines(out, "%10d%10d%10d%10d%10d\n", [shell_id, *corners])
        out.write(b"/SURF/PART/1\nblank, normals towards the beads\n         1\n")
        for ident, rows in enumerate(blank.beads, start=1):
            ids = gather(node_id, rows)
            out.write(f"/GRNOD/NODENS/{100 + ident}\nbead {ident}\n".encode())
            for start in range(0, len(ids), 10):
                out.write("".join(f"{node:10d}" for node in ids[start : start + 10]).encode() + b"\n")
            out.write(BEAD.format(ident=ident, group=100 + ident, ft_last=120.0 if ident == 4 else 0.0).encode())
        out.write(b"/END\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--nodes", type=int, default=2_000_000, help="nodes of the blank, about as many shells")
    parser.add_argument("--beads", type=int, default=4)
    parser.add_argument("--bead-nodes", type=int,
                        help="nodes of each bead (default: 500, fewer on a small blank)")
    parser.add_argument("--out", type=Path, required=True, help="folder for the decks")
    parser.add_argument("--only", choices=["natural", "shuffled"], help="write one of the two")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    started = time.monotonic()
    blank = Blank(arguments.nodes, arguments.beads, arguments.bead_nodes)
    for name in ("natural", "shuffled"):
        if arguments.only in (None, name):
            path = arguments.out / f"{name}_0000.rad"
            write_deck(path, blank, name == "shuffled")
            size = path.stat().st_size / 1e6
            print(f"{path}: {size:.1f} MB after {time.monotonic() - started:.1f} s", file=sys.stderr)


if __name__ == "__main__":
    main()
