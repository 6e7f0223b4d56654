"""The same fit by brdftab and by SciPy's least_squares on a NumPy model with 2-point derivatives, measured in one run.

usage: compare_scipy.py BRDFTAB MATERIAL [STARTS]

600 samples of MATERIAL in plane with 3 % noise, equal weights, residuals in ln f, the same bounds, variables of the same scaling.
"""

import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import numpy
import scipy.optimize
import scipy.special

NAMES = ["n_eff", "k_eff", "sigma_surface", "rho_surface", "sigma_bulk", "rho_bulk", "sigma_retro", "rho_retro", "w_a", "w_b",
         "gamma", "delta", "w", "n"]
LOW = numpy.array([0.05, 0, 0, 1e-4, 0, 1e-4, 0, 1e-4, 0, 0, 0, 0, 0.05, 0])
HIGH = numpy.array([20, 20, 100, 100, 100, 100, 100, 100, 100, 100, 1000, 1000, 100, 60])
SCALE = numpy.array([0, 0.05, 1e-3, 0, 1e-3, 0, 1e-3, 0, 0.02, 0.02, 0.1, 0.02, 0, 0.5])
# Starts are drawn from these ranges, as host/fit/fit_starts.cpp has them, with plain amplitudes.
START_LOW = numpy.array([0.6, 0.01, 0.02, 0.004, 0.02, 0.15, 0.002, 0.01, 0.03, 0.01, 0.05, 0.01, 0.6, 0.05])
START_HIGH = numpy.array([4, 4, 2, 1.5, 2, 10, 1, 3, 1, 5, 30, 5, 3, 40])
NODES = 128


def to_solver(x):
    return numpy.where(SCALE > 0, numpy.arcsinh(x / numpy.where(SCALE > 0, SCALE, 1)), numpy.log(numpy.maximum(x, 1e-300)))


def from_solver(u):
    return numpy.where(SCALE > 0, SCALE * numpy.sinh(u), numpy.exp(u))


def shadowing(chi2, w, n):
    return numpy.maximum(scipy.special.gammaincc(1 + n, (1 + n) * chi2 / w ** 2), 1e-300)


GAUSS_X, GAUSS_W = numpy.polynomial.legendre.leggauss(NODES)


@numpy.errstate(all="ignore")
def normalization(sine, cosine, rho, w, n):
    """N for arrays of theta_i, by Gauss-Legendre nodes over asinh on either side of the peak."""
    a = sine ** 2
    v_i = shadowing(a, w, n)
    p0 = (rho * cosine * v_i) ** 2
    h = numpy.sqrt(p0 * (4 * a + p0))
    total = 0
    for sign, length in ((1, 1 - a), (-1, a)):
        reach = numpy.arcsinh(length / h)
        z = 0.5 * (1 + GAUSS_X)
        x = reach[:, None] * z ** 2 * (3 - 2 * z)
        v = numpy.minimum(h[:, None] * numpy.sinh(x), length[:, None])
        u = numpy.clip(a[:, None] + sign * v, 0, 1)
        mu = numpy.sqrt(numpy.maximum(1 - u, 0))
        p = (rho * 0.5 * (cosine[:, None] + mu)) ** 2 * v_i[:, None] * shadowing(u, w, n)
        root = numpy.sqrt(v ** 2 + p * (2 * (u + a[:, None]) + p))
        jacobian = h[:, None] * numpy.cosh(x) * reach[:, None] * 6 * z * (1 - z)
        total = total + (jacobian / root * 0.5 * GAUSS_W).sum(axis=1)
    return 1 / (numpy.pi * total)


def ln_f(p, theta_i, theta_s, index, angles):
    n_eff, k_eff, s_surface, r_surface, s_bulk, r_bulk, s_retro, r_retro, w_a, w_b, gamma, delta, w, n = p
    m = n_eff + 1j * k_eff
    forward = theta_s >= 0
    alpha_0, alpha = numpy.sin(theta_i), numpy.sin(theta_s)
    mu_i, mu_s = numpy.cos(theta_i), numpy.cos(theta_s)

    def moduli(sine, mu):
        q = numpy.sqrt(m ** 2 - sine ** 2)
        return abs((mu - q) / (mu + q)), abs((m ** 2 * mu - q) / (m ** 2 * mu + q))

    spread = (0.5 * (mu_i + mu_s)) ** 2 * shadowing(alpha_0 ** 2, w, n) * shadowing(alpha ** 2, w, n)
    with numpy.errstate(all="ignore"):
        zeta_0 = numpy.tan(theta_i)
        e_0 = numpy.where(zeta_0 > 0, numpy.exp(-gamma * zeta_0 * numpy.exp(-delta / zeta_0 ** 2)), 1)
        scatter = numpy.where(alpha != 0, numpy.exp(-w_a * abs(numpy.tan(theta_s)) * numpy.exp(-w_b / alpha ** 2)), 1)
    v_m = numpy.where(forward, 1 - e_0 + scatter * e_0, scatter)
    f = 0
    for i, s in zip(moduli(alpha_0, mu_i), moduli(alpha, mu_s)):
        g = i * s
        for amplitude, rho, sign in ((s_surface * g, r_surface, 1), (s_bulk * (1 - g), r_bulk, 1), (s_retro * (1 - g), r_retro, -1)):
            norm = normalization(numpy.sin(angles), numpy.cos(angles), rho, w, n)[index]
            f = f + 0.5 * amplitude * norm / ((alpha - sign * alpha_0) ** 2 + rho ** 2 * spread)
    with numpy.errstate(all="ignore"):
        return numpy.log(v_m * f)


def main():
    program, material = sys.argv[1:3]
    starts = int(sys.argv[3]) if len(sys.argv) > 3 else 24
    pairs = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i},{s:.4f},0\n" for i in range(5, 81, 15)
                                                            for s in numpy.linspace(-80, 80, 100))
    folder = pathlib.Path(tempfile.mkdtemp())
    data = folder / "data.csv"
    subprocess.run([program, "evaluate", material, "-o", data, "--noise", "0.03"], input=pairs, text=True, check=True)
    rows = list(csv.DictReader(line for line in data.open() if not line.startswith("#")))
    theta_i = numpy.radians([float(r["theta_i_deg"]) for r in rows])
    theta_s = numpy.radians([float(r["theta_s_deg"]) for r in rows])
    target = numpy.log([float(r["brdf"]) for r in rows])
    angles, index = numpy.unique(theta_i, return_inverse=True)

    options = ["--floor", "0", "--intervals", "linear", "--force", "--starts", str(starts)]
    begin = time.perf_counter()
    result = subprocess.run([program, "fit", data, "-o", folder / "fit.toml", *options], capture_output=True, text=True, check=True)
    ours = time.perf_counter() - begin
    rms = re.search(r"incidence alike: (\S+)", result.stdout).group(1)
    print(f"{len(rows)} samples, {starts} starts")
    print(f"brdftab fit: {ours:.2f} s as a whole command, rms {rms}; {result.stderr.strip().splitlines()[-1]}")

    random = numpy.random.default_rng(1)
    lower, upper = to_solver(LOW), to_solver(HIGH)
    best = numpy.inf
    evaluations = 0
    begin = time.perf_counter()
    for _ in range(starts):
        start = to_solver(numpy.exp(random.uniform(numpy.log(START_LOW), numpy.log(START_HIGH))))

        def residuals(u):
            nonlocal evaluations
            evaluations += 1
            values = ln_f(from_solver(u), theta_i, theta_s, index, angles) - target
            return numpy.where(numpy.isfinite(values), values, 1e3)

        found = scipy.optimize.least_squares(residuals, numpy.clip(start, lower + 1e-9, upper - 1e-9), bounds=(lower, upper), jac="2-point",
                                             ftol=1e-8, max_nfev=200)
        best = min(best, numpy.sqrt(2 * found.cost / len(rows)))
    theirs = time.perf_counter() - begin
    print(f"SciPy {scipy.__version__} least_squares: {theirs:.1f} s, rms {best:.4g}, {evaluations} evaluations of the model")
    print(f"ratio {theirs / ours:.1f}")


if __name__ == "__main__":
    main()
