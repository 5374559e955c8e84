#!/usr/bin/python3
"""Writes compact fixtures from scenes that were run through the real solver.

usage: make_fixtures.py FOLDER [OUT]

FOLDER/NAME/ holds NAME_0000.rad, outcome.json and trace.csv.gz (one row per cycle and bead node, with all that the
solver computed). OUT/NAME.txt gets the mesh in the solver's storage order, what backs each segment, the beads, what
the Starter warned of, and the rows of the first traced cycle.
"""
import csv
import gzip
import json
import pathlib
import sys

EXPECTED = ("nin inod node seg_n1 seg_n2 seg_n3 seg_n4 xface ssc ttc h1 h2 h3 h4 dist gapn pen depth stf slopen_ig "
            "slopen_seg li2 trib fnlim ftlim distlin disttot xi yi zi").split()


def blocks(path):
    """(keyword parts, data lines) of each block, comments left out."""
    found = []
    for line in path.read_text().splitlines():
        if line.startswith("#") or line.startswith("$"):
            continue
        if line.startswith("/"):
            found.append((line.strip().split("/")[1:], []))
        elif found:
            found[-1][1].append(line)
    return found


def fields(line, width=10):
    return [line[k:k + width].strip() for k in range(0, len(line.rstrip()), width)]


def integers(lines):
    return [int(f) for line in lines for f in fields(line) if f]


class Scene:
    def __init__(self, folder):
        self.name = folder.name
        self.nodes, self.materials, self.properties, self.parts = {}, {}, {}, {}
        self.shells, self.triangles, self.bricks, self.groups, self.surfaces = {}, {}, {}, {}, {}
        self.beads, self.admesh_idt, self.version = [], 0, 0
        for words, lines in blocks(folder / f"{folder.name}_0000.rad"):
            self.read(words, lines)
        self.outcome = json.loads((folder / "outcome.json").read_text())
        self.rows = []
        trace = folder / "trace.csv.gz"
        if trace.exists():
            with gzip.open(trace, "rt") as text:
                for row in csv.DictReader(text):
                    if self.rows and row["ncycle"] != self.rows[0]["ncycle"]:
                        break
                    self.rows.append(row)

    def read(self, words, lines):
        kind = words[0]
        if kind == "BEGIN":
            self.version = int(lines[1].split()[0])
        elif kind == "NODE":
            for line in lines:
                self.nodes[int(line[:10])] = tuple(float(line[k:k + 20]) for k in (10, 30, 50))
        elif kind == "MAT":
            if words[1] == "VOID":
                young, poisson = float(lines[1][20:40] or 0), float(lines[1][40:60] or 0)
            else:
                young, poisson = float(lines[2][:20]), float(lines[2][20:40])
            self.materials[int(words[2])] = (young, poisson)
        elif kind == "PROP" and words[1] == "SHELL":
            self.properties[int(words[2])] = float(lines[3][20:40])
        elif kind == "PART":
            numbers = integers(lines[1:2])
            self.parts[int(words[1])] = (numbers[0], numbers[1])
        elif kind in ("SHELL", "SH3N", "BRICK"):
            count = {"SHELL": 4, "SH3N": 3, "BRICK": 8}[kind]
            table = {"SHELL": self.shells, "SH3N": self.triangles, "BRICK": self.bricks}[kind]
            for line in lines:
                numbers = [int(f) for f in fields(line)[:count + 1]]
                table[numbers[0]] = (numbers[1:], int(words[1]))
        elif kind in ("GRNOD", "GRSHEL"):
            self.groups[(kind, int(words[2]))] = (words[1], integers(lines[1:]))
        elif kind == "SURF":
            self.surfaces[int(words[2])] = (words[1], lines[1:])
        elif kind == "ADMESH" and words[1] == "GLOBAL":
            self.admesh_idt = int(lines[0].split()[-1])
        elif kind == "INTER":
            ids = fields(lines[1])
            forces = fields(lines[2], 20)
            last = fields(lines[3], 20) if len(lines) > 3 and self.version >= 2022 else ["0", "0"]
            self.beads.append({
                "group": int(ids[0]), "surface": int(ids[1]), "iform": int(ids[-1]) or 2,
                "fn": float(forces[0]), "ft": float(forces[1]), "depth": float(forces[2]),
                "fn_last": float(last[0]), "ft_last": float(last[1])})

    def shell_stiffness(self, part):
        prop, mat = self.parts[part]
        return self.materials[mat][0], self.properties[prop]

    def segments(self, surface):
        """(nodes, E, t of the shell or zeros, bulk modulus and corners of the solid or None) in storage order."""
        kind, lines = self.surfaces[surface]
        if kind == "SEG":
            return [self.listed_segment(integers([line])[1:]) for line in lines]
        wanted = {}
        for number in integers(lines):
            sign = -1 if number < 0 else 1
            if kind == "PART":
                for table in (self.shells, self.triangles):
                    for element, (nodes, part) in table.items():
                        if part == abs(number):
                            wanted[(len(nodes), element)] = sign
            elif kind == "GRSHEL":
                for element in self.groups[("GRSHEL", abs(number))][1]:
                    wanted[(4, element)] = sign
            else:
                raise ValueError(f"surface of type {kind}")
        out = []
        for count, element in sorted(wanted, key=lambda k: (-k[0], k[1])):
            nodes, part = (self.shells if count == 4 else self.triangles)[element]
            if wanted[(count, element)] < 0:
                nodes = nodes[::-1]
            out.append((nodes + nodes[-1:] if count == 3 else nodes, *self.shell_stiffness(part), None))
        return out

    def listed_segment(self, nodes):
        if len(nodes) == 3 or nodes[3] == 0:
            nodes = nodes[:3] + [nodes[2]]
        young, thickness, solid = 0.0, 0.0, None
        for element in sorted(self.bricks):
            corners, part = self.bricks[element]
            if set(nodes) <= set(corners):
                e, nu = self.materials[self.parts[part][1]]
                solid = (e / (3 * (1 - 2 * nu)), corners)
        for table in (self.shells, self.triangles):
            for corners, part in table.values():
                if set(corners) == set(nodes):
                    young, thickness = self.shell_stiffness(part)
        return nodes, young, thickness, solid

    def text(self):
        out = [f"scene {self.name}"]
        number = {node: k for k, node in enumerate(self.nodes)}
        out.append(f"nodes {len(self.nodes)}")
        out += [f"{node} {x!r} {y!r} {z!r}" for node, (x, y, z) in self.nodes.items()]
        surfaces = sorted({bead["surface"] for bead in self.beads})
        out.append(f"surfaces {len(surfaces)}")
        for surface in surfaces:
            segments = self.segments(surface)
            out.append(f"segments {len(segments)}")
            for nodes, young, thickness, solid in segments:
                line = [number[n] for n in nodes] + [young, thickness]
                line += [solid[0]] + [number[n] for n in solid[1]] if solid else [0]
                out.append(" ".join(str(v) for v in line))
        out.append(f"beads {len(self.beads)} {self.admesh_idt}")
        messages = self.outcome["starter_messages"]
        for k, bead in enumerate(self.beads):
            kind, nodes = self.groups[("GRNOD", bead["group"])]
            warned = self.outcome["nodes_346"].get(str(k + 1), [])
            out.append(f"{surfaces.index(bead['surface'])} {int(kind == 'NODENS')} {bead['iform']} {bead['fn']!r} "
                       f"{bead['ft']!r} {bead['fn_last']!r} {bead['ft_last']!r} {bead['depth']!r}")
            out.append(" ".join(str(v) for v in [len(nodes)] + [number[n] for n in nodes]))
            out.append(" ".join(str(v) for v in [len(warned)] + warned))
        codes = [message.split()[-1] for message in messages]
        out.append(" ".join(["messages", str(len(codes))] + codes))
        # The blank moves as one: where it stands in the first traced cycle.
        shift = (0.0, 0.0, 0.0)
        if self.rows:
            first = self.rows[0]
            at = self.nodes[int(first["seg_n1"])]
            shift = tuple(float(first[f"{axis}1"]) - at[k] for k, axis in enumerate("xyz"))
        out.append(f"moved {shift[0]!r} {shift[1]!r} {shift[2]!r}")
        # Adaptive meshing makes nodes that the deck does not have: such rows say nothing about its mesh.
        rows = [row for row in self.rows if all(int(row[f"seg_n{k}"]) in self.nodes for k in (1, 2, 3, 4))]
        out.append(f"rows {len(rows)}")
        out += [" ".join(row[column] for column in EXPECTED) for row in rows]
        return "\n".join(out) + "\n"


def main():
    source = pathlib.Path(sys.argv[1])
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parent / "data"
    for folder in sorted(p for p in source.iterdir() if p.is_dir()):
        (target / f"{folder.name}.txt").write_text(Scene(folder).text())


if __name__ == "__main__":
    main()
