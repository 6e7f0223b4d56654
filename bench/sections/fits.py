"""Fits to public measurements and to synthetic ones."""

import re
import sys

from .section import block, section
from .text import percent, plain, table

DIFFUSE = [f"--fix={name}={value}" for name, value in (("w_a", 0), ("w_b", 0), ("gamma", 0), ("delta", 0), ("sigma_retro", 0),
                                                        ("rho_retro", 1))]
YELLOW = ["--fix=gamma=0", "--fix=delta=0"]
FITS = [  # name, file, options; the shipped materials are the fits with more starts
    ("brown vinyl in plane", "imaging_sphere_vinyl_inplane.csv", []),
    ("garnet red paint 550 nm, in plane", "cornell_garnet_red_inplane.csv", ["--channel", "550"]),
    ("garnet red paint 550 nm, hemisphere", "cornell_garnet_red_hemisphere.csv", ["--channel", "550", *DIFFUSE]),
    ("yellow retro-reflective sheeting in plane", "alta_3m_yellow_inplane.csv", YELLOW),
    ("PTFE 532 nm in plane", "nist_ptfe_inplane.csv", ["--channel", "532"]),
    ("brown vinyl, `--model normalization=reciprocal`", "imaging_sphere_vinyl_inplane.csv",
     ["--model", "normalization=reciprocal"]),
    ("yellow sheeting, `--model foreshortening=false --model reflectance_shadowing=surface`", "alta_3m_yellow_inplane.csv",
     [*YELLOW, "--model", "foreshortening=false", "--model", "reflectance_shadowing=surface"]),
]
RMS = re.compile(r"rms of ln\(model/data\), all samples alike: (\S+), each incidence alike: (\S+)")
SAMPLES = re.compile(r"^(\d+) samples, theta_i", re.MULTILINE)
DHR = re.compile(r"theta_i = \S+ .*DHR (\S+)")


@section()
def fits(program):
    """rms of fits to the public measurements, and DHR of what was fitted."""
    figures = {}
    for name, file, options in FITS:
        output = program.brdftab("fit", program.measurement(file), "-o", "fitted.toml", "--force", *options)
        samples, incidences = RMS.search(output).groups()
        figures[name] = {"samples": int(SAMPLES.search(output)[1]), "rms_of_samples": float(samples),
                         "rms_of_incidences": float(incidences), "dhr": [float(value) for value in DHR.findall(output)]}
    return figures


@block
def fit_errors(results):
    return table(["measurement", "samples", "rms of ln(model/data), all samples alike", "each incidence alike"],
                 [[name, str(found["samples"]), plain(found["rms_of_samples"], 3), plain(found["rms_of_incidences"], 3)]
                  for name, found in results["fits"].items()])


@block
def ptfe_dhr(results):
    values = results["fits"]["PTFE 532 nm in plane"]["dhr"]
    return f"{plain(min(values), 3)} to {plain(max(values), 3)}"


@section(long=True)
def fit_recovery(program):
    """Noise-free data of 20 random materials: is f found again, and what it fixes of the parameters."""
    return recovery_figures(program.run(program.build / "bench/recovery", 20, 1, may_fail=True))


def recovery_figures(output):
    rows = re.findall(r"largest error of f (\S+), (\d+) of (\d+) identifiable", output)
    return {"largest_error_of_f": [float(error) for error, _, _ in rows], "recovered": sum(int(found) for _, found, _ in rows),
            "identifiable": sum(int(count) for _, _, count in rows)}


@section(long=True)
def fit_coverage(program):
    """200 trials of 3 % noise: the share of 95 % intervals that cover the truth."""
    return coverage_figures(program.run(program.build / "bench/recovery", "coverage", 200, 1))


def coverage_figures(output):
    return {name: float(share) / 100 for name, share in re.findall(r"^(\w+) +([\d.]+) %", output, re.MULTILINE)}


@section(timed=True)
def fit_scipy(program):
    """The same fit by brdftab and by SciPy's least_squares, in one run."""
    return scipy_figures(program.run(sys.executable, program.root / "bench/compare_scipy.py", program.build / "brdftab",
                                     program.materials["garnet-red-paint"], 24))


def scipy_figures(output):
    samples, starts = re.search(r"(\d+) samples, (\d+) starts", output).groups()
    ours = r"brdftab fit: (\S+) s as a whole command, rms (\S+);.* \((\d+) % of it in kernels"
    command, rms, share = re.search(ours, output).groups()
    version, seconds, their_rms = re.search(r"SciPy (\S+) least_squares: (\S+) s, rms (\S+),", output).groups()
    return {"samples": int(samples), "starts": int(starts), "seconds": float(command), "rms": float(rms),
            "share_in_kernels": int(share) / 100, "scipy": version, "scipy_seconds": float(seconds),
            "scipy_rms": float(their_rms)}


@block
def fit_checks(results):
    recovery, coverage, scipy = results["fit-recovery"], dict(results["fit-coverage"]), results["fit-scipy"]
    errors, every = recovery["largest_error_of_f"], coverage.pop("all")
    return table(["check", "result"], [
        [f"noise-free data of {len(errors)} random materials on the paper's geometry: f recovered to 1e-6 everywhere",
         f"{sum(error < 1e-6 for error in errors)} of {len(errors)}"],
        ["parameters that f to 1e-6 fixes to 1e-3: recovered", f"{recovery['recovered']} of {recovery['identifiable']}"],
        ["3 % noise, 200 trials: 95 % intervals that cover the truth",
         f"{percent(every, 3)} of all; by parameter {plain(100 * min(coverage.values()), 3)} to"
         f" {percent(max(coverage.values()), 3)}"],
        [f"{scipy['starts']} starts on {scipy['samples']} samples, whole command on {results.device('fit-scipy')}",
         f"{plain(scipy['seconds'])} s, {percent(scipy['share_in_kernels'])} of the search in kernels"],
        ["the same fit, same run, by SciPy's least_squares on a NumPy model with 2-point derivatives",
         f"{plain(scipy['scipy_seconds'] / scipy['seconds'])} times as long; rms {plain(scipy['scipy_rms'], 3)},"
         f" here {plain(scipy['rms'], 3)}"]])
