"""Lists the tests of the Python scripts for ctest, a line each: FOLDER MODULE.CLASS.METHOD.

A class with a setUpClass is one line, FOLDER MODULE.CLASS, since each of its methods would pay for the set-up again. The scripts
are parsed and not imported: where a module that one needs is missing, its tests fail, and the list is still whole.
"""

import ast
import pathlib

TESTS = pathlib.Path(__file__).resolve().parent


def scripts():
    return sorted([*TESTS.glob("*_test.py"), *TESTS.glob("*/*_test.py")])


def methods(of_class, classes):
    """The names of a class's methods, with those of the base classes that its own script defines."""
    names = [item.name for item in of_class.body if isinstance(item, ast.FunctionDef)]
    for base in of_class.bases:
        if isinstance(base, ast.Name) and base.id in classes:
            names += methods(classes[base.id], classes)
    return list(dict.fromkeys(names))


def tests(script):
    """The tests of a script, as unittest's command line takes them."""
    classes = {item.name: item for item in ast.parse(script.read_text()).body if isinstance(item, ast.ClassDef)}
    for name, of_class in classes.items():
        found = methods(of_class, classes)
        each = [method for method in found if method.startswith("test")]
        if each and "setUpClass" in found:
            yield f"{script.stem}.{name}"
        else:
            yield from (f"{script.stem}.{name}.{method}" for method in each)


if __name__ == "__main__":
    for path in scripts():
        for test in tests(path):
            print(path.parent.relative_to(TESTS).as_posix(), test)
