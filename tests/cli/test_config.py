"""Configuration files, suppressions and baselines from outside."""

import json
import subprocess
import sys
import unittest

import jsonschema

from support import PROGRAM, ROOT, SAMPLES, CommandLineTest, tiny

CONFIG = ".drawbead.yaml"




class Found(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("lib/a/bad_0000.rad", tiny(group=9))  # REF001, an error

    def status(self, *arguments, **kwargs):
        return self.run_tool("check", "-q", "lib/a/bad_0000.rad", *arguments, **kwargs)[0]

    def test_nearest_file_alone_holds(self):
        self.assertEqual(self.status(), 1)
        self.write(CONFIG, "ignore: [ALL]\n")
        self.assertEqual(self.status(), 0)
        self.write("lib/" + CONFIG, "fail-on: error\n")  # nothing is taken from further up
        self.assertEqual(self.status(), 1)
        self.write("lib/a/" + CONFIG, "fail-on: never\n")
        self.assertEqual(self.status(), 0)
        self.assertEqual(self.status("--isolated"), 1)
        self.assertEqual(self.status("--config", CONFIG), 0)
        self.assertEqual(self.status("--config", "lib/" + CONFIG), 1)
        self.assertEqual(self.status(cwd="/", env={}), 2)  # a path from another folder
        self.assertEqual(self.run_tool("check", "-q", self.folder / "lib/a/bad_0000.rad", cwd="/")[0], 0)

    def test_standard_input_is_looked_at_where_it_is_called(self):
        self.write("lib/" + CONFIG, "ignore: [ALL]\n")
        self.assertEqual(self.run_tool("check", "-q", "-", stdin=tiny(group=9))[0], 1)
        self.assertEqual(self.run_tool("check", "-q", "-", "--stdin-filename", "lib/x_0000.rad", stdin=tiny(group=9))[0], 0)

    def test_decks_of_one_run_may_have_different_files(self):
        self.write("lib/b/bad_0000.rad", tiny(group=9))
        self.write("lib/b/" + CONFIG, "severity: {REF001: info}\n")
        status, out, _ = self.run_tool("check", "lib", "--format", "json", "--select", "REF001")
        self.assertEqual(status, 1)
        self.assertEqual([f["severity"] for d in json.loads(out)["decks"] for f in d["findings"]], ["error", "info"])
        self.write("lib/a/" + CONFIG, "fail-on: never\n")
        self.assertEqual(self.run_tool("check", "-q", "lib")[0], 0)
        self.assertEqual(self.run_tool("check", "-q", "lib", "--fail-on", "info")[0], 1)

    def test_overrides_and_the_command_line(self):
        self.write(CONFIG, json.dumps({"select": "PAR", "overrides": [{"paths": "lib/", "select": "REF"}]}))
        self.assertEqual(self.status(), 1)
        self.assertEqual(self.status("--select", "PAR"), 0)
        self.assertEqual(self.status("--ignore", "REF001"), 0)

    def test_include_path(self):
        self.write("common/group.inc", "/GRNOD/NODENS/9\nbead\n        11        12        13\n")
        self.write("lib/a/bad_0000.rad", tiny(group=9).replace("/END", "#include group.inc\n/END"))
        self.assertEqual(self.status("--select", "SYN009"), 1)
        self.write("lib/" + CONFIG, "include-path: ../common\n")
        self.assertEqual(self.status("--select", "SYN009,REF001"), 0)
        self.assertEqual(self.status("--select", "SYN009", "--include-path", "elsewhere"), 1)
        self.assertEqual(self.status("--select", "SYN009", cwd=self.folder / "common"), 2)

    def test_mistakes_stop_the_run(self):
        self.write("lib/b/good_0000.rad", tiny())
        path = self.write("lib/a/" + CONFIG, "ignore: [LIN]\nselct: [REF]\n")
        for arguments in (["lib"], ["lib", "--show-config"]):
            self.assertEqual(self.run_tool("check", *arguments),
                             (2, "", f"lib/a/{CONFIG}:2:1: error: unknown key 'selct'; did you mean 'select'?\n"))
        self.assertEqual(self.run_tool("fix", "lib", "--dry-run")[0], 2)
        self.assertEqual(self.status("--isolated"), 1)
        path.unlink()
        path.mkdir()
        self.assertIn("cannot read the configuration: Is a directory", self.run_tool("check", "lib")[2])
        path.rmdir()
        path.symlink_to("nowhere")
        self.assertIn("cannot read the configuration: No such file", self.run_tool("check", "lib")[2])
        path.unlink()
        path.write_bytes(b"\x00\x01\xff" * 100)
        self.assertIn(f"{CONFIG}:1:1: error: this byte is no text in UTF-8", self.run_tool("check", "lib")[2])
        self.assertIn("none.yaml: error: cannot read the configuration", self.run_tool("check", "lib", "--config", "none.yaml")[2])
        self.assert_usage_error("--config and --isolated exclude each other; give one of them",
                                "check", "lib", "--config", "x", "--isolated")

    def test_what_is_said_twice_or_means_nothing(self):
        self.write("x_0000.rad", tiny())
        for text, message in (
                ("severity: {LIN005: error, lin005: info}", "1:27: error: 'lin005' is 'LIN005' of line 1 again"),
                ("severity:\n  LIN005: info\n  sharp-corner: error", "3:3: error: 'sharp-corner' is 'LIN005' of line 2 again"),
                ("select: []", "1:9: error: select needs a rule at least"),
                ("overrides: [{paths: /}]", "1:21: error: no deck has a path like '/'"),
                ("overrides: [{paths: .}]", "1:21: error: no deck has a path like '.'")):
            with self.subTest(text):
                self.write(CONFIG, text + "\n")
                status, _, err = self.run_tool("check", "x_0000.rad")
                self.assertEqual(status, 2)
                self.assertIn(f"{CONFIG}:{message}", err)

    def test_this_folder_and_signed_numbers(self):
        self.write("x_0000.rad", tiny(group=9))
        self.write(CONFIG, "overrides:\n  - paths: ./\n    ignore: REF\n    limits: {LIN005: {turn-degrees: +40}}\n")
        status, out, _ = self.run_tool("check", "x_0000.rad", "--show-config")
        self.assertEqual(status, 0)
        self.assertRegex(out, r"ignore: \[REF\]")
        self.assertRegex(out, r"turn-degrees: 40 ")

    def test_fix_honours_it(self):
        half = (SAMPLES / "half_flipped_0000.rad").read_text()
        self.write("half_0000.rad", half)
        titles = lambda: [fix["code"] for deck in json.loads(self.run_tool("fix", "half_0000.rad", "--format", "json")[1])["decks"]
                          for fix in deck["applied"]]
        self.assertIn("SRF001", titles())
        self.write(CONFIG, "ignore: [SRF]\n")
        self.assertEqual(titles(), [])


class Show(CommandLineTest):
    def test_every_value_has_its_origin(self):
        self.write("x_0000.rad", tiny())
        self.write(CONFIG, "ignore: [ENG]\nlimits: {LIN005: {turn-degrees: 30}}\n")
        status, out, err = self.run_tool("check", "x_0000.rad", "--show-config", "--select", "lin")
        self.assertEqual((status, err), (0, ""))
        lines = out.splitlines()
        self.assertEqual(lines[0], "# x_0000.rad: .drawbead.yaml")
        self.assertRegex(out, r"(?m)^select: \[LIN\] +# command line$")
        self.assertRegex(out, r"(?m)^ignore: \[ENG\] +# \.drawbead\.yaml:1:9$")
        self.assertRegex(out, r"(?m)^fail-on: error +# default$")
        self.assertRegex(out, r"(?m)^    turn-degrees: 30 +# \.drawbead\.yaml:2:33$")
        for line in lines[1:]:
            self.assertRegex(line, r"# \S|:$")
        # What is printed is a configuration that says the same.
        self.write("shown.yaml", out)
        again = self.run_tool("check", "x_0000.rad", "--show-config", "--config", "shown.yaml")[1]
        values = lambda text: [line.split("#")[0] for line in text.splitlines() if not line.startswith("#")]
        self.assertEqual(values(again), values(out))

    def test_several_decks_and_none(self):
        self.write("a_0000.rad", tiny())
        self.write("b_0000.rad", tiny())
        status, out, _ = self.run_tool("check", ".", "--show-config")
        self.assertEqual(status, 0)
        self.assertEqual(out.count("---\n"), 1)
        self.assertIn("# a_0000.rad: no configuration file", out)
        self.assertEqual(self.run_tool("check", "lost_0000.rad", "--show-config")[0], 2)


class SchemaOfConfig(CommandLineTest):
    SAMPLES = [
        ("{}", True), ('{"select": "LIN"}', True), ('{"select": ["LIN", "ALL"]}', True), ('{"select": []}', False),
        ('{"ignore": []}', True), ('{"overrides": [{"paths": []}]}', False), ('{"overrides": [{"paths": "./"}]}', True),
        ('{"selct": "LIN"}', False), ('{"select": 5}', False), ('{"select": [["LIN"]]}', False),
        ('{"severity": {"LIN": "error", "SRF001": "info"}}', True), ('{"severity": {"LIN": "fatal"}}', False),
        ('{"severity": "error"}', False), ('{"fail-on": "never"}', True), ('{"fail-on": "sometimes"}', False),
        ('{"limits": {"LIN005": {"turn-degrees": 30}}}', True), ('{"limits": {"LIN005": {"turn-degrees": 181}}}', False),
        ('{"limits": {"LIN005": {"turn-degrees": "30"}}}', False), ('{"limits": {"LIN005": {"turn": 30}}}', False),
        ('{"limits": {"LIN999": {}}}', False), ('{"limits": {"PAR007": {"least-n-per-mm": 1e-3}}}', True),
        ('{"overrides": [{"paths": "a/", "ignore": "LIN"}]}', True), ('{"overrides": [{"ignore": "LIN"}]}', False),
        ('{"overrides": [{"paths": ["a", "b"], "overrides": []}]}', False), ('{"paths": "a"}', False),
        ('{"include-path": "../x"}', True), ('{"overrides": [{"paths": "a", "include-path": "x"}]}', False),
        ('[]', False), ('null', True),
    ]

    def test_schema_and_reader_agree(self):
        status, out, _ = self.run_tool("schema", "config")
        self.assertEqual(status, 0)
        schema = json.loads(out)
        jsonschema.Draft7Validator.check_schema(schema)
        validator = jsonschema.Draft7Validator(schema)
        self.write("x_0000.rad", tiny())
        for text, good in self.SAMPLES:
            with self.subTest(text):
                self.assertEqual(validator.is_valid(json.loads(text)), good)
                self.write(CONFIG, text + "\n")
                status, _, err = self.run_tool("check", "x_0000.rad", "--show-config")
                self.assertEqual(status, 0 if good else 2, err)

    def test_generated_files_are_current(self):
        done = subprocess.run([sys.executable, ROOT / "docs" / "make_configuration.py", PROGRAM, "--check"],
                              stdout=subprocess.PIPE, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, b""))


class Suppressed(CommandLineTest):
    def test_counts(self):
        self.write("x_0000.rad", tiny(group=9).replace("/INTER/", "# drawbead: ignore[REF001] made later\n/INTER/"))
        status, out, err = self.run_tool("check", "x_0000.rad", "--format", "json", "--select", "REF,SUP")
        report = json.loads(out)
        self.assertEqual(status, 0)
        self.assertEqual(report["decks"][0]["findings"], [])
        self.assertEqual(report["decks"][0]["suppressed"], 1)
        self.assertEqual(report["summary"]["suppressed"], 1)
        self.assertRegex(err, r"^1 deck, 1 interface: no findings \(1 suppressed\) in ")

    def test_the_family_is_in_the_catalogue(self):
        out = self.run_tool("rules")[1]
        for code in ("SUP001", "SUP002", "SUP003"):
            self.assertIn(code, out)
            self.assertTrue(self.run_tool("explain", code)[1].startswith(f"# {code} "))


class BaselineFile(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("lib/a_0000.rad", tiny(group=9))
        self.write("lib/b_0000.rad", tiny().replace("                50.0", "               -50.0"))

    def check(self, *arguments, cwd=None):
        return self.run_tool("check", "lib", "--format", "concise", *arguments, cwd=cwd)

    def test_from_failing_to_green_and_on(self):
        status, before, _ = self.check()
        self.assertEqual(status, 1)
        count = len(before.splitlines())
        status, out, err = self.check("--write-baseline", "lib/known.json")
        self.assertEqual((status, out), (0, ""))
        self.assertIn(f"lib/known.json: {count} known findings of 2 decks, {count} added, 0 removed\n", err)
        self.assertRegex(err, rf"2 decks, 2 interfaces: no findings \({count} known\) in ")
        schema = json.loads(self.run_tool("schema", "baseline")[1])
        jsonschema.Draft7Validator.check_schema(schema)
        text = (self.folder / "lib/known.json").read_text()
        jsonschema.Draft7Validator(schema).validate(json.loads(text))
        self.assertEqual(list(json.loads(text)["decks"]), ["a_0000.rad", "b_0000.rad"])

        status, out, err = self.check("--baseline", "lib/known.json")
        self.assertEqual((status, out), (0, ""))
        # Lines above, other lines ends, another folder: still known.
        deck = self.folder / "lib/a_0000.rad"
        deck.write_text(deck.read_text().replace("/NODE", "# one\n# two\n/NODE"))
        self.assertEqual(self.check("--baseline", "lib/known.json")[:2], (0, ""))
        (self.folder / "lib").rename(self.folder / "moved")
        self.assertEqual(self.run_tool("check", "-q", "moved", "--baseline", "moved/known.json")[:2], (0, ""))
        self.assertEqual(self.run_tool("check", "-q", ".", "--baseline", "known.json", cwd=self.folder / "moved")[:2], (0, ""))
        (self.folder / "moved").rename(self.folder / "lib")
        # Another interface id is another finding.
        deck.write_text(deck.read_text().replace("/INTER/TYPE8/7", "/INTER/TYPE8/8"))
        status, out, err = self.check("--baseline", "lib/known.json")
        self.assertEqual(status, 1)
        self.assertIn("REF001", out)
        self.assertRegex(err, r"lib/known\.json: \d known findings? (is|are) gone: lib/a_0000\.rad \w+ of interface 7")
        report = json.loads(self.run_tool("check", "lib", "--format", "json", "--baseline", "lib/known.json")[1])
        self.assertIn("REF001", [entry["code"] for entry in report["decks"][0]["gone"]])
        self.assertEqual(report["summary"]["gone"], sum(e["count"] for d in report["decks"] for e in d["gone"]))
        self.assertGreater(report["summary"]["known"], 0)

        err = self.check("--write-baseline", "lib/known.json")[2]
        self.assertRegex(err, r"\d+ added, \d+ removed")
        self.assertEqual(self.check("--baseline", "lib/known.json")[:2], (0, ""))
        (self.folder / "lib/b_0000.rad").unlink()
        err = self.check("--write-baseline", "lib/known.json")[2]
        self.assertIn(" of 1 deck, 0 added, ", err)

    def test_same_bytes_for_any_number_of_threads(self):
        texts = set()
        for threads in ("1", "2"):
            self.check("--write-baseline", f"lib/{threads}.json", "-j", threads)
            texts.add((self.folder / f"lib/{threads}.json").read_text())
        self.assertEqual(len(texts), 1)

    def test_failures(self):
        self.assertEqual(self.check("--baseline", "none.json"),
                         (2, "", "none.json: error: cannot read the baseline: No such file or directory; --write-baseline makes one\n"))
        self.write("broken.json", "{\n")
        for option in ("--baseline", "--write-baseline"):
            status, _, err = self.check(option, "broken.json")
            self.assertEqual(status, 2)
            self.assertIn("broken.json:2:1: error: this is no baseline", err)
        self.assertEqual((self.folder / "broken.json").read_text(), "{\n")
        status, _, err = self.check("--write-baseline", "no/such/folder.json")
        self.assertEqual(status, 2)
        self.assertIn("no/such/folder.json: error: cannot write", err)
        self.assertNotRegex(err, r"decks?, ")  # told before anything was checked
        # A deck that cannot be read still gives 2, and its entries stay.
        self.check("--write-baseline", "known.json")
        (self.folder / "lib/a_0000.rad").write_text("nothing")
        self.assertEqual(self.check("--write-baseline", "known.json")[0], 2)
        self.assertIn("lib/a_0000.rad", (self.folder / "known.json").read_text())


if __name__ == "__main__":
    unittest.main()
