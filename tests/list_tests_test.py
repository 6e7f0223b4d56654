"""The list that ctest gets of these tests is the one that unittest has itself."""

import importlib
import sys
import unittest

import list_tests


def ids(suite):
    """The tests of a suite, as unittest's command line takes them, with those of a class with a set-up of its own as one."""
    found = set()
    for item in suite:
        if isinstance(item, unittest.TestSuite):
            found |= ids(item)
        else:
            whole = type(item).setUpClass.__func__ is not unittest.TestCase.setUpClass.__func__
            found.add(item.id().rpartition(".")[0] if whole else item.id())
    return found


class List(unittest.TestCase):
    def test_is_unittests_own(self):
        scripts = list_tests.scripts()
        self.assertGreater(len(scripts), 20)
        for script in scripts:
            with self.subTest(script.stem):
                sys.path.insert(0, str(script.parent))
                self.addCleanup(sys.path.remove, str(script.parent))
                module = importlib.import_module(script.stem)
                found = list(list_tests.tests(script))
                self.assertEqual(len(found), len(set(found)))
                self.assertEqual(set(found), ids(unittest.defaultTestLoader.loadTestsFromModule(module)))


if __name__ == "__main__":
    unittest.main()
