"""What `check` and `info` write as JSON is what schemas/report.schema.json says, with nothing besides."""

import copy
import json
import unittest

import jsonschema

from support import ROOT, SAMPLES, CommandLineTest, tiny

SCHEMA = json.loads((ROOT / "schemas" / "report.schema.json").read_text())


def strict(schema):
    """The schema without room for members that it does not name."""
    if isinstance(schema, list):
        return [strict(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    schema = {name: strict(part) for name, part in schema.items()}
    if isinstance(schema.get("required"), list) and "properties" in schema:
        assert set(schema["required"]) <= set(schema["properties"]), schema["required"]
        schema["additionalProperties"] = False
    return schema


def refuse(constant):
    raise ValueError(f"{constant} is not JSON")


def loads(text):
    return json.loads(text, parse_constant=refuse)


class Schema(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.validator = jsonschema.Draft7Validator(strict(SCHEMA))

    def test_it_is_a_schema_and_is_embedded(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)
        status, out, _ = self.run_tool("schema", "report")
        self.assertEqual((status, out), (0, (ROOT / "schemas" / "report.schema.json").read_text()))
        self.assert_usage_error("no schema 'reprot'; did you mean 'report'?", "schema", "reprot")

    def test_the_hand_made_report(self):
        self.validator.validate(loads((ROOT / "tests" / "report" / "example.json").read_text()))

    def test_it_is_not_satisfied_by_anything(self):
        report = loads((ROOT / "tests" / "report" / "example.json").read_text())
        for damage in (lambda r: r.pop("summary"), lambda r: r["decks"][0].pop("starter"),
                       lambda r: r["decks"][0]["findings"][0].update(severity="fatal"),
                       lambda r: r["decks"][0]["findings"][0].update(extra=1), lambda r: r.update(schema=2)):
            damaged = copy.deepcopy(report)
            damage(damaged)
            self.assertFalse(self.validator.is_valid(damaged))

    def test_reports_of_decks(self):
        self.write("bad_0000.rad", tiny(group=9))
        self.write("empty_0000.rad", "")
        self.write("latin_0000.rad", tiny(group=9).replace("bead\n", "W\xfclst\x07 \"1\"\n").encode("latin-1"))
        _, out, _ = self.run_tool("check", ".", SAMPLES, "lost_0000.rad", "--format", "json")
        report = loads(out)
        self.validator.validate(report)
        self.assertEqual(report["summary"]["decks"], len(report["decks"]))
        self.assertEqual(report["summary"]["failed"], 2)
        counts = [finding["severity"] for deck in report["decks"] for finding in deck["findings"]]
        self.assertEqual([counts.count(name) for name in ("error", "warning", "info")],
                         [report["summary"][name] for name in ("errors", "warnings", "infos")])

    def test_table(self):
        schema = json.loads((ROOT / "schemas" / "table.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        status, out, _ = self.run_tool("schema", "table")
        self.assertEqual((status, json.loads(out)), (0, schema))
        validator = jsonschema.Draft7Validator(strict(schema))
        self.write("lost_group_0000.rad", tiny(group=9))
        self.write("lost_surface_0000.rad", tiny().replace("/SURF/PART/1", "/SURF/PART/4"))
        self.write("empty_list_0000.rad", tiny().replace("        11        12        13\n", ""))
        for deck in [*sorted(SAMPLES.glob("*_0000.rad")), *sorted(self.folder.glob("*_0000.rad"))]:
            with self.subTest(deck.name):
                status, out, _ = self.run_tool("table", deck, "--format", "json")
                self.assertEqual(status, 0)
                validator.validate(loads(out))

    def test_fix(self):
        schema = json.loads((ROOT / "schemas" / "fix.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        status, out, _ = self.run_tool("schema", "fix")
        self.assertEqual((status, json.loads(out)), (0, schema))
        validator = jsonschema.Draft7Validator(strict(schema))
        truth = ROOT / "tests" / "truth"
        self.write("lost_group_0000.rad", tiny(group=9))
        status, out, _ = self.run_tool("fix", truth / "half", truth / "twoside_bad", truth / "gap_one", SAMPLES,
                                       self.folder, "lost_0000.rad", "--format", "json")
        self.assertEqual(status, 2)
        report = loads(out)
        validator.validate(report)
        self.assertEqual(report["decks"][0]["applied"][0]["code"], "SRF001")
        self.assertIsNotNone(report["decks"][-1]["failure"])

    def test_info(self):
        for deck in sorted(SAMPLES.glob("*_0000.rad")):
            info = loads(self.run_tool("info", deck, "--format", "json")[1])
            jsonschema.Draft7Validator({**strict(SCHEMA)["definitions"]["info"],
                                        "definitions": strict(SCHEMA)["definitions"]}).validate(info)


if __name__ == "__main__":
    unittest.main()
