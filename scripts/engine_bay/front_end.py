"""The front end: crossmembers, radiator, fan shroud and fans."""

import numpy as np

from .curves import spline
from .mesh import Mesh, join
from .part import ALUMINIUM, GREY_PLASTIC, PAINT, PLASTIC, Part
from .polygon import circle, rectangle, slot
from .solids import bolts, box, cylinder, lathe, plate, sweep, tube

FANS = ((0.762, 0.155, 0.295), (0.762, -0.165, 0.295))
# Where the upper hose meets the radiator: the stub's face and the way out of it.
HOSE_INLET = np.array([0.745, -0.348, 0.435])


def crossmembers():
    upper = sweep(rectangle(0.034, 0.055, 0.009), spline([[0.84, -0.60, 0.525], [0.875, -0.3, 0.535], [0.88, 0, 0.537], [0.875, 0.3, 0.535], [0.84, 0.60, 0.525]], 18))
    lower = sweep(rectangle(0.05, 0.07, 0.012), spline([[0.85, -0.5, 0.06], [0.87, 0, 0.055], [0.85, 0.5, 0.06]], 16))
    latch = plate(rectangle(0.06, 0.12, 0.01), 0, 0.004, [slot(0.04, 0.014, 16, (0, 0), np.pi / 2), circle(0.005, 16, (0.02, 0.045)), circle(0.005, 16, (0.02, -0.045))], 0.001)
    posts = [box((0.03, 0.04, 0.44), (0.858, y, 0.29), 0.006) for y in (-0.43, 0.43)]
    return join(upper, lower, latch.moved(0.87, 0, 0.554), posts)


def core():
    """Flat tubes across, fins between: what shows of a radiator from the front."""
    tubes = [box((0.026, 0.64, 0.0024), (0.812, 0, z), 0.0007, 1) for z in np.arange(0.112, 0.481, 0.0141)]
    fins = [box((0.022, 0.0008, 0.372), (0.812, y, 0.296), 0.0002, 1) for y in np.linspace(-0.316, 0.316, 61)]
    sides = [box((0.03, 0.66, 0.012), (0.812, 0, z), 0.002) for z in (0.100, 0.492)]
    return join(tubes, fins, sides)


def tanks():
    one = box((0.046, 0.045, 0.40), (0.812, 0.345, 0.296), 0.01, corner=0.018)
    ribs = [box((0.050, 0.03, 0.004), (0.812, 0.350, z), 0.001, 1) for z in np.arange(0.13, 0.48, 0.025)]
    stub = lathe([(0, 0), (0.0125, 0), (0.0125, 0.028), (0.016, 0.034), (0.016, 0.06), (0, 0.06)], 32)
    inlet = stub.placed(HOSE_INLET, (1, 0, 0))
    outlet = stub.placed((0.745, 0.35, 0.15), (1, 0, 0))
    cap = join(cylinder(0.024, 0, 0.012, 0.003, 40), box((0.012, 0.05, 0.008), (0, 0, 0.014), 0.003))
    return join(one, ribs, one.mirrored(), [rib.mirrored() for rib in ribs], inlet, outlet, cap.moved(0.812, 0.345, 0.496))


def shroud():
    holes = [circle(0.132, 44, (y, 0)) for y in (0.155, -0.165)]
    panel = plate(rectangle(0.64, 0.37, 0.02), 0, 0.004, holes, 0.001)
    rings = [tube(0.138, 0.132, -0.02, 0.022, 44, 0.001).moved(y, 0, 0) for y in (0.155, -0.165)]
    struts = []
    for y in (0.155, -0.165):
        for k in range(5):
            arm = box((0.10, 0.010, 0.008), (0.085, 0, 0.016), 0.002).rotated("z", 72 * k + 18)
            struts.append(arm.moved(y, 0, 0))
        struts.append(cylinder(0.042, 0.008, 0.034, 0.004, 28).moved(y, 0, 0))
    ribs = [box((0.004, 0.34, 0.012), (y, 0, 0.006), 0.001, 1) for y in (-0.31, -0.005, 0.31)]
    flat = join(panel, rings, struts, ribs)
    return flat.placed((0.782, 0, 0.295), (-1, 0, 0), (0, 1, 0))


def fan():
    """Seven twisted blades about x; the hub at the origin."""
    blades = []
    for k in range(7):
        section = rectangle(0.034, 0.0028, 0.0011, 1)
        steps = np.linspace(0.036, 0.122, 8)
        path = np.column_stack([0 * steps, 0 * steps, steps])
        blade = sweep(section, path, (0, 1, 0))
        twist = np.radians(38 - 240 * (blade.vertices[:, 2] - 0.036))
        x, y = blade.vertices[:, 0].copy(), blade.vertices[:, 1].copy()
        turned = np.column_stack([np.sin(twist) * y + np.cos(twist) * x, np.cos(twist) * y - np.sin(twist) * x, blade.vertices[:, 2]])
        blades.append(Mesh(turned, blade.triangles).rotated("x", 360 / 7 * k))
    hub = lathe([(0, -0.012), (0.030, -0.012), (0.040, -0.006), (0.040, 0.012), (0, 0.012)], 40)
    rim = tube(0.124, 0.120, -0.012, 0.012, 44, 0.001)
    return join(blades, hub.placed((0, 0, 0), (-1, 0, 0)), rim.placed((0, 0, 0), (1, 0, 0)))


def parts():
    fixings = bolts([(0.875, y, 0.553) for y in (-0.35, -0.2, 0.2, 0.35)])
    return [
        Part("crossmembers", join(crossmembers(), fixings), PAINT),
        Part("radiator_core", core(), ALUMINIUM),
        Part("radiator_tanks", tanks(), PLASTIC),
        Part("fan_shroud", shroud(), GREY_PLASTIC),
        *[
            Part(f"fan_{side}", fan(), PLASTIC, "continuous", place, (1.0, 0.0, 0.0))
            for side, place in zip(("left", "right"), FANS)
        ],
    ]
