#!/usr/bin/env python3
"""cable_solver with live while tf and clock are as they should not be: it goes on, tells what is late, and follows again
as soon as it can."""
import math
import sys
import threading
import time

import rospy
import rostest
import tf2_msgs.msg
from cable_variation.msg import CableEvent, CableShapes, Status
from cable_variation.srv import SolveEquilibrium
from geometry_msgs.msg import TransformStamped
from node_client import NodeTest, xyz
from rosgraph_msgs.msg import Clock


class TfFaultsTest(NodeTest):
    now = 1000.0  # of the clock [s]

    def setUp(self):
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        self.tf = rospy.Publisher('/tf', tf2_msgs.msg.TFMessage, queue_size=10)
        self.shapes, self.events = None, []
        self.lock = threading.Lock()
        self.subscribers = [rospy.Subscriber('/cable_solver/shapes', CableShapes, self.take),
                            rospy.Subscriber('/cable_solver/events', CableEvent, self.take_event)]
        self.eventually(lambda: self.clock.get_num_connections() >= 2 and self.tf.get_num_connections() and
                        all(each.get_num_connections() for each in self.subscribers), 'cable_solver')
        TfFaultsTest.now += 1000  # whatever the test before has left on tf is old
        self.follows(0.245, 0, 0)  # so the solver has this time: it may have been at the next place all along
        self.follows(0.25, 0, 0)
        self.events = []

    def take(self, shapes):
        self.shapes = shapes

    def take_event(self, event):
        with self.lock:
            self.events.append(event)

    def told(self, kind):
        with self.lock:
            return [each for each in self.events if each.kind == kind]

    def tick(self, seconds=0.02):
        TfFaultsTest.now += seconds
        self.clock.publish(Clock(rospy.Time.from_sec(self.now)))
        time.sleep(0.02)

    def put(self, x, y, z, w=1.0, stamp=None):
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'world', 'holder'
        transform.header.stamp = rospy.Time.from_sec(self.now if stamp is None else stamp)
        place = transform.transform.translation
        place.x, place.y, place.z = x, y, z
        transform.transform.rotation.w = w
        self.tf.publish(tf2_msgs.msg.TFMessage([transform]))

    def end(self):
        return xyz(self.shapes.cables[0].section[-1].position) if self.shapes and self.shapes.cables else None

    def follows(self, *place):
        def there():
            self.tick()
            self.put(*place)
            end = self.end()
            return end and all(abs(a - b) < 1e-9 for a, b in zip(end, place))
        self.eventually(there, 'the end of the strand at %s' % (place,))

    def answers(self):
        answer = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)()
        self.assertSuccess(answer.status)
        self.assertTrue(all(math.isfinite(each) for section in answer.shapes[0].section
                            for each in xyz(section.position)))

    def test_numbers_that_are_none_move_nothing(self):
        for bad in ((math.nan, 0, 0), (0.24, math.inf, 0), (0.24, 0, 0, math.nan), (0.24, 0, 0, 0.0),
                    (0.24, 0, 0, 5.0)):
            for _ in range(5):
                self.tick()
                self.put(*bad)
            self.answers()
            self.assertEqual([round(each, 9) for each in self.end()], [0.25, 0, 0], bad)
        self.follows(0.24, 0.01, 0)

    def test_a_place_that_no_cable_reaches_is_told(self):
        solve = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)
        for far in (1e300, -1e100, 1e6):
            def refused(x=far):
                self.tick()
                self.put(x, 0, 0)
                status = solve().status
                return status if status.code != Status.SUCCESS else None
            status = self.eventually(refused, 'no equilibrium at %g m' % far)
            self.assertRefused(status, Status.NOT_CONVERGED, "'strand'")
            self.follows(0.24, 0.01, 0)

    def test_a_clock_that_is_set_back_is_followed(self):
        self.tick(-500)
        self.put(0.25, 0, 0)
        self.eventually(lambda: self.tick() or self.put(0.25, 0, 0) or self.told(CableEvent.TIME_WENT_BACK),
                        'it is told that time went back')
        self.follows(0.24, 0.01, 0)
        self.tick(-(self.now - 0.5))  # a simulation that begins again
        self.follows(0.23, 0.01, 0)
        TfFaultsTest.now += 10000
        self.follows(0.22, 0, 0)

    def test_a_clock_that_stands_still_hinders_nobody(self):
        for _ in range(10):
            self.clock.publish(Clock(rospy.Time.from_sec(self.now)))
            self.put(0.24, 0, 0, stamp=self.now + 0.001)
            self.answers()
            time.sleep(0.02)
        self.follows(0.24, 0.01, 0)

    def test_stamps_out_of_order(self):
        for i in range(100):
            self.tick()
            self.put(0.24 + 1e-4 * (i % 7), 0, 0, stamp=self.now - 0.01 * (37 * i % 11))
        self.answers()
        self.follows(0.24, 0.01, 0)

    def test_a_stamp_of_a_day_to_come_is_told_as_soon_as_it_stands_still(self):
        self.put(0.24, 0.02, 0, stamp=4e9)  # in the year 2096

        def late():
            self.tick()
            self.put(0.25, 0, 0)  # tf2 takes what is older for outdated
            return self.told(CableEvent.TF_LATE)
        self.assertEqual(self.eventually(late, 'late tf')[0].component, 'holder')
        self.answers()
        # the end of that is a clock that is set back, which has tf start afresh
        self.tick(-1)
        self.follows(0.24, 0.01, 0)


if __name__ == '__main__':
    rospy.init_node('tf_faults_test')
    rostest.rosrun('cable_variation', 'tf_faults', TfFaultsTest, sys.argv)
