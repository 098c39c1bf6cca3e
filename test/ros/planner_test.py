#!/usr/bin/env python3
"""An envelope as a planner takes it: the URDF's convex collision geometry, and the mesh on ~envelope_mesh, hold the
cables of harnesses within their tolerances."""
import os
import random
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import numpy
import roslib.packages
import rospy
import rostest
from cable_variation.msg import EnvelopeMesh
from cable_variation.srv import GenerateEnvelope, SolveEquilibrium
from node_client import NodeTest, xyz
from visualization_msgs.msg import Marker, MarkerArray

DATA = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'data')
TOLERANCES = {'b_z': 0.005, 'a_ry': numpy.radians(5)}
RADIUS, ROUNDING = 0.004, 1e-6  # of the cable, and of a file's single precision [m]


def triangles_of(path):
    """Corners (n, 3, 3) of a binary STL file [m]."""
    with open(path, 'rb') as file:
        data = file.read()
    record = numpy.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('attribute', '<u2')])
    corners = numpy.frombuffer(data[84:], record)['corners'].astype(float)
    assert len(corners) == int.from_bytes(data[80:84], 'little'), path
    return corners


def planes_of(corners):
    """Outward normals and distances from the origin of a convex body's facets, slivers left out."""
    normal = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = numpy.linalg.norm(normal, axis=1)
    normal = normal[size > 1e-12] / size[size > 1e-12, None]
    return normal, numpy.einsum('ij,ij->i', normal, corners[size > 1e-12, 0])


def winding_numbers(points, corners):
    """How often the surface goes round each point."""
    total = numpy.zeros(len(points))
    for i, point in enumerate(points):
        a, b, c = numpy.moveaxis(corners - point, 1, 0)
        la, lb, lc = (numpy.linalg.norm(each, axis=1) for each in (a, b, c))
        spat = numpy.einsum('ij,ij->i', a, numpy.cross(b, c))
        rest = (la * lb * lc + numpy.einsum('ij,ij->i', a, b) * lc + numpy.einsum('ij,ij->i', b, c) * la +
                numpy.einsum('ij,ij->i', c, a) * lb)
        total[i] = numpy.arctan2(spat, rest).sum() / (2 * numpy.pi)
    return total


def surface_points(cable, count, generator):
    """Of a solved cable, all around it [m]."""
    line = numpy.array([xyz(each) for each in cable.centreline])
    at = generator.integers(1, len(line) - 1, count)
    tangent = line[at + 1] - line[at - 1]
    across = numpy.cross(tangent, generator.normal(size=(count, 3)))
    return line[at] + cable.radius * across / numpy.linalg.norm(across, axis=1, keepdims=True)


class PlannerTest(NodeTest):
    TIMEOUT = 60.0

    def start(self, kind, name, *parameters):
        process = subprocess.Popen([roslib.packages.find_node('cable_variation', kind)[0], '__name:=' + name, *parameters])
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)

    def test_the_obstacle_holds_harnesses_within_their_tolerances(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.start('cable_solver', 'solver', '_scene:=' + os.path.join(DATA, 'envelope.yaml'),
                   '_output_directory:=' + folder.name)
        answer = self.service('/solver/generate_envelope', GenerateEnvelope)(variables=list(TOLERANCES), name='obstacle')
        self.assertSuccess(answer.status)

        # Harnesses drawn here: what the envelope knows nothing of.
        solve, generator = self.service('/solver/solve_equilibrium', SolveEquilibrium), numpy.random.default_rng(5)
        random.seed(5)
        points = []
        for _ in range(20):
            solved = solve(variables=list(TOLERANCES), follow=True,
                           values=[random.uniform(-limit, limit) for limit in TOLERANCES.values()])
            self.assertSuccess(solved.status)
            self.assertAlmostEqual(solved.shapes[0].radius, RADIUS)
            points.append(surface_points(solved.shapes[0], 100, generator))
        points = numpy.vstack(points)

        # The URDF: one link, its collision geometry convex pieces that together hold every point.
        root = xml.etree.ElementTree.parse(answer.urdf_file).getroot()
        self.assertEqual([len(root.findall('link')), len(root.findall('joint'))], [1, 0])
        files = [each.get('filename') for each in root.findall('link/collision/geometry/mesh')]
        self.assertGreater(len(files), 5)
        held = numpy.zeros(len(points), bool)
        for file in files:
            self.assertTrue(file.startswith('file://'), file)
            corners = triangles_of(file[len('file://'):])
            normal, offset = planes_of(corners)
            self.assertLess((corners.reshape(-1, 3) @ normal.T - offset).max(), 1e-5, 'convex: ' + file)
            held |= (points @ normal.T - offset).max(axis=1) < ROUNDING
        self.assertEqual(numpy.count_nonzero(~held), 0)

        # Another node loads it as part of its scene.
        scene = os.path.join(folder.name, 'cell.yaml')
        with open(scene, 'w') as file:
            file.write('components: [{name: obstacle, urdf: "file://%s"}]\n' % answer.urdf_file)
        self.start('static_geometry_node', 'cell', '_scene:=' + scene)
        markers = [each for each in self.latched('/cell/components', MarkerArray).markers if each.action == Marker.ADD]
        self.assertEqual({each.ns for each in markers}, {'component/obstacle'})
        self.assertTrue(all(os.path.isfile(each.mesh_resource[len('file://'):]) for each in markers))

        # The mesh goes once round every point, and is not much larger than all of them.
        mesh = self.latched('/solver/envelope_mesh', EnvelopeMesh).mesh
        vertices = numpy.array([xyz(each) for each in mesh.vertices])
        corners = vertices[numpy.array([each.vertex_indices for each in mesh.triangles])]
        few = points[generator.integers(0, len(points), 200)]
        numpy.testing.assert_allclose(winding_numbers(few, corners), 1.0, atol=1e-6)
        self.assertLess(numpy.abs(vertices[:, 2].min() - points[:, 2].min()), 0.01)


if __name__ == '__main__':
    rospy.init_node('planner_test')
    rostest.rosrun('cable_variation', 'planner', PlannerTest, sys.argv)
