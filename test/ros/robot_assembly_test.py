#!/usr/bin/env python3
"""The robot of launch/robot_assembly.launch sets the connector on its seat, and the harness follows it there."""
import math
import sys
import threading
import time

import rospy
import rostest
from cable_variation.msg import CableEvent, CableShapes, LiveMeasures
from geometry_msgs.msg import WrenchStamped
from node_client import NodeTest, xyz
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Trigger

NEAR = 1e-4  # [m] to the connector's place
TURNED = 1e-3  # [rad]
LINKS = ['link_%d' % i for i in range(1, 7)] + ['tool0', 'gripper', 'finger_left', 'finger_right']


def distance(a, b):
    return math.dist(xyz(a), xyz(b))


def angle(rotation):
    return 2 * math.atan2(math.hypot(rotation.x, rotation.y, rotation.z), abs(rotation.w))


class RobotAssemblyTest(NodeTest):
    TIMEOUT = 60.0

    def setUp(self):
        self.lock = threading.Lock()
        self.kept = {}
        topics = {'events': ('/cable_solver/events', CableEvent), 'measures': ('/cable_solver/measures', LiveMeasures),
                  'shapes': ('/cable_solver/shapes', CableShapes), 'joints': ('/joint_states', JointState),
                  'reactions': ('/cable_solver/reaction/WH_Start', WrenchStamped),
                  'phases': ('/robot_assembly/phase', String)}
        self.subscribers = [rospy.Subscriber(topic, kind, self.keep, name, queue_size=10000)
                            for name, (topic, kind) in topics.items()]

    def keep(self, message, name):
        with self.lock:
            self.kept.setdefault(name, []).append(message)

    def all(self, name):
        with self.lock:
            return list(self.kept.get(name, []))

    def phase(self, name):
        return name in [each.data for each in self.all('phases')]

    def assert_links_agree(self):
        """What follows joint states here is where robot_state_publisher has it."""
        def off(link):
            between = self.transform('arm/' + link, link)
            return max(math.hypot(*xyz(between.translation)), angle(between.rotation))  # [m or rad]
        self.eventually(lambda: all(off(link) < 1e-6 for link in LINKS), 'the same frames by both')

    def test_from_the_tray_to_the_seat(self):
        self.eventually(lambda: all(self.all(name) for name in ('measures', 'shapes', 'joints', 'reactions')),
                        'the nodes')
        self.eventually(lambda: self.phase('ready'), 'the robot')
        self.assert_links_agree()
        there = self.transform('tray', 'connector')
        self.assertLess(math.hypot(*xyz(there.translation)), 1e-9)
        before = {each.name: each.value for each in self.all('measures')[-1].measures}
        finger = xyz(self.transform('arm/gripper', 'arm/finger_left').translation)

        self.assertTrue(self.service('/robot_assembly/start', Trigger)().success)
        self.assertFalse(self.service('/robot_assembly/start', Trigger)().success)
        self.eventually(lambda: self.phase('insert'), 'insertion')
        self.assertGreater(math.dist(finger, xyz(self.transform('arm/gripper', 'arm/finger_left').translation)), 0.005)
        above = self.transform('seat', 'connector')  # in the gripper, upright
        self.assertGreater(above.translation.z, 0.02)
        self.assertLess(angle(above.rotation), TURNED)
        self.eventually(lambda: self.phase('done'), 'the gripper away')
        time.sleep(0.5)

        # The connector is in its place, where the arm let go of it.
        off = self.transform('seat', 'connector')
        self.assertLess(math.hypot(*xyz(off.translation)), NEAR)
        self.assertLess(angle(off.rotation), TURNED)
        self.assert_links_agree()

        # The cable has followed it all the way.
        shapes, end = self.all('shapes'), self.transform('world', 'connector').translation
        self.assertGreater(len(shapes), 100)
        main = next(each for each in shapes[-1].cables if each.cable == 'main')
        self.assertLess(distance(main.section[0].position, end), NEAR)
        stamps = [each.header.stamp for each in shapes]
        self.assertEqual(stamps, sorted(stamps))
        steps = [distance(a.cables[0].section[0].position, b.cables[0].section[0].position)
                 for a, b in zip(shapes, shapes[1:])]
        self.assertLess(max(steps), 0.03)  # it is never somewhere else in between

        # Reactions and measures came, and tell of the same.
        reactions, measures = self.all('reactions'), self.all('measures')
        self.assertGreater(len(reactions), 100)
        forces = [math.hypot(*xyz(each.wrench.force)) for each in reactions]
        self.assertTrue(all(0.1 < force < 20.0 for force in forces), (min(forces), max(forces)))
        self.assertGreater(max(forces) - min(forces), 1.0)
        after = {each.name: each.value for each in measures[-1].measures}
        self.assertAlmostEqual(after['grip_force'], forces[-1], delta=1e-3)
        # The arm's links are measured where they are: the open gripper above the tray, its fingers beside the plug
        # from where the cable comes, and above the seat.
        arm = [value.value for each in measures for value in each.measures if value.name == 'D_ARM']
        self.assertGreater(before['D_ARM'], 0.03)
        self.assertGreater(after['D_ARM'], 0.03)
        self.assertLess(min(arm), 0.02)
        self.assertGreater(min(arm), 0.002)
        eigenvalues = [each.smallest_eigenvalue for each in measures]
        print('force %.2f to %.2f N, arm %.4f to %.4f m, eigenvalue %.0f to %.0f N/m, off by %.2g m, %.2g rad; %d shapes' % (
            min(forces), max(forces), min(arm), max(arm), min(eigenvalues), max(eigenvalues),
            math.hypot(*xyz(off.translation)), angle(off.rotation), len(shapes)))

        # Nothing snapped, and no equilibrium was lost.
        wrong = (CableEvent.SNAPPED, CableEvent.EQUILIBRIUM_LOST, CableEvent.OVERSTRETCHED, CableEvent.TIME_WENT_BACK)
        self.assertEqual([each.text for each in self.all('events') if each.kind in wrong], [])
        self.assertTrue(all(each.status.code == 0 for each in measures))


if __name__ == '__main__':
    rospy.init_node('robot_assembly_test')
    rostest.rosrun('cable_variation', 'robot_assembly', RobotAssemblyTest, sys.argv)
