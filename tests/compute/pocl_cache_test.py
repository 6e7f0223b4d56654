"""PoCL's compiled kernels between runs: damaged, killed and simultaneous starts give the right bytes and end by themselves."""

import fcntl
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

from program import DEVICE, DONE, PROGRAM, SMALL_GRID, VINYL, InFolder, environment, run

REPAIRED = "was damaged"


def drop_tail(share):
    return lambda file: os.truncate(file, int(file.stat().st_size * share))


def change(edit):
    """A damage that edits a file's bytes in place."""

    def damage(file):
        content = bytearray(file.read_bytes())
        edit(content)
        file.write_bytes(content)

    return damage


def overwrite(offset, new):
    def edit(content):
        content[offset:offset + len(new)] = new

    return change(edit)


def zero_tail(content):
    half = len(content) // 2
    content[half:] = bytes(len(content) - half)


def flip_bit_amidst(content):
    content[len(content) // 2] ^= 0x10


def replace_by_folder(file):
    file.unlink()
    file.mkdir()
    (file / "inside").write_text("x")


def replace_by_link(file):
    file.unlink()
    file.symlink_to("/etc/hostname")


def replace_by_fifo(file):
    file.unlink()
    os.mkfifo(file)


DAMAGES = {
    "empty": drop_tail(0), "ten bytes": lambda file: os.truncate(file, 10), "ELF header only": lambda file: os.truncate(file, 64),
    "a third": drop_tail(0.3), "two thirds": drop_tail(0.6), "nine tenths": drop_tail(0.9),
    "all but a byte": lambda file: os.truncate(file, file.stat().st_size - 1), "magic number": overwrite(0, b"X"),
    "program headers": overwrite(0x20, b"\xff"), "section headers": overwrite(0x28, b"\xff\xff\xff"),
    "zeros at the end": change(zero_tail), "one bit": change(flip_bit_amidst),
    "more bytes": change(lambda content: content.extend(b"more")), "folder": replace_by_folder, "link": replace_by_link,
    "fifo": replace_by_fifo,
}


class PoclCache(InFolder):
    @classmethod
    def setUpClass(cls):
        listed = run("devices").stdout
        if "Portable Computing Language" not in listed:
            raise unittest.SkipTest(f"the driver is not PoCL: {listed.strip()}")
        # Makes a warm cache, and keeps the bytes of a table.
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.warm = pathlib.Path(temporary.name)
        first = cls("start")
        first.folder, first.cache, first.expected = cls.warm, cls.warm / "cache", None
        first.start()
        cls.expected = first.expected

    def setUp(self):
        super().setUp()
        self.cache = self.folder / "cache"

    def warm_up(self):
        shutil.copytree(self.warm / "cache", self.cache)

    def process(self, name, *options):
        """A start in a folder of its own, so that each writes the same bytes."""
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        command = [os.path.abspath(shutil.which(PROGRAM)), "generate", VINYL, "-o", "t.h5", "--force", "--device", "portable",
                   *SMALL_GRID, *options]
        return subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=environment(POCL_CACHE_DIR=str(self.cache), SOURCE_DATE_EPOCH="0"))

    def assert_right(self, process, repaired, name="one"):
        """The end of a start: by itself, with the bytes of every other."""
        _, errors = process.communicate(timeout=600)
        self.assertEqual(process.returncode, DONE, errors)
        self.assertEqual(REPAIRED in errors, repaired, errors)
        data = (self.folder / name / "t.h5").read_bytes()
        self.assertEqual(data, self.expected or data)
        self.expected = data
        return errors

    def start(self, repaired=False, options=()):
        return self.assert_right(self.process("one", *options), repaired)

    def kernels(self):
        """What is kept; the end of each name is the checksum of the content."""
        return sorted(f for f in self.cache.glob("brdftab-pocl-*/kernels/**/*") if f.is_file())

    def kernel(self, name):
        [found] = [f for f in self.kernels() if f.stem == name]
        return found

    def assert_warm(self):
        """Nothing is compiled, said or left over."""
        before = self.kernels()
        self.start()
        self.assertEqual(self.kernels(), before)
        self.assertEqual([f.name for f in self.cache.glob("brdftab-pocl-*/*")], ["kernels"])

    def test_the_first_start_says_nothing_of_its_compiler(self):
        pairs = "theta_i_deg,theta_s_deg,phi_deg\n10,20,30\n"
        result = run("evaluate", VINYL, stdin=pairs, POCL_CACHE_DIR=str(self.cache))
        self.assertEqual((result.returncode, result.stderr), (DONE, ""))

    def test_damaged_files_are_compiled_anew(self):
        self.warm_up()
        names = [f.stem for f in self.kernels()]
        for file, damages in [("normalizations.so", DAMAGES), ("program.bc", ["empty", "two thirds", "zeros at the end"])]:
            for name in damages:
                with self.subTest(file=file, damage=name):
                    DAMAGES[name](self.kernel(file))
                    errors = self.start(repaired=True)
                    self.assertEqual(sum(REPAIRED in line for line in errors.splitlines()), 1, errors)
                    self.assertIn(file, errors)
                    self.assertEqual([f.stem for f in self.kernels()], names)
        self.assert_warm()

    def test_kernel_of_another_size_is_as_wrong(self):
        """A whole kernel, but not the one that its place is for."""
        self.warm_up()
        self.kernel("dhrs.so").write_bytes(self.kernel("normalizations.so").read_bytes())
        self.start(repaired=True)
        self.assert_warm()

    def test_damaged_folders(self):
        self.warm_up()
        [store] = self.cache.glob("brdftab-pocl-*/kernels")
        (store / "stray").write_text("no checksum in its name")
        kernel = self.kernel("dhrs.so").parent
        shutil.rmtree(kernel)
        kernel.write_text("no folder")
        self.assertIn("2 files in all", self.start(repaired=True))
        shutil.rmtree(store)
        store.write_text("no folder")
        self.start(repaired=True)
        self.assert_warm()

    def test_quiet(self):
        self.warm_up()
        os.truncate(self.kernel("dhrs.so"), 5000)
        process = self.process("one", "-q")
        self.assertEqual(process.communicate(timeout=600), ("", ""))
        self.assertEqual(process.returncode, DONE)

    def test_other_programs_entries_stay(self):
        foreign = self.cache / "GL" / "DPFHCDJHOBALOPHCGOHGLKHNKLDNJCBPNMCAP" / "program.bc"
        foreign.parent.mkdir(parents=True)
        foreign.write_text("another program's, damaged")
        self.start()
        self.assertEqual([f.name for f in self.cache.rglob("*") if f.is_file() and "brdftab-pocl-" not in str(f)], ["program.bc"])
        self.assertEqual(foreign.read_text(), "another program's, damaged")

    def test_two_devices(self):
        variables = {"POCL_CACHE_DIR": str(self.cache), "POCL_DEVICES": "pthread pthread"}
        command = ["generate", VINYL, "-o", self.folder / "t.h5", "--force", "--device", "all", *SMALL_GRID]
        self.warm_up()
        os.truncate(self.kernel("program.bc"), 5000)
        again = run(*command, **variables)
        self.assertEqual(again.returncode, DONE, again.stderr)
        self.assertIn(REPAIRED, again.stderr)

    def test_first_starts_at_once(self):
        names = ["one", "two", "three", "four"]
        for name, process in [(name, self.process(name)) for name in names]:
            self.assert_right(process, repaired=False, name=name)
        self.start()
        self.assert_warm()
        self.assertEqual(len({f.stem for f in self.kernels()}), len(self.kernels()))

    def test_killed_first_starts(self):
        began = time.monotonic()
        self.start()
        whole = time.monotonic() - began
        shutil.rmtree(self.cache)
        for k in range(8):
            process = self.process("killed")
            time.sleep(k / 8 * whole)
            process.kill()
            process.communicate()
        self.start()
        self.assert_warm()

    def test_a_linker_that_fails(self):
        """PoCL aborts where a kernel cannot be linked, as on a full disk."""
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "ld").write_text("#!/bin/sh\necho 'No space left on device' >&2\nexit 1\n")
        (tools / "ld").chmod(0o755)
        path = f"{tools}:{os.environ['PATH']}"
        failed = run("generate", VINYL, "-o", self.folder / "t.h5", *SMALL_GRID, PATH=path, POCL_CACHE_DIR=str(self.cache))
        if failed.returncode == DONE:
            self.skipTest("this PoCL does not take its linker from PATH")
        self.assertEqual(failed.returncode, DEVICE, failed.stderr)
        self.assertIn(str(self.cache), failed.stderr)
        self.assertFalse((self.folder / "t.h5").exists())
        self.start()
        self.assert_warm()

    def test_small_disk(self):
        self.cache.mkdir()
        mount = ["mount", "-t", "tmpfs", "-o", "size=2m", "tmpfs", str(self.cache)]
        if os.geteuid() != 0 or subprocess.run(mount, capture_output=True).returncode != 0:
            self.skipTest("mounting a small tmpfs takes root")
        self.addCleanup(subprocess.run, ["umount", str(self.cache)])
        result = run("generate", VINYL, "-o", self.folder / "t.h5", POCL_CACHE_DIR=str(self.cache))
        self.assert_refused(result, DEVICE, f"POCL_CACHE_DIR={self.cache}", "less than 64 MiB of free space")

    def test_folders_of_running_programs_stay(self):
        self.warm_up()
        [store] = self.cache.glob("brdftab-pocl-*/kernels")
        folders = {name: store.parent / f"run-{name}" for name in ("killed", "alive")}
        for folder in folders.values():
            folder.mkdir()
            (folder / "lock").touch()
        with open(folders["alive"] / "lock", "r+") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self.start()
            self.assertEqual([f.is_dir() for f in folders.values()], [False, True])
        self.start()
        self.assertFalse(folders["alive"].exists())


if __name__ == "__main__":
    unittest.main()
