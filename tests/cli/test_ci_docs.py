"""docs/ci.md runs as it is written, and the hooks of pre-commit do what it says."""

import json
import os
import re
import shlex
import shutil
import subprocess
import unittest

from support import PROGRAM, ROOT, SAMPLES, CommandLineTest, tiny

PAGE = (ROOT / "docs" / "ci.md").read_text()
HOOKS = (ROOT / ".pre-commit-hooks.yaml").read_text()


def commands():
    """The lines of fenced blocks that call drawbead, as a shell gets them, with the heading they stand under."""
    heading, fenced, found = "", False, []
    for line in PAGE.splitlines():
        if line.startswith("#") and not fenced:
            heading = line.lstrip("# ")
        if line.startswith("```"):
            fenced = not fenced
        text = re.sub(r"^(- |sh ')", "", line.strip())
        if fenced and text.startswith("drawbead "):
            found.append((heading, text.rstrip("'") if "sh '" in line else text))
    return found


def hooks(text):
    """The hooks in a YAML text: id -> key -> value. Enough YAML for plain scalars, one a line."""
    found, current = {}, None
    for line in text.splitlines():
        if match := re.match(r"\s*- id: (\S+)", line):
            current = found.setdefault(match[1], {})
        elif current is not None and (match := re.match(r"\s+(\w+): (.*)", line)):
            current[match[1]] = match[2]
    return found


class Snippets(CommandLineTest):
    def setUp(self):
        super().setUp()
        decks = self.folder / "decks"
        for name in ("half_flipped", "hood_one_list", "ring_closed", "strip_straight"):
            decks.mkdir(exist_ok=True)
            shutil.copy(SAMPLES / f"{name}_0000.rad", decks)
        self.write("bin/drawbead", f'#!/bin/sh\nexec "{PROGRAM}" "$@"\n').chmod(0o755)
        _, self.help, _ = self.run_tool("check", "--help")

    def shell(self, line, **more):
        environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", **more}
        return subprocess.run(["sh", "-c", line], cwd=self.folder, env=environment, capture_output=True, timeout=120,
                              check=False)

    def test_every_command_runs(self):
        lines = commands()
        self.assertGreaterEqual(len(lines), 9)
        for heading, line in lines:
            if "baseline" in line and "--baseline" not in self.help:
                continue
            turns = range(1, 8) if "CI_NODE_INDEX" in line else [1]
            for turn in turns:
                with self.subTest(line, turn=turn):
                    done = self.shell(line, CI_NODE_INDEX=str(turn), CI_NODE_TOTAL="7")
                    expected = {0} if "--fail-on never" in line or "baseline" in line else {0, 1}
                    self.assertIn(done.returncode, expected, done.stderr.decode())
                    for name in re.findall(r"--output \w+=(\S+)", line):
                        name = name.replace("$CI_NODE_INDEX", str(turn))
                        self.assertTrue(name == "-" or (self.folder / name).stat().st_size > 0)

    def test_a_job_with_findings_fails(self):
        line = next(line for heading, line in commands() if heading == "GitHub")
        done = self.shell(line)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout.decode(), r"(?m)^::error file=decks/half_flipped_0000\.rad,line=\d+,")
        runs = json.loads((self.folder / "drawbead.sarif").read_text())["runs"]
        self.assertEqual(runs[0]["invocations"][0]["exitCode"], 1)

    def test_parts_are_the_whole(self):
        for turn in range(1, 8):
            line = next(line for _, line in commands() if "--shard" in line)
            self.shell(line, CI_NODE_INDEX=str(turn), CI_NODE_TOTAL="7")
        merged = self.shell(next(line for _, line in commands() if line.startswith("drawbead merge")))
        whole = self.shell("drawbead check decks")
        self.assertEqual((merged.returncode, merged.stdout), (whole.returncode, whole.stdout))
        self.assertEqual(whole.returncode, 1)


class PreCommit(CommandLineTest):
    """What pre-commit does with a hook: the files that match are added to the entry; not 0 is a failure."""

    def setUp(self):
        super().setUp()
        self.write("good/a_0000.rad", (SAMPLES / "strip_straight_0000.rad").read_bytes())
        self.write("bad/B_0000.RAD", tiny(group=9))
        self.write("bad/notes.txt", "x")
        self.write("mesh.inc", "# nothing\n")

    def call(self, hook, *changed):
        names = [name for name in changed if re.search(hook["files"], name)]
        if not names:
            return None, ""
        program, *words = shlex.split(hook["entry"])
        self.assertEqual((program, hook["language"]), ("drawbead", "system"))
        status, out, err = self.run_tool(*words, *([] if hook.get("pass_filenames") == "false" else names))
        return status, out + err

    def test_the_files_that_are_committed(self):
        hook = hooks(HOOKS)["drawbead-check"]
        self.assertEqual(self.call(hook, "bad/notes.txt", "mesh.inc"), (None, ""))
        self.assertEqual(self.call(hook, "good/a_0000.rad", "bad/notes.txt")[0], 0)
        status, text = self.call(hook, "good/a_0000.rad", "bad/B_0000.RAD")
        self.assertEqual(status, 1)
        self.assertRegex(text, r"(?m)^bad/B_0000\.RAD:\d+:\d+: error: REF001 ")

    def test_all_decks_when_an_include_changes(self):
        hook = hooks(HOOKS)["drawbead-check-all"]
        self.assertEqual(self.call(hook, "bad/notes.txt"), (None, ""))
        self.assertEqual(self.call(hook, "mesh.inc")[0], 1)

    def test_the_page_shows_the_hook(self):
        shown = hooks(PAGE.split("## pre-commit")[1].split("```")[1])["drawbead-check"]
        ours = hooks(HOOKS)["drawbead-check"]
        self.assertEqual({key: ours[key] for key in shown}, shown)


if __name__ == "__main__":
    unittest.main()
