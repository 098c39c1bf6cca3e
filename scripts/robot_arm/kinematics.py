"""Where a URDF's joints put a link, and which positions put it where it is wanted."""

import xml.etree.ElementTree

import numpy as np

CLOSE = 1e-10  # [m and rad] how well solve() meets a pose


def rotation(axis, angle):
    """About a unit vector [rad]."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def rotation_vector(matrix):
    """The axis of a rotation times its angle, which is pi at most."""
    turn = to_quaternion(matrix)
    sine = np.linalg.norm(turn[:3])
    return 2 * turn[:3] if sine < 1e-12 else turn[:3] / sine * 2 * np.arctan2(sine, turn[3])


def from_quaternion(x, y, z, w):
    angle = 2 * np.arctan2(np.linalg.norm([x, y, z]), w)
    axis = np.array([x, y, z])
    return np.eye(3) if not axis.any() else rotation(axis / np.linalg.norm(axis), angle)


def to_quaternion(matrix):
    """x, y, z, w, with w >= 0: by way of its largest component, so that no half turn is lost."""
    m = matrix
    squares = np.array([1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2],
                        1 - m[0, 0] - m[1, 1] + m[2, 2], 1 + m[0, 0] + m[1, 1] + m[2, 2]])  # of them, times 4
    products = np.array([
        [squares[0], m[1, 0] + m[0, 1], m[2, 0] + m[0, 2], m[2, 1] - m[1, 2]],
        [m[1, 0] + m[0, 1], squares[1], m[2, 1] + m[1, 2], m[0, 2] - m[2, 0]],
        [m[2, 0] + m[0, 2], m[2, 1] + m[1, 2], squares[2], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], squares[3]],
    ])
    turn = products[squares.argmax()]
    return turn / np.linalg.norm(turn) * (1 if turn[3] >= 0 else -1)


def pose(position=(0.0, 0.0, 0.0), turned=None):
    """A homogeneous matrix (4, 4)."""
    matrix = np.eye(4)
    matrix[:3, 3] = position
    if turned is not None:
        matrix[:3, :3] = turned
    return matrix


def numbers(element, key, default):
    return np.array([float(each) for each in (element.get(key, default) if element is not None else default).split()])


class Joint:
    def __init__(self, element):
        self.name, self.type = element.get("name"), element.get("type")
        self.parent, self.child = element.find("parent").get("link"), element.find("child").get("link")
        origin, axis, limit = element.find("origin"), element.find("axis"), element.find("limit")
        r, p, y = numbers(origin, "rpy", "0 0 0")
        turned = rotation((0, 0, 1), y) @ rotation((0, 1, 0), p) @ rotation((1, 0, 0), r)
        self.origin = pose(numbers(origin, "xyz", "0 0 0"), turned)
        self.axis = numbers(axis, "xyz", "1 0 0")
        self.axis = self.axis / np.linalg.norm(self.axis)
        self.lower, self.upper = (float(limit.get(key)) if limit is not None else bound
                                  for key, bound in (("lower", -np.inf), ("upper", np.inf)))  # fmt: skip

    def at(self, position):
        if self.type == "fixed":
            return self.origin
        if self.type == "prismatic":
            return self.origin @ pose(self.axis * position)
        return self.origin @ pose(turned=rotation(self.axis, position))


class Chain:
    """The joints from a URDF's root link to one of its links."""

    def __init__(self, urdf, tip):
        joints = [Joint(each) for each in xml.etree.ElementTree.fromstring(urdf).iter("joint") if each.find("parent") is not None]
        by_child = {joint.child: joint for joint in joints}
        if tip not in by_child:
            raise ValueError(f"the URDF has no link '{tip}' on a joint")
        self.joints = []
        while tip in by_child:
            self.joints.insert(0, by_child[tip])
            tip = by_child[tip].parent
        self.moving = [joint for joint in self.joints if joint.type != "fixed"]
        self.names = [joint.name for joint in self.moving]

    def forward(self, positions):
        """The tip in the root's frame, and its Jacobian (6, joints): shift and turn, both in the root's axes."""
        at, axes = np.eye(4), []
        left = list(positions)
        for joint in self.joints:
            at = at @ joint.at(left.pop(0) if joint.type != "fixed" else 0.0)
            if joint.type != "fixed":
                axes.append((at[:3, :3] @ joint.axis, at[:3, 3], joint.type))
        jacobian = [
            np.append(axis, np.zeros(3)) if kind == "prismatic" else np.append(np.cross(axis, at[:3, 3] - place), axis)
            for axis, place, kind in axes
        ]
        return at, np.array(jacobian).T

    def solve(self, wanted, start):
        """Positions that put the tip at the pose `wanted`, found from those at `start` (Newton, damped far away)."""
        positions = np.array(start, float)
        for _ in range(200):
            at, jacobian = self.forward(positions)
            error = np.append(wanted[:3, 3] - at[:3, 3], rotation_vector(wanted[:3, :3] @ at[:3, :3].T))
            if np.abs(error).max() < CLOSE:
                break
            damping = 1e-2 * min(1.0, float(error @ error))
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + damping * np.eye(6), error)
            positions += step * min(1.0, 0.3 / max(np.abs(step).max(), 1e-12))
        else:
            raise ValueError(f"the arm does not reach {np.round(wanted[:3, 3], 3).tolist()} m turned like that")
        for joint, position in zip(self.moving, positions):
            if not joint.lower <= position <= joint.upper:
                raise ValueError(f"joint '{joint.name}' would have to be at {position:.4g}; "
                                 f"expected {joint.lower:g} to {joint.upper:g}")  # fmt: skip
        return positions
