"""`check` says of each sample what stands beside it in NAME.check.txt; DRAWBEAD_UPDATE=1 writes that anew."""

import os
import unittest

from support import SAMPLES, CommandLineTest


class Samples(CommandLineTest):
    def test_each_deck(self):
        decks = sorted(SAMPLES.glob("*_0000.rad"))
        self.assertGreaterEqual(len(decks), 10)
        for deck in decks:
            with self.subTest(deck.name):
                status, out, err = self.run_tool("check", deck.name, "--format", "concise", "-q", cwd=SAMPLES)
                self.assertEqual(err, "")
                self.assertEqual(status, 1 if ": error: " in out else 0)
                golden = SAMPLES / deck.name.replace("_0000.rad", ".check.txt")
                if os.environ.get("DRAWBEAD_UPDATE"):
                    golden.write_text(out)
                self.assertEqual(out, golden.read_text())

    def test_nothing_is_left_over(self):
        names = {deck.name.replace("_0000.rad", "") for deck in SAMPLES.glob("*_0000.rad")}
        self.assertEqual({golden.name[: -len(".check.txt")] for golden in SAMPLES.glob("*.check.txt")} - names, set())


if __name__ == "__main__":
    unittest.main()
