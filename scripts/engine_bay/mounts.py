"""What the clips of the scenes in config/ sit on: connectors, sensors, sheet-metal stays.

The frames of the clips are repeated here from the scenes: position, and yaw about z.
"""

import numpy as np

from .curves import filleted
from .electrics import BATTERY
from .mesh import join, unit
from .part import GREY_PLASTIC, STEEL, Part
from .polygon import circle, rectangle, regular, rounded, slot
from .solids import bolts, box, lathe, plate, sweep, torus

VALVE_TAB = np.array([0.413, 0.342, 0.3895])  # bay frame: upper corner, rear and left
WH_END = (np.array([0.045, 0.250, 0.278]), -50.0)  # engine frame
RELAY_SHELF = np.array([0.519, 0.348, 0.413])  # bay frame: the middle of its upper rear edge
SENSOR_FOOT = np.array([0.091, 0.222, 0.186])  # engine frame
SENSOR_AXIS = unit([-0.55, 0.80, 0.25])
TIE_CLIMB, RING_CLIMB = (16, -149), (40, -92)  # the cable's pitch and yaw at the two clips [deg]
WH_BRANCH = SENSOR_FOOT + 0.042 * SENSOR_AXIS  # the cable arrives against the axis


def strip(path, width, thickness=0.0025, bend=0.006, across=(1.0, 0.0, 0.0)):
    """Sheet metal bent along a polyline."""
    return sweep(rectangle(width, thickness, 0.0008, 2), filleted(path, bend, 5), across)


def connector():
    """A plug on x < 0 whose cable leaves at the origin along +x."""
    body = box((0.030, 0.026, 0.018), (-0.021, 0, 0), 0.003)
    latch = box((0.018, 0.008, 0.004), (-0.024, 0, 0.0105), 0.001)
    ribs = [box((0.003, 0.028, 0.020), (x, 0, 0), 0.001, 1) for x in (-0.012, -0.018, -0.030)]
    boot = lathe([(0, -0.008), (0.0075, -0.008), (0.0075, -0.004), (0.0062, -0.0025), (0.0062, 0), (0, 0)], 24)
    return join(body, latch, ribs, boot.placed((0, 0, 0), (1, 0, 0)))


def start_bracket():
    """Connector WH_Start on its angle; its own frame is the clip's, turned by -66 deg from the bay's."""
    angle = strip([[-0.009, 0.002, -0.0115], [-0.009, 0.0445, -0.0115], [-0.009, 0.0445, 0.016]], 0.030)
    screws = bolts([(-0.009 + dx, 0.0432, 0.009) for dx in (-0.009, 0.009)], (0, -1, 0), width=0.007, height=0.005)
    return join(connector(), join(angle, screws).rotated("z", 66))


def end_bracket():
    """In the engine's frame: the connector WH_End on an angle at the cylinder head's left end."""
    place, yaw = WH_END
    x = place[0] + 0.0135
    angle = strip([[x, place[1] - 0.006, place[2] - 0.0108], [x, 0.2265, place[2] - 0.0108], [x, 0.2265, 0.150]], 0.030)
    screws = bolts([(x, 0.2278, z) for z in (0.165, 0.195)], (0, 1, 0), width=0.009, height=0.006)
    # The cable arrives here, so the plug lies beyond the frame's origin.
    return connector().rotated("z", yaw + 180).moved(place), join(angle, screws)


def coolant_sensor():
    """In the engine's frame: a screwed-in sensor with the connector WH_Branch."""
    length = np.linalg.norm(WH_BRANCH - SENSOR_FOOT)
    boss = lathe([(0, -0.012), (0.013, -0.012), (0.013, 0.003), (0.011, 0.005), (0, 0.005)], 28)
    nut = join(boss, plate(regular(6, 0.017), 0.004, 0.012, bevel=0.001))
    plug = lathe([(0, 0.011), (0.0085, 0.011), (0.0085, 0.016), (0.0072, 0.017), (0.0072, length - 0.010), (0.0058, length - 0.007), (0.0058, length), (0, length)], 24)
    ring = torus(0.0075, 0.0012, 24, 8).moved(0, 0, length - 0.015)
    return join(plug, ring).placed(SENSOR_FOOT, SENSOR_AXIS), nut.placed(SENSOR_FOOT, SENSOR_AXIS)


def relay_stay():
    """Two relays on a stay of the battery tray."""
    x, y, z = RELAY_SHELF
    outline = rounded([[x, y - 0.034], [x + 0.044, y - 0.034], [x + 0.044, y + 0.036], [x, y + 0.036]], 0.007, 5)
    holes = [circle(0.0035, 14, (x + 0.008, y - 0.024)), slot(0.018, 0.006, 12, (x + 0.009, y + 0.012), np.pi / 2)]
    shelf = plate(outline, z - 0.0025, z, holes, 0.0008)
    tray = BATTERY + [0, -0.1015, -0.088]
    upright = strip([[x + 0.028, y - 0.02, z - 0.0035], [x + 0.028, tray[1], z - 0.0035], [x + 0.028, tray[1], tray[2] - 0.008]], 0.028)
    screws = bolts([(x + 0.028, tray[1] - 0.0012, tray[2])], (0, -1, 0), width=0.010)
    relays = []
    for dy in (-0.016, 0.014):
        case = box((0.024, 0.024, 0.026), (x + 0.028, y + dy, z + 0.015), 0.0025)
        rim = box((0.027, 0.027, 0.004), (x + 0.028, y + dy, z + 0.003), 0.001, 1)
        relays.append(join(case, rim))
    return join(shelf, upright, screws), join(relays)


def valve_stay():
    """A purge valve on a stay of the side member; its tab's edge is what the harness passes by."""
    x, y, z = VALVE_TAB
    outline = rounded([[x, y - 0.028], [x + 0.034, y - 0.028], [x + 0.034, y], [x, y]], 0.005, 5)
    top = plate(outline, z - 0.0025, z, [circle(0.0032, 14, (x + 0.008, y - 0.007))], 0.0008)
    bends = [[x + 0.018, y - 0.022, z - 0.0035], [x + 0.018, y - 0.004, z - 0.0035], [x + 0.020, 0.398, 0.300], [x + 0.020, 0.438, 0.224], [x + 0.020, 0.438, 0.2065], [x + 0.020, 0.466, 0.2065]]
    screw = bolts([(x + 0.020, 0.458, 0.2078)], width=0.010)
    body = lathe([(0, -0.002), (0.0095, -0.002), (0.0105, 0), (0.0105, 0.016), (0.0085, 0.018), (0.0085, 0.026), (0.0065, 0.028), (0, 0.028)], 28)
    nozzle = lathe([(0, 0), (0.003, 0), (0.003, 0.010), (0.0038, 0.012), (0.0026, 0.018), (0, 0.018)], 16)
    valve = join(body, nozzle.placed((0, 0, 0.021), (0.6, -0.8, 0)), nozzle.moved(0, 0, 0.026)).moved(x + 0.022, y - 0.014, z)
    return join(top, strip(bends, 0.020), screw), valve


def tab(depth, pitch, yaw):
    """The end of a stay, `depth` below a clip whose cable climbs by `pitch` towards `yaw` [deg]."""
    outline = rounded([[-0.011, -0.010], [0.011, -0.010], [0.011, 0.010], [-0.011, 0.010]], 0.005)
    return plate(outline, -depth - 0.0025, -depth, bevel=0.0008).rotated("y", -pitch).rotated("z", yaw)


def tie_stay():
    """For the tube clip WH_Tie: from the gearbox up to a tab under the cable. Axes as the engine's."""
    bends = [[-0.062, 0, -0.119], [-0.036, 0, -0.127], [-0.004, 0, -0.080], [0.0, 0, -0.045], [0.0, 0, -0.010]]
    screw = bolts([(-0.054, 0, -0.1195)], (0.3, 0, 0.95), width=0.009, height=0.006)
    return join(strip(bends, 0.018, across=(0, 1, 0)), tab(0.0068, *TIE_CLIMB), screw)


def ring_stay():
    """For the ring WH_Ring: from the cylinder head out to a tab under the cable. Axes as the engine's."""
    bends = [[0, -0.0615, -0.095], [0, -0.0615, -0.0140], [0, 0.004, -0.0140]]
    screws = bolts([(0, -0.0603, z) for z in (-0.084, -0.060)], (0, 1, 0), width=0.009, height=0.006)
    return join(strip(bends, 0.018), tab(0.0090, *RING_CLIMB), screws)


def body_parts():
    stay, relays = relay_stay()
    support, valve = valve_stay()
    return [Part("body_stays", join(stay, support), STEEL), Part("relays", join(relays, valve), GREY_PLASTIC)]


def engine_parts():
    plug, angle = end_bracket()
    sensor, nut = coolant_sensor()
    return [
        Part("engine_connectors", join(plug, sensor), GREY_PLASTIC),
        Part("engine_stays", join(angle, nut), STEEL),
    ]


def pieces():
    """Parts that a scene adds one by one, each about its clip's frame."""
    return [
        Part("start_bracket", start_bracket(), GREY_PLASTIC),
        Part("tie_stay", tie_stay(), STEEL),
        Part("ring_stay", ring_stay(), STEEL),
    ]
