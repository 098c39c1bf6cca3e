"""A rear lamp: lens, housing, connector, and the studs that locate it.

Frame: x out of the car to the rear, y to its right, z up; origin in the middle of the lamp on the body's surface.
"""

import numpy as np

from engine_bay.mesh import join
from engine_bay.part import GREY_PLASTIC, STEEL, Part
from engine_bay.solids import box, cylinder, lathe, sheet, sweep

HALF_WIDTH, HALF_HEIGHT = 0.160, 0.080  # of the lens [m]
BULGE = 0.045  # of the lens in front of the body [m]
TUB = 0.075  # depth of the housing behind the body [m]
PLUG = np.array([-0.104, 0.0, -0.018])  # where the pigtail leaves, along -x
LENS = ("clear_lens", (0.66, 0.60, 0.61))

# Studs (y, z) that locate the lamp along x; the first two also along z, the first also along y.
SPREAD = [(-0.135, 0.045), (0.135, 0.040), (0.0, -0.066)]
CLOSE = [(-0.104, 0.012), (-0.020, 0.056), (-0.030, -0.056)]


def rounded_square(a, b, roundness=0.62):
    """The square [-1, 1]² with its corners rounded, as (across, up)."""
    return a * np.sqrt(1 - roundness * b * b / 2), b * np.sqrt(1 - roundness * a * a / 2)


def face(a, b):
    """A point of the lens's outline or inside it, (y, z) [m], for a and b in [-1, 1]: lower towards the right."""
    across, up = rounded_square(a, b)
    height = HALF_HEIGHT * (1 - 0.20 * (0.5 + 0.5 * across) ** 2)
    return HALF_WIDTH * across, height * up + 0.008 * (0.5 + 0.5 * across)


def outline(scale=1.0, per_side=24):
    """The lamp's outline, counter-clockwise seen from behind the car, in (y, z)."""
    side = np.linspace(-1, 1, per_side, endpoint=False)
    one = np.ones(per_side)
    a = np.concatenate([side, one, -side, -one])
    b = np.concatenate([-one, side, one, -side])
    return np.column_stack(face(a, b)) * scale


def lens():
    """Curved both ways and drawn round the car's right corner; ribbed where the light comes out."""

    def surface(u, v):
        a, b = 2 * u - 1, 2 * v - 1
        y, z = face(a, b)
        dome = (1 - a**6) ** 0.5 * (1 - b**6) ** 0.5
        ribs = 0.0012 * np.cos(2 * np.pi * 11 * b) * np.clip(1 - (1.25 * a) ** 8, 0, 1) * np.clip(1 - (1.2 * b) ** 8, 0, 1)
        return BULGE * dome * (1 - 0.35 * (0.5 + 0.5 * a) ** 3) + ribs, y, z

    return sheet(surface, 48, 40, (-0.004, 0, 0))


def housing():
    """A tub behind the lens with a rim on the body, three bulb holders and the plug."""
    depths = [-TUB, -TUB + 0.006, -0.030, -0.012, -0.008, -0.0075, -0.0035]
    scales = [0.45, 0.50, 0.55, 0.56, 0.56, 1.045, 1.045]
    tub = sweep(outline(), [[x, 0, 0] for x in depths], (0, 1, 0), np.array(scales))
    bulb = lathe([(0, -0.006), (0.016, -0.006), (0.016, 0.004), (0.013, 0.006), (0.013, 0.016), (0.008, 0.019), (0, 0.019)], 32)
    bulbs = [bulb.placed((-TUB, y, 0.010), (-1, 0, 0)) for y in (-0.044, 0.0, 0.044)]
    plug = box((0.026, 0.026, 0.018), (PLUG[0] + 0.015, PLUG[1], PLUG[2]), 0.0025)
    boot = cylinder(0.0045, 0.0, 0.006, 0.001, 20).placed(PLUG + [0.004, 0, 0], (-1, 0, 0))
    return join(tub, bulbs, plug, boot)


def studs(places):
    """A stud at each place, through the body, with the collar that rests on it."""
    stud = join(cylinder(0.003, -0.024, -0.003, 0.0008, 20), cylinder(0.0055, -0.008, -0.002, 0.0005, 24))
    return join(*[stud.placed((0, y, z), (1, 0, 0)) for y, z in places])


def parts(name, places):
    return [
        Part("lens", lens(), LENS),
        Part("housing", housing(), GREY_PLASTIC),
        Part(f"studs_{name}", studs(places), STEEL),
    ]
