"""`evaluate` and `plan` from outside: recorded runs come out, scenes and their errors, outputs and their readers."""

import csv
import gzip
import json
import unittest
import xml.etree.ElementTree as ElementTree

import jsonschema
import meshio

from support import ROOT, SAMPLES, CommandLineTest, tiny
from test_schema import loads, strict

TRUTH = ROOT / "tests" / "truth"


def scene(name):
    return TRUTH / name / f"{name}_0000.rad", TRUTH / name / "trace.csv.gz"


def schema(name):
    return json.loads((ROOT / "schemas" / f"{name}.schema.json").read_text())


def cells(*values):
    return "".join(f"{value:>10}" for value in values) + "\n"


def reals(*values):
    return "".join(f"{value:>20}" for value in values) + "\n"


# The tiny deck with a blank that stands still and a bead that the cards to be added move.
HELD_BLANK = "/GRNOD/NODE/5\nblank nodes\n" + cells(1, 2, 3, 4) + "/BCS/5\nheld\n   111 111" + cells(0, 5)
FUNCTION = "/FUNCT/1\nramp\n" + reals(0.0, 0.0) + reals(1.0, 1.0)


def moved(*blocks, keep_bead_held=False):
    text = tiny()
    if not keep_bead_held:
        text = text.replace("   111 111         0         1\n", "   111 111         0         9\n")
    return text.replace("/END\n", HELD_BLANK + FUNCTION + "".join(blocks) + "/END\n")


class Evaluate(CommandLineTest):
    def rows(self, path, law="solver"):
        with open(path, newline="") as file:
            return [row for row in csv.DictReader(file) if row["law"] == law]

    def evaluate(self, text, *options):
        path = self.write("scene.yaml", text)
        status, out, err = self.run_tool("evaluate", path, "--format", "json", *options)
        self.assertEqual((status, err), (0, ""))
        return loads(out)

    def positions(self, deck, *options, end="1"):
        """z of the first bead node at the end, as the deck moves it."""
        self.write("d_0000.rad", deck)
        status, out, err = self.run_tool("evaluate", "d_0000.rad", "--end", end, "--steps", "4", "--csv", "d.csv",
                                         "--format", "json", *options)
        self.assertEqual((status, err), (0, ""))
        return float(self.rows(self.folder / "d.csv")[-1]["zi"]), loads(out)

    def refused_scene(self, text, message):
        with self.subTest(text):
            self.write("scene.yaml", text)
            status, out, err = self.run_tool("evaluate", "scene.yaml")
            self.assertEqual((status, out), (2, ""))
            self.assertIn(message, err)

    def refused(self, deck):
        self.write("d_0000.rad", deck)
        status, out, err = self.run_tool("evaluate", "d_0000.rad", "--end", "1")
        self.assertEqual((status, out), (2, ""))
        return err

    def test_numbers_out_of_range_are_no_result(self):
        text = tiny()
        card = "                50.0                20.0                 2.0"
        self.assertIn(card, text)
        self.write("d_0000.rad", text.replace(card, "               1e300               1e300                 9.0"))
        scene_file = self.write("scene.yaml", """deck: d_0000.rad
law: solver
time: {end: 1e-200, steps: 10}
output: {csv: out.csv}
motion:
  - move: {surface: 1}
    velocity: {y: 1e200}
""")
        status, out, err = self.run_tool("evaluate", scene_file)
        self.assertEqual((status, out), (2, ""))
        self.assertRegex(err, r"scene\.yaml: error: interface 7, law solver: numbers leave the range of a double in the "
                              r"energies; look for a limit, stiffness, mass or motion that is far too large")
        self.assertFalse((self.folder / "out.csv").exists())

    def test_recorded_runs(self):
        for name in ("n2_two_thick_reset", "j_window", "win_late", "twoside_bad", "m_sh3n"):
            with self.subTest(name):
                deck, trace = scene(name)
                ours = self.folder / "ours.csv"
                status, _, err = self.run_tool("evaluate", deck, "--trace", trace, "--law", "solver", "--csv", ours)
                self.assertEqual((status, err), (0, ""))
                by_key = {(r["ncycle"], r["nin"], r["inod"]): r for r in self.rows(ours)}
                with gzip.open(trace, "rt") as file:
                    theirs = list(csv.DictReader(file))
                scale = max(abs(float(r[c])) for r in theirs for c in ("fnx", "fny", "fnz", "ftx", "fty", "ftz"))
                for row in theirs:
                    own = by_key[row["ncycle"], row["nin"], row["inod"]]
                    for column in ("node", "seg_n1", "seg_n2", "seg_n3", "seg_n4"):
                        self.assertEqual(own[column], row[column])
                    for column in ("fx", "fy", "fz", "fnx", "fny", "fnz", "ftx", "fty", "ftz"):
                        self.assertLessEqual(abs(float(own[column]) - float(row[column])), 1e-9 * scale)

    def test_same_bytes_with_any_number_of_threads(self):
        text = f"""
deck: {SAMPLES / 'hood_0000.rad'}
time: {{end: 1.0e-2, steps: 50}}
output: {{csv: out.csv}}
motion:
  - move: {{surface: 1}}
    velocity: {{x: [[0, 0], [5e-3, 1500], [1e-2, 0]], y: 300}}
  - move: {{interface: [1, 2, 3], side: secondary}}
    displacement: {{z: [[0, 0], [1e-2, -6]]}}
"""
        results = []
        for threads in (1, 2, 4):
            report = self.evaluate(text, "-j", threads)
            results.append((report, (self.folder / "out.csv").read_bytes()))
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])
        report = results[0][0]
        jsonschema.Draft7Validator(strict(schema("evaluation"))).validate(report)
        self.assertEqual([bead["interface"] for bead in report["beads"]], [1, 2, 3])
        self.assertEqual(report["tools"][0]["interfaces"], [1, 2, 3])
        self.assertGreater(report["tools"][0]["sums"][0]["normal"]["value"], 0)
        for bead in report["beads"]:
            self.assertIsNotNone(bead["restraint_difference"])

    def test_prove(self):
        deck, trace = scene("half")
        status, out, err = self.run_tool("evaluate", deck, "--trace", trace, "--prove")
        self.assertEqual((status, err), (0, ""))
        proof = out[out.index("\nproof\n"):]
        self.assertIn("interface 1, law solver: the same bits with all effects\n", proof)
        self.assertIn("interface 1, law manual: the same bits with all effects\n", proof)
        self.assertIn("  window: 0 planned, 69 with all\n", proof)
        status, out, _ = self.run_tool("evaluate", deck, "--trace", trace, "--force-effects", "window,variation")
        self.assertEqual((status, out.count("FORCED")), (0, 4))
        rows = []
        for more in ([], ["--force-effects", "all"]):
            self.run_tool("evaluate", deck, "--trace", trace, "--csv", "rows.csv", *more)
            rows.append((self.folder / "rows.csv").read_bytes())
        self.assertEqual(*rows)
        self.assert_usage_error("--force-effects knows no 'windwo'; did you mean 'window'?", "evaluate", deck,
                                "--force-effects", "windwo")

    def test_plan(self):
        deck, _ = scene("a_closing")
        status, out, err = self.run_tool("plan", deck, "--end", "2e-6", "--format", "json", "--law", "solver")
        self.assertEqual((status, err), (0, ""))
        plan = loads(out)
        jsonschema.Draft7Validator(strict(schema("plan"))).validate(plan)
        effects = {e["name"]: e for e in plan["beads"][0]["laws"][0]["effects"]}
        self.assertEqual(effects["search"]["verdict"], "OFF")
        self.assertEqual(effects["search"]["reason"], "nearest approach 7.88 mm > DEPTH + t/2 = 5.5 mm")
        status, out, _ = self.run_tool("plan", deck, "--end", "1.6e-4", "--law", "solver")
        self.assertIn("approach down to -1.6 mm <= DEPTH + t/2 = 5.5 mm", out)

    def test_statistics(self):
        deck, trace = scene("twoside_bad")
        status, _, err = self.run_tool("evaluate", deck, "--trace", trace, "--statistics", "-q")
        self.assertEqual(status, 0)
        for line, law in zip(err.splitlines(), ("solver", "manual"), strict=True):
            self.assertRegex(line, rf"^law {law}: \d+ steps of bead nodes in \S+ s, \S+ ns each$")

    def test_vtu(self):
        deck, trace = scene("twoside_bad")
        status, _, err = self.run_tool("evaluate", deck, "--trace", trace, "--vtu", "series", "--csv", "rows.csv",
                                       "--every", 10)
        self.assertEqual((status, err), (0, ""))
        series = ElementTree.parse(self.folder / "series_solver.pvd").getroot().findall("Collection/DataSet")
        rows = self.rows(self.folder / "rows.csv")
        self.assertEqual([float(s.get("timestep")) for s in series], sorted({float(r["tt"]) for r in rows}))
        # Read by a library that knows nothing of drawbead.
        last = meshio.read(self.folder / series[-1].get("file"))
        rows = [r for r in rows if r["tt"] == rows[-1]["tt"]]
        vectors = lambda *columns: [[float(r[c]) for c in columns] for r in rows]
        self.assertEqual([n for (n,) in last.point_data["node"].tolist()], [int(r["node"]) for r in rows])
        self.assertEqual(last.point_data["force"].tolist(), vectors("fx", "fy", "fz"))
        self.assertEqual(last.points.tolist(), vectors("xi", "yi", "zi"))
        lines = {block.type: block.data.tolist() for block in last.cells}
        self.assertEqual(list(lines), ["line"])
        self.assertEqual(len(lines["line"]), len(rows) - 2)  # two beads

    def test_motion_of_the_deck(self):
        impdisp = ("/IMPDISP/1\ndown\n" + cells(1, "Z", 0, 0, 1) + reals(1.0, -2.0, 0.0, 0.0)
                   + "/BCS/8\nguided\n   110 111" + cells(0, 1))
        z, report = self.positions(moved(impdisp))
        self.assertAlmostEqual(z, 1.0)
        self.assertEqual(report["beads"][0]["nodes"], 3)

        body = ("/GRNOD/NODE/6\nmain\n" + cells(1000) + "/RBODY/1\ntool\n"
                + cells(1000, 0, 0, 0) .rstrip("\n") + f"{0.0:>20}" + cells(1) + reals(0, 0, 0) * 2 + cells(0)
                + "/BCS/8\nguided\n   110 111" + cells(0, 6)
                + "/IMPVEL/1\ndown\n" + cells(1, "Z", 0, 0, 6) + reals(2.0, -3.0, 0.0, 0.0))
        deck = moved(body).replace("/SHELL/1\n", "/NODE\n      1000" + reals(0.0, 0.0, 50.0) + "/SHELL/1\n")
        z, report = self.positions(deck)
        self.assertAlmostEqual(z, 3 - 3 * 0.25)  # v = 3 t/2
        self.assertEqual(report["beads"][0]["rigid_body"], 1)
        self.assertIn("may turn", self.refused(deck.replace("   110 111         0         6", "   110 000         0         6")))

        sensor = impdisp.replace(cells(1, "Z", 0, 0, 1), cells(1, "Z", 0, 3, 1))
        _, report = self.positions(moved(sensor))
        self.assertTrue(any("sensor 3 is ignored" in note for note in report["notes"]), report["notes"])

        skew = impdisp.replace(cells(1, "Z", 0, 0, 1), cells(1, "Z", 2, 0, 1))
        self.assertIn("/IMPDISP/1: directions of a skew or frame are not read", self.refused(moved(skew)))
        turning = impdisp.replace(cells(1, "Z", 0, 0, 1), cells(1, "ZZ", 0, 0, 1))
        self.assertIn("imposed rotations are not read", self.refused(moved(turning)))
        missing = impdisp.replace(cells(1, "Z", 0, 0, 1), cells(7, "Z", 0, 0, 1))
        self.assertIn("/FUNCT/7 is not defined", self.refused(moved(missing)))
        late = impdisp.replace(reals(1.0, -2.0, 0.0, 0.0), reals(1.0, -2.0, 0.5, 0.0))
        self.assertIn("does not act over the whole run", self.refused(moved(late)))
        self.assertIn("nothing in the deck prescribes its motion", self.refused(moved()))
        self.assertIn("it is free in Z", self.refused(moved(impdisp.split("/IMPDISP")[0] + "/BCS/8\nguided\n   110 111"
                                                           + cells(0, 1))))
        both = impdisp.replace("   110 111", "   111 111")
        self.assertIn("act in the same direction Z", self.refused(moved(both)))

    def test_initial_velocity_counts_in_the_first_cycle(self):
        inivel = ("/INIVEL/TRA/1\nkick\n" + reals(0.0, 1000.0, 0.0).rstrip("\n") + cells(5, 0))
        deck = moved(inivel, keep_bead_held=True).replace("                50.0                20.0                 2.0",
                                                          "                50.0                20.0                 9.0")
        self.write("d_0000.rad", deck)
        self.run_tool("evaluate", "d_0000.rad", "--end", "1", "--steps", "2", "--law", "solver", "--csv", "d.csv")
        restraint = [abs(float(r["fty"])) for r in self.rows(self.folder / "d.csv")]
        self.assertGreater(restraint[0], 0)
        self.assertEqual(restraint[-1], 0)

    def test_end_of_the_engine_deck(self):
        self.write("d_0000.rad", moved(keep_bead_held=True))
        self.assertIn("please give --end", self.run_tool("evaluate", "d_0000.rad")[2])
        self.write("d_0001.rad", "#RADIOSS ENGINE\n/RUN/d/1\n# end\n               0.002\n")
        status, out, _ = self.run_tool("evaluate", "d_0000.rad", "--format", "json")
        self.assertEqual((status, loads(out)["end"]), (0, 0.002))

    def test_the_deck_is_looked_at_before_its_end_is_asked_for(self):
        (self.folder / "folder").mkdir()
        self.write("binary.rad", bytes(range(256)) * 40)
        self.write("empty.rad", "")
        for name in "folder", "binary.rad", "empty.rad", "none.rad":
            status, out, err = self.run_tool("evaluate", name)
            self.assertEqual((status, out), (2, ""))
            self.assertIn(name, err)
            self.assertNotIn("--end", err)

    def test_initial_rotations_are_not_read_and_said_so(self):
        spin = "/INIVEL/ROT/3\nspin\n" + reals(0.0, 0.0, 5.0).rstrip("\n") + cells(5, 0)
        self.write("d_0000.rad", moved(spin, keep_bead_held=True))
        status, out, _ = self.run_tool("evaluate", "d_0000.rad", "--end", "1", "--steps", "2")
        self.assertEqual(status, 0)
        self.assertIn("note: /INIVEL/ROT/3: initial rotations are not read", out)

    def test_the_beads_of_a_tool_against_what_holds_it(self):
        body = ("/GRNOD/NODE/6\nmain\n" + cells(1000) + "/RBODY/1\ntool\n"
                + cells(1000, 0, 0, 0).rstrip("\n") + f"{0.0:>20}" + cells(1) + reals(0, 0, 0) * 2 + cells(0)
                + "/FUNCT/2\nforce\n" + reals(0.0, -1.0) + reals(1.0, -3.0)
                + "/CLOAD/4\npress\n" + cells(2, "Z", 0, 0, 6, 0).rstrip("\n") + reals(1.0, 100.0))
        deck = moved(body).replace("/SHELL/1\n", "/NODE\n      1000" + reals(0.0, 0.0, 50.0) + "/SHELL/1\n")
        self.write("d_0000.rad", deck)
        text = """deck: d_0000.rad
law: solver
time: {end: 1, steps: 100}
motion:
  - move: {interface: 7, side: secondary}
    displacement: {z: [[0, 0], [0.5, -3], [1, -3]]}
"""
        (tool,) = self.evaluate(text)["tools"]
        (total,) = tool["sums"]
        self.assertEqual(tool["rigid_body"], 1)
        time = total["normal"]["time"]
        self.assertGreater(time, 0.4)
        self.assertAlmostEqual(total["normal"]["value"], 300, 6)  # 50 N/mm over 6 mm
        self.assertAlmostEqual(total["holding"], 100 * (1 + 2 * time), 6)
        out = self.run_tool("evaluate", "scene.yaml")[1]
        self.assertIn(f"normal force up to 300 N at {time:g}, ", out.replace(" s, ", ", "))
        self.assertIn(" that hold it then", out)
        self.write("d_0000.rad", deck.replace("/CLOAD", "/CLOUD"))
        self.assertIsNone(self.evaluate(text)["tools"][0]["sums"][0]["holding"])

    def test_check_takes_motion_and_time_from_a_scene(self):
        self.write("d_0000.rad", moved(keep_bead_held=True))
        self.assertIn("KIN004", self.run_tool("check", "d_0000.rad", "--format", "concise")[1])
        text = """deck: d_0000.rad
time: {end: 1, steps: 10}
motion:
  - move: {interface: 7, side: secondary}
    displacement: {z: [[0, 0], [0.5, -3], [1, -3]], y: [[0, 0], [0.5, 0], [1, 2]]}
"""
        self.write("scene.yaml", text)
        status, out, _ = self.run_tool("check", "--scene", "scene.yaml", "--format", "concise")
        self.assertEqual(status, 1)
        self.assertIn("KIN003", out)
        self.assertNotIn("KIN004", out)
        self.write("scene.yaml", text.replace("interface: 7", "interface: 8"))
        status, out, err = self.run_tool("check", "--scene", "scene.yaml", "-q")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("scene.yaml:4:", err)
        self.assertIn("8 does not exist in the deck", err)
        status, _, err = self.run_tool("check", "--scene", "none.yaml")
        self.assertEqual(status, 2)
        self.assertIn("none.yaml", err)
        self.write("scene.yaml", text.replace("d_0000", "x_0000"))
        self.assertEqual(self.run_tool("check", "--scene", "scene.yaml")[0], 2)
        self.assert_usage_error("--scene names its deck itself; please leave out PATH or --scene",
                                "check", "--scene", "scene.yaml", "d_0000.rad")

    def test_errors_of_scenes(self):
        self.write("d_0000.rad", moved(keep_bead_held=True))
        good = "deck: d_0000.rad\ntime: {end: 1, steps: 10}\n"
        self.evaluate(good)
        move = good + "motion:\n  - move: {surface: 1}\n    "
        for text, message in {
                "dekc: x\n": "scene.yaml:1:1: error: unknown key 'dekc'; did you mean 'deck'?",
                "deck: d_0000.rad\n": "scene.yaml:1:1: error: key 'time' is missing",
                good + "law: slover\n": "scene.yaml:3:6: error: law knows no 'slover'; did you mean 'solver'?",
                good + "interfaces: [1, x]\n": "scene.yaml:3:17: error: interfaces needs a whole number, not 'x'",
                "deck: d_0000.rad\ntime: {end: -1, steps: 3}\n": "scene.yaml:2:13: error: end must be above 0",
                "deck: d_0000.rad\ntime: {end: 1}\n": "scene.yaml:2:7: error: time needs either step or steps beside end",
                good + "motion: [\n": "scene.yaml:4:1: error: ",
                move + "velocity: {x: 1e}\n": "scene.yaml:5:19: error: velocity x needs a number, not '1e'",
                move + "velocity: {w: 1}\n": "scene.yaml:5:16: error: unknown key 'w'; did you mean 'x'?",
                move + "velocity: {x: [[0, 0], [0, 1]]}\n": "scene.yaml:5:28: error: times must increase",
                move + "displacement: {z: 1}\n": "scene.yaml:5:23: error: a displacement starts at 0; "
                                                 "give a table [[0, 0], [time, value]]",
                move + "velocity: {x: [[0, 0], [0.5, 1]]}\n": "scene.yaml:5:19: error: the table does not cover the run",
                good + "motion:\n  - move: {surface: 9}\n    velocity: {x: 1}\n":
                    "scene.yaml:4:21: error: surface 9 does not exist in the deck",
                good + "motion:\n  - move: {interface: 7}\n    velocity: {x: 1}\n":
                    "scene.yaml:4:11: error: an interface needs a side: main or secondary",
                good + good: "error: key 'deck' stands twice",
        }.items():
            self.refused_scene(text, message)
        self.write("scene.yaml", good + "interfaces: 8\n")
        self.assertIn("no /INTER/TYPE8 with id 8", self.run_tool("evaluate", "scene.yaml")[2])

    def test_what_a_scene_names_and_the_deck_does_not_have(self):
        self.write("d_0000.rad", moved(keep_bead_held=True))
        good = "deck: d_0000.rad\ntime: {end: 1, steps: 10}\n"
        for text, message in {
                good + "interfaces: [7, 8]\n": "scene.yaml:3:13: error: no /INTER/TYPE8 with id 8; the deck has 7",
                good + "output: {nodes: [11, 5], csv: o.csv}\n": "scene.yaml:3:17: error: node 5 is no node of a bead",
                good + "---\nlaw: manual\n": "scene.yaml:3:1: error: a second document in the file",
                "": "scene.yaml: error: a scene is a map of keys; it begins with: deck: NAME_0000.rad",
        }.items():
            self.refused_scene(text, message)
        self.assertFalse((self.folder / "o.csv").exists())
        self.write("scene.yaml", good)
        status, _, err = self.run_tool("evaluate", "scene.yaml", "--end", "2")
        self.assertEqual(status, 2)
        self.assertIn("--end, --step, --steps and --trace are for decks, and this is a scene", err)

    def test_steps_and_cycles_have_a_limit(self):
        self.write("d_0000.rad", moved(keep_bead_held=True))
        status, _, err = self.run_tool("evaluate", "d_0000.rad", "--end", "1e-3", "--step", "1e-30")
        self.assertEqual(status, 2)
        self.assertIn("more than 1e8 steps", err)
        deck, trace = scene("gap_one")
        lines = gzip.open(trace, "rt").read().splitlines()
        column = lines[0].split(",").index("ncycle")
        for cycle in ("-5", "2000000000"):
            row = lines[1].split(",")
            row[column] = cycle
            self.write("t.csv", "\n".join([lines[0], ",".join(row), *lines[2:]]) + "\n")
            for command in (["audit", deck, "t.csv"], ["evaluate", deck, "--trace", "t.csv"]):
                status, _, err = self.run_tool(*command)
                self.assertEqual(status, 2, command)
                self.assertRegex(err, r"t\.csv:2:\d+: error: ncycle is '" + cycle + "', not a cycle from 0 to 100000000")

    def test_a_negative_restraint_at_rest_has_its_energy(self):
        deck, _ = scene("negft2")
        self.write("scene.yaml", f"deck: {deck}\nlaw: solver\ntime: {{end: 2.0e-4, steps: 1}}\nmotion: []\n")
        status, out, err = self.run_tool("evaluate", "scene.yaml", "--prove")
        self.assertEqual((status, err), (0, ""))
        self.assertIn("law solver: the same bits with all effects", out)

    def test_the_balance_begins_with_the_first_cycle(self):
        deck, trace = scene("negft2")
        _, out, _ = self.run_tool("evaluate", deck, "--trace", trace, "--law", "solver", "--format", "json")
        law = loads(out)["beads"][0]["laws"][0]["energy"]
        sums = [law[key] for key in ("restraint_work", "stored", "dissipated")]
        self.assertAlmostEqual(sum(sums) - law["created"], 0, delta=1e-9 * max(map(abs, sums)))

    def test_the_same_velocity_in_one_move_or_two(self):
        self.write("d_0000.rad", (SAMPLES / "strip_straight_0000.rad").read_text())
        head = "deck: d_0000.rad\nlaw: manual\ntime: {end: 1.0e-2, steps: 1}\nmotion:\n"
        bead = "  - move: {interface: 1, side: secondary}\n    velocity: {z: %s}\n"
        blank = "  - move: {surface: 1}\n    velocity: {z: %s}\n"
        first = []
        for moves in (bead % "[[0, -2000], [1.0e-2, 2000]]",
                      bead % -2000 + bead % "[[0, 0], [1.0e-2, 4000]]",
                      bead % "[[0, 0], [1.0e-2, 4000]]" + blank % 2000):
            law = self.evaluate(head + moves)["beads"][0]["laws"][0]
            first.append(law["first_contact"])
        self.assertIsNotNone(first[0])
        for t in first[1:]:
            self.assertAlmostEqual(t, first[0], delta=1e-9 * first[0])

    def test_viscous_work_over_a_jump_of_the_velocity(self):
        text = (SAMPLES / "slow_viscous_0000.rad").read_text()
        self.write("d_0000.rad", text)
        motion = ("motion:\n  - move: {interface: 1, side: secondary}\n    displacement: {z: [[0, 0], [1.0e-3, -3], "
                  "[1.0e-2, -3]]}\n  - move: {surface: 1}\n    displacement: {x: [[0, 0], [1.0e-3, 0], [5.0e-3, 0.4], "
                  "[1.0e-2, 0]]}\n")
        lost = []
        for steps in (1, 3, 64):
            report = self.evaluate(f"deck: d_0000.rad\nlaw: manual\ntime: {{end: 1.0e-2, steps: {steps}}}\n" + motion)
            lost.append(report["beads"][0]["laws"][0]["energy"]["dissipated"])
        self.assertGreater(lost[0], 0)
        for value in lost[1:]:
            self.assertAlmostEqual(value, lost[0], delta=1e-9 * lost[0])

    def test_rotation(self):
        self.write("d_0000.rad", tiny())
        report = self.evaluate("""
deck: d_0000.rad
law: manual
time: {end: 1, step: 0.25}
output: {csv: out.csv}
motion:
  - move: {node_group: 1}
    rotate: {about: [0, 5, 3], axis: [0, 0, 2], angle: [[0, 0], [1, 90]]}
    displacement: {z: [[0, 0], [1, -1]]}
""")
        last = self.rows(self.folder / "out.csv", "manual")[-3:]
        for row, radius in zip(last, (2, 5, 8)):
            self.assertAlmostEqual(float(row["xi"]), 0)
            self.assertAlmostEqual(float(row["yi"]), 5 + radius)
            self.assertAlmostEqual(float(row["zi"]), 2)
        self.assertEqual(report["left_out"], [])

    def test_schemas_are_embedded_and_fit_scenes(self):
        for name in ("evaluation", "plan", "scene"):
            jsonschema.Draft7Validator.check_schema(schema(name))
            status, out, _ = self.run_tool("schema", name)
            self.assertEqual((status, json.loads(out)), (0, schema(name)))
        scenes = jsonschema.Draft7Validator(schema("scene"))
        move = {"move": {"surface": 1}, "velocity": {"x": [[0, 0], [1, 2]], "y": 3}}
        scenes.validate({"deck": "d", "time": {"end": 1, "steps": 3}, "motion": [move]})
        scenes.validate({"deck": "d", "time": {"trace": "t"}, "motion": "deck", "law": "both", "interfaces": [1]})
        self.assertFalse(scenes.is_valid({"deck": "d", "time": {"end": 1}}))
        self.assertFalse(scenes.is_valid({"deck": "d", "time": {"trace": "t"}, "moton": "deck"}))


if __name__ == "__main__":
    unittest.main()
