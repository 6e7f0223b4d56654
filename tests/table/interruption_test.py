"""Interrupted and killed runs leave no table under the final name; memory does not grow with the table."""

import os
import shutil
import signal
import subprocess
import time
import unittest

from program import DONE, INTERRUPTED, PROGRAM, SMALL_GRID, VINYL, InFolder, run

# The table has about 4 GB, which take long enough to be stopped in the middle.
LARGE_GRID = ["--theta-i", "0:85:5", "--phi-i", "0:355:5", "--theta-s", "0:89:1", "--phi-s", "0:360:0.04"]
LARGE_BYTES = 18 * 72 * 90 * 9001 * 4


class Interruption(InFolder):
    def stopped(self, table, *signals, options=()):
        command = [PROGRAM, "generate", VINYL, "-o", table, "--force", *LARGE_GRID, *options]
        process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 120
        # The signal comes once samples have reached the partial file's disk blocks.
        while process.poll() is None and time.monotonic() < deadline:
            partial = [f for f in self.folder.iterdir() if f.name.startswith(f".{table.name}.")]
            if partial and partial[0].stat().st_blocks * 512 > 20e6:
                break
            time.sleep(0.01)
        self.assertIsNone(process.poll(), "finished before it could be stopped")
        process.send_signal(signals[0])
        _, talk = process.communicate(timeout=120)
        return process.returncode, talk

    def setUp(self):
        super().setUp()
        if shutil.disk_usage(self.folder).free < 3 * LARGE_BYTES:
            self.skipTest("less than 12 GB of free space")

    def test_sigint_leaves_nothing(self):
        table = self.folder / "t.h5"
        status, talk = self.stopped(table, signal.SIGINT)
        self.assertEqual(status, INTERRUPTED, talk)
        self.assertIn("interrupted", talk)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_sigint_while_openexr_is_written_leaves_nothing(self):
        table = self.folder / "t.exr"
        status, talk = self.stopped(table, signal.SIGINT, options=["--exr-layout", "tiles"])
        self.assertEqual(status, INTERRUPTED, talk)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_earlier_table_is_untouched(self):
        table = self.folder / "t.h5"
        self.assertEqual(run("generate", VINYL, "-o", table, *SMALL_GRID).returncode, DONE)
        before = table.read_bytes()
        for signals in ((signal.SIGINT,), (signal.SIGTERM,), (signal.SIGKILL,)):
            self.stopped(table, *signals)
            self.assertEqual(table.read_bytes(), before)
        partial = [f for f in self.folder.iterdir() if f != table]
        self.assertLessEqual(len(partial), 1, "only a killed run may leave its partial file")

    def test_sigkill_leaves_no_table(self):
        table = self.folder / "t.h5"
        status, _ = self.stopped(table, signal.SIGKILL)
        self.assertEqual(status, -signal.SIGKILL)
        self.assertFalse(table.exists())


class Memory(InFolder):
    def check(self, name, *options):
        if shutil.disk_usage(self.folder).free < 3 * LARGE_BYTES:
            self.skipTest("less than 12 GB of free space")
        table = self.folder / name
        process = subprocess.Popen([PROGRAM, "generate", VINYL, "-q", "-o", table, *LARGE_GRID, *options])
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, DONE)
        self.assertGreater(table.stat().st_size, LARGE_BYTES)
        self.assertLess(usage.ru_maxrss * 1024, 512e6)

    def test_4_gb_of_hdf5_take_less_than_512_mb(self):
        self.check("t.h5")

    def test_4_gb_of_openexr_take_less_than_512_mb(self):
        self.check("t.exr", "--exr-layout", "tiles")


if __name__ == "__main__":
    unittest.main()
