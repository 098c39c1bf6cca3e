#!/usr/bin/env python3
"""cable_solver with live: cables follow their components on tf, and their figures come with its stamps."""
import math
import sys

import rospy
import rostest
import tf2_ros
from cable_variation.msg import CableShapes, ClipReactions, LiveMeasures, Status
from cable_variation.srv import GetScene, SolveEquilibrium
from geometry_msgs.msg import TransformStamped, WrenchStamped
from node_client import NodeTest, xyz
from std_msgs.msg import Float64
from visualization_msgs.msg import Marker, MarkerArray


class LiveTest(NodeTest):
    def setUp(self):
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.shapes = None
        self.subscriber = rospy.Subscriber('/cable_solver/shapes', CableShapes, self.take)
        self.stamps = set()

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
        self.stamps.add(transform.header.stamp)
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

    def test_out_of_reach_the_last_shape_stays_grey_until_it_is_back(self):
        self.follows(0.24, 0, 0)

        def gone():
            self.put_holder(0.5, 0, 0)
            return self.shapes is not None and not self.shapes.cables
        self.eventually(gone, 'no shape when out of reach')
        markers = [each for each in self.latched('/cable_solver/cables', MarkerArray).markers
                   if each.action == Marker.ADD]
        self.assertEqual({each.ns for each in markers}, {'clip/A', 'clip/B', 'cable/strand'})
        for each in markers:
            if each.ns == 'cable/strand':
                self.assertLess(max(each.color.r, each.color.g, each.color.b)
                                - min(each.color.r, each.color.g, each.color.b), 0.05)
                self.assertLess(each.color.a, 1)
                self.assertLess(each.pose.position.x, 0.25)
        measures = self.latched('/cable_solver/measures', LiveMeasures)
        self.assertRefused(measures.status, Status.NOT_CONVERGED, 'strand')
        self.assertEqual((measures.measures, measures.smallest_eigenvalue), ([], 0))
        self.assertEqual(self.latched('/cable_solver/reactions', ClipReactions).reactions, [])
        self.follows(0.25, 0, 0)
        self.assertSuccess(self.latched('/cable_solver/measures', LiveMeasures).status)

    def test_measures_are_those_of_the_shape_with_the_stamp_of_its_tf(self):
        self.follows(0.23, 0.03, 0.02)
        measures = self.latched('/cable_solver/measures', LiveMeasures)
        self.assertSuccess(measures.status)
        self.assertEqual(measures.header.frame_id, 'world')
        self.assertIn(measures.header.stamp, self.stamps)
        self.assertEqual(self.shapes.header.stamp, measures.header.stamp)
        answer = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)(follow=True)
        self.assertAlmostEqual(measures.smallest_eigenvalue / answer.smallest_eigenvalue, 1, places=6)
        for mine, asked in zip(measures.measures, answer.measures):
            self.assertEqual((mine.name, mine.unit, mine.within, mine.has_lower), (asked.name, asked.unit, asked.within,
                                                                                   asked.has_lower))
            if mine.type != 'similarity':
                self.assertAlmostEqual(mine.value, asked.value, places=7)
        by_name = {each.name: each for each in measures.measures}
        self.assertEqual(set(by_name), {'clearance', 'change', 'height', 'end_force'})
        # to the design with its components where the scene has them: at its end the strand has gone 41 mm
        self.assertGreater(by_name['change'].value, 0.03)
        self.assertLess(by_name['change'].value, 0.06)
        for name, each in by_name.items():
            self.assertEqual(self.latched('/cable_solver/live/' + name, Float64).data, each.value)

    def test_reactions_are_wrenches_in_their_clips_frames(self):
        self.follows(0.23, 0.03, 0.02)
        reactions = self.latched('/cable_solver/reactions', ClipReactions)
        self.assertIn(reactions.header.stamp, self.stamps)
        self.assertEqual([each.clip for each in reactions.reactions], ['A', 'B'])
        weight = 2000 * math.pi * 0.004 ** 2 * 0.312 * 9.81
        self.assertAlmostEqual(sum(each.force.z for each in reactions.reactions), weight, places=6)
        for each in reactions.reactions:  # both frames have the axes of the world, and the section at their origin
            wrench = self.latched('/cable_solver/reaction/' + each.clip, WrenchStamped)
            self.assertEqual((wrench.header.frame_id, wrench.header.stamp), (each.clip, reactions.header.stamp))
            for mine, asked in ((wrench.wrench.force, each.force), (wrench.wrench.torque, each.moment)):
                for a, b in zip(xyz(mine), xyz(asked)):
                    self.assertAlmostEqual(a, b, places=9)


if __name__ == '__main__':
    rospy.init_node('live_test')
    rostest.rosrun('cable_variation', 'live', LiveTest, sys.argv)
