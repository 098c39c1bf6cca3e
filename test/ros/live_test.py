#!/usr/bin/env python3
"""cable_solver with live: cables follow their components on tf."""
import sys

import rospy
import rostest
import tf2_ros
from cable_variation.msg import CableShapes
from cable_variation.srv import GetScene, SolveEquilibrium
from geometry_msgs.msg import TransformStamped
from node_client import NodeTest, xyz
from visualization_msgs.msg import Marker, MarkerArray


class LiveTest(NodeTest):
    def setUp(self):
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.shapes = None
        self.subscriber = rospy.Subscriber('/cable_solver/shapes', CableShapes, self.take)

    def take(self, shapes):
        self.shapes = shapes

    def put_holder(self, x, y, z):
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'world', 'holder'
        transform.header.stamp = rospy.Time.now()
        transform.transform.translation.x = x
        transform.transform.translation.y = y
        transform.transform.translation.z = z
        transform.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(transform)

    def follows(self, *place):
        def there():
            self.put_holder(*place)
            if self.shapes is None or not self.shapes.cables:
                return False
            end = xyz(self.shapes.cables[0].section[-1].position)
            return all(abs(a - b) < 1e-9 for a, b in zip(end, place))
        self.eventually(there, 'the end of the strand at %s' % (place,))

    def test_follows_its_component_and_back(self):
        self.follows(0.24, 0.02, 0.01)
        clip = self.service('/cable_solver/get_scene', GetScene)().clips[1]
        self.assertAlmostEqual(clip.world_pose.position.y, 0.02)
        self.assertAlmostEqual(clip.pose.position.y, 0)
        answer = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)(variables=['b_z'], values=[0.002])
        self.assertAlmostEqual(answer.shapes[0].section[-1].position.z, 0.012)
        self.follows(0.25, 0, 0)

    def test_out_of_reach_shows_no_cable_until_it_is_back(self):
        self.follows(0.24, 0, 0)

        def gone():
            self.put_holder(0.5, 0, 0)
            return self.shapes is not None and not self.shapes.cables
        self.eventually(gone, 'no shape when out of reach')
        markers = self.latched('/cable_solver/cables', MarkerArray).markers
        self.assertEqual({each.ns for each in markers if each.action == Marker.ADD}, {'clip/A', 'clip/B'})
        self.follows(0.25, 0, 0)


if __name__ == '__main__':
    rospy.init_node('live_test')
    rostest.rosrun('cable_variation', 'live', LiveTest, sys.argv)
