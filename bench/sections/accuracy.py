"""Errors of the kernels against the scalar reference."""

import json
import re

from .section import block, section
from .text import power, table

COMPARED = re.compile(r"^(.*?), float(32|64) +(\d+) compared  median (\S+)  99 % \S+  max (\S+) ", re.MULTILINE)
PROMISED = {"f, float64": 1e-12, "N, float64": 1e-10, "DHR of a lobe, float64": 1e-8}
WHERE = {"f, float64": "f above 1e-30 1/sr", "f, float32": "f above 1e-20 1/sr", "DHR of a lobe, float64": "DHR above 1e-12",
         "DHR of a lobe, float32": "DHR above 1e-12"}


@section(long=True)
def kernels_accuracy(program):
    """f, N and DHR at random directions of 200 random materials against the scalar reference."""
    output = program.run(program.build / "bench/accuracy", 200, 7)
    return {f"{quantity}, float{bits}": {"compared": int(count), "median": float(median), "max": float(worst)}
            for quantity, bits, count, median, worst in COMPARED.findall(output)}


@section()
def table_accuracy(program):
    """Every node of tables of random materials against the scalar reference: the largest error."""
    program.run(program.build / "tests/device_test", "--gtest_filter=*FactoredTable*", "--gtest_output=json:report.json")
    tests = json.loads((program.folder / "report.json").read_text())["testsuites"][0]["testsuite"]
    return {test["name"].split("/")[-1]: float(test["worst_relative_error"]) for test in tests}


@block
def accuracy_table(results):
    tables, kernels = results["table-accuracy"], results["kernels-accuracy"]
    rows = [[f"{precision} table, every node", promised, "", power(tables[precision]), "f above 1e-30 1/sr; all variants"]
            for precision, promised in (("float32", "1e-6"), ("float64", "1e-12"))]
    for name, found in kernels.items():
        quantity, precision = name.rsplit(", ", 1)
        promised = f"{PROMISED[name]:.0e}".replace("e-0", "e-") if name in PROMISED else ""
        quantity = "f at a direction" if quantity == "f" else quantity
        where = f"{found['compared']} values" + (f", {WHERE[name]}" if name in WHERE else "")
        rows.append([f"{quantity}, {precision} kernels", promised, power(found["median"]), power(found["max"]), where])
    return table(["quantity", "promised", "median", "largest", "where compared"],
                 [*rows, ["file against the device's samples", "0", "0", "0", "byte for byte"]])


@block
def accuracy_device(results):
    return results.device("kernels-accuracy")


@block
def float32_table_error(results):
    return power(results["table-accuracy"]["float32"])
