"""The way of a connector from a tray to its seat, as positions of an arm's joints."""

from dataclasses import dataclass

import numpy as np

from .kinematics import pose, rotation, rotation_vector

RATE = 100.0  # of steps [Hz]
# The gripper in the frame of the connector's clip: from above, its fingers on both sides of the plug.
GRASP = pose((-0.021, 0.0, 0.0), np.diag([-1.0, 1.0, -1.0]))
OPEN, CLOSED = 0.022, 0.014  # where the fingers are: away from the plug, and at its ribs [m]
CLEAR = 0.060  # above tray and seat [m]
LIFT = 0.050  # in the middle of the way from one to the other, besides [m]
READY = (-0.27, 0.65, -0.43, 0.0, 1.35, -0.44)  # about above the tray; where the search for joint positions begins


@dataclass
class Step:
    phase: str
    joints: np.ndarray  # [rad]
    fingers: float  # [m]
    holder: str  # of the connector: tray, gripper or seat


def smooth(count):
    """From 0 to 1 with speed and acceleration 0 at both ends."""
    t = np.arange(1, count + 1) / count
    return t**3 * (10 - 15 * t + 6 * t**2)


def between(start, end, share, lift=0.0):
    position = start[:3, 3] + share * (end[:3, 3] - start[:3, 3]) + [0, 0, 4 * lift * share * (1 - share)]
    turn = rotation_vector(start[:3, :3].T @ end[:3, :3])
    angle = np.linalg.norm(turn)
    turned = np.eye(3) if angle < 1e-12 else rotation(turn / angle, share * angle)
    return pose(position, start[:3, :3] @ turned)


def plan(chain, tray, seat):
    """Steps, RATE a second. `tray` and `seat`: the clip's frame at both, in the frame of the arm's base.

    Raises ValueError where the arm does not get.
    """
    up = pose((0.0, 0.0, CLEAR))
    take, set_down = tray @ GRASP, seat @ GRASP
    above_tray, above_seat = up @ take, up @ set_down
    moves = [  # phase, seconds, from, to, lift, fingers from and to, holder
        ("approach", 1.5, above_tray, take, 0.0, OPEN, OPEN, "tray"),
        ("take", 0.5, take, take, 0.0, OPEN, CLOSED, "tray"),
        ("lift", 1.5, take, above_tray, 0.0, CLOSED, CLOSED, "gripper"),
        ("carry", 4.0, above_tray, above_seat, LIFT, CLOSED, CLOSED, "gripper"),
        ("insert", 2.5, above_seat, set_down, 0.0, CLOSED, CLOSED, "gripper"),
        ("release", 0.5, set_down, set_down, 0.0, CLOSED, OPEN, "seat"),
        ("retreat", 1.5, set_down, above_seat, 0.0, OPEN, OPEN, "seat"),
    ]
    joints = chain.solve(above_tray, READY)
    steps = [Step("ready", joints, OPEN, "tray")]
    for phase, seconds, start, end, lift, fingers, fingers_end, holder in moves:
        for share in smooth(round(seconds * RATE)):
            joints = chain.solve(between(start, end, share, lift), joints)
            steps.append(Step(phase, joints, fingers + share * (fingers_end - fingers), holder))
    return steps
