"""The rear panel of a car, cut open for two lamps side by side. In the panel's frame, as the lamps'."""

import numpy as np

from engine_bay.mesh import join
from engine_bay.part import PAINT, Part
from engine_bay.polygon import circle, rectangle
from engine_bay.solids import box, plate

from .lamp import outline

LAMPS = {"left": -0.185, "right": 0.185}  # y of each lamp [m]
SADDLE = np.array([-0.022, -0.070, -0.118])  # pigtail's clip behind the panel, from the lamp's origin
FRONT = -0.008  # of the panel: what the lamps' collars rest on


def panel():
    holes = [outline(0.60) + [y, 0] for y in LAMPS.values()]
    holes += [circle(0.004, 16, (x, y)) for x in (-0.40, 0.0, 0.40) for y in (-0.145, 0.145)]
    flat = plate(rectangle(0.86, 0.34, 0.020, 6), FRONT - 0.0015, FRONT, holes, 0.0004, 1)
    return flat.placed((0, 0, 0), (1, 0, 0), (0, 1, 0))


def stiffeners():
    bars = [box((0.012, 0.84, 0.010), (FRONT - 0.007, 0, z), 0.002) for z in (-0.155, 0.155)]
    # Their backs touch the cables of radius 2.5 mm.
    saddles = [box((0.010, 0.016, 0.008), SADDLE + [0.0075, y, 0], 0.0015) for y in LAMPS.values()]
    return join(bars, saddles)


def parts():
    return [Part("panel", join(panel(), stiffeners()), PAINT)]
