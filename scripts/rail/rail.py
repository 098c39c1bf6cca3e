"""A sill with a crowned rail between flanges, two open clips and two connectors, which a bundle is laid over and into.

x along the sill, z up; the origin in the middle of the rail, on its crown.
"""

import numpy as np

from engine_bay.mesh import join
from engine_bay.part import ALUMINIUM, PAINT, PLASTIC, GREY_PLASTIC, Part
from engine_bay.polygon import rounded
from engine_bay.solids import bolts, box, plate

CROWN = 0.60  # radius of the rail's crown [m]
RAIL, FLANGE = 0.280, 0.007  # length of the rail, height of its flanges above the crown [m]
FLOOR = -0.060  # the sill's upper face, z [m]
CLIP_AT, CLIP_FLOOR = 0.205, -0.0345  # of the open clips: x, and the z of what carries the bundle [m]
CLIP_INSIDE = 0.018  # between their walls [m]
CONNECTOR_AT, CONNECTOR_HEIGHT = 0.300, -0.046  # x and z of where the bundle is held [m]


def extruded(outline, low, high, z_axis, x_hint, bevel):
    return plate(outline, low, high, bevel=bevel).placed((0, 0, 0), z_axis, x_hint)


def crowned(rise, low, high, bevel):
    """From the sill up to the crown and `rise` beyond, between two y."""
    x = np.linspace(-RAIL / 2, RAIL / 2, 57)
    crown = np.column_stack([x, np.sqrt(CROWN**2 - x**2) - CROWN + rise])
    foot = [[-RAIL / 2, FLOOR], [RAIL / 2, FLOOR]]
    # an outline in x and z, carried along -y
    return extruded(np.vstack([crown[::-1], foot]), -high, -low, (0, -1, 0), (1, 0, 0), bevel)


def rail():
    """The crown between two flanges, lower than the bundle is thick."""
    inside = CLIP_INSIDE / 2
    flanges = [crowned(FLANGE, *ys, 0.0008) for ys in ((inside, inside + 0.003), (-inside - 0.003, -inside))]
    return join(crowned(0.0, -inside - 0.001, inside + 0.001, 0.0005), *flanges)


def clip(x):
    inside, wall, base, height = CLIP_INSIDE / 2, 0.0025, 0.003, 0.017
    outer = inside + wall
    top = CLIP_FLOOR + height
    outline = [[-outer, FLOOR], [outer, FLOOR], [outer, top], [inside, top], [inside, CLIP_FLOOR]]
    outline += [[-inside, CLIP_FLOOR], [-inside, top], [-outer, top]]
    radii = [0.001, 0.001, 0.001, 0.001, 0.002, 0.002, 0.001, 0.001]
    u = extruded(rounded(outline, radii), -0.008, 0.008, (1, 0, 0), (0, 1, 0), 0.0005)
    return u.moved((x, 0, 0))


def connector(side):
    body = box((0.036, 0.030, 0.026), (side * (CONNECTOR_AT + 0.020), 0, CONNECTOR_HEIGHT), 0.003)
    foot = box((0.030, 0.026, 0.030), (side * (CONNECTOR_AT + 0.020), 0, FLOOR + 0.004), 0.002)
    return join(body, foot)


def parts():
    sill = box((0.720, 0.110, 0.008), (0, 0, FLOOR - 0.004), 0.003)
    heads = bolts([(x, y, FLOOR) for x in (-0.32, -0.17, 0.17, 0.32) for y in (-0.040, 0.040)])
    return [
        Part("rail_sill", join(sill, heads), PAINT),
        Part("rail_crown", rail(), ALUMINIUM),
        Part("rail_clips", join(clip(-CLIP_AT), clip(CLIP_AT)), PLASTIC),
        Part("rail_connectors", join(connector(-1), connector(1)), GREY_PLASTIC),
    ]
