#!/usr/bin/python3
"""Writes the sample decks of this folder; with --check, says whether the committed ones are what it would write.

Every scene is our own and fully specified: lengths in mm, forces in N, times in s (Mg-mm-s) unless the deck says
otherwise. Nothing is random and no clock is read, so the same script always writes the same bytes.
"""
import math
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
RULER = "#---1----|----2----|----3----|----4----|----5----|----6----|----7----|----8----|----9----|---10----|"

BLANK, BINDER, DIE, PUNCH = 1, 2, 3, 4  # part ids, and the ids of their property, surface and rigid body
STEEL, TOOL_STEEL = 1, 2  # material ids
BLANK_NODES, BINDER_NODES, PULLED_NODES, HELD_NODES = 1, 20, 11, 12  # node groups
HARDENING, CLOSE, PULL, SIDE = 1, 11, 12, 13  # functions

# True stress over plastic strain of a cold-rolled steel, MPa.
CURVE = [(0.0, 330.0), (0.01, 375.0), (0.03, 425.0), (0.07, 484.0), (0.15, 556.0), (0.3, 636.0), (0.6, 725.0)]


class Units:
    """A coherent unit system, as factors from Mg, mm, s."""

    def __init__(self, mass, length, time, mass_factor=1.0, length_factor=1.0):
        self.names = (mass, length, time)
        self.length = length_factor
        self.density = mass_factor / length_factor**3
        self.stress = mass_factor / length_factor
        self.force_per_length = mass_factor
        self.speed = length_factor


MM = Units("Mg", "mm", "s")
SI = Units("kg", "m", "s", mass_factor=1e3, length_factor=1e-3)


def number(value):
    """A real as people write it: 12 digits at most, always with a point or an exponent."""
    text = f"{value:.12g}"
    if text == "-0":
        text = "0"
    return text if "." in text or "e" in text else text + ".0"


def card(*cells):
    """One card line. An int fills 10 columns, a float 20, None leaves 10 blank, a str is copied as it is."""
    line = ""
    for cell in cells:
        if cell is None:
            line += " " * 10
        elif isinstance(cell, str):
            line += cell
        elif isinstance(cell, float):
            line += f"{number(cell):>20}"
        else:
            line += f"{cell:10d}"
    return line.rstrip()


def id_list(ids):
    ids = list(ids)
    return [card(*ids[i : i + 10]) for i in range(0, len(ids), 10)]


class Mesh:
    """Nodes (id -> point) and 4-node shells (id, nodes) of one part."""

    def __init__(self, first_node=1, first_shell=1):
        self.first_node, self.first_shell = first_node, first_shell
        self.nodes, self.shells = {}, []

    def add_node(self, point):
        node = self.first_node + len(self.nodes)
        self.nodes[node] = point
        return node

    def add_shell(self, corners):
        self.shells.append((self.first_shell + len(self.shells), tuple(corners)))

    def where(self, test):
        return [node for node, (x, y, z) in self.nodes.items() if test(x, y, z)]


def steps(start, stop, step):
    count = round((stop - start) / step)
    return [start + i * (stop - start) / count for i in range(count + 1)]


def sheet(xs, ys, height=lambda x, y: 0.0, keep=lambda x, y: True, first_node=1, first_shell=1):
    """Quads over a grid, normals up. `keep` says by its centre whether a quad is there."""
    mesh = Mesh(first_node, first_shell)
    cells = [
        (i, j)
        for j in range(len(ys) - 1)
        for i in range(len(xs) - 1)
        if keep((xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2)
    ]
    used = sorted({(j + b, i + a) for i, j in cells for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))})
    node = {(i, j): mesh.add_node((xs[i], ys[j], round(height(xs[i], ys[j]), 6))) for j, i in used}
    for i, j in cells:
        mesh.add_shell((node[i, j], node[i + 1, j], node[i + 1, j + 1], node[i, j + 1]))
    return mesh


def disc_ring(radii, sectors, z, first_node, first_shell):
    """Quads between circles around the z axis, normals up."""
    mesh = Mesh(first_node, first_shell)
    node = {}
    for r, radius in enumerate(radii):
        for s in range(sectors):
            angle = 2 * math.pi * s / sectors
            node[r, s] = mesh.add_node((round(radius * math.cos(angle), 6), round(radius * math.sin(angle), 6), z))
    for r in range(len(radii) - 1):
        for s in range(sectors):
            t = (s + 1) % sectors
            mesh.add_shell((node[r, s], node[r + 1, s], node[r + 1, t], node[r, t]))
    return mesh


def extruded(profile, ys, first_node, first_shell):
    """Quads along a profile of (x, z) points, drawn out in y; normals to the left of the profile's direction."""
    mesh = Mesh(first_node, first_shell)
    node = [[mesh.add_node((round(x, 6), y, round(z, 6))) for y in ys] for x, z in profile]
    for i in range(len(profile) - 1):
        for j in range(len(ys) - 1):
            mesh.add_shell((node[i][j], node[i + 1][j], node[i + 1][j + 1], node[i][j + 1]))
    return mesh


def straight(start, stop, step):
    """Points along a straight line, both ends included."""
    count = round(math.dist(start, stop) / step)
    return [tuple(a + (b - a) * i / count for a, b in zip(start, stop)) for i in range(count + 1)]


class Deck:
    """The lines of one starter deck, written block by block."""

    def __init__(self, name, about, version=2022, units=MM):
        self.name, self.version, self.units = name, version, units
        self.lines = ["#RADIOSS STARTER", RULER]
        self.lines += [f"# {line}".rstrip() for line in about]
        self.lines += [RULER, "/BEGIN", name, card(version, 0)]
        self.lines += ["".join(f"{unit:>20}" for unit in units.names)] * 2
        self.block("/TITLE", name.replace("_", " "))

    def block(self, keyword, title, *lines):
        self.lines += [keyword, title, *lines]

    def section(self, text):
        self.lines += [RULER, f"# {text}", RULER]

    def text(self):
        return "\n".join([*self.lines, "/END", ""])

    # -- materials, properties, parts ---------------------------------------------------------------------------
    def elastic(self, ident, title):
        u = self.units
        self.block(
            f"/MAT/ELAST/{ident}", title,
            "#              RHO_I", card(7.85e-9 * u.density),
            "#                  E                  nu", card(210000.0 * u.stress, 0.3),
        )

    def tabulated(self, ident, title):
        u = self.units
        self.block(
            f"/MAT/PLAS_TAB/{ident}", title,
            "#              RHO_I", card(7.85e-9 * u.density),
            "#                  E                  nu           Eps_p_max               Eps_t               Eps_m",
            card(210000.0 * u.stress, 0.3, 0.0, 0.0, 0.0),
            "#  N_funct  F_smooth              C_hard               F_cut               Eps_f                  VP",
            card(1, 0, 0.0, 0.0, 0.0, None, 0),
            "#  fct_IDp              Fscale   Fct_IDE                EInf                  CE",
            card(0, 0.0, 0, 0.0, 0.0),
            "# func_ID1", card(HARDENING),
            "#           Fscale_1", card(u.stress),
            "#          Eps_dot_1", card(0.0),
        )
        self.function(HARDENING, "true stress over plastic strain, MPa", CURVE)

    def hill_tabulated(self, ident, title):
        u = self.units
        self.block(
            f"/MAT/HILL_TAB/{ident}", title,
            "#              RHO_I", card(7.85e-9 * u.density),
            "#                  E                  nu", card(210000.0 * u.stress, 0.3),
            "#FUNCT_IDE                          EINF                  CE",
            card(0, None, 0.0, 0.0),
            "#                r00                 r45                 r90              C_hard",
            card(1.73, 1.34, 2.24, 0.0),
            "#           EPSP_max              EPS_t1               EPS_m",
            card(0.0, 0.0, 0.0),
            "# func_IDi                      Fscale_i           EPS_dot_i",
            card(HARDENING, None, u.stress, 0.0),
        )
        self.function(HARDENING, "true stress over plastic strain, MPa", CURVE)

    def johnson(self, ident, title):
        u = self.units
        self.block(
            f"/MAT/PLAS_JOHNS/{ident}", title,
            "#              RHO_I", card(7.85e-9 * u.density),
            "#                  E                  nu     Iflag", card(210000.0 * u.stress, 0.3, 0),
            "#                  a                   b                   n           EPS_p_max            SIG_max0",
            card(330.0 * u.stress, 520.0 * u.stress, 0.5, 0.0, 0.0),
            "#                  c           EPS_DOT_0       ICC   Fsmooth               F_cut               Chard",
            card(0.0, 0.0, 0, 0, 0.0, 0.0),
            "#                  m              T_melt              rhoC_p                 T_r",
            card(0.0, 0.0, 0.0, 0.0),
        )

    def shell_property(self, ident, title, thickness, integration_points):
        self.block(
            f"/PROP/SHELL/{ident}", title,
            "#   Ishell    Ismstr     Ish3n    Idrill", card(24, 0, 0, 0),
            "#                 hm                  hf                  hr                  dm                  dn",
            card(0.0, 0.0, 0.0, 0.0, 0.0),
            "#        N   Istrain               Thick              Ashear              Ithick     Iplas",
            card(integration_points, 0, thickness * self.units.length, 0.0, None, 1, 1),
        )

    def part(self, ident, title, prop, material):
        self.block(f"/PART/{ident}", title, "#  prop_ID    mat_ID subset_ID", card(prop, material, 0))

    def function(self, ident, title, points):
        self.block(
            f"/FUNCT/{ident}", title,
            "#                  X                   Y", *(card(float(x), float(y)) for x, y in points),
        )

    # -- mesh ---------------------------------------------------------------------------------------------------
    def nodes(self, nodes):
        scale = self.units.length
        self.lines += ["/NODE", "#  node_ID                   X                   Y                   Z"]
        self.lines += [card(n, float(x * scale), float(y * scale), float(z * scale)) for n, (x, y, z) in nodes.items()]

    def shells(self, part, mesh):
        self.lines += [f"/SHELL/{part}", "# shell_ID  node_ID1  node_ID2  node_ID3  node_ID4"]
        self.lines += [card(ident, *corners) for ident, corners in mesh.shells]

    # -- groups, motion, rigid bodies -----------------------------------------------------------------------------
    def group(self, kind, ident, title, ids):
        self.block(f"/GRNOD/{kind}/{ident}", title, *id_list(ids))

    def surface(self, ident, title, part):
        self.block(f"/SURF/PART/{ident}", title, *id_list([part]))

    def fixed(self, ident, title, directions, group):
        self.block(f"/BCS/{ident}", title, "#  Tra rot   skew_ID  grnod_ID", f"   {directions}" + card(0, group))

    def velocity(self, ident, title, function, direction, group):
        self.block(
            f"/IMPVEL/{ident}", title,
            "#funct_IDT       Dir   skew_ID sensor_ID  grnod_ID  frame_ID     Icoor",
            card(function, f"{direction:>10}", 0, 0, group, 0, 0),
            "#           Ascale_x            Fscale_Y              Tstart               Tstop",
            card(1.0, self.units.speed, 0.0, 1e30),
        )

    def rigid_body(self, ident, title, main_node, group):
        self.block(
            f"/RBODY/{ident}", title,
            "#    rb_ID   sens_ID   skew_ID    Ispher                Mass grnod_IDs     Ikrem      ICoG   surf_ID",
            card(main_node, 0, 0, 0, 0.0, group, 0, 3, 0),
            "#                Jxx                 Jyy                 Jzz", card(0.0, 0.0, 0.0),
            "#                Jxy                 Jyz                 Jxz", card(0.0, 0.0, 0.0),
            "#  Ioptoff", card(0),
        )

    # -- interfaces -----------------------------------------------------------------------------------------------
    def contact(self, ident, title, group, surface, gap):
        self.block(
            f"/INTER/TYPE7/{ident}", title,
            "# grnod_id   surf_id      Istf      Ithe      Igap                Ibag      Idel     Icurv      Iadm",
            card(group, surface, 4, 0, 1000, None, 0, 0, 0, 0),
            "#          Fscalegap             Gap_max             Fpenmax", card(0.0, 0.0, 0.0),
            "#              Stmin               Stmax   Percent_mesh_size               dtmin  Irem_gap   Irem_i2",
            card(0.0, 0.0, 0.0, 0.0, 0, 0),
            "#              Stfac                Fric              GAPmin              Tstart               Tstop",
            card(1.0, 0.1, gap * self.units.length, 0.0, 0.0),
            "#      IBC                        Inacti               VIS_S               VIS_F              Bumult",
            "       000" + card(None, None, 0, 0.0, 0.0, 0.0),
            "#    Ifric    Ifiltr               Xfreq     Iform   sens_ID   fct_IDF             AscaleF   fric_ID",
            card(0, 0, 0.0, 2, 0, 0, 0.0, 0),
        )

    def drawbead(self, ident, title, group, surface, fn, ft, depth, iform=2, fn_last=0.0, ft_last=0.0,
                 start=0.0, stop=0.0):
        """TYPE8 with the columns of this deck's version from 110 on."""
        force = self.units.force_per_length
        self.block(
            f"/INTER/TYPE8/{ident}", title,
            "# grnd_IDs  surf_IDm               Iform", card(group, surface, None, iform),
            "#                 Fn                  Ft               Depth              Tstart               Tstop",
            card(fn * force, ft * force, depth * self.units.length, start, stop),
        )
        if self.version >= 2022:
            self.lines += ["#            Fn_last             Ft_last", card(fn_last * force, ft_last * force)]
        else:
            self.lines += [""]

    def histories(self, interfaces):
        self.block("/TH/INTER/1", "drawbead forces", "#     var1", "DEF", "#     Obj1", *id_list(interfaces))


class Fragment(Deck):
    """Lines of an included file: no frame of its own. Some releases of the solver lose the last block of an
    include that does not end with #enddata."""

    def __init__(self, units, about):
        self.units, self.lines = units, list(about)

    def text(self):
        return "\n".join([*self.lines, "#enddata", ""])


def trapezoid(start, rise, hold, fall, peak):
    """Speed that grows from 0 to `peak`, stays and falls again; it covers peak * (rise / 2 + hold + fall / 2)."""
    t1, t2, t3 = start + rise, start + rise + hold, start + rise + hold + fall
    points = [(0.0, 0.0), (start, 0.0), (t1, peak), (t2, peak), (t3, 0.0)]
    return [point for i, point in enumerate(points) if i == 0 or point != points[i - 1]]


# The binder comes down by 2.5 mm within 5 ms, then the strip is pulled.
CLOSING = trapezoid(0.0, 0.0025, 0.0, 0.0025, -1000.0) + [(1.0, 0.0)]
PULLING = [(0.0, 0.0), (0.005, 0.0), (0.007, 1000.0), (1.0, 1000.0)]


class Bead:
    def __init__(self, title, points, first_node, **values):
        self.title, self.points, self.values = title, points, values
        self.nodes = {first_node + i: point for i, point in enumerate(points)}


def strip(name, about, beads, length=100.0, width=50.0, element=5.0, thickness=1.0, units=MM, version=2022,
          closing=tuple(CLOSING), pulling=tuple(PULLING), side=None, hold_blank=False, flip=lambda x, y: False,
          group_kind="NODENS", material="tabulated", binder_gap=3.0,
          include_mesh=False, submodel=False):
    """A flat sheet held flat by /BCS, a rigid binder above it that carries the beads, and a pull along x.

    Returns {file name: text}; the bead nodes are `binder_gap` above the sheet unless a bead says otherwise.
    """
    files = {}
    deck = Deck(name, about, version, units)
    blank = sheet(steps(0.0, length, element), steps(0.0, width, element))
    blank.shells = [
        (ident, corners[::-1] if flip(*centre(blank, corners)) else corners) for ident, corners in blank.shells
    ]
    binder = sheet(steps(0.0, length, 4 * element), steps(0.0, width, 2 * element), lambda x, y: binder_gap,
                   first_node=20001, first_shell=20001)
    binder_main = 29999

    deck.section("Materials, properties and parts")
    getattr(deck, material)(STEEL, "cold-rolled steel")
    deck.elastic(TOOL_STEEL, "tool steel")
    deck.shell_property(BLANK, "blank", thickness, 5)
    deck.shell_property(BINDER, "binder", 1.0, 1)
    deck.part(BLANK, "blank", BLANK, STEEL)
    deck.part(BINDER, "binder", BINDER, TOOL_STEEL)

    deck.section("Mesh: blank, binder, bead nodes")
    target = deck
    if include_mesh:
        mesh_file = f"{name}_mesh.inc"
        deck.lines += [f"#include {mesh_file}"]
        target = Fragment(units, [f"# Mesh of the blank and the binder of {name}_0000.rad"])
        files[mesh_file] = target
    target.nodes(blank.nodes)
    target.nodes({**binder.nodes, binder_main: (length / 2, width / 2, binder_gap + 10.0)})
    target.shells(BLANK, blank)
    target.shells(BINDER, binder)

    bead_groups = []
    if submodel:
        offset_of_groups, offset_of_nodes = 1000, 50000
        bead_file = f"{name}_beads.inc"
        inner = Fragment(units, ["# Bead lines, numbered from 1: the submodel that reads this file shifts the ids"])
        for index, bead in enumerate(beads, start=1):
            first = 1 + 100 * (index - 1)
            bead.nodes = {first + i: point for i, point in enumerate(bead.points)}
            inner.nodes(bead.nodes)
            inner.group(group_kind, index, bead.title, bead.nodes)
            bead_groups.append(offset_of_groups + index)
        files[bead_file] = inner
        deck.lines += [
            "//SUBMODEL/1", "bead lines",
            "#  off_def   off_nod   off_ele  off_part   off_mat  off_type   off_sub",
            card(offset_of_groups, offset_of_nodes, 0, 0, 0, 0, 0),
            f"#include {bead_file}", "//ENDSUB",
        ]
    else:
        merged = {}
        for bead in beads:
            merged.update(bead.nodes)
        deck.nodes(merged)

    deck.section("Node groups and the main surface")
    if not submodel:
        for index, bead in enumerate(beads, start=101):
            deck.group(group_kind, index, bead.title, bead.nodes)
            bead_groups.append(index)
    deck.group("PART", BLANK_NODES, "blank", [BLANK])
    deck.group("PART", BINDER_NODES, "binder mesh", [BINDER])
    deck.group("GRNOD", BINDER_NODES + 1, "binder with its beads", [BINDER_NODES, *bead_groups])
    deck.group("NODE", BINDER_NODES + 2, "main node of the binder", [binder_main])
    deck.surface(BLANK, "blank, normals towards the beads", BLANK)

    deck.section("Binder: a rigid body, closed by an imposed velocity")
    deck.rigid_body(BINDER, "binder", binder_main, BINDER_NODES + 1)
    deck.function(CLOSE, "speed of the binder, mm/s", closing)
    deck.velocity(1, "binder closes", CLOSE, "Z", BINDER_NODES + 2)
    deck.fixed(1, "binder guided", ("010" if side else "110") + " 111", BINDER_NODES + 2)
    if side:
        deck.function(SIDE, "sideways speed of the binder, mm/s", side)
        deck.velocity(3, "binder slides", SIDE, "X", BINDER_NODES + 2)

    deck.section("Blank: held flat, pulled along x")
    deck.fixed(2, "blank held flat", "001 110", BLANK_NODES)
    if hold_blank:
        deck.group("NODE", HELD_NODES, "held edge", blank.where(lambda x, y, z: x == 0.0))
        deck.fixed(3, "edge held", "110 001", HELD_NODES)
    else:
        deck.group("NODE", PULLED_NODES, "pulled edge", blank.where(lambda x, y, z: x == length))
        deck.function(PULL, "speed of the pulled edge, mm/s", pulling)
        deck.velocity(2, "edge pulled", PULL, "X", PULLED_NODES)

    deck.section("Drawbeads")
    interfaces = range(1, len(bead_groups) + 1)
    for ident, group, bead in zip(interfaces, bead_groups, beads):
        deck.drawbead(ident, bead.title, group, BLANK, **bead.values)
    deck.histories(interfaces)
    return {f"{name}_0000.rad": deck.text(), **{key: fragment.text() for key, fragment in files.items()}}


def centre(mesh, corners):
    points = [mesh.nodes[n] for n in corners]
    return sum(p[0] for p in points) / 4, sum(p[1] for p in points) / 4


def across(x, y0, y1, z=3.0, step=5.0):
    return straight((x, y0, z), (x, y1, z), step)


def strip_straight():
    return strip(
        "strip_straight",
        ["A strip of 100 mm x 50 mm is pulled across one straight bead of 11 nodes.",
         "Limits: Ft 80 N/mm over 50 mm = 4000 N, Fn 60 N/mm = 3000 N."],
        [Bead("bead across the strip", across(42.5, 0, 50), 10001, fn=60.0, ft=80.0, depth=2.0)],
    )


def strip_linear():
    return strip(
        "strip_linear",
        ["The restraint grows along the bead from Ft 40 N/mm to 120 N/mm: mean 80 N/mm, 4000 N in total."],
        [Bead("bead with linear restraint", across(42.5, 0, 50), 10001, fn=60.0, ft=40.0, depth=2.0, fn_last=60.0,
              ft_last=120.0)],
    )


def strip_two_pieces():
    left, right = across(42.5, 10, 30), across(42.5, 90, 110)
    return strip(
        "strip_two_pieces",
        ["Two beads of 20 mm with a hole of 60 mm between them, all in one node group: the hop counts as bead",
         "length at both its ends, which adds 80 N/mm x 60 mm = 4800 N to the intended 3200 N."],
        [Bead("two beads in one list", left + right, 10001, fn=60.0, ft=80.0, depth=2.0)], width=120.0,
    )


def half_flipped():
    return strip(
        "half_flipped",
        ["strip_straight with half of the shells reversed (y > 25): their normals face away from the bead, which",
         "then acts with its full force at any distance and pulls the blank to itself."],
        [Bead("bead across the strip", across(42.5, 0, 50), 10001, fn=60.0, ft=80.0, depth=2.0)],
        flip=lambda x, y: y > 25.0,
    )


def strip_mm():
    return strip(
        "strip_mm",
        ["The same strip as strip_si, in Mg, mm, s. Fn/DEPTH = 100 is below 0.2 E t = 42 000: the slope stays."],
        [Bead("bead across the strip", across(42.5, 0, 50), 10001, fn=100.0, ft=80.0, depth=1.0)],
    )


def strip_si():
    return strip(
        "strip_si",
        ["The same strip as strip_mm, in kg, m, s. Fn/DEPTH = 1e8 is above 0.2 E t = 4.2e7: the slope is reset,",
         "although nothing but the unit system has changed."],
        [Bead("bead across the strip", across(42.5, 0, 50), 10001, fn=100.0, ft=80.0, depth=1.0)], units=SI,
    )


def slow_viscous():
    return strip(
        "slow_viscous",
        ["Viscous form (Iform 1), pulled at 100 mm/s: a small part of Ft is reached, since the force grows with",
         "the speed up to the limit."],
        [Bead("bead with the viscous form", across(42.5, 0, 50), 10001, fn=60.0, ft=100.0, depth=2.0, iform=1)],
        pulling=[(0.0, 0.0), (0.005, 0.0), (0.007, 100.0), (1.0, 100.0)],
    )


def moving_tool():
    return strip(
        "moving_tool",
        ["The blank is held at rest and the binder with its bead slides over it at 200 mm/s: the solver takes the",
         "blank's own velocity for the slip and gives no restraint at all."],
        [Bead("bead on the sliding binder", across(62.5, 0, 50), 10001, fn=60.0, ft=80.0, depth=2.0)],
        side=[(0.0, 0.0), (0.005, 0.0), (0.007, -200.0), (0.1, -200.0), (0.102, 0.0), (1.0, 0.0)], hold_blank=True,
    )


def lift_return():
    closing = CLOSING[:-1] + [(0.010, 0.0)]
    lifting = [(0.0125, 1600.0), (0.015, 0.0), (0.020, 0.0), (0.0225, -1600.0), (0.025, 0.0), (1.0, 0.0)]
    pulling = [(0.0, 0.0), (0.005, 0.0), (0.007, 500.0), (0.009, 0.0), (1.0, 0.0)]
    return strip(
        "lift_return",
        ["The binder closes, the strip is pulled, the binder lifts off by 4 mm at 10 ms and comes back at 20 ms.",
         "The restraint stored before the lift acts again at the return (incremental form)."],
        [Bead("bead on the returning binder", across(42.5, 0, 50), 10001, fn=60.0, ft=80.0, depth=2.0)],
        closing=closing + lifting, pulling=pulling,
    )


def sorted_group():
    return strip(
        "sorted_group",
        ["The bead is a /GRNOD/NODE, which the Starter sorts: it refuses the interface with error 112.",
         "/GRNOD/NODENS keeps the order."],
        [Bead("bead in a sorted group", across(42.5, 0, 50), 10001, fn=60.0, ft=80.0, depth=2.0)],
        group_kind="NODE",
    )


def old_version():
    return strip(
        "old_version",
        ["/BEGIN says 110, but Fn and Depth stand in the columns that only versions from 130 on read: they are",
         "dropped without a word, and a bead without depth acts at any distance."],
        [Bead("bead of an old deck", across(42.5, 0, 50), 10001, fn=60.0, ft=80.0, depth=2.0)],
        version=110, material="elastic",
    )


def with_includes():
    return strip(
        "with_includes",
        ["The mesh is an include; the bead lines stand in a submodel with offsets: its group 1 is 1001 here, its",
         "node 1 is 50001. Two beads, 30 mm apart."],
        [Bead("first bead", across(32.5, 0, 50), 0, fn=60.0, ft=80.0, depth=2.0),
         Bead("second bead", across(62.5, 0, 50), 0, fn=60.0, ft=60.0, depth=2.0)],
        include_mesh=True, submodel=True,
    )


def two_sided():
    """Its own tools: an upper and a lower binder."""
    name = "two_sided"
    deck = Deck(name, ["A bead above the blank and one below it share the surface of the blank: for one of them every",
                       "normal faces away. Each side needs a surface of its own."])
    blank = sheet(steps(0.0, 100.0, 5.0), steps(0.0, 50.0, 5.0))
    upper = Bead("bead of the upper binder", across(32.5, 0, 50, 3.0), 10001, fn=60.0, ft=80.0, depth=2.0)
    lower = Bead("bead of the lower binder", across(67.5, 0, 50, -3.0), 10101, fn=60.0, ft=80.0, depth=2.0)

    deck.section("Materials, properties and parts")
    deck.tabulated(STEEL, "cold-rolled steel")
    deck.elastic(TOOL_STEEL, "tool steel")
    deck.shell_property(BLANK, "blank", 1.0, 5)
    deck.shell_property(BINDER, "tools", 1.0, 1)
    deck.part(BLANK, "blank", BLANK, STEEL)
    deck.part(BINDER, "upper binder", BINDER, TOOL_STEEL)
    deck.part(DIE, "lower binder", BINDER, TOOL_STEEL)

    deck.section("Mesh: blank, binders, bead nodes")
    deck.nodes(blank.nodes)
    deck.shells(BLANK, blank)
    for part, x0, z, first, main in ((BINDER, 20.0, 3.0, 20001, 29999), (DIE, 55.0, -3.0, 30001, 39999)):
        x1 = x0 + 25.0
        tool = sheet(steps(x0, x1, 12.5), steps(0.0, 50.0, 12.5), lambda x, y, z=z: z, first_node=first,
                     first_shell=first)
        deck.nodes({**tool.nodes, main: ((x0 + x1) / 2, 25.0, z + math.copysign(10.0, z))})
        deck.shells(part, tool)
    deck.nodes({**upper.nodes, **lower.nodes})

    deck.section("Node groups and the main surface")
    deck.group("PART", BLANK_NODES, "blank", [BLANK])
    deck.group("NODE", PULLED_NODES, "pulled edge", blank.where(lambda x, y, z: x == 100.0))
    deck.surface(BLANK, "blank", BLANK)
    deck.fixed(2, "blank held flat", "001 110", BLANK_NODES)
    deck.function(PULL, "speed of the pulled edge, mm/s", PULLING)
    deck.velocity(9, "edge pulled", PULL, "X", PULLED_NODES)

    deck.section("Binders: rigid bodies that close from above and from below")
    deck.function(CLOSE, "speed of the upper binder, mm/s", CLOSING)
    deck.function(CLOSE + 10, "speed of the lower binder, mm/s", [(t, 0.0 if v == 0 else -v) for t, v in CLOSING])
    for index, (part, title, bead, main) in enumerate(
        ((BINDER, "upper binder", upper, 29999), (DIE, "lower binder", lower, 39999))
    ):
        deck.group("NODENS", 101 + index, bead.title, bead.nodes)
        mesh, rigid, main_group = (ident + 10 * part for ident in (0, 1, 2))
        deck.group("PART", mesh, title + " mesh", [part])
        deck.group("GRNOD", rigid, title + " with its bead", [mesh, 101 + index])
        deck.group("NODE", main_group, "main node of the " + title, [main])
        deck.rigid_body(part, title, main, rigid)
        deck.velocity(1 + index, title + " closes", CLOSE + 10 * index, "Z", main_group)
        deck.fixed(10 + index, title + " guided", "110 111", main_group)

    deck.section("Drawbeads")
    deck.drawbead(1, upper.title, 101, BLANK, **upper.values)
    deck.drawbead(2, lower.title, 102, BLANK, **lower.values)
    deck.histories([1, 2])
    return {f"{name}_0000.rad": deck.text()}


class Tool:
    """A rigid tool: its mesh, its main node, the bead groups it carries, and its motion in z (None: fixed)."""

    def __init__(self, part, title, mesh, main, motion=None, beads=()):
        self.part, self.title, self.mesh, self.main = part, title, mesh, main
        self.motion, self.beads = motion, beads


def press(name, about, blank, thickness, material, tools, beads, groups):
    """A deep-drawing deck: blank between rigid tools with contact, beads on the binder.

    `groups` is a list of (id, title, nodes, interface values): one drawbead interface each.
    """
    deck = Deck(name, about)
    deck.section("Materials, properties and parts")
    getattr(deck, material)(STEEL, "cold-rolled steel")
    deck.elastic(TOOL_STEEL, "tool steel")
    deck.shell_property(BLANK, "blank", thickness, 5)
    deck.shell_property(BINDER, "tools", 1.0, 1)
    deck.part(BLANK, "blank", BLANK, STEEL)
    for tool in tools:
        deck.part(tool.part, tool.title, BINDER, TOOL_STEEL)

    deck.section("Blank")
    deck.nodes(blank.nodes)
    deck.shells(BLANK, blank)
    for tool in tools:
        deck.section(f"Tool: {tool.title}")
        deck.nodes({**tool.mesh.nodes, tool.main[0]: tool.main[1]})
        deck.shells(tool.part, tool.mesh)
    deck.section("Bead lines, carried by the binder")
    deck.nodes({node: point for bead in beads for node, point in bead.nodes.items()})
    for ident, title, nodes, _ in groups:
        deck.group("NODENS", ident, title, nodes)

    deck.section("Node groups, surfaces, rigid bodies, motion")
    deck.group("PART", BLANK_NODES, "blank", [BLANK])
    deck.surface(BLANK, "blank, normals towards the binder", BLANK)
    for tool in tools:
        first = 10 * tool.part
        carried = [ident for ident, _, _, _ in groups] if tool.beads else []
        deck.group("PART", first, f"{tool.title} mesh", [tool.part])
        deck.group("GRNOD", first + 1, f"{tool.title} rigid body", [first, *carried])
        deck.group("NODE", first + 2, f"main node of the {tool.title}", [tool.main[0]])
        deck.surface(tool.part, tool.title, tool.part)
        deck.rigid_body(tool.part, tool.title, tool.main[0], first + 1)
        deck.fixed(tool.part, f"{tool.title} guided", ("110" if tool.motion else "111") + " 111", first + 2)
        if tool.motion:
            deck.function(100 + tool.part, f"speed of the {tool.title}, mm/s", tool.motion)
            deck.velocity(tool.part, f"{tool.title} moves", 100 + tool.part, "Z", first + 2)

    deck.section("Contact of the blank with the tools")
    for tool in tools:
        deck.contact(10 + tool.part, f"blank to {tool.title}", BLANK_NODES, tool.part, thickness / 2)
    deck.section("Drawbeads")
    interfaces = range(1, len(groups) + 1)
    for ident, (group, title, _, values) in zip(interfaces, groups):
        deck.drawbead(ident, title, group, BLANK, **values)
    deck.histories(interfaces)
    return {f"{name}_0000.rad": deck.text()}


def arc(centre_x, centre_z, radius, start, stop, count=4):
    """Points of a circle in the x-z plane, angles in degrees, the first one left out."""
    angles = [math.radians(start + (stop - start) * i / count) for i in range(1, count + 1)]
    return [(centre_x + radius * math.cos(a), centre_z + radius * math.sin(a)) for a in angles]


def u_channel():
    half = [(28.0, -40.0), (28.0, -6.0)] + arc(34.0, -6.0, 6.0, 180.0, 90.0) + [(70.0, 0.0), (100.0, 0.0)]
    shoulder = [(x, z - 0.5) for x, z in half]  # the die touches the lower side of a blank of t = 0.8 with 0.1 to spare
    profile = [(-x, z) for x, z in reversed(shoulder)] + shoulder
    floor = [(-27.0, 40.0), (-27.0, 6.5)] + arc(-22.0, 6.5, 5.0, 180.0, 270.0)
    punch = floor + [(-x, z) for x, z in reversed(floor)]
    ys = [0.0, 25.0, 50.0]
    beads = [
        Bead("bead of the left shoulder", across(-62.5, 2.5, 47.5), 10001),
        Bead("bead of the right shoulder", across(62.5, 2.5, 47.5), 10101),
    ]
    values = dict(fn=75.0, ft=100.0, depth=2.0)
    binder = sheet([-100.0, -80.0, -60.0, -40.0, 40.0, 60.0, 80.0, 100.0], ys, lambda x, y: 3.0,
                   lambda x, y: abs(x) > 40.0, 20001, 20001)
    blank = sheet(steps(-90.0, 90.0, 5.0), steps(0.0, 50.0, 5.0))
    tools = [
        Tool(BINDER, "binder", binder, (29999, (0.0, 25.0, 20.0)),
             trapezoid(0.0, 0.0026, 0.0, 0.0026, -1000.0) + [(1.0, 0.0)], beads),
        Tool(DIE, "die", extruded(profile, ys, 30001, 30001), (39999, (0.0, 25.0, -60.0))),
        Tool(PUNCH, "punch", extruded(punch, ys, 40001, 40001), (49999, (0.0, 25.0, 50.0)),
             trapezoid(0.0052, 0.002, 0.0288, 0.002, -1000.0) + [(1.0, 0.0)]),
    ]
    about = ["A channel is drawn over two shoulders with a bead on each: t = 0.8 mm, Ft 100 N/mm, 45 mm per bead.",
             "The scene is symmetric, so both beads give the same force and the same draw-in."]
    groups = [(101 + i, bead.title, bead.nodes, values) for i, bead in enumerate(beads)]
    return press("u_channel", about, blank, 0.8, "hill_tabulated", tools, beads, groups)


def ring_beads(name, about, closing_node):
    radius, count = 100.0, 72
    points = []
    for i in range(count):
        angle = 2 * math.pi * i / count
        points.append((round(radius * math.cos(angle), 6), round(radius * math.sin(angle), 6), 3.0))
    if closing_node:
        points.append(points[0])
    bead = Bead("ring of R 100", points, 10001)
    values = dict(fn=75.0, ft=100.0, depth=2.0)
    blank = sheet(steps(-150.0, 150.0, 10.0), steps(-150.0, 150.0, 10.0))
    flange = [75.0, 100.0, 125.0, 150.0]
    tools = [
        Tool(BINDER, "binder", disc_ring(flange, 36, 3.0, 20001, 20001), (29999, (0.0, 0.0, 20.0)), CLOSING, [bead]),
        Tool(DIE, "die", disc_ring(flange, 36, -0.6, 30001, 30001), (39999, (0.0, 0.0, -60.0))),
        Tool(PUNCH, "punch", disc_ring([10.0, 30.0, 50.0], 36, 0.6, 40001, 40001), (49999, (0.0, 0.0, 50.0)),
             trapezoid(0.005, 0.002, 0.03, 0.002, -1000.0) + [(1.0, 0.0)]),
    ]
    return press(name, about, blank, 1.0, "tabulated", tools, [bead], [(101, bead.title, bead.nodes, values)])


def ring_closed():
    return ring_beads(
        "ring_closed",
        ["A cup with a circular bead of R 100 in 72 steps, Ft 100 N/mm. The ring is closed by a node of its own that",
         "coincides with the first; repeating the first id would stop the Engine.",
         "The chords are shorter than the arc by 1 - sin(5 deg)/(5 deg) = 0.13 %."], True,
    )


def ring_open():
    return ring_beads(
        "ring_open",
        ["ring_closed without its closing node: the last step of the ring, 8.7 mm of bead, carries no force."], False,
    )


def corner_90():
    corner = (22.5, 22.5, 3.0)
    points = straight((22.5, 77.5, 3.0), corner, 5.0) + straight(corner, (77.5, 22.5, 3.0), 5.0)[1:]
    return strip(
        "corner_90",
        ["An L-shaped bead with one node at the corner: its tributary length is the chord across the corner, 29 %",
         "short of the two half steps beside it."],
        [Bead("bead around the corner", points, 10001, fn=60.0, ft=80.0, depth=2.0)], width=100.0,
    )


def crown(x, y):
    """The gently curved hood blank, mm."""
    return 30.0 - x * x / 3000.0 - y * y / 2000.0


def above_crown(x, y, distance):
    """The point at `distance` from the blank over (x, y), along its normal."""
    nx, ny = x / 1500.0, y / 1000.0
    length = math.sqrt(nx * nx + ny * ny + 1.0)
    return tuple(round(c + distance * n / length, 6) for c, n in zip((x, y, crown(x, y)), (nx, ny, 1.0)))


def hood_scene(name, about, one_list):
    blank = sheet(steps(-192.0, 192.0, 8.0), steps(-136.0, 136.0, 8.0), crown)
    front = [-108.0 + 6.0 * i for i in range(37)]
    runs = [
        ("left bead", [(-150.0, 70.0 - 6.0 * i) for i in range(25)], 150.0),
        ("front bead", [(x, -112.0 + 8.0 * (x / 108.0) ** 2) for x in front], 90.0),
        ("right bead", [(150.0, -74.0 + 6.0 * i) for i in range(25)], 150.0),
    ]
    beads = []
    for index, (title, line, ft) in enumerate(runs):
        values = dict(fn=round(0.75 * ft, 3), ft=ft, depth=2.0)
        beads.append(Bead(title, [above_crown(x, y, 3.0) for x, y in line], 10001 + 100 * index, **values))

    def tool_sheet(distance, first, keep):
        return sheet(steps(-192.0, 192.0, 24.0), steps(-136.0, 136.0, 27.2), lambda x, y: crown(x, y) + distance, keep,
                     first, first)

    def opening(x, y):
        return abs(x) < 120.0 and abs(y) < 81.6

    def flange(x, y):
        return not opening(x, y)

    tools = [
        Tool(BINDER, "binder", tool_sheet(3.2, 20001, flange), (29999, (0.0, 0.0, 60.0)), CLOSING, beads),
        Tool(DIE, "die", tool_sheet(-0.8, 30001, flange), (39999, (0.0, 0.0, -60.0))),
        Tool(PUNCH, "punch", tool_sheet(0.8, 40001, opening), (49999, (0.0, 0.0, 90.0)),
             trapezoid(0.005, 0.002, 0.018, 0.002, -1000.0) + [(1.0, 0.0)]),
    ]
    if one_list:
        nodes = [node for bead in beads for node in bead.nodes]
        groups = [(101, "hood beads", nodes, dict(fn=90.0, ft=120.0, depth=2.0))]
    else:
        groups = [(101 + i, bead.title, bead.nodes, bead.values) for i, bead in enumerate(beads)]
    return press(name, about, blank, 1.0, "johnson", tools, beads, groups)


def hood():
    return hood_scene(
        "hood",
        ["Draw shell of a hood: a gently curved blank and three bead runs, each with an interface of its own.",
         "Ft 150 N/mm left and right, 90 N/mm in front."], False,
    )


def hood_one_list():
    return hood_scene(
        "hood_one_list",
        ["The three bead runs of the hood in one list, which the manual warns of: the hops between the runs count as",
         "bead length at both their ends."], True,
    )


SCENES = [strip_straight, strip_linear, strip_two_pieces, u_channel, hood, hood_one_list, ring_closed, ring_open,
          corner_90, half_flipped, strip_mm, strip_si, slow_viscous, moving_tool, lift_return, sorted_group,
          old_version, with_includes, two_sided]


def main(arguments):
    if arguments not in ([], ["--check"]):
        print(f"usage: {Path(__file__).name} [--check]", file=sys.stderr)
        return 2
    wanted = {}
    for scene in SCENES:
        wanted.update(scene())
    present = {path.name for pattern in ("*_0000.rad", "*.inc") for path in FOLDER.glob(pattern)}
    if arguments:
        differing = [n for n, text in wanted.items() if n not in present or (FOLDER / n).read_bytes() != text.encode()]
        stale = sorted(present - wanted.keys())
        for name in differing:
            print(f"{name}: differs from what make_samples.py writes", file=sys.stderr)
        for name in stale:
            print(f"{name}: not written by make_samples.py", file=sys.stderr)
        return 1 if differing or stale else 0
    for name in sorted(present - wanted.keys()):
        (FOLDER / name).unlink()
    for name, text in wanted.items():
        (FOLDER / name).write_bytes(text.encode())
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
