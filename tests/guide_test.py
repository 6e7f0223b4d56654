"""The developer's guide names files, folders and functions that exist."""

import re
import unittest

from program import ROOT

GUIDE = (ROOT / "host" / "README.md").read_text()
NAMES = set(re.findall(r"`([^`\n]+)`", re.sub(r"```.*?```", "", GUIDE, flags=re.DOTALL)))


class Guide(unittest.TestCase):
    def test_paths_exist(self):
        paths = {name for name in NAMES if re.fullmatch(r"(\.ci|host|kernels|tests|bench)(/[\w.-]+)*/?|CMakeLists\.txt", name) and "NAME" not in name}
        self.assertGreater(len(paths), 30)
        self.assertEqual({path for path in paths if not (ROOT / path).exists()}, set())
        links = re.findall(r"\]\(([^)#]+)\)", GUIDE)
        self.assertEqual([link for link in links if not (ROOT / "host" / link).exists()], [])

    def test_words_of_the_code_exist(self):
        words = {name for name in NAMES if re.fullmatch(r"[A-Za-z]+(_[a-z]+)+|[A-Z][a-z]+[A-Z]\w+", name)}
        self.assertGreater(len(words), 2)
        code = "".join(path.read_text() for path in (ROOT / "host").rglob("*.[ch]pp"))
        self.assertEqual({word for word in words if not re.search(rf"\b{word}\b", code)}, set())


if __name__ == "__main__":
    unittest.main()
