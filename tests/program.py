"""The program under test, as a user runs it."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("BRDFTAB", "brdftab")
ROOT = pathlib.Path(__file__).resolve().parent.parent
MATERIALS = ROOT / "host" / "materials"
VINYL = MATERIALS / "brown-vinyl.toml"
GOLDEN = ROOT / "tests" / "golden"

DONE, CHECK_FAILED, BAD_INPUT, DEVICE, FILE, INTERRUPTED = 0, 1, 2, 3, 4, 130
SMALL_GRID = ["--theta-i", "0:80:20", "--theta-s", "0:88:8", "--phi-s", "0:360:30"]


def environment(**changes):
    """The environment with changes; None removes a variable."""
    variables = {**os.environ, **{k: v for k, v in changes.items() if v is not None}}
    for name in [k for k, v in changes.items() if v is None]:
        variables.pop(name, None)
    return variables


def run(*arguments, stdin="", **changes):
    return subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True, text=True,
                          env=environment(**changes), timeout=600)


class InFolder(unittest.TestCase):
    """A test with an empty folder of its own."""

    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self._temporary.cleanup)
        self.folder = pathlib.Path(self._temporary.name)

    def assert_refused(self, result, status, *parts):
        """One line on standard error with every part, the exit status, and no file left in the folder."""
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for part in parts:
            self.assertIn(str(part), result.stderr)
        self.assertEqual(result.stdout, "")
