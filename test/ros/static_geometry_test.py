#!/usr/bin/env python3
"""static_geometry_node: markers and tf of the parts that no motion moves."""
import sys

import rospy
import rostest
from node_client import NodeTest, xyz
from visualization_msgs.msg import Marker, MarkerArray


class StaticGeometryTest(NodeTest):
    def test_markers_are_latched_and_ride_on_their_frames(self):
        markers = self.latched('/static_strand/components', MarkerArray).markers
        self.assertEqual([(each.ns, each.id) for each in markers], [('component/post', 0)])
        post = markers[0]
        self.assertEqual(post.header.frame_id, 'post')
        self.assertEqual(post.header.stamp, rospy.Time(0))
        self.assertTrue(post.frame_locked)
        self.assertEqual(post.type, Marker.MESH_RESOURCE)
        self.assertEqual(post.mesh_resource, 'package://cable_variation/test/data/meshes/tetrahedron_binary.stl')
        self.assertEqual(xyz(post.scale), (1, 1, 1))

    def test_static_transforms(self):
        self.assertEqual(xyz(self.transform('world', 'holder').translation), (0.25, 0, 0))
        self.assertEqual(xyz(self.transform('world', 'post').translation), (0, 0, 0))

    def test_leaves_moving_parts_to_the_other_node(self):
        markers = self.latched('/static_moving/components', MarkerArray).markers
        self.assertEqual([each.ns for each in markers], ['component/floor'])
        self.transform('world', 'floor')
        self.assertFalse(self.buffer.can_transform('world', 'table', rospy.Time(0)))

    def test_world_is_on_tf_though_a_scene_has_no_parts(self):
        self.assertEqual(self.latched('/static_none/components', MarkerArray).markers, [])
        self.transform('world', 'scene')


if __name__ == '__main__':
    rospy.init_node('static_geometry_test')
    rostest.rosrun('cable_variation', 'static_geometry', StaticGeometryTest, sys.argv)
