"""Cables and envelopes as the collision objects of a planner: moveit_msgs/CollisionObject, whose class is an argument, for
it is there only where MoveIt is."""
import math

from geometry_msgs.msg import Point, Pose, Quaternion
from shape_msgs.msg import SolidPrimitive

SEGMENT = 0.010  # length of a cylinder that stands for a piece of cable, about [m]


def xyz(point):
    return (point.x, point.y, point.z)


def along(start, end):
    """The pose half-way between two points whose z axis goes from one to the other."""
    direction = [b - a for a, b in zip(start, end)]
    length = math.hypot(*direction)
    x, y, z = (each / length for each in direction)
    # half-way between the z axis and the direction; straight down there are many: about x
    w = math.sqrt(max(0.0, (1.0 + z) / 2.0))
    turn = Quaternion(-y / (2 * w), x / (2 * w), 0.0, w) if w > 1e-6 else Quaternion(1.0, 0.0, 0.0, 0.0)
    return Pose(Point(*((a + b) / 2 for a, b in zip(start, end))), turn)


def off_chord(points):
    """How far a piece of centreline gets from the straight line between its ends, at most [m]."""
    start, end = points[0], points[-1]
    chord = [b - a for a, b in zip(start, end)]
    square = sum(c * c for c in chord)
    farthest = 0.0
    for point in points[1:-1]:
        to = [b - a for a, b in zip(start, point)]
        share = min(1.0, max(0.0, sum(a * b for a, b in zip(to, chord)) / square)) if square > 0.0 else 0.0
        farthest = max(farthest, math.hypot(*(a - share * c for a, c in zip(to, chord))))
    return farthest


def new_object(kind, header, name):
    message = kind()
    message.header, message.id, message.operation = header, name, kind.ADD
    if hasattr(message, 'pose'):  # since MoveIt 1.1
        message.pose.orientation.w = 1.0
    return message


def removed(kind, header, name):
    message = new_object(kind, header, name)
    message.operation = kind.REMOVE
    return message


def cable_object(kind, header, cable, padding=0.0):
    """A cable_variation/CableState as balls and the cylinders between them, which hold all of it."""
    message = new_object(kind, header, 'cable/' + cable.cable)
    points = [xyz(each) for each in cable.centreline]
    step = max(1, round(SEGMENT * (len(points) - 1) / cable.length))
    ends = list(range(0, len(points) - 1, step)) + [len(points) - 1]
    radius = cable.radius + padding + max(off_chord(points[a:b + 1]) for a, b in zip(ends, ends[1:]))
    for at in ends:
        message.primitives.append(SolidPrimitive(SolidPrimitive.SPHERE, [radius]))
        message.primitive_poses.append(Pose(Point(*points[at]), Quaternion(0, 0, 0, 1)))
    for a, b in zip(ends, ends[1:]):
        if points[a] == points[b]:
            continue
        message.primitives.append(SolidPrimitive(SolidPrimitive.CYLINDER, [math.dist(points[a], points[b]), radius]))
        message.primitive_poses.append(along(points[a], points[b]))
    return message


def envelope_object(kind, envelope, name='envelope'):
    """A cable_variation/EnvelopeMesh as a mesh; without triangles: the one before goes."""
    if not envelope.mesh.triangles:
        return removed(kind, envelope.header, name)
    message = new_object(kind, envelope.header, name)
    message.meshes.append(envelope.mesh)
    message.mesh_poses.append(Pose(Point(), Quaternion(0, 0, 0, 1)))
    return message
