"""Gearbox, pulleys, belt and alternator. In the engine frame."""

import numpy as np

from .mesh import join, strips, weld
from .part import ALUMINIUM, PRIMER, RUBBER, STEEL, Part
from .polygon import circle, rectangle, rounded, slot
from .solids import bolts, box, cylinder, lathe, plate, tube

# Belt pulleys at the engine's right end: x, z, radius.
PULLEYS = ((0.0, 0.0, 0.072), (0.175, 0.035, 0.028), (0.030, 0.138, 0.042), (-0.080, 0.085, 0.030))


def gearbox():
    bell = lathe([(0, 0), (0.150, 0), (0.152, 0.012), (0.142, 0.014), (0.136, 0.06), (0.112, 0.11), (0.095, 0.13), (0.092, 0.205), (0.080, 0.216), (0, 0.216)], 48)
    ribs = []
    for k in range(14):
        rib = box((0.018, 0.006, 0.105), (0.0, 0, 0.0), 0.002).rotated("y", -21).moved(0.128, 0, 0.062)
        rib = rib.rotated("z", 360 / 14 * k + 8)
        ribs.append(rib)
    ribs += [tube(0.097, 0.090, z, z + 0.006, 32, 0.0015) for z in (0.155, 0.187)]
    case = join(bell, ribs).placed((-0.01, 0.215, -0.015), (0, 1, 0), (1, 0, 0))
    final = lathe([(0, -0.08), (0.05, -0.08), (0.095, -0.05), (0.105, 0.0), (0.095, 0.05), (0.05, 0.08), (0, 0.08)], 48).placed((-0.14, 0.30, -0.06), (0, 1, 0))
    selector = join(box((0.075, 0.055, 0.035), (0.02, 0.375, 0.085), 0.008), cylinder(0.012, 0.10, 0.132, 0.002, 24).moved(0.02, 0.375, 0))
    return join(case, final, selector)


def gearbox_fixings():
    ring = [(-0.01 + 0.144 * np.cos(a), 0.229, -0.015 + 0.144 * np.sin(a)) for a in np.arange(0, 2 * np.pi, np.pi / 6)]
    return join(bolts(ring, (0, 1, 0), width=0.011))


def selector_lever():
    """The shift lever: a flat arm with a ball, on the selector's shaft."""
    arm = plate(rounded([[-0.012, -0.014], [0.075, -0.009], [0.075, 0.009], [-0.012, 0.014]], 0.008), 0, 0.005, [circle(0.004, 16, (0.055, 0)), slot(0.02, 0.006, 16, (0.030, 0))], 0.0012)
    ball = lathe([(0, -0.008)] + [(0.008 * np.cos(a), 0.008 * np.sin(a)) for a in np.linspace(-1.3, 1.3, 9)] + [(0, 0.008)], 20)
    return join(arm.rotated("z", -115).moved(0.02, 0.375, 0.130), ball.moved(-0.0085, 0.307, 0.143), bolts([(0.02, 0.375, 0.134)]))


def pulley(x, z, radius):
    w = 0.024
    profile = [(0, 0), (0.6 * radius, 0), (0.62 * radius, 0.004), (radius, 0.004)]
    for k in range(3):
        profile += [(radius - 0.002, 0.007 + 0.0045 * k), (radius, 0.009 + 0.0045 * k)]
    profile += [(radius, w), (0.80 * radius, w), (0.78 * radius, w - 0.008), (0.35 * radius, w - 0.010), (0.33 * radius, w), (0, w)]
    return join(lathe(profile, 32).placed((x, -0.226, z), (0, -1, 0)), bolts([(x, -0.226 - w, z)], (0, -1, 0), width=min(0.017, 0.4 * radius), height=0.010))


def belt():
    """A flat belt on the outside of the pulleys: their convex hull, 5 mm thick."""
    points = np.vstack([circle(r + 0.0005, 40, (x, z)) for x, z, r in PULLEYS])
    points = points[np.lexsort((points[:, 1], points[:, 0]))]

    def half(sequence):
        chain = []
        for p in sequence:
            while len(chain) > 1 and np.cross(chain[-1] - chain[-2], p - chain[-2]) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]

    loop = np.array(half(points) + half(points[::-1]))
    tangent = np.roll(loop, -1, axis=0) - np.roll(loop, 1, axis=0)
    outward = np.column_stack([tangent[:, 1], -tangent[:, 0]]) / np.linalg.norm(tangent, axis=1, keepdims=True)
    section = rectangle(0.0045, 0.018, 0.001, 2, centre=(0.0025, 0.238))
    rings = np.array([[[p[0] + a * n[0], -b, p[1] + a * n[1]] for a, b in section] for p, n in zip(loop, outward)])
    return weld(*strips(rings[:, ::-1], closed=True)).check("belt")


def alternator():
    body = lathe([(0, 0), (0.050, 0), (0.058, 0.008), (0.062, 0.02), (0.062, 0.085), (0.055, 0.10), (0.03, 0.112), (0, 0.112)], 48)
    fins = [box((0.012, 0.005, 0.085), (0.060, 0, 0.052), 0.001, 1).rotated("z", 20 * k) for k in range(18)]
    return join(body, fins, cylinder(0.018, -0.02, 0.005, 0.002, 24)).placed((0.175, -0.195, 0.035), (0, 1, 0))


def parts():
    pulleys = [pulley(*p) for p in PULLEYS]
    return [
        Part("gearbox", join(gearbox(), alternator()), ALUMINIUM),
        Part("belt", belt(), RUBBER),
        Part("pulleys", join(pulleys), PRIMER),
        Part("gearbox_fixings", join(gearbox_fixings(), selector_lever()), STEEL),
    ]
