#!/usr/bin/env python3
"""Cables and envelopes as collision objects: what stands for a cable holds all of it."""
import math
import os
import random
import subprocess
import sys
import unittest

from cable_variation.msg import CableState, EnvelopeMesh
from geometry_msgs.msg import Point
from shape_msgs.msg import MeshTriangle, SolidPrimitive
from std_msgs.msg import Header

SCRIPTS = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'scripts')
sys.path.insert(0, SCRIPTS)
from collision_objects import along, cable_object, envelope_object  # noqa: E402

try:
    from moveit_msgs.msg import CollisionObject
    HAS_MOVEIT = True
except ImportError:
    HAS_MOVEIT = False

    class CollisionObject:
        """As far as the objects here go: without MoveIt there is no other."""
        ADD, REMOVE = 0, 1

        def __init__(self):
            self.header, self.id, self.operation = Header(), '', 0
            self.primitives, self.primitive_poses, self.meshes, self.mesh_poses = [], [], [], []


def rotated(turn, vector):
    """By a unit quaternion."""
    u, w = (turn.x, turn.y, turn.z), turn.w

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    t = [2 * each for each in cross(u, vector)]
    return [v + w * a + b for v, a, b in zip(vector, t, cross(u, t))]


def holds(message, point):
    for primitive, pose in zip(message.primitives, message.primitive_poses):
        to = [a - b for a, b in zip(point, (pose.position.x, pose.position.y, pose.position.z))]
        if primitive.type == SolidPrimitive.SPHERE:
            if math.hypot(*to) <= primitive.dimensions[0] + 1e-12:
                return True
            continue
        height, radius = primitive.dimensions
        axis = rotated(pose.orientation, (0, 0, 1))
        up = sum(a * b for a, b in zip(to, axis))
        if abs(up) <= height / 2 and math.sqrt(max(0.0, sum(a * a for a in to) - up * up)) <= radius + 1e-12:
            return True
    return False


class CollisionObjectsTest(unittest.TestCase):
    def test_a_cylinder_goes_from_one_point_to_the_other(self):
        random.seed(1)
        for _ in range(100):
            start, end = ([random.uniform(-1, 1) for _ in range(3)] for _ in range(2))
            pose = along(start, end)
            half = rotated(pose.orientation, (0, 0, math.dist(start, end) / 2))
            for found, a, b in zip(half, start, end):
                self.assertAlmostEqual(found, (b - a) / 2, places=9)
        down = along((0, 0, 1), (0, 0, 0))
        self.assertAlmostEqual(rotated(down.orientation, (0, 0, 1))[2], -1)

    def test_a_cable_is_within_its_balls_and_cylinders(self):
        cable, turns = CableState(cable='main', radius=0.004, length=0.3), 1.5
        for i in range(151):  # a helix
            a = 2 * math.pi * turns * i / 150
            cable.centreline.append(Point(0.02 * math.cos(a), 0.02 * math.sin(a), 0.2 * i / 150))
        message = cable_object(CollisionObject, Header(frame_id='world'), cable)
        self.assertEqual((message.id, message.header.frame_id), ('cable/main', 'world'))
        random.seed(2)
        for _ in range(1000):
            at = random.choice(cable.centreline)
            direction = [random.gauss(0, 1) for _ in range(3)]
            length = math.hypot(*direction)
            self.assertTrue(holds(message, [c + 0.004 * d / length for c, d in zip((at.x, at.y, at.z), direction)]))
        largest = max(each.dimensions[-1] for each in message.primitives)
        self.assertLess(largest, 0.0055)
        self.assertFalse(holds(message, (0, 0, 0.1)))

    def test_an_envelope_is_a_mesh_until_it_goes(self):
        envelope = EnvelopeMesh(header=Header(frame_id='engine'))
        self.assertEqual(envelope_object(CollisionObject, envelope).operation, CollisionObject.REMOVE)
        envelope.mesh.triangles = [MeshTriangle([0, 1, 2])]
        envelope.mesh.vertices = [Point(), Point(1, 0, 0), Point(0, 1, 0)]
        message = envelope_object(CollisionObject, envelope)
        self.assertEqual((message.operation, message.header.frame_id), (CollisionObject.ADD, 'engine'))
        self.assertEqual(message.meshes, [envelope.mesh])
        self.assertEqual(message.mesh_poses[0].orientation.w, 1)

    @unittest.skipIf(HAS_MOVEIT, 'MoveIt is here')
    def test_without_moveit_it_says_what_it_needs(self):
        ran = subprocess.run([sys.executable, os.path.join(SCRIPTS, 'collision_object_bridge')], capture_output=True,
                             text=True, check=False)
        self.assertEqual(ran.returncode, 1)
        self.assertIn('it needs moveit_msgs', ran.stderr)
        self.assertEqual(ran.stderr.count('\n'), 1)


if __name__ == '__main__':
    unittest.main()
