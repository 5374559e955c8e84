"""Formats of `check`, `fix --dry-run` and `merge`, held to the schemas of those who read them."""

import csv
import io
import json
import os
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree
from urllib.parse import unquote

import jsonschema

from support import ROOT, SAMPLES, CommandLineTest, tiny
from test_schema import loads, strict

THIRD_PARTY = ROOT / "tests" / "third_party"
FORMATS = ["full", "concise", "json", "jsonl", "csv", "sarif", "junit", "github", "gitlab"]
SARIF = jsonschema.Draft4Validator(json.loads((THIRD_PARTY / "sarif" / "sarif-2.1.0-rtm.5.json").read_text()))
LINES = jsonschema.Draft7Validator(strict(json.loads((ROOT / "schemas" / "lines.schema.json").read_text())))
# The fields that GitLab's documentation of the Code Quality report names.
GITLAB = jsonschema.Draft7Validator({
    "type": "array",
    "items": {
        "type": "object",
        "required": ["description", "check_name", "fingerprint", "severity", "location"],
        "properties": {
            "description": {"type": "string", "minLength": 1},
            "check_name": {"type": "string", "minLength": 1},
            "fingerprint": {"type": "string", "minLength": 1},
            "severity": {"enum": ["info", "minor", "major", "critical", "blocker"]},
            "location": {
                "type": "object",
                "required": ["path", "lines"],
                "properties": {
                    "path": {"type": "string", "minLength": 1, "not": {"pattern": "^\\./"}},
                    "lines": {
                        "type": "object",
                        "required": ["begin"],
                        "properties": {"begin": {"type": "integer", "minimum": 1}},
                    },
                },
            },
        },
    },
})


def titled(deck):
    """A deck whose group has a title of signs that some format has a meaning for."""
    return deck.replace("bead\n        11", "Bördel & <\"Nut\"> %, {0}\n        11")


class Formats(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("clean_0000.rad", (SAMPLES / "strip_straight_0000.rad").read_bytes())
        self.write("bad_0000.rad", tiny(group=9))
        self.write("twice_0000.rad", tiny().replace("        11        12        13\n",
                                                    "        11        12        12        13\n"))
        self.write("latin_0000.rad", titled(tiny(group=9)).encode("latin-1"))
        self.write("utf_0000.rad", titled(tiny(group=9)).encode())
        self.write("empty_0000.rad", "")
        for name in ("with_includes_0000.rad", "with_includes_beads.inc", "with_includes_mesh.inc"):
            self.write(name, (SAMPLES / name).read_bytes())
        self.write("flipped_0000.rad", (SAMPLES / "half_flipped_0000.rad").read_bytes())
        self.write("gap_0000.rad", (SAMPLES / "hood_one_list_0000.rad").read_bytes())

    def outputs(self, *arguments, command="check", status=2, formats=FORMATS, **more):
        """Runs with one file per format; returns their bytes."""
        targets = []
        for name in formats:
            targets += ["--output", f"{name}=out.{name}"]
        got, out, err = self.run_tool(command, *targets, *arguments, **more)
        self.assertEqual((got, out), (status, ""), err)
        return {name: (self.folder / f"out.{name}").read_bytes() for name in formats}

    def validate(self, files):
        """Every format by something that is not ours."""
        SARIF.validate(loads(files["sarif"]))
        GITLAB.validate(loads(files["gitlab"]))
        prints = [issue["fingerprint"] for issue in loads(files["gitlab"])]
        self.assertEqual(len(prints), len(set(prints)))
        for line in files["jsonl"].decode().splitlines():
            LINES.validate(loads(line))
        rows = list(csv.reader(io.StringIO(files["csv"].decode()), strict=True))
        self.assertEqual({len(row) for row in rows}, {14})
        xml.etree.ElementTree.fromstring(files["junit"])
        (self.folder / "junit.xml").write_bytes(files["junit"])
        done = subprocess.run(["xmllint", "--noout", "--nonet", "--schema",
                               THIRD_PARTY / "junit" / "junit-10.xsd", self.folder / "junit.xml"],
                              capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        for line in files["github"].decode().splitlines():
            self.assertRegex(line, r"^::(error|warning|notice) ([a-zA-Z]+=[^,:]*)(,[a-zA-Z]+=[^,:]*)*::")

    def test_a_folder_of_oddities(self):
        odd = os.fsdecode(b"l\xf6st, %3A_0000.rad")
        try:
            shutil.copy(self.folder / "bad_0000.rad", self.folder / odd)
        except OSError:
            self.skipTest("the file system has no such names")
        files = self.outputs(".")
        self.validate(files)
        report = loads(files["json"])
        self.assertEqual(report["summary"]["decks"], 10)
        findings = sum(len(deck["findings"]) for deck in report["decks"])

        sarif = loads(files["sarif"])["runs"][0]
        self.assertEqual(len(sarif["results"]), findings)
        invocation = sarif["invocations"][0]
        self.assertEqual((invocation["executionSuccessful"], invocation["exitCode"]), (False, 2))
        self.assertEqual([n["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
                          for n in invocation["toolExecutionNotifications"]], ["empty_0000.rad"])
        uris = {unquote(r["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], errors="surrogateescape")
                for r in sarif["results"]}
        self.assertIn(odd, uris)
        for result in sarif["results"]:
            self.assertEqual(sarif["tool"]["driver"]["rules"][result["ruleIndex"]]["id"], result["ruleId"])
            self.assertLessEqual(1 + len(result.get("relatedLocations", [])), 100)

        lines = [loads(line) for line in files["jsonl"].decode().splitlines()]
        self.assertEqual([line["type"] for line in lines].count("finding"), findings)
        self.assertEqual((lines[0]["type"], lines[-1]["type"]), ("run", "summary"))
        self.assertEqual(len(loads(files["gitlab"])), findings + 1)
        rows = list(csv.DictReader(io.StringIO(files["csv"].decode())))
        self.assertEqual(len(rows), findings + 1)
        suites = xml.etree.ElementTree.fromstring(files["junit"]).findall("testsuite")
        self.assertEqual(len(suites), 10)
        self.assertEqual(sum(int(suite.get("errors")) for suite in suites), 1)
        self.assertEqual(len(files["github"].decode().splitlines()), 11)
        self.assertTrue(files["github"].startswith(b"::error file=empty_0000.rad,title=deck not read::"))

    def test_a_report_is_read_back_without_loss(self):
        odd = os.fsdecode(b"l\xf6st_0000.rad")
        try:
            shutil.copy(self.folder / "bad_0000.rad", self.folder / odd)
        except OSError:
            self.skipTest("the file system has no such names")
        files = self.outputs(".")
        self.assertIn("raw_texts", files["json"].decode())
        (self.folder / "report.json").write_bytes(files["json"])
        self.assertEqual(self.outputs("report.json", command="merge"), files)

    def test_nothing_to_say(self):
        files = self.outputs("clean_0000.rad", "--select", "REF", status=0)
        self.validate(files)
        self.assertEqual((files["full"], files["concise"], files["gitlab"]), (b"", b"", b"[]\n"))
        self.assertEqual(loads(files["sarif"])["runs"][0]["results"], [])
        self.assertIn(b'name="no findings"', files["junit"])
        self.assertEqual(files["github"].decode(), "::notice title=drawbead::1 deck, 1 interface: no findings\n")

    def test_no_decks_in_a_shard(self):
        files = self.outputs("clean_0000.rad", "--shard", "2/2", status=0)
        self.validate(files)
        self.assertEqual(loads(files["json"])["decks"], [])

    def test_standard_input(self):
        files = self.outputs("-", "--stdin-filename", "sub/<a>_0000.rad", stdin=tiny(group=9), status=1)
        self.validate(files)
        result = loads(files["sarif"])["runs"][0]["results"][0]
        self.assertEqual(result["locations"][0]["physicalLocation"]["artifactLocation"],
                         {"uri": "sub/%3Ca%3E_0000.rad", "uriBaseId": "SRCROOT"})

    def test_each_format_alone_on_standard_output(self):
        files = self.outputs("bad_0000.rad", "latin_0000.rad", "flipped_0000.rad", status=1)
        for name in FORMATS:
            with self.subTest(name):
                _, out, _ = self.run_tool("check", "--format", name, "bad_0000.rad", "latin_0000.rad",
                                          "flipped_0000.rad")
                self.assertEqual(out.encode(errors="surrogateescape"), files[name])

    def test_columns_are_code_points(self):
        deck = tiny().replace("\nbead\n         1 ", "\nbead\n         1 ")
        deck = deck.replace("                50.0                20.0", "# öö\n                50.0 ö              20.0")
        self.write("wide_0000.rad", deck)
        files = self.outputs("wide_0000.rad", status=1)
        for finding in loads(files["json"])["decks"][0]["findings"]:
            place = finding["places"][0]
            line = deck.encode().splitlines()[place["line"] - 1]
            result = next(r for r in loads(files["sarif"])["runs"][0]["results"]
                          if r["partialFingerprints"]["drawbead/v1"] == finding["fingerprint"])
            region = result["locations"][0]["physicalLocation"]["region"]
            self.assertEqual(region["startColumn"], len(line[: place["column"] - 1].decode(errors="replace")) + 1)
            self.assertEqual(region["endColumn"], len(line[: place["end_column"] - 1].decode(errors="replace")) + 1)
            if place["end_column"] > 23:
                self.assertNotEqual(region["endColumn"], place["end_column"])
        self.assertIn("end_character_column", files["json"].decode())

    def replaced(self, text, fix):
        """The text with a SARIF fix of one file made, by a reader that knows lines and columns only."""
        starts = [0]
        for line in text.split("\n"):
            starts.append(starts[-1] + len(line) + 1)
        for one in reversed(fix["artifactChanges"][0]["replacements"]):
            region = one["deletedRegion"]
            begin = starts[region["startLine"] - 1] + region["startColumn"] - 1
            end = starts[region["endLine"] - 1] + region["endColumn"] - 1
            text = text[:begin] + one.get("insertedContent", {}).get("text", "") + text[end:]
        return text

    def test_the_fixes_repair(self):
        """Each of them alone, on the decks that the other tests know."""
        decks = [*sorted(self.folder.glob("*_0000.rad")), *sorted(SAMPLES.glob("*_0000.rad")),
                 *sorted((ROOT / "tests" / "truth").glob("*/*_0000.rad"))]
        made = set()
        for deck in decks:
            _, out, _ = self.run_tool("check", deck, "--format", "sarif")
            results = loads(out)["runs"][0]["results"]
            for result in results:
                for fix in result.get("fixes", []):
                    if len(fix["artifactChanges"]) > 1:
                        continue
                    with self.subTest(deck=deck.name, rule=result["ruleId"]):
                        text = deck.read_text(errors="surrogateescape")
                        repaired = self.replaced(text, fix)
                        self.assertNotEqual(repaired, text)
                        _, after, _ = self.run_tool("check", "-", "--format", "json", "--stdin-filename", deck,
                                                    stdin=repaired.encode(errors="surrogateescape"))
                        left = {finding["fingerprint"] for finding in loads(after)["decks"][0]["findings"]}
                        self.assertNotIn(result["partialFingerprints"]["drawbead/v1"], left)
                        made.add(result["ruleId"])
        self.assertGreaterEqual(len(made), 8, made)

    def test_fix_dry_run(self):
        formats = ["jsonl", "csv", "sarif", "junit", "github", "gitlab"]
        before = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        targets = [word for name in formats for word in ("--output", f"{name}=out.{name}")]
        status, out, err = self.run_tool("fix", "--dry-run", "flipped_0000.rad", "empty_0000.rad", *targets)
        self.assertEqual(status, 2)
        self.assertIn("nothing written", out)
        self.assertIn("empty_0000.rad: error: the file is empty", err)
        files = {name: (self.folder / f"out.{name}").read_bytes() for name in formats}
        self.validate(files)
        for name, content in before.items():
            self.assertEqual((self.folder / name).read_bytes(), content)
        results = loads(files["sarif"])["runs"][0]["results"]
        notes = {r["ruleId"]: r["properties"].get("notes", []) for r in results}
        self.assertTrue(any("'drawbead fix' would repair it: " in note for note in notes["SRF001"]))
        self.assertIn("fixes", next(r for r in results if r["ruleId"] == "SRF001"))
        status, out, _ = self.run_tool("fix", "--dry-run", "flipped_0000.rad", "--format", "sarif")
        SARIF.validate(loads(out))
        self.assert_usage_error("findings in other formats are for a run that writes nothing; please give --dry-run "
                                "instead", "fix", "flipped_0000.rad", "--in-place", "--output", "sarif=x.sarif")

    def test_all_rules_have_help(self):
        files = self.outputs("clean_0000.rad", status=0, formats=["sarif"])
        rules = loads(files["sarif"])["runs"][0]["tool"]["driver"]["rules"]
        _, out, _ = self.run_tool("rules", "--format", "json")
        levels = {"error": "error", "warning": "warning", "info": "note"}
        for rule, known in zip(rules, json.loads(out)["rules"], strict=True):
            self.assertEqual(rule["id"], known["code"])
            self.assertEqual(rule["defaultConfiguration"]["level"], levels[known["severity"]])
            self.assertEqual(rule["help"]["markdown"], self.run_tool("explain", known["code"])[1])
            self.assertNotIn("helpUri", rule)


class Targets(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("bad_0000.rad", tiny(group=9))

    def test_mistakes(self):
        for message, *arguments in [
            ("two formats want standard output; give each a file of its own: --output FORMAT=FILE",
             "--output", "sarif=-", "--output", "junit=-"),
            ("two formats want standard output; give each a file of its own: --output FORMAT=FILE",
             "--format", "json", "--output", "junit=-"),
            ("two formats want the file 'a'; give each a file of its own: --output FORMAT=FILE",
             "--output", "sarif=a", "--output", "junit=a"),
            ("--output 'b' is a second file for one format; write FORMAT=FILE, with one of full, concise, json, jsonl, "
             "csv, sarif, junit, github, gitlab", "-o", "a", "-o", "b"),
            ("--output sarif= names no file; - stands for standard output", "--output", "sarif="),
            ("--output sarif names a format and no file; write sarif=FILE, or ./sarif for a file of this name",
             "--output", "sarif"),
            ("--output knows no format 'sarf'; did you mean 'sarif'? (./sarf=a for a file of this name)",
             "--output", "sarf=a"),
            ("--format knows no 'sarf'; did you mean 'sarif'?", "--format", "sarf"),
            ("--shard needs a part and a number of parts, not '8/7'; such as 2/7: the second of seven", "--shard", "8/7"),
            ("--shard needs a part and a number of parts, not '1'; such as 2/7: the second of seven", "--shard", "1"),
        ]:
            with self.subTest(arguments):
                self.assert_usage_error(message, "check", "bad_0000.rad", *arguments)

    def test_what_cannot_be_written_is_known_before_the_work(self):
        status, out, err = self.run_tool("check", "bad_0000.rad", "--output", "json=a.json",
                                         "--output", "sarif=no/such/folder.sarif")
        self.assertEqual((status, out), (2, ""))
        self.assertEqual(err, "no/such/folder.sarif: error: cannot write: No such file or directory\n")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["bad_0000.rad"])
        status, _, err = self.run_tool("check", "bad_0000.rad", "-o", "bad_0000.rad")
        self.assertEqual((status, err), (2, "bad_0000.rad: error: results would take the place of a file that is "
                                            "read; give --output another file\n"))

    def test_a_full_disk_spares_the_others(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        status, _, err = self.run_tool("check", "bad_0000.rad", "--output", "json=a.json", "--output", "sarif=/dev/full")
        self.assertEqual((status, err), (2, "/dev/full: error: cannot write: No space left on device\n"))
        loads((self.folder / "a.json").read_text())

    def test_plain_names_take_the_format(self):
        status, out, _ = self.run_tool("check", "bad_0000.rad", "--format", "json", "-o", "a=b.json",
                                       "--output", "concise=-")
        self.assertEqual(status, 1)
        self.assertRegex(out, r"^bad_0000\.rad:\d+:\d+: error: REF001 ")
        loads((self.folder / "a=b.json").read_text())
        status, out, _ = self.run_tool("check", "bad_0000.rad", "--format", "concise", "--output", "csv=a.csv")
        self.assertTrue(re.match(r"bad_0000\.rad:\d+:\d+: error: REF001 ", out))


if __name__ == "__main__":
    unittest.main()
