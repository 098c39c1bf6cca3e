#!/usr/bin/env python3
"""static_geometry_node: markers and tf of the parts that no motion moves."""
import sys

import rospy
import rostest
from cable_variation.msg import ComponentDeviation, ComponentDeviations
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

    def test_a_part_off_its_design_moves_in_its_frame(self):
        def post():
            return self.latched('/static_strand/components', MarkerArray).markers[0].pose.position.y
        self.assertEqual(post(), 0)
        publisher = rospy.Publisher('/static_strand/component_deviations', ComponentDeviations, queue_size=1, latch=True)
        message = ComponentDeviations([ComponentDeviation(component='post')])
        message.components[0].pose.position.y, message.components[0].pose.orientation.w = 0.25, 1.0
        publisher.publish(message)
        self.eventually(lambda: post() == 0.25, 'the post 0.25 m from its frame')
        publisher.publish(ComponentDeviations())
        self.eventually(lambda: post() == 0, 'the post back')

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
