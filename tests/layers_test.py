"""The floors of host/: what a file may include, by the folder it lies in. CMakeLists.txt holds the same for what is linked."""

import pathlib
import re
import tempfile
import unittest

from program import ROOT

# A folder of host/ includes itself and the floors named here. "face" stands for host/brdftab.hpp and host/brdftab.cpp.
FLOORS = {
    "base": [],
    "model": ["base"],
    "reference": ["base", "model"],
    "compute": ["base", "model"],
    "table": ["base", "model", "reference", "compute"],
    "formats": ["base", "model", "compute", "table"],
    "fit": ["base", "model", "compute"],
    "pictures": ["base", "model", "reference", "compute", "table", "formats", "fit"],
    "face": ["base", "model", "reference", "compute", "table", "formats", "fit"],
    "commands": ["base", "model", "reference", "compute", "table", "formats", "fit", "pictures", "face"],
    "main": ["base", "model", "reference", "compute", "table", "formats", "fit", "pictures", "face", "commands"],
}
NO_FOLDER = {"host/main.cpp": "main", "host/brdftab.hpp": "face", "host/brdftab.cpp": "face"}

# Headers of a library, and the folders (or the file) whose files may include them.
LIBRARIES = {
    r"CL/": ["host/compute/"],
    r"hdf5": ["host/formats/"],
    r"OpenEXR/": ["host/formats/"],
    r"ceres/|glog/": ["host/fit/", "host/main.cpp"],
    r"cairo|librsvg/": ["host/pictures/"],
    r"CLI/": ["host/commands/", "host/main.cpp"],
}
# A library's own types, and the one folder whose headers may name them.
TYPES = {
    r"\bcl::\w+": "host/compute/",
    r"\bhid_t\b|\bH5\w+": "host/formats/",
    r"\bImf::\w+": "host/formats/",
    r"\bceres::\w+": "host/fit/",
    r"\bCLI::\w+": "host/commands/",
}
# Units that see a library's header, be it through other headers: each takes a second or more to compile.
MOST_UNITS = {"CL/opencl.hpp": 97, "hdf5.h": 10}
MOST_FILES = 25

# What does not keep the rules yet.
UPWARD = {
    ("host/compute/evaluate.cpp", "host/reference/model.hpp"),
    ("host/compute/integrals.cpp", "host/reference/model.hpp"),
}
CROWDED = {"kernels"}
ON_OTHER_FLOORS = {"host/table/slab_ring.hpp"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+[<"]([^>"]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def floor(path):
    """The floor of a file of host/, or None."""
    parts = path.split("/")
    if parts[0] != "host":
        return None
    return parts[1] if len(parts) > 2 and parts[1] in FLOORS else NO_FOLDER.get(path)


class Tree:
    """The C++ files under a folder's host/, and what each includes."""

    def __init__(self, root):
        files = [p for p in sorted((root / "host").rglob("*")) if p.suffix in (".cpp", ".hpp", ".inc")]
        self.text = {p.relative_to(root).as_posix(): p.read_text() for p in files}
        self.includes = {path: INCLUDE.findall(text) for path, text in self.text.items()}

    def upward(self):
        """Includes of a floor that does not stand below."""
        return [(path, name) for path, names in self.includes.items() for name in names if floor(name)
                and floor(name) not in (floor(path), *FLOORS[floor(path)])]

    def seen_by(self, path):
        """All that a file includes, itself or through other headers of host/."""
        seen, left = set(), [path]
        while left:
            for name in self.includes.get(left.pop(), []):
                if name not in seen:
                    seen.add(name)
                    left.append(name)
        return seen


class Layers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = Tree(ROOT)

    def test_every_file_is_in_a_floor(self):
        self.assertEqual([path for path in self.tree.text if floor(path) is None], [])

    def test_includes_run_downward(self):
        self.assertEqual(set(self.tree.upward()) - UPWARD, set())

    def test_includes_name_whole_paths(self):
        wrong = [(path, name) for path, text in self.tree.text.items() for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)
                 if not (ROOT / name).is_file()]
        self.assertEqual(wrong, [])

    def test_kernels_are_included_by_compute_only(self):
        wrong = [(path, name) for path, names in self.tree.includes.items() for name in names
                 if name.startswith("kernels/") and floor(path) != "compute"]
        self.assertEqual(wrong, [])

    def test_libraries_stay_on_their_floor(self):
        wrong = [(path, name) for path, names in self.tree.includes.items() for name in names
                 for library, folders in LIBRARIES.items() if re.match(library, name) and not path.startswith(tuple(folders)) and path not in ON_OTHER_FLOORS]
        self.assertEqual(wrong, [])

    def test_headers_name_types_of_their_own_floors_libraries(self):
        wrong = [(path, found) for path, text in self.tree.text.items() if path.endswith(".hpp") and path not in ON_OTHER_FLOORS
                 for types, folder in TYPES.items() if not path.startswith(folder)
                 for found in re.findall(types, COMMENT.sub("", text))]
        self.assertEqual(wrong, [])

    def test_few_units_see_a_large_library(self):
        for header, most in MOST_UNITS.items():
            units = [path for path in self.tree.text if path.endswith(".cpp") and header in self.tree.seen_by(path)]
            self.assertGreater(len(units), 0, header)
            self.assertLessEqual(len(units), most, (header, units))

    def test_folders_hold_few_files(self):
        folders = {path.parent for top in ("host", "kernels", "tests", "bench") for path in (ROOT / top).rglob("*") if path.is_file()}
        count = {folder.relative_to(ROOT).as_posix(): sum(p.is_file() for p in folder.iterdir()) for folder in folders
                 if folder.name != "__pycache__"}
        self.assertEqual({folder: files for folder, files in count.items() if files > MOST_FILES and folder not in CROWDED}, {})


class UpwardInclude(unittest.TestCase):
    def test_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "host/model/measurement").mkdir(parents=True)
            (root / "host/model/measurement/sample.cpp").write_text(
                '#include <vector>\n#include "host/base/csv.hpp"\n#include "host/compute/plan.hpp"\n')
            self.assertEqual(Tree(root).upward(), [("host/model/measurement/sample.cpp", "host/compute/plan.hpp")])


if __name__ == "__main__":
    unittest.main()
