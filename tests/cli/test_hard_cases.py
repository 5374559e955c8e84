"""`accuracy --hard-cases` from outside."""

import json
import pathlib
import unittest

import jsonschema

from support import ROOT, CommandLineTest
from test_schema import loads, strict


class HardCases(CommandLineTest):
    def test_all_pass_and_are_told(self):
        status, out, err = self.run_tool("accuracy", "--hard-cases", "--format", "json")
        self.assertEqual((status, err), (0, ""))
        report = loads(out)
        cases = report["cases"]
        self.assertGreaterEqual(len({case["name"] for case in cases}), 60)
        self.assertGreaterEqual(len({case["guard"] for case in cases} - {""}), 30)
        verdicts = [case["verdict"] for case in cases]
        self.assertEqual(report["summary"], {"cases": len(cases), "hold": verdicts.count("holds"),
                                             "broken": verdicts.count("broken"), "failed": 0})
        self.assertEqual({case["law"] for case in cases}, {"manual", "solver"})
        self.assertEqual({case["number"] for case in cases}, {"double", "float"})
        for case in cases:
            self.assertLessEqual(abs(case["measured"] - case["expected"]), case["bound"], case["name"])
            self.assertEqual(case["expected"] != 0, case["verdict"] == "broken", case["name"])

        status, text, err = self.run_tool("accuracy", "--hard-cases")
        self.assertEqual((status, err), (0, ""))
        status, out, err = self.run_tool("accuracy", "--hard-cases", "-o", "cases.txt")
        self.assertEqual((status, out, err), (0, "", ""))
        self.assertEqual((self.folder / "cases.txt").read_text(), text)
        lines = text.splitlines()
        self.assertEqual(len(lines), len(cases) + 3)
        self.assertEqual(lines[0].split()[:4], ["case", "law", "number", "measured"])
        for line, case in zip(lines[1:], cases):
            self.assertEqual(line.split()[:3], [case["name"], case["law"], case["number"]])
            self.assertTrue(line.endswith(case["invariant"]))
        self.assertIn(f"{len(cases)} cases: {verdicts.count('holds')} hold", lines[-1])

    def test_schema(self):
        schema = json.loads((ROOT / "schemas" / "hard-cases.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        status, out, _ = self.run_tool("schema", "hard-cases")
        self.assertEqual((status, json.loads(out)), (0, schema))
        validator = jsonschema.Draft7Validator(strict(schema))
        report = loads(self.run_tool("accuracy", "--hard-cases", "--format", "json")[1])
        validator.validate(report)
        report["cases"][0]["verdict"] = "perhaps"
        self.assertFalse(validator.is_valid(report))

    def test_a_file_that_cannot_be_written(self):
        status, out, err = self.run_tool("accuracy", "--hard-cases", "-o", pathlib.Path("nowhere") / "cases.txt")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("nowhere", err)

    def test_usage(self):
        self.assert_usage_error("--format knows no 'yaml'; please give one of text, json, csv", "accuracy", "--hard-cases",
                                "--format", "yaml")
        self.assert_usage_error("unknown option '--hard-case'; did you mean '--hard-cases'?", "accuracy", "--hard-case")
        self.assert_usage_error("--hard-cases prints no csv; please give --format text or json", "accuracy", "--hard-cases",
                                "--format", "csv")
        self.assert_usage_error("accuracy needs a scene or --hard-cases; see 'drawbead accuracy --help'", "accuracy")


if __name__ == "__main__":
    unittest.main()
