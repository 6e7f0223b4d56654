"""A section: commands that measure, and the figures that they give; a block: the piece of a text made of them."""

import dataclasses
import functools
import json
import os
import pathlib
import re
import shlex
import subprocess
import typing

SECTIONS = {}
BLOCKS = {}
BUSY = 0.5  # processes that wait for a core, over the last minute


class NotMeasured(Exception):
    """Why a section cannot be measured here."""


class Program:
    """The built programs, run as a user types their commands, in a folder for their files. Keeps the lines."""

    def __init__(self, root, build, folder, data=None):
        self.root, self.build, self.folder, self.data = root, build, pathlib.Path(folder), data
        self.materials = {path.stem: path for path in sorted((root / "host" / "materials").glob("*.toml"))}
        self.commands = []

    def measurement(self, name):
        if self.data is None:
            raise NotMeasured("takes public measurements: --data FOLDER")
        if not (self.data / name).is_file():
            raise NotMeasured(f"{self.data / name}: does not exist")
        return (self.data / name).resolve()

    def run(self, *command, stdin="", may_fail=False):
        """Standard output. A command that fails is an error with its message; one that may fail, only if it prints nothing."""
        done = subprocess.run(self._kept(command), input=stdin, capture_output=True, text=True, cwd=self.folder)
        if done.returncode and not (may_fail and done.stdout):
            raise SystemExit(f"{self.commands[-1]}: exit status {done.returncode}: {done.stderr.strip()}")
        return done.stdout

    def _kept(self, command):
        """The command as text; its line is kept as it is typed at the root of the checkout."""
        command = [str(part) for part in command]
        if not pathlib.Path(command[0]).exists():
            target = pathlib.Path(command[0]).name
            raise NotMeasured(f"{command[0]}: missing: tests/run or cmake --build --preset release --target {target} makes it")
        line = shlex.join(command).replace(f"{self.build}/", ".build/release/").replace(f"{self.root}/", "")
        self.commands.append(line if self.data is None else line.replace(f"{self.data.resolve()}/", ""))
        return command

    def brdftab(self, *arguments, **rest):
        return self.run(self.build / "brdftab", *arguments, **rest)

    def usage(self, *arguments):
        """What the program took: (bytes of memory that it held at most, seconds of all cores, whoever else uses them)."""
        process = subprocess.Popen(self._kept([self.build / "brdftab", *arguments]), cwd=self.folder, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        if status:
            raise SystemExit(f"{self.commands[-1]}: exit status {os.waitstatus_to_exitcode(status)}")
        return usage.ru_maxrss * 1024, usage.ru_utime + usage.ru_stime

    @functools.cached_property
    def device(self):
        """The default device's name and driver."""
        listed = subprocess.run([self.build / "brdftab", "devices"], capture_output=True, text=True, check=True)
        lines = listed.stdout.splitlines()
        chosen = next(k for k, line in enumerate(lines) if "(default)" in line)
        name = re.search(r"\d+:\d+ +(.*?) +\(default\)", lines[chosen]).group(1)
        return f"{name}, {lines[chosen + 1].strip()}"

    @functools.cached_property
    def version(self):
        told = subprocess.run([self.build / "brdftab", "--version"], capture_output=True, text=True, check=True)
        return told.stdout.strip()


@dataclasses.dataclass
class Section:
    name: str
    says: str
    measure: typing.Callable
    timed: bool
    long: bool

    @property
    def cost(self):
        return "times: on a machine that does nothing else" if self.timed else "takes long" if self.long else ""

    def save(self, program, root):
        if self.timed and os.getloadavg()[0] > BUSY:
            raise NotMeasured(f"the machine does other work: load {os.getloadavg()[0]:.1f}, not at most {BUSY}")
        figures = rounded(self.measure(program))
        saved = {"commands": program.commands, "program": program.version, "device": program.device, "figures": figures}
        text = json.dumps(saved, indent=1, ensure_ascii=False) + "\n"
        (root / "bench/results" / f"{self.name}.json").write_text(text, encoding="utf-8")


def section(timed=False, long=False):
    """Registers a function from Program to figures; its first sentence of documentation says what it measures."""
    def register(measure):
        name = measure.__name__.replace("_", "-")
        SECTIONS[name] = Section(name, measure.__doc__.splitlines()[0].rstrip("."), measure, timed, long)
        return measure
    return register


def block(render):
    """Registers a function from Results to Markdown: the lines of a table, or a figure within a sentence."""
    BLOCKS[render.__name__.replace("_", "-")] = render
    return render


class Results:
    """The saved figures by section; `device(name)` is where they were measured."""

    def __init__(self, root):
        self.folder = root / "bench/results"

    @functools.cache
    def saved(self, name):
        path = self.folder / f"{name}.json"
        if not path.exists():
            raise SystemExit(f"bench/results/{name}.json: does not exist: bench/figures {name} makes it")
        return json.loads(path.read_text(encoding="utf-8"))

    def __getitem__(self, name):
        return self.saved(name)["figures"]

    def device(self, name):
        """In short: its name, platform and driver."""
        return re.sub(r"^(.*?), (.*?), .*(driver .*)$", r"\1 (\2, \3)", self.saved(name)["device"])


def rounded(value):
    """Six digits of every number: more than any text shows."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, dict):
        return {key: rounded(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [rounded(entry) for entry in value]
    return value
