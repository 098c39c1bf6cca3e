"""Reservoirs, air filter, and the pipes and hoses between them. In the bay frame."""

import numpy as np

from .curves import filleted, spline
from .mesh import join
from .part import ALUMINIUM, BLUE, NATURAL, PLASTIC, RUBBER, STEEL, YELLOW, Part
from .polygon import circle, rectangle, rounded
from .solids import bolts, box, cylinder, lathe, pipe, plate, sweep, torus

AIR_FILTER = np.array([0.625, -0.500, 0.355])


def screw_cap(radius):
    grips = [box((0.004, 0.005, 0.014), (radius, 0, 0.010), 0.001, 1).rotated("z", 36 * k) for k in range(10)]
    return join(cylinder(radius, 0, 0.020, 0.004, 32), grips)


def washer_bottle():
    outline = rounded([[-0.07, -0.05], [0.07, -0.05], [0.07, 0.02], [0.03, 0.05], [-0.07, 0.05]], 0.018, 5)
    body = plate(outline, 0.21, 0.42, bevel=0.014, segments=4)
    neck = pipe(filleted([[0.02, -0.01, 0.41], [0.02, -0.01, 0.47], [0.02, -0.005, 0.50]], 0.04), 0.022, 28)
    return join(body, neck).moved(0.425, -0.545, 0), screw_cap(0.028).moved(0.445, -0.55, 0.495)


def expansion_tank():
    body = lathe([(0, 0)] + [(0.058 * np.sin(a) ** 0.6, 0.058 - 0.058 * np.cos(a)) for a in np.linspace(0.25, np.pi - 0.25, 14)] + [(0, 0.116)], 40)
    seam = torus(0.058, 0.004, 40, 8).moved(0, 0, 0.058)
    return join(body, seam).moved(0.085, -0.555, 0.35), screw_cap(0.026).moved(0.085, -0.555, 0.455)


def brake_reservoir():
    body = plate(rectangle(0.085, 0.055, 0.012), 0, 0.045, bevel=0.006, segments=3)
    return body.moved(0.165, 0.30, 0.425), screw_cap(0.021).moved(0.165, 0.30, 0.465)


def air_filter():
    lower = plate(rectangle(0.23, 0.17, 0.03), -0.105, 0.03, bevel=0.012, segments=3)
    rim = plate(rectangle(0.248, 0.188, 0.036), 0.025, 0.041, bevel=0.003)
    lid = plate(rectangle(0.228, 0.168, 0.03), 0.04, 0.095, bevel=0.016, segments=4)
    ribs = [box((0.008, 0.12, 0.008), (x, 0, 0.094), 0.002, 1) for x in np.linspace(-0.075, 0.075, 7)]
    clips = [box((0.014, 0.010, 0.034), (x, y, 0.034), 0.003) for x in (-0.07, 0.07) for y in (-0.094, 0.094)]
    snorkel = sweep(rectangle(0.045, 0.085, 0.016), spline([[0.10, 0.0, 0.065], [0.16, 0.01, 0.075], [0.20, 0.03, 0.100], [0.26, 0.05, 0.110]], 16))
    return join(lower, rim, lid, ribs, clips, snorkel).moved(AIR_FILTER)


def air_duct():
    """From the filter's lid back to the throttle: corrugated rubber, with slack for the engine's motion."""
    path = spline([[0.530, -0.500, 0.400], [0.492, -0.490, 0.412], [0.478, -0.440, 0.422], [0.524, -0.385, 0.412], [0.600, -0.350, 0.376], [0.635, -0.330, 0.365]], 49)
    scale = 1.0 + 0.07 * np.sin(np.pi * np.arange(49) / 2 + 0.6) * (np.abs(np.arange(49) - 24) < 18)
    return sweep(circle(0.037, 24), path, scale=scale)


def coolant_pipes():
    lower = spline([[0.745, 0.35, 0.15], [0.700, 0.345, 0.145], [0.600, 0.300, 0.105], [0.520, 0.150, 0.085], [0.480, 0.05, 0.120]], 24)
    heater = [spline([[0.012, y, 0.34 + dz], [0.06, y, 0.34 + dz], [0.10, y - 0.06, 0.35 + dz], [0.15, y - 0.10, 0.36 + dz], [0.262, y - 0.11, 0.375]], 22) for y, dz in ((-0.02, 0.0), (0.04, 0.03))]
    overflow = spline([[0.085, -0.50, 0.40], [0.11, -0.46, 0.43], [0.20, -0.42, 0.44], [0.27, -0.33, 0.40]], 22)
    return join(pipe(lower, 0.017, 18), [pipe(path, 0.010, 14) for path in heater], pipe(overflow, 0.007, 14))


def hard_lines():
    """Brake lines from the master cylinder along the firewall, and the air conditioner's."""
    brake = [filleted([[0.15 + 0.03 * k, 0.30, 0.385], [0.15 + 0.03 * k, 0.30, 0.340 - 0.01 * k], [0.035, 0.34 + 0.012 * k, 0.33 - 0.012 * k], [0.035, 0.44, 0.25 - 0.012 * k], [0.12, 0.445, 0.225 - 0.01 * k], [0.14, 0.46, 0.212]], 0.02, 5) for k in (0, 1)]
    cross = filleted([[0.030, 0.30, 0.462], [0.030, -0.50, 0.462], [0.06, -0.56, 0.462]], 0.03, 5)
    gas = filleted([[0.012, -0.10, 0.30], [0.10, -0.12, 0.30], [0.12, -0.40, 0.30], [0.30, -0.43, 0.27], [0.72, -0.425, 0.25], [0.79, -0.40, 0.25]], 0.04, 6)
    lines = [pipe(path, 0.0028, 8) for path in [*brake, cross]] + [pipe(gas, 0.008, 16)]
    lines += [box((0.014, 0.012, 0.014), (0.026, y, 0.462), 0.003) for y in (0.2, 0.0, -0.2, -0.4)]
    return join(lines)


def filter_fixings():
    stay = plate(rounded([[-0.03, -0.10], [0.03, -0.10], [0.03, 0.02], [-0.03, 0.02]], 0.012), 0, 0.003, [circle(0.0045, 14, (0, -0.085))], 0.001, 1)
    return join(stay.moved(0.625, -0.41, 0.245), bolts([(0.625, -0.495, 0.248)], width=0.010))


def parts():
    washer, washer_cap = washer_bottle()
    tank, tank_cap = expansion_tank()
    brake, brake_cap = brake_reservoir()
    return [
        Part("reservoirs", join(washer, tank, brake), NATURAL),
        Part("washer_cap", washer_cap, BLUE),
        Part("tank_caps", join(tank_cap, brake_cap), YELLOW),
        Part("air_filter", air_filter(), PLASTIC),
        Part("hoses", join(air_duct(), coolant_pipes()), RUBBER),
        Part("hard_lines", join(hard_lines(), filter_fixings()), STEEL),
    ]
