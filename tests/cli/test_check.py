"""`drawbead check`: what it reads, its exit status, what goes where."""

import json
import os
import pty
import re
import unittest

from support import BEGIN, SAMPLES, CommandLineTest, tiny

SUMMARY = r"in \d+\.\d\d s\n"


class ExitStatus(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("good_0000.rad", (SAMPLES / "strip_straight_0000.rad").read_bytes())
        self.write("bad_0000.rad", tiny(group=9))  # no such group: REF001, an error

    def test_findings_and_fail_on(self):
        for arguments, expected in [
            (["bad_0000.rad"], 1),
            (["bad_0000.rad", "--fail-on", "never"], 0),
            (["bad_0000.rad", "--fail-on=info"], 1),
            (["bad_0000.rad", "--ignore", "ALL"], 0),
            (["bad_0000.rad", "--select", "PAR"], 0),
            (["bad_0000.rad", "--select", "par,ref001"], 1),
            (["bad_0000.rad", "--select", "PAR", "--select", "node-group-undefined"], 1),
            (["good_0000.rad", "--fail-on", "error"], 0),
            (["good_0000.rad", "bad_0000.rad"], 1),
            (["bad_0000.rad", "lost_0000.rad"], 2),
            (["lost_0000.rad", "bad_0000.rad", "--fail-on", "never"], 2),
        ]:
            with self.subTest(arguments):
                self.assertEqual(self.run_tool("check", *arguments)[0], expected)

    def test_the_rest_is_checked(self):
        status, out, err = self.run_tool("check", "lost_0000.rad", "bad_0000.rad", "--format", "concise")
        self.assertEqual(status, 2)
        self.assertIn(" error: REF001 node-group-undefined: ", out)
        self.assertIn("lost_0000.rad: error: no such file or folder", err)
        self.assertRegex(err, r"2 decks, 1 interface: 1 error.*, 1 deck not read " + SUMMARY + "$")

    def test_summary_and_quiet(self):
        status, out, err = self.run_tool("check", "good_0000.rad", "--select", "REF")
        self.assertEqual((status, out), (0, ""))
        self.assertRegex(err, "^1 deck, 1 interface: no findings " + SUMMARY + "$")
        self.assertEqual(self.run_tool("check", "good_0000.rad", "--select", "REF", "-q"), (0, "", ""))
        self.assertEqual(self.run_tool("check", "lost_0000.rad", "-q"),
                         (2, "", "lost_0000.rad: error: no such file or folder\n"))


class WrongInput(CommandLineTest):
    def failure(self, *arguments, stdin=b""):
        status, out, err = self.run_tool("check", "--quiet", *arguments, stdin=stdin)
        self.assertEqual((status, out), (2, ""))
        return err

    def test_messages(self):
        self.write("empty_0000.rad", "")
        self.write("binary_0000.rad", bytes(range(256)) * 40)
        self.write("prose_0000.rad", "this is no deck\n" * 100)
        self.write("decks_0000.rad", tiny())
        (self.folder / "hollow").mkdir()
        self.assertIn("empty_0000.rad: error: the file is empty", self.failure("empty_0000.rad"))
        self.assertIn("binary_0000.rad: error: the file is binary", self.failure("binary_0000.rad"))
        self.assertIn("prose_0000.rad:1:1: error: no /BEGIN keyword", self.failure("prose_0000.rad"))
        self.assertEqual(self.failure("deks_0000.rad"),
                         "deks_0000.rad: error: no such file or folder; did you mean 'decks_0000.rad'?\n")
        self.assertEqual(self.failure("hollow"),
                         "hollow: error: no starter deck (*_0000.rad) in this folder or below; "
                         "name the file itself if it is called otherwise\n")
        self.assertEqual(self.failure("no*_0000.rad"), "no*_0000.rad: error: no file matches this pattern\n")
        self.assertEqual(self.failure(""), "drawbead: error: an empty path\n")
        self.assertIn("<stdin>: error: the file is empty", self.failure("-"))

    def test_unreadable(self):
        if os.geteuid() == 0:
            self.skipTest("root reads everything")
        self.write("secret_0000.rad", tiny()).chmod(0)
        closed = self.folder / "closed"
        closed.mkdir(mode=0o300)
        self.assertIn("Permission denied", self.failure("secret_0000.rad"))
        self.assertIn("closed: error: cannot read the folder: Permission denied", self.failure("closed"))

    def test_broken_link(self):
        (self.folder / "link_0000.rad").symlink_to("nowhere")
        self.assertIn("link_0000.rad: error: ", self.failure("."))

    def test_damaged_decks_end_without_a_crash(self):
        deck = tiny().encode()
        self.write("line_0000.rad", BEGIN.encode() + b"/NODE\n" + b"7" * 3_000_000 + b"\n")
        for step in range(1, 12):
            self.write(f"cut{step}_0000.rad", deck[: len(deck) * step // 12])
        status, out, err = self.run_tool("check", ".", "--format", "json")
        self.assertIn(status, (0, 1, 2))
        self.assertEqual(len(json.loads(out)["decks"]), 12)
        self.assertRegex(err, SUMMARY + "$")


class Paths(CommandLineTest):
    def paths(self, *arguments):
        _, out, _ = self.run_tool("check", "--format", "json", *arguments)
        return [deck["path"] for deck in json.loads(out)["decks"]]

    def setUp(self):
        super().setUp()
        for name in ["b_0000.rad", "a_0000.rad", "a_0001.rad", "x.inc", "sub/c_0000.RAD", "sub/deep/d_0000.rad",
                     ".hidden/e_0000.rad", "other.k", "[f]_0000.rad"]:
            self.write(name, tiny())

    def test_folders(self):
        everything = ["[f]_0000.rad", "a_0000.rad", "b_0000.rad", "sub/c_0000.RAD", "sub/deep/d_0000.rad"]
        self.assertEqual(self.paths("."), everything)
        self.assertEqual(self.paths("sub/"), ["sub/c_0000.RAD", "sub/deep/d_0000.rad"])
        self.assertEqual(self.paths(self.folder), [str(self.folder / name) for name in everything])

    def test_files_are_taken_as_they_are(self):
        self.assertEqual(self.paths("other.k", "x.inc", "a_0001.rad"), ["other.k", "x.inc", "a_0001.rad"])
        self.assertEqual(self.paths("[f]_0000.rad"), ["[f]_0000.rad"])
        self.assertEqual(self.paths("--", "b_0000.rad"), ["b_0000.rad"])

    def test_patterns(self):
        self.assertEqual(self.paths("[ab]_0000.rad"), ["a_0000.rad", "b_0000.rad"])
        self.assertEqual(self.paths("**/*_0000.rad"),
                         ["[f]_0000.rad", "a_0000.rad", "b_0000.rad", "sub/deep/d_0000.rad"])
        self.assertEqual(self.paths("s*"), ["sub/c_0000.RAD", "sub/deep/d_0000.rad"])
        self.assertEqual(self.paths(str(self.folder / "sub" / "*" / "d*")), [str(self.folder / "sub/deep/d_0000.rad")])

    def test_each_deck_once(self):
        self.assertEqual(self.paths("b_0000.rad", "./b_0000.rad", "sub/../b_0000.rad", "b*"), ["b_0000.rad"])

    def test_links_do_not_go_round(self):
        (self.folder / "sub" / "up").symlink_to("..")
        self.assertEqual(self.paths("sub"), ["sub/c_0000.RAD", "sub/deep/d_0000.rad"])


class StandardInput(CommandLineTest):
    def test_name(self):
        _, out, _ = self.run_tool("check", "-", "--format=concise", stdin=tiny(group=9))
        self.assertRegex(out, r"(?m)^<stdin>:\d+:\d+: error: REF001 ")
        _, out, _ = self.run_tool("check", "-", "--format=concise", "--stdin-filename", "hood_0000.rad",
                                  stdin=tiny(group=9))
        self.assertRegex(out, r"(?m)^hood_0000.rad:\d+:\d+: error: REF001 ")

    def test_includes_lie_beside_the_name(self):
        self.write("model/mesh.inc", "/NODE\n         1                 0.0                 0.0                 0.0\n#enddata\n")
        _, out, _ = self.run_tool("info", "-", "--format=json", "--stdin-filename", "model/x_0000.rad",
                                  stdin=BEGIN + "#include mesh.inc\n/END\n")
        info = json.loads(out)
        self.assertEqual((info["nodes"], info["files"]), (1, ["model/x_0000.rad", "model/mesh.inc"]))

    def test_it_takes_the_place_of_the_file_on_disk(self):
        self.write("x_0000.rad", "not what is checked")
        status, out, _ = self.run_tool("check", "-", "--stdin-filename", "x_0000.rad", "--select=REF", stdin=tiny())
        self.assertEqual((status, out), (0, ""))


class Output(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("bad_0000.rad", tiny(group=9))

    def test_file(self):
        _, direct, _ = self.run_tool("check", "bad_0000.rad")
        status, out, _ = self.run_tool("check", "bad_0000.rad", "-o", "report.txt")
        self.assertEqual((status, out), (1, ""))
        self.assertEqual((self.folder / "report.txt").read_text(), direct)
        self.assertEqual(sorted(os.listdir(self.folder)), ["bad_0000.rad", "report.txt"])

    def test_unwritable(self):
        for where, message in [("no/report.txt", "No such file or directory"), (".", "Is a directory"),
                               ("/dev/full", "No space left on device")]:
            with self.subTest(where):
                status, out, err = self.run_tool("check", "bad_0000.rad", "-q", "-o", where)
                self.assertEqual((status, out, err), (2, "", f"{where}: error: cannot write: {message}\n"))
        with open("/dev/full", "wb") as full:
            status, _, err = self.run_tool("check", "bad_0000.rad", stdout=full)
            self.assertEqual((status, err), (2, "standard output: error: cannot write: No space left on device\n"))
            self.assertEqual(self.run_tool("--version", stdout=full)[0], 2)

    def test_closed_pipe_is_quiet(self):
        reading, writing = os.pipe()
        os.close(reading)
        with os.fdopen(writing, "wb") as closed:
            status, _, err = self.run_tool("check", "bad_0000.rad", stdout=closed)
        self.assertEqual((status, err), (2, ""))

    def test_colour(self):
        def coloured(*arguments, **env):
            return "\x1b[" in self.run_tool("check", "bad_0000.rad", *arguments, env=env)[1]

        self.assertFalse(coloured())
        self.assertTrue(coloured("--color=always"))
        self.assertTrue(coloured("--color", "always", NO_COLOR="1"))
        self.assertTrue(coloured(CLICOLOR_FORCE="1"))
        self.assertFalse(coloured(CLICOLOR_FORCE="0"))
        self.assertFalse(coloured(CLICOLOR_FORCE="1", NO_COLOR="1"))
        self.assertFalse(coloured("--color=never", CLICOLOR_FORCE="1"))
        self.assertFalse(coloured("--format=json", CLICOLOR_FORCE="1"))

    def test_terminal(self):
        try:
            for end in pty.openpty():
                os.close(end)
        except OSError as reason:  # a chroot without /dev/pts
            self.skipTest(str(reason))

        def on_terminal(*arguments, **env):
            ours, theirs = pty.openpty()
            with os.fdopen(theirs, "wb") as terminal:
                self.run_tool("check", "bad_0000.rad", *arguments, stdout=terminal, env={"TERM": "xterm", **env})
                shown = os.read(ours, 100_000)
            os.close(ours)
            return b"\x1b[" in shown

        self.assertTrue(on_terminal())
        self.assertFalse(on_terminal(NO_COLOR="1"))
        self.assertFalse(on_terminal(TERM="dumb"))
        self.assertFalse(on_terminal("--color=never"))

    def test_formats_agree(self):
        _, concise, _ = self.run_tool("check", "bad_0000.rad", "--format", "concise")
        _, full, _ = self.run_tool("check", "bad_0000.rad", "--format", "full")
        _, text, _ = self.run_tool("check", "bad_0000.rad", "--format", "json")
        findings = json.loads(text)["decks"][0]["findings"]
        self.assertEqual(len(concise.splitlines()), len(findings))
        self.assertEqual([line for line in full.splitlines() if re.match(r"\S+: (error|warning|info): ", line)],
                         concise.splitlines())
        for line, finding in zip(concise.splitlines(), findings):
            place = finding["places"][0]
            self.assertTrue(line.startswith(f"{place['file']}:{place['line']}:{place['column']}: {finding['severity']}: "
                                            f"{finding['code']} {finding['name']}: {finding['message']}"), line)


class Threads(CommandLineTest):
    def test_same_bytes(self):
        for i in range(150):  # more than may wait for a slow one
            self.write(f"d{i:03}_0000.rad", tiny(group=1 + i % 3))
        for form in ("full", "concise", "json"):
            with self.subTest(form):
                one = self.run_tool("check", ".", SAMPLES, "lost", "--format", form, "-j1")[:2]
                for threads in ("2", "7", "0"):
                    self.assertEqual(self.run_tool("check", ".", SAMPLES, "lost", "--format", form, "-j", threads)[:2], one)
                self.assertEqual(one[0], 2)

    def test_locale_does_not_matter(self):
        self.write("bad_0000.rad", tiny(group=9))
        plain = self.run_tool("check", "bad_0000.rad", "--format=json")[:2]
        self.assertEqual(self.run_tool("check", "bad_0000.rad", "--format=json", env={"LC_ALL": "de_DE.UTF-8"})[:2], plain)


class Usage(CommandLineTest):
    def test_messages(self):
        self.assert_usage_error("unknown option '--formt'; did you mean '--format'?", "check", "--formt", "x")
        self.assert_usage_error("--format knows no 'jsn'; did you mean 'json'?", "check", "--format", "jsn", "x")
        self.assert_usage_error("--fail-on knows no 'x'; please give one of error, warning, info, never",
                                "check", "--fail-on", "x", "y")
        self.assert_usage_error("no rule or family 'REF0001'; did you mean 'REF001'?", "check", "--select", "REF0001", "x")
        self.assert_usage_error("no rule or family 'nonsense'; 'drawbead rules' lists all",
                                "check", "--ignore", "PAR,nonsense", "x")
        self.assert_usage_error("no rule or family ''; 'drawbead rules' lists all", "check", "--select", "", "x")
        self.assert_usage_error("-j needs a number of threads, not '-1'; please give 0 (all cores) to 1024",
                                "check", "--threads=-1", "x")
        self.assert_usage_error("check needs an argument: PATH is required; see 'drawbead check --help'", "check")
        self.assert_usage_error("--select: 1 required RULE missing; see 'drawbead check --help'", "check", "x", "--select")


if __name__ == "__main__":
    unittest.main()
