"""`fix` from outside: what it prints, what it writes, and that no byte of the originals is ever lost."""

import json
import os
import resource
import signal
import stat
import subprocess
import time
import unittest

from support import PROGRAM, ROOT, CommandLineTest, tiny

TRUTH = ROOT / "tests" / "truth"


def deck_of(name):
    return (TRUTH / name / f"{name}_0000.rad").read_bytes()


def split_into_include(text, begin, end):
    """(main, include): the blocks from one header up to another in an include of their own."""
    a, b = text.index(begin), text.index(end)
    return text[:a] + b"#include mesh.inc\n" + text[b:], b"# the sheet\n" + text[a:b] + b"#enddata\n"


class Fix(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.deck = self.write("half_0000.rad", deck_of("half"))

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def findings(self, path):
        _, out, _ = self.run_tool("check", "--format", "json", path)
        return {f["code"] for f in json.loads(out)["decks"][0]["findings"]}

    def test_a_dry_run_says_what_would_be_done_and_writes_nothing(self):
        for arguments in ([], ["--dry-run"]):
            status, out, err = self.run_tool("fix", self.deck.name, *arguments)
            self.assertEqual((status, err), (0, ""))
            self.assertEqual(out, "half_0000.rad:213:1: would fix: SRF001 segment-normal-away-from-bead: "
                                  "signed groups in a surface of its own\n"
                                  "  bead 1 'drawbead 1': 50 segments turned, nodes 9; sum of Fn L 3800 N, "
                                  "of Ft L 1900 N; slope 20 MPa; the Starter says 346, 499 -> nothing\n"
                                  "half_0000.rad: 1 repair in 1 file, nothing written; nothing left\n")
        self.assertEqual(self.deck.read_bytes(), deck_of("half"))
        self.assertEqual(self.files(), ["half_0000.rad"])

    def test_the_diff_patches_the_deck_into_what_o_writes(self):
        for name in ("half", "seg_rev", "g_reversed", "twoside_bad"):
            for windows in (False, True):
                for cut in (False, True):
                    text = deck_of(name)
                    if cut:
                        text = text[:text.index(b"/END")].rstrip(b"\n")
                    if windows:
                        text = text.replace(b"\n", b"\r\n")
                    deck = self.write("a_0000.rad", text)
                    _, diff, report = self.run_tool("fix", deck.name, "--diff")
                    self.assertIn("would fix: SRF001", report)
                    self.run_tool("fix", deck.name, "-q", "-o", "out.rad")
                    wanted = (self.folder / "out.rad").read_bytes()
                    self.assertNotEqual(wanted, text)
                    for tool in (["patch", "-p1", "--binary"], ["git", "apply"]):
                        deck.write_bytes(text)
                        done = subprocess.run(tool, input=diff.encode(errors="surrogateescape"), cwd=self.folder,
                                              capture_output=True, check=False,
                                              env={**os.environ, "GIT_CEILING_DIRECTORIES": str(self.folder.parent)})
                        self.assertEqual(done.returncode, 0, (tool, done.stderr, diff[:400]))
                        self.assertEqual(deck.read_bytes(), wanted)

    def test_bytes_outside_the_edits_are_the_same(self):
        text = deck_of("half").replace(b"# half\n", b"# half \xff\xfe \x01\n")
        deck = self.write("a_0000.rad", text)
        status, out, _ = self.run_tool("fix", deck, "--format", "json", "-o", self.folder / "out.rad")
        self.assertEqual(status, 0)
        report = json.loads(out)["decks"][0]
        rebuilt, at = b"", 0
        for edit in report["files"][0]["edits"]:
            rebuilt += text[at:edit["offset"]] + edit["text"].encode()
            at = edit["offset"] + edit["removed"]
            self.assertEqual(edit["line"], text[:edit["offset"]].count(b"\n") + 1)
        rebuilt += text[at:]
        self.assertEqual(rebuilt, (self.folder / "out.rad").read_bytes())
        self.assertEqual(report["written"], [str(self.folder / "out.rad")])
        self.assertEqual(report["interfaces"][0]["segments_turned"], 50)

    def test_in_place_keeps_permissions_and_follows_links(self):
        self.deck.chmod(0o640)
        link = self.folder / "link_0000.rad"
        link.symlink_to(self.deck.name)
        status, _, err = self.run_tool("fix", link, "--in-place")
        self.assertEqual((status, err), (0, ""))
        self.assertTrue(link.is_symlink())
        self.assertEqual(stat.S_IMODE(self.deck.stat().st_mode), 0o640)
        self.assertEqual(self.findings(self.deck), set())
        self.assertEqual(self.files(), ["half_0000.rad", "link_0000.rad"])

    def test_a_second_run_changes_nothing_and_writes_nothing(self):
        self.run_tool("fix", self.deck, "--in-place")
        before = self.deck.stat()
        status, out, _ = self.run_tool("fix", self.deck, "--in-place")
        after = self.deck.stat()
        self.assertEqual((status, out), (0, f"{self.deck}: nothing repaired; nothing left\n"))
        self.assertEqual((before.st_mtime_ns, before.st_ino), (after.st_mtime_ns, after.st_ino))
        self.run_tool("fix", self.deck, "-o", self.folder / "out.rad")
        self.assertFalse((self.folder / "out.rad").exists())

    def test_standard_input_and_output(self):
        status, out, err = self.run_tool("fix", "-", "-o", "-", "--stdin-filename", "x_0000.rad", stdin=deck_of("half"))
        self.assertEqual(status, 0)
        self.assertTrue(err.startswith("x_0000.rad:213:1: fixed: SRF001"), err)
        fixed = self.write("fixed_0000.rad", out)
        self.assertEqual(self.findings(fixed), set())
        status, out, _ = self.run_tool("fix", "-", "-q", "-o", "-", stdin=fixed.read_bytes())
        self.assertEqual((status, out.encode()), (0, fixed.read_bytes()))

    def test_an_include_that_changes(self):
        main, include = split_into_include(deck_of("seg_rev"), b"/SURF/SEG/1", b"/BCS/1")
        deck = self.write("a_0000.rad", main)
        mesh = self.write("mesh.inc", include)
        status, _, err = self.run_tool("fix", deck, "-o", self.folder / "out.rad")
        self.assertEqual(status, 2)
        self.assertIn("the repair changes included files, too; give -o a folder, or use --in-place or --diff", err)
        self.assertFalse((self.folder / "out.rad").exists())
        self.run_tool("fix", deck, "-o", f"{self.folder}/out/")
        self.assertEqual((self.folder / "out" / "a_0000.rad").read_bytes(), main)
        status, _, _ = self.run_tool("fix", deck, "--in-place")
        self.assertEqual(status, 0)
        self.assertEqual(deck.read_bytes(), main)
        self.assertEqual(mesh.read_bytes(), (self.folder / "out" / "mesh.inc").read_bytes())
        self.assertNotEqual(mesh.read_bytes(), include)
        self.assertNotIn("SRF001", self.findings(deck))

    def test_o_never_writes_over_the_deck(self):
        (self.folder / "link.rad").symlink_to(self.deck.name)
        for target in (self.deck, self.folder, self.folder / "link.rad"):
            status, _, err = self.run_tool("fix", self.deck, "-o", target)
            self.assertEqual(status, 2)
            self.assertIn("-o would write over a file of the deck; give -o another place, or use --in-place", err)
        self.assertEqual(self.deck.read_bytes(), deck_of("half"))

    def test_select_and_ignore(self):
        _, out, _ = self.run_tool("fix", self.deck, "--ignore", "SRF")
        self.assertIn("nothing repaired; 2 errors", out)
        _, out, _ = self.run_tool("fix", self.deck, "--select", "SRF002")
        self.assertIn("would fix: SRF002", out)
        self.assert_usage_error("no rule or family 'SRF999'; did you mean 'SRF009'?", "fix", self.deck, "--select",
                                "SRF999")

    def test_words_that_exclude_each_other(self):
        self.assert_usage_error("--diff, --output, --in-place and --dry-run exclude each other; "
                                "see 'drawbead fix --help'", "fix", self.deck, "--diff", "--in-place")
        self.write("b_0000.rad", tiny())
        status, _, err = self.run_tool("fix", self.folder, "-o", "out.rad")
        self.assertEqual((status, err), (2, "drawbead: error: -o takes the repair of one deck, and there are 2; "
                                            "use --in-place or --diff\n"))

    def test_the_exit_status_says_what_is_left(self):
        bad = self.write("bad_0000.rad", tiny(group=9))
        self.assertEqual(self.run_tool("fix", bad)[0], 1)
        self.assertEqual(self.run_tool("fix", bad, "--fail-on", "never")[0], 0)
        self.assertEqual(self.run_tool("fix", "missing_0000.rad")[0], 2)

    def test_several_decks(self):
        other = self.write("other_0000.rad", deck_of("g_reversed"))
        status, out, _ = self.run_tool("fix", self.folder, "--in-place")
        self.assertEqual(status, 0)
        self.assertEqual(out.count("1 repair in 1 file, written:"), 2)
        self.assertEqual(self.findings(self.deck) | self.findings(other), set())


class Mishaps(CommandLineTest):
    """The original stays whole whatever happens."""

    def setUp(self):
        super().setUp()
        self.text = deck_of("half")
        self.deck = self.write("half_0000.rad", self.text)

    def alone(self):
        return [path.name for path in self.folder.iterdir()] == ["half_0000.rad"]

    def test_no_room_on_the_disk(self):
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))
        done = subprocess.run([PROGRAM, "fix", "--in-place", str(self.deck)], capture_output=True, preexec_fn=small_files,
                              check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"cannot write: File too large; no file was changed", done.stderr)
        self.assertEqual(self.deck.read_bytes(), self.text)
        self.assertTrue(self.alone())

    @unittest.skipIf(os.geteuid() == 0, "everything is writable for root")
    def test_a_folder_or_file_that_may_not_be_written(self):
        self.folder.chmod(0o500)
        self.addCleanup(self.folder.chmod, 0o700)
        status, _, err = self.run_tool("fix", "--in-place", self.deck)
        self.assertEqual(status, 2)
        self.assertIn("cannot write beside the file: Permission denied; no file was changed", err)
        self.folder.chmod(0o700)
        self.deck.chmod(0o400)
        status, _, err = self.run_tool("fix", "--in-place", self.deck)
        self.assertEqual(status, 2)
        self.assertIn("cannot write: Permission denied", err)
        self.assertEqual(self.deck.read_bytes(), self.text)
        self.assertTrue(self.alone())

    def test_killed_at_any_moment(self):
        fixed = None
        for step in range(40):
            self.deck.write_bytes(self.text)
            process = subprocess.Popen([PROGRAM, "fix", "-q", "--in-place", str(self.deck)])
            time.sleep(step * 0.0005)
            process.kill()
            process.wait()
            now = self.deck.read_bytes()
            if now != self.text:
                fixed = fixed or now
                self.assertEqual(now, fixed)
            for path in self.folder.iterdir():
                if path != self.deck:
                    path.unlink()
        if fixed is None:
            self.run_tool("fix", "-q", "--in-place", self.deck)
            fixed = self.deck.read_bytes()
        self.assertNotEqual(fixed, self.text)

    def test_changed_while_it_is_repaired(self):
        """A pipe in the place of an include holds the tool while the deck is rewritten."""
        pipe = self.folder / "note.inc"
        os.mkfifo(pipe)
        text = self.text.replace(b"/BCS/1\n", b"#include note.inc\n/BCS/1\n")
        self.deck.write_bytes(text)
        process = subprocess.Popen([PROGRAM, "fix", "--in-place", str(self.deck)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        with open(pipe, "wb") as end:  # opens when the tool reads the include: the deck is in its memory by then
            self.deck.write_bytes(text + b"# somebody else\n")
            end.write(b"# a note\n#enddata\n")
        _, err = process.communicate()
        self.assertEqual(process.returncode, 2)
        self.assertIn(b"the file was changed by somebody else while it was being repaired; "
                      b"no file was changed by this run; run it again", err)
        self.assertEqual(self.deck.read_bytes(), text + b"# somebody else\n")


if __name__ == "__main__":
    unittest.main()
