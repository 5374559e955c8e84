"""What a run says by its exit status and its files: per deck, with streams closed, in places that are taken."""

import json
import os
import pathlib
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree as ElementTree

from support import PROGRAM, SAMPLES, CommandLineTest, tiny
from test_schema import loads

CONFIG = ".drawbead.yaml"
WARNING = SAMPLES / "corner_90_0000.rad"  # one warning, no error


class FailOn(CommandLineTest):
    """`fail-on` of a configuration holds for the decks below it, in every format and behind `merge`."""

    def setUp(self):
        super().setUp()
        for folder, word in (("strict", "warning"), ("lax", "never")):
            (self.folder / folder).mkdir()
            (self.folder / folder / CONFIG).write_text(f"fail-on: {word}\n")
        self.write("strict/a_0000.rad", WARNING.read_text())
        self.write("lax/b_0000.rad", tiny(group=9))

    def failures(self, *arguments):
        status, out, _ = self.run_tool(*arguments, "--format", "junit")
        return status, [int(suite.get("failures")) for suite in ElementTree.fromstring(out)]

    def test_junit_agrees_with_the_exit_status(self):
        self.assertEqual(self.failures("check", "strict"), (1, [1]))
        self.assertEqual(self.failures("check", "lax"), (0, [0]))
        self.assertEqual(self.failures("check", "lax", "strict", "--fail-on", "error"), (1, [1, 0]))
        self.assertEqual(self.failures("fix", "--dry-run", "strict"), (1, [1]))

    def test_parts_are_the_whole(self):
        for decks in (["strict"], ["lax"], ["lax", "strict"]):
            for k in (1, 2):
                self.run_tool("check", *decks, "--shard", f"{k}/2", "--fail-on", "never", "-o", f"json={k}.json")
            for name in ("json", "sarif", "junit", "jsonl"):
                with self.subTest(decks=decks, format=name):
                    whole = self.run_tool("check", *decks, "--format", name)[:2]
                    self.assertEqual(self.run_tool("merge", "1.json", "2.json", "--format", name)[:2], whole)
        self.assertEqual(self.failures("merge", "1.json", "2.json", "--fail-on", "error"), (1, [1, 0]))

    def test_reports_of_before(self):
        _, out, _ = self.run_tool("check", "lax", "--format", "json")
        report = json.loads(out)
        self.assertEqual(report["decks"][0].pop("fail_on"), "never")
        self.write("old.json", json.dumps(report))
        self.assertEqual(self.run_tool("merge", "old.json")[0], 1)
        report["decks"][0]["fail_on"] = "perhaps"
        self.write("odd.json", json.dumps(report))
        status, _, err = self.run_tool("merge", "odd.json")
        self.assertEqual(status, 2)
        self.assertIn("fail_on is not a known word", err)


class ClosedStreams(CommandLineTest):
    """A descriptor that was closed by the caller is not given to a file."""

    def setUp(self):
        super().setUp()
        self.write("a_0000.rad", tiny(group=9))

    def run_closed(self, closing, *arguments):
        line = '"$0" "$@" ' + closing
        return subprocess.run(["sh", "-c", line, PROGRAM, *arguments], cwd=self.folder, check=False,
                              capture_output=True).returncode

    def test_standard_output(self):
        status = self.run_closed(">&-", "check", "a_0000.rad", "--output", "full=-", "--output", "json=x.json")
        self.assertEqual(status, 2)
        self.assertEqual(loads((self.folder / "x.json").read_text())["summary"]["errors"], 1)

    def test_standard_error(self):
        status = self.run_closed("2>&-", "check", "a_0000.rad", "lost_0000.rad", "-o", "json=x.json")
        self.assertEqual(status, 2)
        self.assertEqual(loads((self.folder / "x.json").read_text())["summary"]["failed"], 1)

    def test_all(self):
        self.assertEqual(self.run_closed("<&- >&- 2>&-", "check", "a_0000.rad", "-o", "json=x.json"), 1)
        loads((self.folder / "x.json").read_text())


class TakenPlaces(CommandLineTest):
    """Results never take the place of what is read, or of each other."""

    def refused(self, *arguments, why="take the place of a file that is read"):
        before = {path: path.read_bytes() for path in self.folder.rglob("*") if path.is_file()}
        status, _, err = self.run_tool(*arguments)
        self.assertEqual(status, 2, err)
        self.assertIn(why, err)
        for path, content in before.items():
            self.assertEqual(path.read_bytes(), content, path)
        return err

    def test_what_is_read(self):
        for path in SAMPLES.glob("with_includes*"):
            self.write(path.name, path.read_text())
        self.write("c.yaml", "ignore: ENG\n")
        self.write("d_0000.rad", tiny())
        self.run_tool("check", "d_0000.rad", "--write-baseline", "b.json")
        self.refused("check", "with_includes_0000.rad", "-o", "csv=with_includes_mesh.inc", "-o", "json=x.json")
        loads((self.folder / "x.json").read_text())  # the other results are there all the same
        self.refused("check", "d_0000.rad", "--config", "c.yaml", "-o", "csv=c.yaml")
        self.refused("check", "d_0000.rad", "--baseline", "b.json", "-o", "json=b.json")
        self.refused("check", "d_0000.rad", "-o", "json=d_0000.rad")
        self.refused("fix", "--dry-run", "d_0000.rad", "--config", "c.yaml", "-o", "csv=c.yaml")

    def test_each_other(self):
        self.write("d_0000.rad", tiny())
        (self.folder / "here").symlink_to(".")
        why = "two results of this run want this file"
        self.refused("check", "d_0000.rad", "-o", "json=q.json", "-o", "csv=here/q.json", why=why)
        self.refused("check", "d_0000.rad", "--write-baseline", "b.json", "-o", "csv=./b.json", why=why)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.suffix == ".json"], [])
        status = self.run_tool("check", "d_0000.rad")[0]
        self.assertEqual(self.run_tool("check", "d_0000.rad", "-o", "json=/dev/null", "-o", "csv=here/x.csv")[0], status)


class BaselineOfOddNames(CommandLineTest):
    """Decks whose names differ in bytes that are no UTF-8 are different decks."""

    def write_bytes(self, name, text):
        path = os.fsencode(self.folder) + b"/" + name
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def test_new_errors_are_not_hidden(self):
        self.write_bytes(b"a\xe9_0000.rad", tiny(group=9))
        self.write_bytes(b"a\xe8_0000.rad", tiny())
        self.assertEqual(self.run_tool("check", ".", "--write-baseline", "b.json")[0], 0)
        self.assertEqual(self.run_tool("check", ".", "--baseline", "b.json")[0], 0)
        self.write_bytes(b"a\xe8_0000.rad", tiny(group=9))
        self.assertEqual(self.run_tool("check", ".", "--baseline", "b.json")[0], 1)
        self.write_bytes(b"a%e9_0000.rad", tiny())  # what the first one is called in the file
        self.write_bytes(b"a\xe8_0000.rad", tiny())
        _, _, err = self.run_tool("check", ".", "--baseline", "b.json")
        self.assertNotIn("gone", err)

    def test_decks_that_were_not_looked_at_stay(self):
        for name in (b"a\xe9_0000.rad", b"n\nl_0000.rad", b"p%41_0000.rad"):
            self.write_bytes(name, tiny(group=9))
        self.write("x_0000.rad", tiny())
        self.run_tool("check", ".", "--write-baseline", "b.json")
        known = (self.folder / "b.json").read_text()
        _, _, err = self.run_tool("check", "x_0000.rad", "--write-baseline", "b.json")
        self.assertIn("0 added, 0 removed", err)
        self.assertEqual((self.folder / "b.json").read_text(), known)

    def test_another_version_and_devices(self):
        self.write("x_0000.rad", tiny())
        self.write("old.json", '{"schema": 2, "decks": {}}')
        status, _, err = self.run_tool("check", "x_0000.rad", "--write-baseline", "old.json")
        self.assertEqual(status, 2)
        self.assertIn("delete it, and write it anew with --write-baseline", err)
        (self.folder / "old.json").unlink()
        self.assertEqual(self.run_tool("check", "x_0000.rad", "--write-baseline", "old.json")[0], 0)
        if pathlib.Path("/dev/full").exists():
            status, _, err = self.run_tool("check", "x_0000.rad", "--write-baseline", "/dev/full")
            self.assertEqual(status, 2)
            self.assertIn("No space left", err)


class StatisticsOfKnown(CommandLineTest):
    def test_what_rules_found_whatever_is_known(self):
        self.write("a_0000.rad", tiny(group=9))
        self.run_tool("check", ".", "--write-baseline", "b.json")
        for option in ("--baseline", "--write-baseline"):
            _, _, err = self.run_tool("check", ".", "--statistics", option, "b.json")
            self.assertRegex(err, r"REF001 +node-group-undefined +1 ")


class FixInterrupted(CommandLineTest):
    def test_what_is_done_is_written(self):
        for i in range(3):
            self.write(f"{i}_0000.rad", tiny(group=9))
        process = subprocess.Popen([PROGRAM, "fix", "--dry-run", "0_0000.rad", "-", "2_0000.rad", "-o", "sarif=f.sarif",
                                    "-o", "junit=f.xml"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, cwd=self.folder)
        deadline = time.monotonic() + 30
        while not list(self.folder.glob("f.xml.*")) and time.monotonic() < deadline:
            time.sleep(0.01)
        time.sleep(0.2)  # the first deck is done, the second one is waited for
        process.send_signal(signal.SIGINT)
        time.sleep(0.1)
        _, err = process.communicate(tiny().encode(), timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertRegex(err.decode(), r"interrupted: \d of 3 decks are done")
        self.assertEqual(sorted(path.name for path in self.folder.glob("f.*")), ["f.sarif", "f.xml"])
        run = loads((self.folder / "f.sarif").read_text())["runs"][0]
        self.assertEqual((run["invocations"][0]["executionSuccessful"], run["invocations"][0]["exitCode"]), (False, 130))
        self.assertEqual(ElementTree.parse(self.folder / "f.xml").getroot().tag, "testsuites")


if __name__ == "__main__":
    unittest.main()
