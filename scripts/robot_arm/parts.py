"""A small six-axis arm with a gripper, and what it works at: a plug, its seat in the engine bay, a tray.

Each mesh is in its link's frame, with which the link's joint begins. At 0 the upper arm stands upright, the forearm and
the hand point along the base's x.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from engine_bay.curves import filleted
from engine_bay.mesh import join
from engine_bay.mounts import connector, strip
from engine_bay.part import ALUMINIUM, GREY_PLASTIC, STEEL, Part
from engine_bay.polygon import rectangle, rounded
from engine_bay.solids import bolts, box, lathe, plate, sweep

SHOULDER, UPPER, FORE, HAND = 0.30, 0.42, 0.40, 0.09  # from axis to axis [m]
PALM = 0.135  # from the flange to the middle between the fingertips [m]
ORANGE = ("robot_orange", (0.90, 0.45, 0.12))
DARK = ("robot_joints", (0.25, 0.26, 0.28))
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@dataclass
class Link:
    """A link and the joint that it begins with."""

    name: str
    part: Part | None
    parent: str = ""
    joint: str = ""
    kind: str = "fixed"
    origin: tuple = (0.0, 0.0, 0.0)
    turned: tuple = (0.0, 0.0, 0.0)  # roll, pitch, yaw [rad]
    axis: tuple = X
    limits: tuple = ()
    mimics: str = ""


def bar(start, end, wide, deep):
    """A tapering bar with rounded edges; `deep` along y, `wide` at either end across."""
    at = np.linspace(0, 1, 5)
    path = np.asarray(start, float) + at[:, None] * (np.asarray(end, float) - start)
    section = rectangle(deep, wide[0], 0.3 * min(deep, wide[0]), 4)
    return sweep(section, path, Y, 1 + (wide[1] / wide[0] - 1) * at)


def drum(radius, half, place=(0, 0, 0), axis=Y):
    """The housing of a joint's motor."""
    body = lathe([(0, -half), (radius - 0.008, -half), (radius, -half + 0.008), (radius, half - 0.008), (radius - 0.008, half), (0, half)], 40)
    return body.placed(place, axis)


def base():
    pedestal = lathe([(0, -0.42), (0.17, -0.42), (0.17, -0.395), (0.12, -0.38), (0.105, -0.02), (0.12, 0.0), (0.12, 0.05), (0.10, 0.085), (0.10, 0.11), (0, 0.11)], 48)
    feet = bolts([(0.148 * np.cos(a), 0.148 * np.sin(a), -0.395) for a in np.radians(range(0, 360, 60))], width=0.016)
    return join(pedestal, feet)


def shoulder():
    turret = lathe([(0, -SHOULDER + 0.112), (0.098, -SHOULDER + 0.112), (0.098, -0.13), (0.075, -0.09), (0, -0.09)], 40)
    yoke = [box((0.11, 0.030, 0.20), (0, y, -0.045), 0.012) for y in (-0.072, 0.072)]
    return join(turret, box((0.13, 0.17, 0.05), (0, 0, -0.115), 0.015), yoke, drum(0.050, 0.094))


def upper_arm():
    beam = bar((0, 0, -0.02), (0, 0, UPPER + 0.02), (0.095, 0.075), 0.085)
    return join(beam, drum(0.058, 0.052), drum(0.048, 0.060, (0, 0, UPPER)))


def elbow():
    """Carries the forearm's roll: its frame is the elbow's axis."""
    body = bar((0, 0, 0), (0.125, 0, 0.0), (0.085, 0.085), 0.075)
    cheeks = [box((0.085, 0.018, 0.085), (0, y, 0), 0.007) for y in (-0.072, 0.072)]
    neck = drum(0.042, 0.02, (0.135, 0, 0), X)
    return join(body, cheeks, drum(0.040, 0.081), neck)


def forearm():
    """Rolls about x; its frame is where the wrist's axes meet."""
    tube_part = lathe([(0, -FORE + 0.157), (0.040, -FORE + 0.157), (0.040, -0.17), (0.030, -0.09), (0.030, -0.06), (0, -0.06)], 36).placed((0, 0, 0), X)
    fork = [box((0.105, 0.016, 0.050), (-0.022, y, 0), 0.006) for y in (-0.034, 0.034)]
    return join(tube_part, box((0.030, 0.080, 0.056), (-0.068, 0, 0), 0.008), fork, drum(0.024, 0.044))


def wrist():
    body = box((0.06, 0.050, 0.044), (0.020, 0, 0), 0.008)
    return join(body, drum(0.0245, 0.024), drum(0.026, 0.009, (0.056, 0, 0), X))


def flange():
    """Turns about x; its frame is at the wrist's axes."""
    disc = lathe([(0, 0.066), (0.028, 0.066), (0.028, HAND), (0, HAND)], 36).placed((0, 0, 0), X)
    screws = bolts([(HAND - 0.001, 0.021 * np.cos(a), 0.021 * np.sin(a)) for a in np.radians(range(45, 360, 90))], X, width=0.005, height=0.003)
    return join(disc, screws)


def gripper():
    """z is where it points; its frame lies between the fingertips."""
    palm = box((0.044, 0.084, 0.052), (0, 0, -PALM + 0.028), 0.008)
    rail = box((0.024, 0.096, 0.012), (0, 0, -PALM + 0.059), 0.003)
    return join(palm, rail)


def finger():
    """On the side of +y, its face at y = 0."""
    root = box((0.022, 0.014, 0.034), (0, 0.014, -PALM + 0.079), 0.003)
    tip = box((0.012, 0.007, 0.058), (0, 0.0035, -0.020), 0.002)
    shank = box((0.018, 0.018, 0.018), (0, 0.0095, -0.047), 0.003)
    return join(root, shank, tip)


def seat():
    """What the plug WH_Start sits on, in the frame of its clip: the angle of start_bracket on the fuse box."""
    angle = strip([[-0.009, 0.002, -0.0115], [-0.009, 0.0445, -0.0115], [-0.009, 0.0445, 0.016]], 0.030)
    screws = bolts([(-0.009 + dx, 0.0432, 0.009) for dx in (-0.009, 0.009)], (0, -1, 0), width=0.007, height=0.005)
    return join(angle, screws).rotated("z", 66)


def tray():
    """Where the plug waits, in the frame that its clip has then: a nest on a bar that lies on the fender."""
    outline = rounded([[-0.060, -0.032], [0.010, -0.032], [0.010, 0.032], [-0.060, 0.032]], 0.010)
    floor = plate(outline, -0.0150, -0.0100, bevel=0.001)
    stop = box((0.006, 0.030, 0.012), (-0.0405, 0, -0.006), 0.0015)
    posts = [box((0.008, 0.005, 0.014), (-0.003, y, -0.005), 0.001) for y in (-0.0115, 0.0115)]
    path = [[-0.030, 0, -0.0225], [-0.160, 0, -0.0225], [-0.220, 0, 0.0135], [-0.325, 0, 0.0135]]
    stand = sweep(rectangle(0.030, 0.015, 0.004, 3), filleted(path, 0.02, 5), Y)
    screws = bolts([(x, 0, 0.0205) for x in (-0.285, -0.310)], width=0.009, height=0.006)
    return join(floor, stop, posts, stand, screws)


def links():
    """In the order of the chain, the root first."""
    turn, right = (-2.9, 2.9), np.pi / 2
    return [
        Link("base_link", Part("base", base(), DARK)),
        Link("link_1", Part("shoulder", shoulder(), ORANGE), "base_link", "joint_1", "revolute", (0, 0, SHOULDER), axis=Z, limits=turn),
        Link("link_2", Part("upper_arm", upper_arm(), ORANGE), "link_1", "joint_2", "revolute", axis=Y, limits=(-1.9, 1.9)),
        Link("link_3", Part("elbow", elbow(), DARK), "link_2", "joint_3", "revolute", (0, 0, UPPER), axis=Y, limits=(-2.4, 2.4)),
        Link("link_4", Part("forearm", forearm(), ORANGE), "link_3", "joint_4", "revolute", (FORE, 0, 0), axis=X, limits=turn),
        Link("link_5", Part("wrist", wrist(), DARK), "link_4", "joint_5", "revolute", axis=Y, limits=(-2.2, 2.2)),
        Link("link_6", Part("flange", flange(), STEEL), "link_5", "joint_6", "revolute", axis=X, limits=(-3.1, 3.1)),
        Link("tool0", None, "link_6", "flange_joint", origin=(HAND, 0, 0), turned=(0, right, 0)),
        Link("gripper", Part("palm", gripper(), DARK), "tool0", "gripper_joint", origin=(0, 0, PALM)),
        Link("finger_left", Part("finger", finger(), STEEL), "gripper", "finger_joint", "prismatic", axis=Y, limits=(0.0, 0.024)),
        Link("finger_right", Part("finger", finger(), STEEL), "gripper", "finger_right_joint", "prismatic", turned=(0, 0, np.pi), axis=Y, limits=(0.0, 0.024), mimics="finger_joint"),
    ]


def pieces():
    """Parts that the scene adds one by one, each about the frame of the plug's clip there."""
    return [Part("plug", connector(), GREY_PLASTIC), Part("seat", seat(), STEEL), Part("tray", tray(), ALUMINIUM)]
