"""`drawbead table`: formats that agree, totals, what cannot be computed."""

import csv
import io
import json
import unittest

from support import ROOT, SAMPLES, CommandLineTest, tiny

COLUMNS = ("interface,index,node,s,tributary,fn_limit,ft_limit,n1,n2,n3,n4,xi,eta,inside,distance,half_thickness,"
           "penetration,stiffness,slope,slope_read,reset,closest_n1,closest_n2,closest_n3,closest_n4,closest_distance,"
           "manual_slope,manual_reset").split(",")


def cell(value):
    """A CSV cell as the JSON has it."""
    return None if value == "" else float(value)


class Table(CommandLineTest):
    def table(self, *arguments, status=0):
        got, out, err = self.run_tool("table", *arguments)
        self.assertEqual(got, status, err)
        return out, err

    def test_one_small_bead(self):
        self.write("x_0000.rad", tiny())
        out, err = self.table("x_0000.rad", "--format", "csv")
        self.assertEqual(err, "")
        # One segment, three nodes: the Engine reads the slopes of the second and third behind the table's end.
        self.assertEqual(out, ",".join(COLUMNS) + """
7,1,11,0,1.5,50,20,1,2,3,4,-0.6,0,1,3,0.5,-0.5,42000,25,25,0,1,2,3,4,3,25,0
7,2,12,3,3,50,20,1,2,3,4,0,0,1,3,0.5,-0.5,42000,25,,0,1,2,3,4,3,25,0
7,3,13,6,1.5,50,20,1,2,3,4,0.6,0,1,3,0.5,-0.5,42000,25,,0,1,2,3,4,3,25,0
""")

    def test_formats_agree(self):
        for deck in sorted(SAMPLES.glob("*_0000.rad")):
            with self.subTest(deck.name):
                rows = list(csv.DictReader(io.StringIO(self.table(deck, "--format", "csv")[0])))
                document = json.loads(self.table(deck, "--format", "json")[0])
                text = self.table(deck)[0]
                self.assertGreater(len(rows), 0)
                self.assertEqual(list(rows[0]), COLUMNS)
                self.assertEqual(len(document["rows"]), len(rows))
                for row, other in zip(rows, document["rows"]):
                    self.assertEqual(list(other), COLUMNS)
                    self.assertEqual({name: cell(value) for name, value in row.items()}, other)
                blocks = [block.splitlines() for block in text.split("\n\n")]
                lines = [line.split() for block in blocks if block[0].startswith("/INTER") for line in block[3:]]
                self.assertEqual([line[:3] for line in lines],
                                 [[row["interface"], row["index"], row["node"]] for row in rows])
                self.assertEqual({len(line) for line in lines}, {len(COLUMNS)})
                totals = document["totals"]
                for name in ("fn", "ft"):
                    force = sum(float(row[name + "_limit"]) * float(row["tributary"]) for row in rows)
                    for sums in (totals["beads"], totals["tools"], [totals["deck"]]):
                        self.assertAlmostEqual(sum(one[name] for one in sums), force, delta=1e-9 * abs(force))
                self.assertEqual(sum(one["inside"] for one in totals["beads"]),
                                 sum(row["inside"] == "1" for row in rows))

    def test_text_as_recorded(self):
        out, err = self.table(SAMPLES / "strip_linear_0000.rad")
        self.assertEqual((out, err), ((ROOT / "tests" / "cli" / "strip_linear.table.txt").read_text(), ""))

    def test_threads_do_not_matter(self):
        deck = SAMPLES / "hood_0000.rad"
        self.assertEqual(self.table(deck, "--format=csv", "-j1"), self.table(deck, "--format=csv", "-j3"))

    def test_one_interface(self):
        deck = SAMPLES / "hood_0000.rad"
        rows = list(csv.DictReader(io.StringIO(self.table(deck, "--format=csv")[0])))
        ids = list(dict.fromkeys(row["interface"] for row in rows))
        self.assertGreater(len(ids), 1)
        chosen = list(csv.DictReader(io.StringIO(self.table(deck, "--format=csv", "--interface", ids[1])[0])))
        self.assertEqual(chosen, [row for row in rows if row["interface"] == ids[1]])
        _, err = self.table(deck, "--interface", "999", status=2)
        self.assertIn("error: no /INTER/TYPE8 with id 999; there is: " + ", ".join(ids), err)
        self.assert_usage_error("--interface needs the id of a /INTER/TYPE8, not 'x'; see 'drawbead table --help'",
                                "table", deck, "--interface", "x")

    def test_file(self):
        self.write("x_0000.rad", tiny())
        expected, _ = self.table("x_0000.rad", "--format=json")
        self.assertEqual(self.table("x_0000.rad", "--format=json", "-o", "x.json"), ("", ""))
        self.assertEqual((self.folder / "x.json").read_text(), expected)

    def test_what_cannot_be_computed(self):
        self.write("x_0000.rad", tiny().replace("/SURF/PART/1", "/SURF/PART/4"))
        out, err = self.table("x_0000.rad", "--format=csv")
        self.assertEqual(err, "x_0000.rad: warning: interface 7 is not computed: surface 1 is not defined\n")
        self.assertEqual(out.splitlines()[1:], [start + "," * 21 for start in
                                                ("7,1,11,0,1.5,50,20", "7,2,12,3,3,50,20", "7,3,13,6,1.5,50,20")])
        self.write("y_0000.rad", tiny(group=9))
        out, err = self.table("y_0000.rad", "--format=csv")
        self.assertEqual((out, err), (",".join(COLUMNS) + "\n", "y_0000.rad: warning: interface 7 is not computed: "
                                      "node group 9 is not defined\n"))

    def test_wrong_input(self):
        self.write("empty_0000.rad", "")
        self.assertIn("lost_0000.rad: error: ", self.table("lost_0000.rad", status=2)[1])
        self.assertIn("empty_0000.rad: error: the file is empty", self.table("empty_0000.rad", status=2)[1])

    def test_the_starter_in_check(self):
        self.write("x_0000.rad", tiny().replace("                50.0                20.0                 2.0",
                                                "                50.0                20.0                 0.0"))
        report = json.loads(self.run_tool("check", "x_0000.rad", "--format=json")[1])
        self.assertEqual(report["decks"][0]["starter"],
                         {"messages": [1043], "interfaces": [{"id": 7, "messages": [1043], "nodes_346": []}]})
        report = json.loads(self.run_tool("check", "x_0000.rad", "--select=REF001", "--format=json")[1])
        self.assertIsNone(report["decks"][0]["starter"])


if __name__ == "__main__":
    unittest.main()
