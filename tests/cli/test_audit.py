"""`audit` from outside: text, JSON and its schema, exit status, and that docs/solver-differences.md is what it prints."""

import gzip
import json
import unittest

import jsonschema

from support import ROOT, CommandLineTest
from test_schema import loads, strict

TRUTH = ROOT / "tests" / "truth"
SCHEMA = json.loads((ROOT / "schemas" / "audit.schema.json").read_text())


def scene(name):
    return TRUTH / name / f"{name}_0000.rad", TRUTH / name / "trace.csv.gz"


class Audit(CommandLineTest):
    def trace(self, name):
        with gzip.open(scene(name)[1], "rt") as text:
            return text.read().splitlines()

    def test_within(self):
        status, out, err = self.run_tool("audit", *scene("c_drawin_incr"))
        self.assertEqual((status, err), (0, ""))
        self.assertIn("1656 rows, 184 cycles, 1 interface, largest force 475 N\n", out)
        self.assertIn("\nsegment choice: the same in 1656 of 1656 rows\n", out)
        self.assertIn("restraint work", out)
        self.assertTrue(out.endswith("\nwithin tolerance 1e-12\n"))
        self.assertEqual(self.run_tool("audit", *scene("n_two_thick"), "--tolerance", "1e-17")[0], 1)

    def test_plain_text_and_columns_in_any_order(self):
        rows = [line.split(",") for line in self.trace("negft2")]
        path = self.write("t.csv", "".join(",".join(reversed(row)) + "\n" for row in rows))
        self.assertEqual(self.run_tool("audit", scene("negft2")[0], path)[0], 0)

    def test_a_deck_with_its_bead_elsewhere(self):
        deck, trace = scene("c_drawin_incr")
        nodes, text = False, []
        for line in deck.read_text().splitlines():
            nodes = line.startswith("/NODE") or (nodes and not line.startswith("/"))
            if nodes and line[:10].strip() == "1005":
                line = line[:10] + f"{float(line[10:30]) + 1e-4:20.6f}" + line[30:]
            text.append(line)
        self.assertNotEqual(text, deck.read_text().splitlines())
        path = self.write("moved_0000.rad", "\n".join(text) + "\n")
        status, _, err = self.run_tool("audit", path, trace)
        self.assertEqual(status, 2)
        self.assertIn("node 1005 begins in another place than in the deck; is this the trace of this deck?", err)

    def test_out_of_tolerance(self):
        lines = self.trace("negft2")
        column = lines[0].split(",").index("fz")
        row = lines[50].split(",")
        row[column] = repr(float(row[column]) * (1 + 1e-6))
        lines[50] = ",".join(row)
        path = self.write("t.csv", "\n".join(lines) + "\n")
        status, out, err = self.run_tool("audit", scene("negft2")[0], path)
        self.assertEqual((status, err), (1, ""))
        line = next(line for line in out.splitlines() if line.startswith("total force"))
        self.assertIn(" OUT ", line)
        self.assertIn("line 51, cycle ", line)
        self.assertTrue(out.endswith("\nOUT of tolerance 1e-12\n"))
        status, out, _ = self.run_tool("audit", scene("negft2")[0], path, "--format", "json")
        quantities = {q["name"]: q for q in loads(out)["quantities"]}
        self.assertEqual(status, 1)
        self.assertEqual([name for name, q in quantities.items() if not q["within"]], ["total force"])
        self.assertEqual(quantities["total force"]["largest"]["line"], 51)

    def test_unusable(self):
        deck, trace = scene("negft2")
        lines = self.trace("negft2")
        header = lines[0].split(",")
        cut = [header.index("stf"), header.index("m4")]
        without = "".join(",".join(v for k, v in enumerate(line.split(",")) if k not in cut) + "\n" for line in lines)
        for path, message in ((self.write("a.csv", without), "lacks the columns stf, m4"),
                              (self.write("b.csv", ""), "the trace is empty"),
                              (self.write("c.csv.gz", trace.read_bytes()[:2000]), "cut"),
                              (self.write("d.csv.gz", trace.read_bytes()[:-4]), "cut"),
                              (self.write("e.csv.gz", trace.read_bytes()[:3000] + b"\0" * 20 + trace.read_bytes()[3020:]),
                               "cannot read the trace: "),
                              (self.write("f.csv", bytes(range(256)) * 50), "names no column of a trace"),
                              (self.write("g.csv", ",".join(header) + "\n"), "g.csv:1: error: the trace has no rows"),
                              (self.folder / "none.csv", "no such file"), (self.folder, "it is a folder"),
                              (scene("half")[1], "is this the trace of this deck?")):
            status, out, err = self.run_tool("audit", deck, path)
            self.assertEqual((status, out), (2, ""), path)
            self.assertIn("error: ", err)
            self.assertIn(message, err)
        self.assertEqual(self.run_tool("audit", "none_0000.rad", trace)[0], 2)
        self.assert_usage_error("--tolerance needs a number, not 'x'; please give 0 to below 1, such as 1e-12",
                                "audit", deck, trace, "--tolerance", "x")

    def test_json(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)
        self.assertEqual(self.run_tool("schema", "audit")[1], (ROOT / "schemas" / "audit.schema.json").read_text())
        validator = jsonschema.Draft7Validator(strict(SCHEMA))
        for name in ("c_drawin_incr", "l2_admesh_idt0", "o_nsn_gt_nrt", "twoside_bad", "void_E"):
            status, out, err = self.run_tool("audit", *scene(name), "--format", "json", "--law", "manual")
            self.assertEqual((status, err), (0, ""))
            audit = loads(out)
            validator.validate(audit)
            self.assertTrue(audit["within"])
            self.assertEqual(len(audit["manual"]), len(audit["energies"]))
            self.assertEqual(self.run_tool("audit", *scene(name), "--format", "json", "--law", "manual", "-o",
                                           "out.json")[:2], (0, ""))
            self.assertEqual((self.folder / "out.json").read_text(), out)
            broken = dict(audit, segment_choice={})
            self.assertFalse(validator.is_valid(broken))

    def test_what_was_not_checked_is_said(self):
        notes = loads(self.run_tool("audit", *scene("o_nsn_gt_nrt"), "--format", "json")[1])["notes"]
        self.assertEqual(notes, ["50 rows: the slope is taken from the trace, because the Engine read it past the end "
                                 "of its table (more bead nodes than segments)"])
        notes = loads(self.run_tool("audit", *scene("l2_admesh_idt0"), "--format", "json")[1])["notes"]
        self.assertIn("540 rows: on segments that adaptive meshing made, which the deck cannot confirm", notes)


class Documents(CommandLineTest):
    def assert_printed(self, name, least):
        text = (ROOT / name).read_text()
        blocks = [block.split("\n```")[0] for block in text.split("```console\n")[1:]]
        blocks = [block for block in blocks if block.startswith("$ drawbead audit ")]
        self.assertGreaterEqual(len(blocks), least)
        for block in blocks:
            command, *lines = block.split("\n")
            status, out, err = self.run_tool(*command.split()[2:], cwd=ROOT)
            self.assertEqual((status, err), (0, ""), command)
            printed = iter(out.splitlines())
            for line in lines:
                if line != "...":
                    self.assertIn(line, printed, command)  # uses up the lines before it

    def test_the_pasted_numbers_are_what_is_printed(self):
        self.assert_printed("docs/solver-differences.md", 24)
        self.assert_printed("README.md", 1)

    def test_every_column_is_explained(self):
        text = (ROOT / "docs" / "audit.md").read_text()
        with gzip.open(scene("negft2")[1], "rt") as lines:
            columns = lines.readline().strip().split(",")
        ranges = {"seg_n": 4, "h": 4, "m": 4}
        for column in columns:
            stem = column.rstrip("0123456789")
            if stem in ranges or column[-1] in "xyz" or column[-2:-1] in "xyz":
                continue  # written as a range
            self.assertIn(f"`{column}`", text)


if __name__ == "__main__":
    unittest.main()
