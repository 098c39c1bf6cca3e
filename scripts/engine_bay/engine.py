"""A transverse four-cylinder engine: block, head, cover, sump, exhaust shield.

Engine frame: origin on the crankshaft's axis in the middle of the block, x forward, y along the
crankshaft to the car's left, z up.
"""

import numpy as np

from .curves import filleted, smoothstep
from .mesh import join
from .part import ALUMINIUM, COVER, PLASTIC, STEEL, YELLOW, Part
from .polygon import circle, rectangle, rounded
from .solids import bolts, box, cylinder, lathe, pipe, plate, sheet, tube

CYLINDERS = (-0.138, -0.046, 0.046, 0.138)


def block():
    body = box((0.25, 0.44, 0.25), (0, 0, 0.015), 0.008)
    ribs = [box((0.262, 0.012, 0.20), (0, y, 0.02), 0.003) for y in (-0.18, -0.092, 0.0, 0.092, 0.18)]
    ribs += [box((0.262, 0.42, 0.010), (0, 0, z), 0.003) for z in (-0.06, 0.04, 0.125)]
    plugs = [cylinder(0.019, 0, 0.006, 0.002, 24).placed((0.125, y, 0.085), (1, 0, 0)) for y in CYLINDERS]
    sump = plate(rectangle(0.23, 0.40, 0.03), -0.19, -0.105, bevel=0.02, segments=4)
    rim = plate(rectangle(0.26, 0.43, 0.03), -0.112, -0.102, bevel=0.002)
    return join(body, ribs, plugs, sump, rim)


def head():
    lower = box((0.23, 0.45, 0.075), (0.0, 0, 0.176), 0.006)
    ports = [box((0.05, 0.060, 0.045), (0.11, y, 0.178), 0.010) for y in CYLINDERS]
    joint = plate(rectangle(0.246, 0.456, 0.012), 0.138, 0.1405, bevel=0.0006, segments=1)
    lug = plate(rounded([[-0.03, -0.02], [0.03, -0.02], [0.018, 0.03], [-0.018, 0.03]], 0.009), 0, 0.010, [circle(0.009, 24, (0, 0.010))], 0.002)
    return join(lower, ports, joint, lug.placed((0.01, -0.219, 0.215), (0, 1, 0)), lug.placed((0.01, 0.209, 0.215), (0, 1, 0)))


def head_cover():
    rim = plate(rectangle(0.236, 0.446, 0.022), 0.213, 0.224, bevel=0.002)
    dome = plate(rectangle(0.205, 0.415, 0.03, 6), 0.22, 0.264, bevel=0.014, segments=5)
    well = plate(rectangle(0.062, 0.385, 0.014, 5), 0.258, 0.270, bevel=0.004, segments=3)
    ribs = [box((0.052, 0.006, 0.012), (x, y, 0.264), 0.0025, 1) for x in (-0.065, 0.065) for y in np.linspace(-0.17, 0.17, 13)]
    cap = join(cylinder(0.026, 0.26, 0.282, 0.004, 40), box((0.012, 0.054, 0.012), (0, 0, 0.286), 0.004), tube(0.033, 0.026, 0.262, 0.268, 40))
    return join(rim, dome, well, ribs), cap.moved(0.062, -0.162, 0.0)


def coils():
    out = []
    for y in CYLINDERS:
        top = box((0.040, 0.034, 0.024), (0.0, y, 0.281), 0.005)
        plug = box((0.026, 0.022, 0.016), (-0.030, y, 0.280), 0.003)
        out += [top, plug, cylinder(0.016, 0.262, 0.272, 0.002, 28).moved(0, y, 0)]
    rail = [[-0.040, CYLINDERS[0] - 0.02, 0.280], [-0.046, -0.05, 0.281], [-0.046, 0.05, 0.281], [-0.040, CYLINDERS[3] + 0.02, 0.280]]
    return join(out, pipe(filleted(rail, 0.02), 0.0055, 10))


def exhaust_shield():
    def surface(u, v):
        y = 0.21 - 0.42 * u
        angle = np.pi * (0.02 + 0.72 * v)
        dent = 0.004 * np.cos(14 * np.pi * u) * np.sin(np.pi * v)
        bulge = 0.028 * smoothstep(np.abs(u - 0.5), 0.5, 0.30)
        r = 0.050 + bulge + dent
        return -0.115 - r * np.sin(angle), y, 0.128 - 1.5 * r * np.cos(angle)

    return sheet(surface, 14, 34, (0.0014, 0, 0.0007))


def fixings():
    edge = [(sx * 0.109, y, 0.224) for sx in (-1, 1) for y in np.linspace(-0.205, 0.205, 6)]
    sump = [(0.122, y, -0.102) for y in np.linspace(-0.19, 0.19, 7)]
    coil = [(0.016, y - 0.022, 0.270) for y in CYLINDERS]
    shield = [(-0.175, y, 0.165) for y in (-0.12, 0.12)]
    return join(bolts(edge, width=0.010), bolts(sump, width=0.010), bolts(coil, width=0.008, height=0.006), bolts(shield, (-1, 0, 0.4), width=0.010))


def dipstick():
    path = filleted([[0.128, 0.06, -0.02], [0.150, 0.06, 0.06], [0.150, 0.075, 0.20], [0.148, 0.08, 0.275]], 0.03)
    handle = tube(0.014, 0.009, -0.003, 0.003, 28, 0.001).placed((0.148, 0.08, 0.296), (1, 0.3, 0))
    stem = lathe([(0, 0.268), (0.0065, 0.268), (0.0065, 0.285), (0, 0.285)], 16).moved(0.148, 0.08, 0)
    return pipe(path, 0.0045, 12), join(handle, stem)


def parts():
    cover, cap = head_cover()
    stick, handle = dipstick()
    return [
        Part("engine_block", join(block(), head()), ALUMINIUM),
        Part("engine_cover", cover, COVER),
        Part("engine_plastics", join(coils(), cap), PLASTIC),
        Part("engine_shield", exhaust_shield(), ALUMINIUM),
        Part("engine_fixings", join(fixings(), stick), STEEL),
        Part("dipstick", handle, YELLOW),
    ]
