#!/usr/bin/env python3
"""A robot's links follow joint states, on tf, in RViz and in what is measured; what stands on a frame that others
publish is where they have it."""
import math
import sys
import time

import rospy
import rostest
import tf2_ros
from cable_variation.msg import CableEvent, LiveMeasures
from cable_variation.srv import GetScene
from geometry_msgs.msg import TransformStamped
from node_client import NodeTest, xyz
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

RADIUS, HALF, REACH = 0.004, 0.01, 0.4  # of the strand, of a finger, from the arm's axis to the finger at 0 [m]


class JointStatesTest(NodeTest):
    def setUp(self):
        self.measures, self.warnings, self.events = None, [], []
        self.subscribers = [rospy.Subscriber('/cable_solver/measures', LiveMeasures, self.take_measures),
                            rospy.Subscriber('/cable_solver/events', CableEvent, self.events.append),
                            rospy.Subscriber('/rosout', Log, self.take_log)]
        self.joint_states = rospy.Publisher('/cell/joint_states', JointState, queue_size=10)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.eventually(lambda: self.joint_states.get_num_connections() and self.measures, 'the nodes')

    def take_measures(self, measures):
        self.measures = measures

    def take_log(self, log):
        if log.name == '/moving_geometry_node' and log.level >= Log.WARN:
            self.warnings.append(log.msg)

    def put(self, y=0.5, **positions):
        """The base at y, the joints at positions."""
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'world', 'base'
        transform.header.stamp = rospy.Time.now()
        transform.transform.translation.x, transform.transform.translation.y = 0.15, y
        transform.transform.rotation.w = 1
        self.broadcaster.sendTransform(transform)
        state = JointState()
        state.header.stamp = transform.header.stamp
        state.name, state.position = list(positions), list(positions.values())
        self.joint_states.publish(state)

    def measured(self, name):
        return next(each.value for each in self.measures.measures if each.name == name)

    def until(self, value, name, **where):
        """Goes there until the measure has the value."""
        def there():
            self.put(**where)
            time.sleep(0.02)
            return abs(self.measured(name) - value) < 1e-6
        self.eventually(there, '%s at %g m with %s; it is at %g m' % (name, value, where, self.measured(name)))

    def test_links_are_measured_where_their_joints_have_them(self):
        for y in (0.5, 0.51):
            for slide in (0.0, 0.03, 0.08):
                gap = y - REACH - slide - HALF - RADIUS
                self.until(gap, 'whole', y=y, turn=-math.pi / 2, slide=slide)
        # the thumb does the contrary, and is measured alone
        self.assertAlmostEqual(self.measured('thumb'), 0.51 - 0.2 + 0.08 - HALF - RADIUS, delta=1e-6)
        # turned away, the foot is closest
        self.until(0.5 - 0.025 - RADIUS, 'whole', turn=math.pi / 2, slide=0.0)

    def test_links_are_frames_with_their_markers_and_carry_what_rides_on_them(self):
        self.until(0.5 - REACH - 0.05 - HALF - RADIUS, 'whole', turn=-math.pi / 2, slide=0.05)
        # here tf may arrive later than at the solver
        self.eventually(lambda: math.dist(xyz(self.transform('arm', 'arm/finger').translation), (0.0, -0.45, 0.0)) < 1e-9,
                        'the finger on tf')
        self.eventually(lambda: abs(self.transform('arm/upper', 'arm/thumb').translation.x - 0.15) < 1e-9,
                        'the thumb on tf')
        for found, expected in zip(xyz(self.transform('arm/finger', 'tool').translation), (0.01, 0.0, 0.1)):
            self.assertAlmostEqual(found, expected, delta=1e-9)
        markers = self.latched('/moving_geometry_node/components', MarkerArray).markers
        frames = {each.ns: each.header.frame_id for each in markers if each.action == each.ADD}
        self.assertEqual(frames, {'component/' + link: link for link in ('arm/finger', 'arm/thumb')})
        fixed = self.latched('/static_geometry_node/components', MarkerArray).markers
        self.assertIn('component/arm', [each.ns for each in fixed])

    def test_all_markers_are_told_again_for_those_who_could_not_place_them(self):
        for node in ('/static_geometry_node', '/moving_geometry_node'):
            told = []
            subscriber = rospy.Subscriber(node + '/components', MarkerArray, told.append)
            self.eventually(lambda: len(told) >= 2, 'the markers of %s again' % node)
            subscriber.unregister()
            self.assertEqual(told[0].markers, told[-1].markers)

    def test_nobody_publishes_the_frame_that_tf_drives(self):
        for _ in range(2):
            sent = rospy.wait_for_message('/tf_static', TFMessage, timeout=self.TIMEOUT).transforms
            self.assertNotIn('base', [each.child_frame_id for each in sent])
        components = {each.name: each for each in self.service('/cable_solver/get_scene', GetScene)().components}
        self.assertEqual(components['base'].driven_by, 'tf')
        finger = components['arm/finger']
        self.assertEqual((finger.driven_by, finger.robot, finger.joint, finger.parent, finger.moving),
                         ('joint_states', 'arm', 'slide', 'arm/upper', True))

    def test_what_stops_is_told(self):
        self.until(0.5 - REACH - HALF - RADIUS, 'whole', turn=-math.pi / 2, slide=0.0)

        def late():
            return {each.component for each in self.events if each.kind == CableEvent.TF_LATE}
        self.eventually(lambda: {'base', 'arm/finger', 'arm/thumb', 'arm/upper'} <= late(), 'late joint states and tf')

    def test_what_is_wrong_is_told_once(self):
        for _ in range(3):
            self.put(turn=0.0, slid=0.01, slide=0.5)
            time.sleep(0.05)
        self.eventually(lambda: len(self.warnings) >= 2, 'two warnings')
        time.sleep(0.5)
        self.assertEqual(sorted(each for each in self.warnings if "joint 'sli" in each), [
            "/cell/joint_states: joint 'slid' is of no robot in the scene; did you mean 'slide'?",
            "/cell/joint_states: joint 'slide' is at 0.5, out of its limits 0 to 0.09; it is followed"])


if __name__ == '__main__':
    rospy.init_node('joint_states_test')
    rostest.rosrun('cable_variation', 'joint_states', JointStatesTest, sys.argv)
