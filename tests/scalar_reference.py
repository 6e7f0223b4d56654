"""f by the scalar reference, and golden values of f, for comparison with what simulators make of a file."""

import csv
import io
import math

from program import DONE, GOLDEN, run

# Materials that stay as they are: broad lobes, and a narrow retro lobe with a steep shadowing.
VINYL = GOLDEN / "brown-vinyl.toml"
SHEETING = GOLDEN / "yellow-retro-sheeting.toml"


def rows(text):
    return list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))


def brdf(material, directions, engine="reference"):
    """f in 1/sr at (theta_i, theta_s, phi), degrees, phi 0 forward; band by band where the material has bands."""
    table = "theta_i_deg,theta_s_deg,phi_deg\n" + "".join(f"{i},{s},{math.remainder(phi, 360)}\n" for i, s, phi in directions)
    result = run("evaluate", material, "--engine", engine, stdin=table)
    assert result.returncode == DONE, result.stderr
    return [float(row["brdf"]) for row in rows(result.stdout)]


def golden(*direction):
    """f of VINYL at (theta_i, theta_s, phi) by an independent implementation; the direction is one of its table."""
    for row in rows((GOLDEN / "brdf.csv").read_text()):
        if row["material"] == VINYL.stem and tuple(float(row[k]) for k in ("theta_i_deg", "theta_s_deg", "phi_deg")) == direction:
            return float(row["brdf"])
    raise LookupError(f"the golden values have not {direction}")


def off_plane():
    """A golden direction off the plane of incidence and off the specular direction, and f there. With light and viewer
    exchanged f is 31 % less, and on the other side, at 180 degrees - phi, 54 % more."""
    direction = (35, 75.9, 226.38)
    return direction, golden(*direction)
