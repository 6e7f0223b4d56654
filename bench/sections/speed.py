"""Rates of the kernels, and what whole commands take."""

import json

from .section import block, section
from .text import plain, power, table


@section(timed=True)
def speed(program):
    """brdftab bench: kernels beside the device's store rate, the host's memset and the scalar reference."""
    program.brdftab("bench", "--rounds", "9", "--file", "4", "--json", "bench.json")
    return json.loads((program.folder / "bench.json").read_text())


@block
def speed_device(results):
    measured = results["speed"]
    return f"{results.device('speed')}, {measured['hardware_threads']} threads, {measured['devices'][0]['precision']}"


@block
def speed_command(results):
    return f"`{results['speed']['command']}`"


@block
def speed_table(results):
    device = results["speed"]["devices"][0]
    work = {entry["name"]: entry for entry in device["workloads"]}
    ratio = {name: plain(value) for name, value in device["ratios"].items()}
    whole = device["generate"]

    def stored(name):
        return f"{power(work[name]['per_second'])} samples/s, {plain(work[name]['bytes_per_second'] / 1e9, 3)} GB/s"

    stages = ", ".join(f"{name} {plain(seconds)}" for name, seconds in whole["stages_seconds"].items())
    return table(["what", "rate", "beside"], [
        ["table of all four angles, in device memory (`dense`)", stored("dense"),
         f"{ratio['dense / store']} of a store-only kernel on the same buffers; {ratio['dense / memset']} of memset;"
         f" {ratio['dense / reference']} times the scalar reference on one thread"],
        ["table of one φ_i, where no row repeats (`dense rows`)", stored("dense rows"),
         f"{ratio['dense rows / store rows']} of the store-only kernel: arithmetic is the rest"],
        ["f_s and f_p at random directions, lists in host memory (`direct`)",
         f"{power(work['direct']['per_second'])} directions/s",
         f"{ratio['direct / reference']} times the scalar reference on one thread,"
         f" {ratio['direct / reference, all threads']} times on all"],
        ["N of three lobes; N and DHR", f"{plain(work['N']['per_second'])}; {plain(work['N and DHR']['per_second'])} values/s",
         f"{ratio['N / reference N']}; {ratio['N and DHR / reference N and DHR']} times the scalar reference on one thread"],
        [f"whole `generate` of a {plain(whole['bytes'] / 1e9)} GB table",
         f"{plain(whole['generate_seconds_median'])} s: {stages}",
         f"{plain(whole['ratio_median'])} of the time of write(2) calls for as many bytes to the same folder"]])


@section()
def memory(program):
    """Peak memory of `generate` for tables of 1 and 4 GB."""
    command = ["generate", "-q", program.materials["garnet-red-paint"], "-o", "table.h5", "--force", "--theta-i", "0:85:5",
               "--phi-i", "0:355:5", "--theta-s", "0:89:1", "--phi-s"]
    return {gigabytes: program.usage(*command, f"0:360:{step}")[0] for gigabytes, step in (("1", 0.16), ("4", 0.04))}


@block
def peak_memory(results):
    return plain(max(results["memory"].values()) / 1e9, 1) + " GB"


@section()
def reciprocal_normalization(program):
    """Seconds of all cores that integrate takes for brown vinyl at 91 angles, with either N: the least of three."""
    text = program.materials["brown-vinyl"].read_text()
    figures = {}
    for kind in ("hemispherical", "reciprocal"):
        (program.folder / f"{kind}.toml").write_text(f'{text}\n[model]\nnormalization = "{kind}"\n')
        # The first run compiles kernels.
        figures[kind] = min(program.usage("integrate", f"{kind}.toml", "--theta-i", "0:45:0.5")[1] for _ in range(3))
    return figures


@block
def reciprocal_ratio(results):
    seconds = results["reciprocal-normalization"]
    return plain(seconds["reciprocal"] / seconds["hemispherical"])
