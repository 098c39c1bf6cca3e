"""The painted body: firewall, cowl, inner wings, strut towers, side members, rails.

Bay frame: x forward from the firewall, y to the car's left, z up; the origin lies at the foot of the
firewall in the middle. The bay is 0.9 m long, 1.4 m wide and 0.6 m high.
"""

import numpy as np

from .curves import bead, filleted, smoothstep, spline
from .mesh import join
from .part import PAINT, PLASTIC, PRIMER, STEEL, Part
from .polygon import circle, rectangle, rounded, slot
from .solids import bolts, box, lathe, pipe, plate, sheet, sweep, tube


def firewall():
    def surface(u, v):
        y, z = -0.69 + 1.38 * u, 0.6 * v
        beads = sum(bead(y, c, 0.030, 0.016) for c in (-0.52, -0.40, -0.28, -0.16, 0.16, 0.28, 0.52))
        relief = 0.010 * beads * smoothstep(z, 0.20, 0.23) * (1 - smoothstep(z, 0.41, 0.44))
        relief += 0.012 * bead(z, 0.485, 0.022, 0.014) * (1 - smoothstep(np.abs(y), 0.60, 0.63))
        tunnel = (1 - smoothstep(np.abs(y), 0.12, 0.20)) * (1 - smoothstep(z, 0.14, 0.26))
        return relief - 0.09 * tunnel, y, z

    return sheet(surface, 30, 104, (-0.002, 0, 0), plain_back=True)


def cowl():
    holes = [slot(0.055, 0.012, 8, (0.052, y), np.pi / 2) for y in np.linspace(-0.60, 0.60, 17)]
    panel = plate(rounded([[0, -0.68], [0.10, -0.66], [0.10, 0.66], [0, 0.68]], 0.015), 0, 0.003, holes, 0.001)
    lip = sweep(rectangle(0.016, 0.016, 0.006, 3), [[0.10, -0.66, 0], [0.104, -0.3, 0], [0.104, 0.3, 0], [0.10, 0.66, 0]])
    return join(panel, lip).rotated("y", 8).moved(0.0, 0, 0.605)


def inner_wing():
    """The left one; the wheel house bulges into it behind the strut tower's foot."""

    def surface(u, v):
        x = 0.88 * u
        top = 0.650 - 0.065 * smoothstep(x, 0.35, 1.0)
        y = 0.475 + (top - 0.475) * smoothstep(v, 0.0, 1.0)
        z = 0.20 + 0.335 * v
        arch = np.clip(1 - ((x - 0.23) / 0.30) ** 2, 0, 1) ** 0.5
        y = y - 0.055 * arch * np.sin(np.pi * np.clip(v, 0, 1)) ** 0.7
        y = y - 0.007 * bead(x, 0.66, 0.12, 0.02) * bead(v, 0.5, 0.35, 0.15)
        return x, y, z

    return sheet(surface, 18, 36, (0, 0.0015, 0))


def strut_tower():
    profile = [(0, 0.22), (0.125, 0.22), (0.116, 0.30), (0.104, 0.40), (0.098, 0.47)]
    profile += [(0.098 - 0.022 * (1 - np.cos(a)), 0.47 + 0.022 * np.sin(a)) for a in np.linspace(0.3, np.pi / 2, 6)]
    profile += [(0.052, 0.492), (0.047, 0.489), (0.044, 0.480), (0.038, 0.478), (0, 0.478)]
    dome = lathe(profile, 48)
    bearing = lathe([(0, 0.474), (0.034, 0.474), (0.034, 0.484), (0.030, 0.488), (0.016, 0.489), (0.014, 0.498), (0, 0.499)], 32)
    return dome.moved(0.22, 0.545, 0), join(
        bearing, bolts([(0.064 * np.cos(a), 0.064 * np.sin(a), 0.4915) for a in (0.5, 2.6, 4.7)], width=0.014)
    ).moved(0.22, 0.545, 0)


def side_member():
    """The left one: a closed box beam with a holed inner face, a top flange and a crash-box plate."""
    beam = sweep(rectangle(0.110, 0.060, 0.012, 3), [[x, 0.452, 0.15] for x in (0.0, 0.3, 0.6, 0.895)])
    holes = [slot(0.055, 0.032, 12, (x, 0.0)) for x in (0.12, 0.26, 0.68, 0.80)]
    holes += [circle(r, 16, (x, y)) for x, y, r in ((0.36, 0.0, 0.016), (0.44, 0.0, 0.016), (0.52, 0.0, 0.016), (0.60, 0.0, 0.012))]
    holes += [circle(0.005, 8, (x, y)) for x in (0.05, 0.19, 0.33, 0.47, 0.61, 0.74, 0.86) for y in (-0.036, 0.036)]
    inner = plate(rectangle(0.87, 0.096, 0.01, centre=(0.44, 0)), 0, 0.003, holes, 0.001, 1)
    spots = [circle(0.006, 10, (x, 0.016)) for x in np.arange(0.06, 0.82, 0.09)]
    flange = plate(rectangle(0.87, 0.032, 0.006, centre=(0.44, 0.012)), 0, 0.0025, spots, 0.0008, 1)
    end = plate(rectangle(0.10, 0.15, 0.012), 0, 0.006, [circle(0.0055, 16, (sx * 0.038, sy * 0.06)) for sx in (-1, 1) for sy in (-1, 1)], 0.0015, 1)
    return join(
        beam,
        inner.rotated("x", 90).moved(0, 0.4225, 0.15),
        flange.moved(0, 0.472, 0.204),
        end.rotated("y", 90).moved(0.893, 0.452, 0.15),
    )


def strut_brace():
    """From the right strut tower to the front crossmember, over the filter's duct and the cooler hose."""
    tower, front = np.array([0.277, -0.517, 0.492]), np.array([0.868, -0.245, 0.552])
    along = (front - tower) * [1, 1, 0] / np.linalg.norm((front - tower)[:2])

    def above(foot, forward, z):
        return [*(foot + forward * along)[:2], z]

    bends = [above(tower, 0.055, 0.529), above(front, -0.050, 0.541)]
    rod = pipe(filleted([above(tower, 0.012, 0.498), *bends, above(front, -0.010, 0.558)], 0.03, 6), 0.008, 24)
    turn = np.degrees(np.arctan2(along[1], along[0]))
    feet = [plate(rectangle(0.056, 0.030, 0.009), 0, 0.004, bevel=0.001).rotated("z", turn).moved(foot) for foot in (tower, front)]
    return join(rod, feet, bolts([above(tower, -0.016, 0.496), above(front, 0.016, 0.556)], width=0.013))


def upper_rail():
    path = spline([[0.0, 0.665, 0.545], [0.3, 0.660, 0.543], [0.6, 0.645, 0.535], [0.86, 0.600, 0.520]], 16)
    rail = sweep(rectangle(0.042, 0.052, 0.010), path)
    strip = sweep(rectangle(0.003, 0.030, 0.001, 2), path + [0, -0.036, -0.016])
    return rail, join(strip, bolts([path[i] + [0, 0, 0.021] for i in (2, 5, 9, 12, 14)], width=0.012))


def brake_booster():
    can = lathe([(0, 0), (0.085, 0), (0.108, 0.008), (0.115, 0.02), (0.115, 0.045), (0.108, 0.06), (0.085, 0.082), (0.045, 0.095), (0.04, 0.104), (0, 0.104)], 48)
    seam = tube(0.120, 0.113, 0.030, 0.042, 48)
    cylinder = lathe([(0, 0.10), (0.018, 0.10), (0.018, 0.19), (0.014, 0.195), (0, 0.195)], 24)
    flange = plate(rounded([[-0.04, 0], [0, -0.025], [0.04, 0], [0, 0.025]], 0.012), 0.100, 0.108, bevel=0.0015)
    return join(can, seam, cylinder, flange).placed((0.0, 0.30, 0.40), (1, 0, 0), (0, 1, 0))


def parts():
    tower, top = strut_tower()
    rail, strip = upper_rail()
    left = join(inner_wing(), tower, rail)
    fixings = join(top, strip)
    member = side_member()
    grommets = [box((0.004, 0.05, 0.03), (0.012, y, z), 0.0015) for y, z in ((-0.34, 0.34), (0.40, 0.30))]
    return [
        Part("body", join(firewall(), left, left.mirrored()), PAINT),
        Part("cowl", join(cowl(), grommets), PRIMER),
        Part("side_members", join(member, member.mirrored()), PRIMER),
        Part("body_fixings", join(fixings, fixings.mirrored()), STEEL),
        Part("strut_brace", strut_brace(), STEEL),
        Part("brake_booster", brake_booster(), PLASTIC),
    ]
