"""What the tests of the command line share: the program, small decks, a folder of their own."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["DRAWBEAD"]
ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"

BEGIN = """#RADIOSS STARTER
/BEGIN
tiny
      2022         0
                  Mg                  mm                   s
                  Mg                  mm                   s
"""
# A bead of three nodes over one shell; {group} is the group that the interface asks for.
TINY = BEGIN + """/MAT/ELAST/1
steel
            7.85e-09
            210000.0                 0.3
/PROP/SHELL/1
sheet
        24         4
                 0.0                 0.0                 0.0                 0.0                 0.0
         5                           1.0                 0.0
/PART/1
blank
         1         1         0
/NODE
         1                 0.0                 0.0                 0.0
         2                10.0                 0.0                 0.0
         3                10.0                10.0                 0.0
         4                 0.0                10.0                 0.0
        11                 2.0                 5.0                 3.0
        12                 5.0                 5.0                 3.0
        13                 8.0                 5.0                 3.0
/SHELL/1
         1         1         2         3         4
/GRNOD/NODENS/1
bead
        11        12        13
/BCS/1
the bead is held
#  Tra rot   skew_ID  grnod_ID
   111 111         0         1
/SURF/PART/1
blank
         1
/INTER/TYPE8/7
bead
         {group}         1                   2
                50.0                20.0                 2.0                 0.0                 0.0
                 0.0                 0.0
/END
"""


def tiny(group=1):
    return TINY.replace("{group}", str(group))


class CommandLineTest(unittest.TestCase):
    """Runs the program in a folder of its own."""

    maxDiff = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content)
        return path

    def run_tool(self, *arguments, stdin=b"", cwd=None, stdout=subprocess.PIPE, env=None):
        """(exit status, standard output, standard error); the texts decoded so that no byte is lost."""
        if isinstance(stdin, str):
            stdin = stdin.encode()
        environment = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "CLICOLOR_FORCE")}
        environment.update(env or {})
        done = subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, stdout=stdout, stderr=subprocess.PIPE,
                              cwd=cwd or self.folder, env=environment, timeout=120, check=False)
        out = done.stdout.decode(errors="surrogateescape") if done.stdout is not None else ""
        return done.returncode, out, done.stderr.decode(errors="surrogateescape")

    def assert_usage_error(self, message, *arguments):
        status, out, err = self.run_tool(*arguments)
        self.assertEqual(err, f"drawbead: error: {message}\n")
        self.assertEqual((status, out), (2, ""))
