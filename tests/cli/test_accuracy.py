"""`accuracy` from outside: its picks against an evaluator of their own, JSON and schema, mistakes, and the document."""

import csv
import json
import math
import unittest
import xml.etree.ElementTree as ElementTree

import jsonschema

from support import ROOT, SAMPLES, CommandLineTest
from test_schema import loads

TOLERANCES = (0.01, 0.001, 0.0001)


def schema(name):
    return json.loads((ROOT / "schemas" / f"{name}.schema.json").read_text())


def interpolated(table, t):
    for (t0, y0), (t1, y1) in zip(table, table[1:]):
        if t <= t1:
            return y0 + (y1 - y0) * (t - t0) / (t1 - t0)
    return table[-1][1]


def integrated(table, t):
    """Of a table that is linear in between, from 0 to t."""
    total = 0.0
    for (t0, y0), (t1, y1) in zip(table, table[1:]):
        end = min(t, t1)
        if end <= t0:
            break
        total += (end - t0) * (y0 + y0 + (y1 - y0) * (end - t0) / (t1 - t0)) / 2
    return total


def corners(table):
    """Where it bends or is zero."""
    times = {t for t, _ in table}
    for (t0, y0), (t1, y1) in zip(table, table[1:]):
        if y0 * y1 < 0:
            times.add(t0 + (t1 - t0) * y0 / (y0 - y1))
    return times


class Strip:
    """A bead over a flat sheet that moves along x after the bead has closed along z: nothing but sums over straight
    pieces of the line, each with a slider that is exact from turn to turn."""

    def __init__(self, nodes, fn, ft, depth, thickness, young, height, closing, drawing, is_velocity, end):
        self.end, self.closing = end, closing
        gap = height + integrated(closing, end)
        deep = depth - gap + thickness / 2
        self.k = 0.2 * young * thickness
        self.pieces = []
        hops = [math.dist(a, b) for a, b in zip(nodes, nodes[1:])]
        for i, hop in enumerate(hops):
            across = (nodes[i][1] - nodes[i + 1][1]) / hop  # x of n × line
            sideways = (nodes[i + 1][0] - nodes[i][0]) / hop
            for node in (i, i + 1):
                length = (hops[node - 1] if node > 0 else 0) / 2 + (hops[node] if node < len(hops) else 0) / 2
                assert fn * length / depth <= self.k
                self.pieces.append((node, hop / 2, length, across, sideways))
        self.ramp = min(max(deep / depth, 0), 1)
        self.ft, self.fn = ft, fn
        self.x = (lambda t: integrated(drawing, t)) if is_velocity else (lambda t: interpolated(drawing, t))
        self.turns = sorted(corners(drawing) if is_velocity else {t for t, _ in drawing})

    def run(self, times):
        """Restraint (x, y) at each time, and work."""
        stops = sorted(set(times) | set(self.turns))
        forces = {t: [0.0, 0.0] for t in times}
        work = 0.0
        for node, part, length, across, sideways in self.pieces:
            limit, share, q, before = self.ft * length * self.ramp, part / length, 0.0, 0.0
            for t in stops:
                way = (self.x(t) - before) * across
                before = self.x(t)
                trial = q + self.k * way
                now = min(max(trial, -limit), limit)
                work += share * ((now * now - q * q) / (2 * self.k) + now * (trial - now) / self.k)
                q = now
                if t in forces:
                    forces[t][0] -= share * q * across
                    forces[t][1] -= share * q * sideways
        return forces, work

    def normal(self):
        return self.fn * self.ramp * sum(part for _, part, *_ in self.pieces)


def bead_nodes(name, group=101):
    """Positions of a list of nodes of a sample."""
    lines = (SAMPLES / name).read_text().split("\n")
    position, ids, block = {}, [], ""
    for line in lines:
        if line.startswith("/"):
            block = line
        elif line.startswith("#") or not line.strip():
            continue
        elif block.startswith("/NODE"):
            position[int(line[:10])] = tuple(float(line[10 + 20 * k:30 + 20 * k]) for k in range(3))
        elif block in (f"/GRNOD/NODENS/{group}", f"/GRNOD/NODE/{group}") and line[:10].strip().isdigit():
            ids += [int(word) for word in line.split()]
    return [position[i] for i in ids]


CLOSING = [(0, 0), (0.5e-3, -3000), (1.0e-3, 0), (1.0e-2, 0)]
SMOOTH = [(0, 0), (1.0e-3, 0), (2.0e-3, 1500), (7.0e-3, -1200), (1.0e-2, 100)]
KINKED = [(0, 0), (1.0e-3, 0), (4.1e-3, 3), (7.3e-3, 1), (1.0e-2, 2)]

SCENES = {
    "draw_straight.yaml": ("strip_straight_0000.rad", 60, 80, SMOOTH, True),
    "draw_kinked.yaml": ("strip_straight_0000.rad", 60, 80, KINKED, False),
    "draw_ring.yaml": ("ring_closed_0000.rad", 75, 100, SMOOTH, True),
}


def strip(name):
    deck, fn, ft, drawing, is_velocity = SCENES[name]
    nodes = bead_nodes(deck)
    return Strip(nodes, fn, ft, 2.0, 1.0, 210000.0, nodes[0][2], CLOSING, drawing, is_velocity, 1.0e-2)


class Accuracy(CommandLineTest):
    studies = {}

    def study(self, scene, *options):
        """The report; of a sample it is made once."""
        key = (scene, options)
        if scene.parent == SAMPLES and key in self.studies:
            return self.studies[key]
        self.studies[key] = self.studied(scene, *options)
        return self.studies[key]

    def studied(self, scene, *options):
        status, out, err = self.run_tool("accuracy", scene, "--format", "json", "--no-times", "-q", *options)
        self.assertEqual((status, err), (0, ""))
        report = loads(out)
        jsonschema.Draft7Validator(schema("accuracy")).validate(report)
        return report

    def test_picks_against_an_evaluator_of_their_own(self):
        for name in SCENES:
            with self.subTest(name):
                truth = strip(name)
                report = self.study(SAMPLES / name)
                rows = report["rows"]
                self.assertEqual([pick["tolerance"] for pick in report["picks"]], list(TOLERANCES))
                fine = [truth.end * i / 2000 for i in range(2001)]
                forces, work = truth.run(fine + truth.turns)
                largest = max(math.hypot(*f) for f in forces.values())
                reference = report["reference"]["beads"][0]["values"]
                self.assertAlmostEqual(reference["largest_restraint"] / largest, 1, delta=1e-9)
                self.assertAlmostEqual(reference["work"] / work, 1, delta=1e-9)
                self.assertAlmostEqual(reference["normal"] / truth.normal(), 1, delta=1e-9)

                def error(row):
                    v = row["beads"][0]["values"]
                    return max(abs(v["largest_restraint"] / largest - 1), abs(v["work"] / work - 1),
                               abs(v["normal"] / truth.normal() - 1), row["errors"]["restraint"],
                               row["errors"]["first_slip"])

                for pick in report["picks"]:
                    chosen = rows[pick["row"]]
                    self.assertLessEqual(error(chosen), pick["tolerance"])
                    for row in rows:
                        if row["cost"]["evaluations"] < chosen["cost"]["evaluations"]:
                            self.assertGreater(error(row), pick["tolerance"], row["settings"])
                    self.pasted(name, pick, chosen, truth, largest, work)

    def pasted(self, name, pick, row, truth, largest, work):
        """What `evaluate` makes of the settings, step by step."""
        text = (SAMPLES / name).read_text().replace("deck: ", f"deck: {SAMPLES}/")
        scene = self.write("scene.yaml", text.replace("motion:", f"accuracy: {pick['yaml']}\nlaw: manual\nmotion:"))
        status, out, _ = self.run_tool("evaluate", scene, "--csv", "rows.csv", "--format", "json", "-q")
        self.assertEqual(status, 0)
        report = loads(out)
        self.assertTrue(any(f"{row['cost']['evaluations']} evaluations" in note for note in report["notes"]))
        law = report["beads"][0]["laws"][0]
        self.assertEqual(law["restraint"]["value"], row["beads"][0]["values"]["largest_restraint"])
        self.assertEqual(law["first_slip"], row["beads"][0]["values"]["first_slip"])
        totals = {}
        with open(self.folder / "rows.csv", newline="") as file:
            for line in csv.DictReader(file):
                total = totals.setdefault(float(line["tt"]), [0.0, 0.0])
                total[0] += float(line["ftx"])
                total[1] += float(line["fty"])
        self.assertEqual(len(totals), row["settings"]["steps"] + 1)
        forces, _ = truth.run(list(totals))
        for t, total in totals.items():
            self.assertLessEqual(math.dist(total, forces[t]), pick["tolerance"] * largest + 1e-9)
        self.assertAlmostEqual((law["energy"]["dissipated"] + law["energy"]["stored"]) / work, 1,
                               delta=pick["tolerance"])

    def test_orders(self):
        for name, expected in (("draw_straight.yaml", 2), ("draw_kinked.yaml", 1), ("draw_ring.yaml", 2)):
            orders = {(o["knob"], o["quantity"]): o for o in self.study(SAMPLES / name)["orders"]}
            self.assertAlmostEqual(orders["steps", "work"]["observed"], expected, delta=0.1)
            self.assertEqual(orders["steps", "work"]["expected"], expected)
        self.assertAlmostEqual(orders["chord angle", "length"]["observed"], 2, delta=0.1)

    def test_the_same_bytes_every_time(self):
        one = self.run_tool("accuracy", SAMPLES / "draw_kinked.yaml", "--no-times", "--svg", "one.svg")
        two = self.run_tool("accuracy", SAMPLES / "draw_kinked.yaml", "--no-times", "-j", "1", "--svg", "two.svg")
        self.assertEqual(one, two)
        self.assertEqual((self.folder / "one.svg").read_text(), (self.folder / "two.svg").read_text())
        drawing = ElementTree.parse(self.folder / "one.svg").getroot()
        texts = ["".join(t.itertext()) for t in drawing.iter("{http://www.w3.org/2000/svg}text")]
        self.assertIn("evaluations of the law at a point", texts)
        self.assertIn("Pareto front", texts)

    def test_times_csv_and_within(self):
        status, out, _ = self.run_tool("accuracy", SAMPLES / "draw_kinked.yaml", "--format", "csv", "--within", "0.001")
        self.assertEqual(status, 0)
        rows = list(csv.DictReader(out.splitlines()))
        timed = [row for row in rows if row["median_s"]]
        self.assertGreater(len(timed), 3)
        self.assertTrue(all(float(row["least_s"]) <= float(row["median_s"]) for row in timed))
        report = self.study(SAMPLES / "draw_kinked.yaml", "--within", "0.5%")
        self.assertEqual([p["tolerance"] for p in report["picks"] if p["asked"]], [0.005])
        status, out, _ = self.run_tool("accuracy", SAMPLES / "draw_kinked.yaml", "--no-times", "-q", "--within", "1e-17")
        self.assertEqual(status, 1)
        self.assertIn("\nnothing is within 1e-15 %; the best has ", out)

    def test_settings_of_the_scene_are_studied(self):
        text = (SAMPLES / "draw_straight.yaml").read_text().replace("deck: ", f"deck: {SAMPLES}/")
        scene = self.write("scene.yaml", text.replace("motion:", "accuracy: {steps: 37, line: 6, number: float}\nmotion:"))
        first = self.study(scene)["rows"][0]
        self.assertEqual(first["settings"], {"steps": 37, "line": 6, "kinks": "stepped", "tributary": "chord",
                                             "projection": "exact", "search": "exact", "sum": "compensated",
                                             "number": "float"})
        self.assertEqual(first["cost"]["evaluations"], 38 * (6 * 10 + 2))

    def test_scenes_of_many_steps(self):
        """Above 20 000 steps the laws meet the reference at some of them, and the report says at which."""
        text = (SAMPLES / "draw_straight.yaml").read_text().replace("deck: ", f"deck: {SAMPLES}/")
        errors, notes = [], []
        for steps in (20000, 20001, 60001):
            report = self.study(self.write(f"steps{steps}.yaml", text.replace("steps: 500", f"steps: {steps}")))
            errors.append(report["differences_of_laws"]["solver"]["restraint"])
            notes.append([note for note in report["notes"] if "compared after every" in note])
        self.assertGreater(errors[0], 0.01)
        self.assertAlmostEqual(errors[1] / errors[0], 1, delta=0.02)
        self.assertAlmostEqual(errors[2] / errors[0], 1, delta=0.1)
        said = "difference of laws: restraint over time is compared after every {} of the scene's {} steps"
        self.assertEqual(notes, [[], [said.format(2, 20001)], [said.format(4, 60001)]])

    def test_readings(self):
        line = self.study(SAMPLES / "draw_ring.yaml")
        nodes = self.study(SAMPLES / "draw_ring.yaml", "--reference", "nodes")
        self.assertEqual((line["reference"]["reading"], nodes["reference"]["reading"]), ("line", "nodes"))
        self.assertEqual(set(line["reference"]["other_readings"]), {"nodes", "arc"})
        for error in nodes["differences_of_laws"]["evaluate"].values():
            self.assertLess(error, 1e-9)

    def test_mistakes(self):
        deck = SAMPLES / "strip_straight_0000.rad"
        for section, message in {
                "steps: 0": "3:19: error: steps must be 1 to 1e8",
                "steps: 8, line: 3": "3:28: error: the points per hop are an even number from 2 to 64",
                "steps: 8, line: knots": "3:28: error: line knows no 'knots'",
                "steps: 8, lin: nodes": "3:22: error: unknown key 'lin'; did you mean 'line'?",
                "steps: 8, search: trackd": "3:30: error: search knows no 'trackd'; did you mean 'tracked'?",
                "line: nodes": "3:11: error: key 'steps' is missing",
        }.items():
            self.write("scene.yaml", f"deck: {deck}\ntime: {{end: 1, steps: 3}}\naccuracy: {{{section}}}\n")
            for command in ("accuracy", "evaluate"):
                status, out, err = self.run_tool(command, "scene.yaml")
                self.assertEqual((status, out), (2, ""))
                self.assertIn("scene.yaml:" + message, err)
        self.write("scene.yaml", f"deck: {deck}\ntime: {{end: 1, steps: 3}}\naccuracy: {{line: nodes, steps: 100001}}\n")
        status, out, err = self.run_tool("accuracy", "scene.yaml")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("scene.yaml:3:32: error: accuracy compares at most 100000 steps with its reference", err)
        self.write("binary.yaml", bytes(range(256)) * 20)
        (self.folder / "folder.yaml").mkdir()
        for name, message in {"missing.yaml": "cannot be read", "folder.yaml": "cannot be read",
                              "binary.yaml": "binary.yaml:", str(deck): "accuracy needs a scene"}.items():
            status, out, err = self.run_tool("accuracy", name)
            self.assertEqual((status, out), (2, ""))
            self.assertIn(message, err)
        for nonsense in ("abc", "0", "-1%", "100%", "5", "nan", "%", "0.1%%"):
            status, out, err = self.run_tool("accuracy", SAMPLES / "draw_kinked.yaml", f"--within={nonsense}")
            self.assertEqual((status, out), (2, ""))
            self.assertIn(f"--within needs a tolerance, not '{nonsense}'", err)
        status, out, err = self.run_tool("accuracy", SAMPLES / "draw_kinked.yaml", "--no-times", "-q", "--svg", "no/where.svg")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("no/where.svg: error: cannot write", err)

    def test_schemas(self):
        jsonschema.Draft7Validator.check_schema(schema("accuracy"))
        self.assertEqual(json.loads(self.run_tool("schema", "accuracy")[1]), schema("accuracy"))
        scenes = jsonschema.Draft7Validator(schema("scene"))
        scene = {"deck": "d", "time": {"end": 1, "steps": 3}}
        scenes.validate(dict(scene, accuracy={"steps": 8, "line": 4, "kinks": "split"}))
        for wrong in ({"line": 4}, {"steps": 8, "line": 3}, {"steps": 8, "number": "half"}, {"steps": 8, "more": 1}):
            self.assertFalse(scenes.is_valid(dict(scene, accuracy=wrong)))

    def test_the_document_is_what_is_printed(self):
        text = (ROOT / "docs" / "accuracy.md").read_text()
        blocks = [block.split("\n```")[0] for block in text.split("```console\n")[1:]]
        self.assertGreaterEqual(len(blocks), 3)
        for block in blocks:
            command, *lines = block.split("\n")
            self.assertTrue(command.startswith("$ drawbead accuracy "))
            status, out, _ = self.run_tool(*command.split()[2:], "-q", cwd=ROOT)
            self.assertEqual(status, 0, command)
            printed = iter(line.rstrip() for line in out.splitlines())
            for line in lines:
                if line != "...":
                    self.assertIn(line, printed, command)  # uses up the lines before it


if __name__ == "__main__":
    unittest.main()
