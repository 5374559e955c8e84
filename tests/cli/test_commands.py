"""The other commands: info, rules, explain, schema, completion, --version, --help."""

import json
import subprocess
import unittest

from support import CommandLineTest, tiny


class General(CommandLineTest):
    def test_version_and_help(self):
        status, out, err = self.run_tool("--version")
        self.assertRegex(out, r"^drawbead \d+\.\d+\.\d+\n$")
        self.assertEqual((status, err), (0, ""))
        for arguments in (["--help"], ["check", "--help"], ["check", "-h"]):
            status, out, err = self.run_tool(*arguments)
            self.assertEqual((status, err), (0, ""))
            self.assertIn("Usage: drawbead", out)
            self.assertIn("Exit status: 0 clean, 1 findings", out)

    def test_usage(self):
        self.assert_usage_error("a command is missing; see 'drawbead --help'")
        self.assert_usage_error("unknown command 'chekc'; did you mean 'check'?", "chekc", "x")
        self.assert_usage_error("unknown command 'frobnicate'; please give one of check, merge, fix, table, info, audit, "
                                "evaluate, plan, accuracy, rules, explain, schema, completion", "frobnicate")
        self.assert_usage_error("unknown option '--verison'; did you mean '--version'?", "--verison")
        self.assert_usage_error("unexpected argument 'b'; see 'drawbead info --help'", "info", "a", "b")


class Info(CommandLineTest):
    def test_json(self):
        self.write("x_0000.rad", tiny())
        status, out, err = self.run_tool("info", "x_0000.rad", "--format", "json")
        self.assertEqual((status, err), (0, ""))
        info = json.loads(out)
        self.assertEqual({name: info[name] for name in ("version", "nodes", "shells4", "shells3", "solids", "parts")},
                         {"version": 2022, "nodes": 7, "shells4": 1, "shells3": 0, "solids": 0, "parts": 1})
        self.assertEqual(info["files"], ["x_0000.rad"])
        self.assertEqual(info["units"]["work"], {"mass": "Mg", "length": "mm", "time": "s"})
        self.assertEqual(info["interfaces_type8"],
                         [{"id": 7, "title": "bead", "nodes": 3, "segments": 1, "length": 6}])
        self.assertEqual(info["keywords"]["/NODE"], 1)
        self.assertEqual(info["keywords"]["/INTER/TYPE8"], 1)

    def test_text(self):
        self.write("x_0000.rad", tiny())
        status, out, _ = self.run_tool("info", "x_0000.rad")
        self.assertEqual(status, 0)
        self.assertIn("\nnodes      7\n", out)
        self.assertIn("\n   7      3         1    6 mm  bead\n", out)

    def test_wrong_input(self):
        status, out, err = self.run_tool("info", "lost_0000.rad")
        self.assertEqual((status, out), (2, ""))
        self.assertIn("lost_0000.rad: error: ", err)
        self.assertEqual(self.run_tool("info", ".")[0], 2)


class Rules(CommandLineTest):
    def test_every_rule_is_listed_and_explained(self):
        rules = json.loads(self.run_tool("rules", "--format=json")[1])["rules"]
        self.assertEqual([rule["code"] for rule in rules], sorted(rule["code"] for rule in rules))
        lines = self.run_tool("rules")[1].splitlines()
        self.assertEqual(lines[0].split()[:4], ["code", "name", "severity", "fix"])
        self.assertEqual([line.split()[:3] for line in lines[1:]],
                         [[rule["code"], rule["name"], rule["severity"]] for rule in rules])
        for rule in rules:
            status, page, _ = self.run_tool("explain", rule["code"])
            self.assertEqual(status, 0)
            self.assertTrue(page.startswith("# " + rule["code"]), page[:40])
            self.assertEqual(self.run_tool("explain", rule["name"])[1], page)
            self.assertEqual(self.run_tool("explain", rule["code"].lower())[1], page)

    def test_unknown(self):
        self.assert_usage_error("no rule 'REF01'; did you mean 'REF001'?", "explain", "REF01")
        self.assert_usage_error("no rule 'nonsense'; 'drawbead rules' lists all", "explain", "nonsense")


class Completion(CommandLineTest):
    def test_unknown(self):
        self.assert_usage_error("no completion script for 'zhs'; did you mean 'zsh'?", "completion", "zhs")
        self.assert_usage_error("no completion script for 'tcl'; there is: bash, zsh, fish", "completion", "tcl")

    def complete(self, *words):
        """What bash offers for the last word."""
        script = self.run_tool("completion", "bash")[1]
        ask = script + '\nCOMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _drawbead; printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "--norc", "-c", ask, "bash", "drawbead", *words], cwd=self.folder,
                              capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split("\n")[:-1]

    def test_bash(self):
        self.write("a b_0000.rad", "")
        (self.folder / "parts").mkdir()
        self.assertEqual(self.complete("ch"), ["check"])
        self.assertEqual(self.complete("--v"), ["--version"])
        self.assertEqual(self.complete("check", "--f"), ["--fail-on", "--format"])
        self.assertEqual(self.complete("check", "--format", "co"), ["concise"])
        self.assertEqual(self.complete("check", "--format", "=", "j"), ["json", "jsonl", "junit"])
        self.assertEqual(self.complete("merge", "--format", "="),
                         ["json", "jsonl", "csv", "sarif", "junit", "github", "gitlab", "full", "concise"])
        self.assertEqual(self.complete("check", "--sh"), ["--shard", "--show-config"])
        self.assertEqual(self.complete("check", "a"), ["a b_0000.rad"])
        self.assertEqual(self.complete("check", "--include-path", ""), ["parts"])
        self.assertEqual(self.complete("check", "--select", "REF00")[:2], ["REF001", "REF002"])
        self.assertEqual(self.complete("explain", "REF001"), ["REF001"])
        self.assertEqual(self.complete("schema", ""),
                         ["accuracy", "audit", "baseline", "config", "evaluation", "fix", "hard-cases", "lines", "plan",
                          "report", "scene", "table"])
        self.assertEqual(self.complete("completion", "f"), ["fish"])

    def test_others_name_every_option(self):
        options = [line.split()[0].split(",")[-1] for line in self.run_tool("check", "--help")[1].splitlines()
                   if line.startswith("  -")]
        self.assertIn("--select", options)
        zsh, fish = self.run_tool("completion", "zsh")[1], self.run_tool("completion", "fish")[1]
        self.assertTrue(zsh.startswith("#compdef drawbead\n"))
        for option in options:
            self.assertIn(option, zsh)
            self.assertIn(f" -l {option[2:]} ", fish)
        for line in fish.splitlines():  # every quote is closed
            self.assertEqual(line.replace("'\\''", "").count("'") % 2, 0, line)


if __name__ == "__main__":
    unittest.main()
