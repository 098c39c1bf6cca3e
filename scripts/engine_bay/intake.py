"""The engine's intake manifold with throttle, and its coolant outlet. In the engine frame."""

import numpy as np

from .curves import spline
from .engine import CYLINDERS
from .mesh import join, unit
from .part import ALUMINIUM, GREY_PLASTIC, STEEL, Part
from .polygon import circle, rectangle, rounded
from .solids import bolts, box, lathe, pipe, plate, sweep, torus, tube

# Where the cooler hose leaves the engine: the stub's face and the way out of it.
HOSE_OUTLET = np.array([0.125, -0.262, 0.212])
HOSE_OUTLET_AXIS = unit([0.92, -0.10, 0.38])


def manifold():
    pieces = []
    for y in CYLINDERS:
        path = spline([[0.125, y, 0.185], [0.165, y, 0.205], [0.205, y, 0.255], [0.255, y, 0.268], [0.292, y, 0.235], [0.292, y, 0.190]], 17)
        pieces.append(pipe(path, 0.021, 20))
        for i in (6, 11):
            tangent = path[i + 1] - path[i - 1]
            pieces.append(torus(0.021, 0.003, 20, 6).placed(path[i], tangent))
    pieces.append(plate(rectangle(0.066, 0.41, 0.014), 0, 0.012, bevel=0.002).placed((0.128, 0, 0.182), (1, 0, 0), (0, 0, 1)))
    plenum = [(0, -0.215), (0.025, -0.215), (0.040, -0.207), (0.047, -0.190), (0.047, 0.175), (0.041, 0.192), (0.025, 0.200), (0, 0.200)]
    pieces.append(lathe(plenum, 40).placed((0.275, 0, 0.165), (0, 1, 0)))
    pieces += [torus(0.047, 0.004, 32, 6).placed((0.275, y, 0.165), (0, 1, 0)) for y in np.arange(-0.17, 0.18, 0.068)]
    return join(pieces)


def throttle():
    flange = plate(rounded([[-0.042, -0.042], [0.042, -0.042], [0.042, 0.042], [-0.042, 0.042]], 0.014), 0, 0.010, bevel=0.002)
    bore = tube(0.036, 0.031, 0.0, 0.055, 40, 0.0015)
    motor = box((0.045, 0.038, 0.040), (0.055, 0, 0.030), 0.006)
    screws = bolts([(sx * 0.034, sy * 0.034, 0.010) for sx in (-1, 1) for sy in (-1, 1)], width=0.008, height=0.006)
    return join(flange, bore, motor, screws).placed((0.275, -0.213, 0.165), (0, -1, 0))


def thermostat_housing():
    foot = plate(rounded([[-0.034, 0], [0, -0.030], [0.034, 0], [0, 0.030]], 0.016, 5), 0, 0.012, bevel=0.002)
    foot = foot.placed((0.080, -0.225, 0.188), (0, -1, 0), (1, 0, 0))
    start = np.array([0.080, -0.225, 0.188])
    bend = pipe(spline([start, start + [0.002, -0.022, 0.003], HOSE_OUTLET - 0.024 * HOSE_OUTLET_AXIS], 14), 0.0165, 24)
    end = lathe([(0, -0.030), (0.0165, -0.030), (0.0165, -0.024), (0.0125, -0.022), (0.0125, 0.0), (0, 0.0)], 28)
    return join(foot, bend, end.placed(HOSE_OUTLET, HOSE_OUTLET_AXIS))


def fuel_rail():
    rail = sweep(rectangle(0.016, 0.016, 0.005), [[0.150, y, 0.232] for y in (-0.17, 0.0, 0.17)])
    injectors = [lathe([(0, 0), (0.008, 0), (0.008, 0.02), (0.006, 0.022), (0.006, 0.05), (0, 0.05)], 20).placed((0.130, y, 0.192), (0.45, 0, 0.9)) for y in CYLINDERS]
    return join(rail, injectors, bolts([(0.140, y, 0.186) for y in (-0.185, -0.092, 0.0, 0.092, 0.185)], (1, 0, 0), width=0.010))


def parts():
    return [
        Part("intake_manifold", manifold(), GREY_PLASTIC),
        Part("throttle", join(throttle(), thermostat_housing()), ALUMINIUM),
        Part("fuel_rail", fuel_rail(), STEEL),
    ]
