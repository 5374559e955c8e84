"""Many decks in one run: order, shards and their union, interruption, statistics."""

import json
import os
import pty
import re
import shutil
import signal
import subprocess
import time
import unittest

from support import PROGRAM, SAMPLES, CommandLineTest, tiny
from test_formats import FORMATS


class Shards(CommandLineTest):
    def setUp(self):
        super().setUp()
        for name in ("corner_90", "half_flipped", "hood_one_list", "ring_open", "strip_straight", "u_channel"):
            shutil.copy(SAMPLES / f"{name}_0000.rad", self.folder)
        for k in range(5):
            self.write(f"sub/t{k}_0000.rad", tiny(group=1 + 8 * (k % 2)))
        self.write("sub/t2_0000.rad", "")
        self.write("sub/t3_0000.rad", tiny(group=9).replace("bead\n        11", "B\xf6rdel\n        11").encode("latin-1"))
        self.paths = ["sub", "hood_one_list_0000.rad", ".", "lost_0000.rad"]

    def run_into(self, folder, *arguments, command="check"):
        (self.folder / folder).mkdir()
        targets = [word for name in FORMATS for word in ("--output", f"{name}={folder}/{name}")]
        status, out, err = self.run_tool(command, *arguments, *targets)
        self.assertEqual((status, out), (2, ""), err)
        return {name: (self.folder / folder / name).read_bytes() for name in FORMATS}

    def test_threads_and_shards_give_the_same_bytes(self):
        single = self.run_into("one", *self.paths, "-j1")
        self.assertEqual(json.loads(single["json"])["summary"]["decks"], 12)
        self.assertEqual(self.run_into("two", *self.paths, "-j2"), single)
        for of in (1, 3, 7, 20):
            with self.subTest(of):
                reports = []
                for number in range(1, of + 1):
                    reports.append(f"{of}.{number}.json")
                    self.run_tool("check", *self.paths, "--shard", f"{number}/{of}", "--output", f"json={reports[-1]}")
                self.assertEqual(self.run_into(f"merged{of}", *reversed(reports), command="merge"), single)

    def test_whole_runs_are_joined_in_the_order_given(self):
        for name in ("ring_open", "corner_90"):
            self.run_tool("check", f"{name}_0000.rad", "--output", f"json={name}.json")
        status, out, err = self.run_tool("merge", "ring_open.json", "corner_90.json")
        _, both, _ = self.run_tool("check", "ring_open_0000.rad", "corner_90_0000.rad", "--format", "json")
        self.assertEqual(out, both)
        self.assertRegex(err, "^2 decks, 2 interfaces: ")

    def test_what_cannot_be_merged(self):
        for number in (1, 2, 3):
            self.run_tool("check", "sub", "--shard", f"{number}/3", "--output", f"json={number}.json")
        self.run_tool("check", "sub", "--output", "json=whole.json")
        self.run_tool("check", "sub", "--shard", "1/2", "--output", "json=half.json")
        text = (self.folder / "whole.json").read_text()
        self.write("cut.json", text[: len(text) // 2])
        self.write("other.json", "{}\n")
        self.write("later.json", text.replace('"schema": 1', '"schema": 2'))
        self.write("wrong.json", re.sub(r'"severity": "error"', '"severity": "fatal"', text, count=1))
        self.write("short.json", text.replace('"place_count"', '"places_count"', 1))
        for message, *reports in [
            ("drawbead: error: of 3 shards, these are missing: 2; give the reports of all of them", "1.json", "3.json"),
            ("1.json: error: shard 1 of 3 is given twice", "1.json", "2.json", "1.json"),
            ("whole.json: error: not a part of the same run as '1.json'; merge all shards of one run, or whole runs",
             "1.json", "whole.json"),
            ("half.json: error: not a part of the same run as '1.json'; merge all shards of one run, or whole runs",
             "1.json", "half.json"),
            ("other.json: error: this is no report of 'drawbead check --format json'", "other.json"),
            ("lost.json: error: cannot read 'lost.json': No such file or directory", "lost.json"),
            ("sub: error: cannot read 'sub': it is a folder", "sub"),
            ("later.json: error: the report is of schema 2, and 1 is the one known here", "later.json"),
            ("wrong.json: error: not a report as it should be: decks[0].findings[0].severity is not a known word",
             "wrong.json"),
            ("short.json: error: not a report as it should be: decks[0].findings[0].\"place_count\" is missing",
             "short.json"),
        ]:
            with self.subTest(reports):
                status, out, err = self.run_tool("merge", *reports)
                self.assertEqual((status, out), (2, ""))
                self.assertIn(message, err)
        status, out, err = self.run_tool("merge", "cut.json")
        self.assertEqual((status, out), (2, ""))
        self.assertRegex(err, r"^cut\.json:\d+:\d+: error: this is no JSON, or it is cut; give reports")

    def test_statistics(self):
        _, plain, _ = self.run_tool("check", ".", "--format", "json")
        status, out, err = self.run_tool("check", ".", "--format", "json", "--statistics")
        self.assertEqual((status, out), (2, plain))
        self.assertRegex(err, r"\nREF001 +node-group-undefined +2 +\d+\.\d\d\n")
        self.assertRegex(err, r"\n +reading decks +\d+\.\d\d\n")


class Interrupted(CommandLineTest):
    """The third deck comes from standard input, which keeps the run waiting until it is told to stop."""

    def setUp(self):
        super().setUp()
        for name in "abd":
            self.write(f"{name}_0000.rad", tiny(group=9))

    def interrupt(self, number, *arguments):
        process = subprocess.Popen([PROGRAM, "check", "-j1", "a_0000.rad", "lost_0000.rad", "-", "d_0000.rad",
                                    *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, cwd=self.folder)
        line = process.stderr.readline()  # of the second deck: the third is next
        self.assertIn(b"lost_0000.rad: error: no such file", line)
        process.send_signal(number)
        try:
            process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            process.stdin.close()  # the signal came before the wait for standard input began
        out, err = process.stdout.read(), process.stderr.read()
        process.wait(timeout=60)
        for stream in (process.stdin, process.stdout, process.stderr):
            stream.close()
        return process.returncode, out, err.decode()

    def test_what_is_done_is_written(self):
        targets = [word for name in FORMATS for word in ("--output", f"{name}=out.{name}")]
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number):
                got, out, err = self.interrupt(number, *targets)
                self.assertEqual((got, out), (status, b""))
                self.assertRegex(err, r"2 decks, 1 interface: 1 error.*, 1 deck not read, interrupted after 2 of 4 in")
                report = json.loads((self.folder / "out.json").read_text())
                self.assertEqual([deck["path"] for deck in report["decks"]], ["a_0000.rad", "lost_0000.rad"])
                self.assertEqual((report["summary"]["interrupted"], report["summary"]["asked"]), (True, 4))
                sarif = json.loads((self.folder / "out.sarif").read_text())["runs"][0]["invocations"][0]
                self.assertEqual((sarif["executionSuccessful"], sarif["exitCode"]), (False, status))
                for name in ("sarif", "junit", "github", "gitlab", "csv"):
                    self.assertIn("interrupted after 2 of 4", (self.folder / f"out.{name}").read_text())
                self.assertEqual(len(list(self.folder.glob("out.*"))), len(FORMATS))

    def test_a_part_of_a_run_can_be_merged(self):
        self.interrupt(signal.SIGINT, "--output", "json=part.json")
        status, out, err = self.run_tool("merge", "part.json")
        self.assertEqual(status, 2)
        self.assertEqual(out, (self.folder / "part.json").read_text())
        self.assertIn("interrupted after 2 of 4", err)


class ProgressLine(CommandLineTest):
    def test_rate_and_time_left(self):
        try:
            for end in pty.openpty():
                os.close(end)
        except OSError as reason:  # a chroot without /dev/pts
            self.skipTest(str(reason))
        self.write("a_0000.rad", tiny())
        self.write("c_0000.rad", tiny())
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, "check", "-j1", "-", "a_0000.rad", "c_0000.rad"], stdin=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL, stderr=theirs, cwd=self.folder)
        time.sleep(0.8)  # the line is shown after half a second
        process.communicate(tiny().encode(), timeout=60)
        os.close(theirs)
        shown = b""
        try:
            while part := os.read(ours, 100_000):
                shown += part
        except OSError:  # the other end is closed
            pass
        os.close(ours)
        self.assertRegex(shown.decode(), r"\[1/3\] \d+(\.\d)?/s, \d+ s left  <stdin>")
        self.assertRegex(shown.decode(), r"\r\x1b\[K3 decks, 3 interfaces: ")


if __name__ == "__main__":
    unittest.main()
