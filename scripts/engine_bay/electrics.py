"""Battery with tray and straps, fuse box, engine control unit. In the bay frame."""

import numpy as np

from .curves import filleted
from .mesh import join
from .part import ALUMINIUM, GREY_PLASTIC, LEAD, PLASTIC, PRIMER, STEEL, Part
from .polygon import circle, rectangle, slot
from .solids import bolts, box, cylinder, lathe, pipe, plate, sweep

BATTERY = np.array([0.665, 0.488, 0.365])  # middle of the case
FUSE_BOX = np.array([0.425, 0.530, 0.415])


def battery_case():
    case = box((0.236, 0.172, 0.165), (0, 0, -0.012), 0.004, corner=0.008)
    ribs = [box((0.006, 0.176, 0.11), (x, 0, -0.02), 0.0015, 1) for x in np.linspace(-0.095, 0.095, 9)]
    foot = plate(rectangle(0.246, 0.182, 0.01), -0.095, -0.084, bevel=0.003)
    return join(case, ribs, foot).moved(BATTERY)


def battery_lid():
    lid = plate(rectangle(0.242, 0.178, 0.012), 0.070, 0.088, bevel=0.004)
    step = plate(rectangle(0.20, 0.085, 0.010, centre=(0.0, 0.03)), 0.086, 0.096, bevel=0.003)
    caps = [cylinder(0.011, 0.095, 0.099, 0.0015, 16).moved(x, 0.03, 0) for x in np.linspace(-0.08, 0.08, 6)]
    handles = [pipe(filleted([[x, -0.055, 0.086], [x, -0.055, 0.104], [x, 0.055, 0.104], [x, 0.055, 0.086]], 0.012, 5), 0.004, 8) for x in (-0.112, 0.112)]
    return join(lid, step, caps, handles).moved(BATTERY)


def battery_terminals():
    posts = []
    for x in (-0.085, 0.085):
        post = lathe([(0, 0.086), (0.0095, 0.086), (0.0085, 0.104), (0, 0.104)], 24)
        clamp = plate(rectangle(0.034, 0.030, 0.010), 0.090, 0.101, [circle(0.0093, 20)], 0.002, 1)
        lug = box((0.022, 0.014, 0.010), (0.024, 0, 0.0955), 0.002)
        posts.append(join(post, clamp, lug, bolts([(0.026, 0, 0.1005)], width=0.008, height=0.006)).moved(x, -0.045, 0))
    return join(posts).moved(BATTERY)


def battery_tray():
    holes = [circle(0.010, 12, (x, y)) for x in (-0.09, 0.0, 0.09) for y in (-0.06, 0.06)]
    floor = plate(rectangle(0.262, 0.198, 0.012), -0.099, -0.095, holes, 0.001, 1)
    lips = [box((0.262, 0.004, 0.022), (0, y, -0.088), 0.0015) for y in (-0.098, 0.098)]
    lips += [box((0.004, 0.198, 0.022), (x, 0, -0.088), 0.0015) for x in (-0.130, 0.130)]
    legs = [sweep(rectangle(0.004, 0.05, 0.001, 2), filleted([[x, -0.06, -0.098], [x, -0.03, -0.098], [x, -0.030, -0.165]], 0.012, 5), (0, 0, 1)) for x in (-0.08, 0.08)]
    return join(floor, lips, legs).moved(BATTERY)


def battery_strap():
    path = filleted([[0, -0.094, -0.075], [0, -0.094, 0.0915], [0, 0.0945, 0.0915], [0, 0.0945, -0.075]], 0.010, 5)
    strap = sweep(rectangle(0.0025, 0.028, 0.0008, 2), path, (0, -1, 0))
    return join(strap, bolts([(0, -0.094, -0.05)], (0, -1, 0), width=0.010)).moved(BATTERY)


def fuse_box():
    lower = box((0.160, 0.118, 0.060), (0, 0, -0.022), 0.004, corner=0.010)
    lid = plate(rectangle(0.170, 0.128, 0.014), 0.002, 0.040, bevel=0.006, segments=3)
    ribs = [box((0.110, 0.005, 0.004), (0, y, 0.041), 0.001, 1) for y in np.linspace(-0.036, 0.036, 7)]
    latches = [box((0.022, 0.008, 0.026), (x, y, -0.002), 0.002) for x in (-0.045, 0.045) for y in (-0.065, 0.065)]
    return join(lower, lid, ribs, latches).moved(FUSE_BOX)


def fuse_box_bracket():
    arm = filleted([[0, 0.03, -0.054], [0, -0.035, -0.054], [0, -0.050, -0.190], [0, -0.075, -0.205]], 0.015, 5)
    arms = [sweep(rectangle(0.003, 0.030, 0.001, 2), arm + [x, 0, 0]) for x in (-0.05, 0.05)]
    return join(arms, bolts([(x, -0.067, -0.2) for x in (-0.05, 0.05)], (0, 0, 1), width=0.010)).moved(FUSE_BOX)


def control_unit():
    """On the firewall, right of the middle."""
    case = box((0.034, 0.20, 0.15), (0.034, -0.30, 0.36), 0.005, corner=0.012)
    fins = [box((0.012, 0.006, 0.13), (0.054, y, 0.36), 0.0015, 1) for y in np.linspace(-0.385, -0.265, 11)]
    plate_ = plate(rectangle(0.23, 0.18, 0.01), 0, 0.003, [circle(0.004, 12, (sx * 0.107, sy * 0.08)) for sx in (-1, 1) for sy in (-1, 1)], 0.001, 1)
    return join(case, fins), plate_.placed((0.014, -0.30, 0.36), (1, 0, 0), (0, 1, 0))


def ground_strap():
    negative = BATTERY + [0.124, -0.045, 0.097]
    return pipe(filleted([negative, negative + [0.02, -0.03, 0.0], [0.80, 0.405, 0.40], [0.80, 0.41, 0.205]], 0.025), 0.006, 14)


def parts():
    unit, unit_plate = control_unit()
    return [
        Part("battery_case", battery_case(), GREY_PLASTIC),
        Part("battery_lid", join(battery_lid(), ground_strap()), PLASTIC),
        Part("battery_terminals", battery_terminals(), LEAD),
        Part("battery_tray", join(battery_tray(), fuse_box_bracket(), unit_plate), PRIMER),
        Part("battery_strap", battery_strap(), STEEL),
        Part("fuse_box", fuse_box(), PLASTIC),
        Part("control_unit", unit, ALUMINIUM),
    ]
