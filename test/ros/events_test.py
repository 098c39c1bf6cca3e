#!/usr/bin/env python3
"""cable_solver among a robot's tf: what happens to the cables is told on ~events, once, and nothing else is."""
import math
import sys
import threading
import time

import rospy
import rostest
import tf2_ros
from cable_variation.msg import CableEvent, LiveMeasures
from geometry_msgs.msg import TransformStamped
from node_client import NodeTest

AHEAD = math.radians(35)  # beyond the angle at which the strip flips


class EventsTest(NodeTest):
    def setUp(self):
        self.events = []
        self.lock = threading.Lock()
        self.subscriber = rospy.Subscriber('/cable_solver/events', CableEvent, self.take, queue_size=1000)
        self.measures = None
        self.measures_subscriber = rospy.Subscriber('/cable_solver/measures', LiveMeasures, self.take_measures)
        self.broadcaster = tf2_ros.TransformBroadcaster()
        self.eventually(lambda: self.subscriber.get_num_connections() and self.measures is not None, 'cable_solver')
        self.go(0.0)
        self.events = []

    def take(self, event):
        with self.lock:
            self.events.append(event)

    def take_measures(self, measures):
        self.measures = measures

    def told(self, *kinds):
        with self.lock:
            return [each for each in self.events if each.kind in kinds]

    def put(self, angle, x=0.3):
        """The holder turned about y; the stamp it has on tf."""
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'world', 'holder'
        transform.header.stamp = rospy.Time.now()
        transform.transform.translation.x = x
        transform.transform.rotation.y, transform.transform.rotation.w = math.sin(angle / 2), math.cos(angle / 2)
        self.broadcaster.sendTransform(transform)
        return transform.header.stamp

    def go(self, angle, x=0.3):
        """Puts the holder there and waits for the shape."""
        stamp = self.put(angle, x)

        def there():
            if self.measures.header.stamp >= stamp:
                return True
            time.sleep(0.005)
            return self.put(angle, x) is None
        self.eventually(there, 'the shape of the holder at %g rad' % angle)

    def turn(self, start, end, steps, rate=100.0):
        """Turns the holder, step by step."""
        for i in range(1, steps + 1):
            self.put(start + (end - start) * i / steps)
            time.sleep(1.0 / rate)

    def test_each_snap_forced_at_10_hz_is_told_and_no_other(self):
        flips = 40
        for i in range(flips):
            stamp = self.put(AHEAD if i % 2 == 0 else -AHEAD)
            time.sleep(0.1)
            # a machine that is busy may take longer, and only the newest tf is followed
            self.eventually(lambda: self.measures.header.stamp >= stamp, 'the shape after turn %d' % i)
        self.eventually(lambda: len(self.told(CableEvent.SNAPPED)) >= flips - 1, 'the snaps of %d turns' % flips)
        time.sleep(0.3)
        snaps = self.told(CableEvent.SNAPPED)
        # the first turn may be to the side that the strip is on
        self.assertIn(len(snaps), (flips - 1, flips))
        for snap in snaps:
            self.assertEqual(snap.cable, 'strip')
            self.assertGreater(snap.distance, 0.02)
            self.assertLess(snap.to_value, snap.from_value)
            self.assertIn('snapped over', snap.text)

    def test_none_is_made_up_in_ordinary_motion(self):
        start = time.time()
        while time.time() - start < 15.0:
            t = time.time() - start
            self.put(math.radians(8) * math.sin(3 * t), 0.3 + 0.004 * math.sin(2 * t))
            time.sleep(0.01)
        self.assertEqual(self.told(CableEvent.SNAPPED, CableEvent.EQUILIBRIUM_LOST, CableEvent.OVERSTRETCHED), [])

    def test_out_of_reach_and_back(self):
        self.turn(0, 0, 1)
        self.go(0.0, 0.5)
        lost = self.eventually(lambda: self.told(CableEvent.OVERSTRETCHED), 'overstretched')
        self.assertIn('strip', lost[0].text)
        self.assertEqual(self.told(CableEvent.EQUILIBRIUM_BACK), [])
        self.go(0.0)
        self.eventually(lambda: self.told(CableEvent.EQUILIBRIUM_BACK), 'an equilibrium again')
        self.assertEqual((len(self.told(CableEvent.OVERSTRETCHED)), len(self.told(CableEvent.EQUILIBRIUM_BACK))), (1, 1))

    def test_a_limit_broken_and_kept_again(self):
        # hanging down, the middle of the strip is below its limit; flipped up it is not
        self.go(-AHEAD)
        self.go(AHEAD)
        self.go(-AHEAD)
        self.go(AHEAD)
        broken = self.eventually(lambda: self.told(CableEvent.LIMIT_BROKEN), 'a limit broken')
        kept = self.eventually(lambda: self.told(CableEvent.LIMIT_KEPT), 'and kept again')
        self.assertEqual({each.measure for each in broken + kept}, {'z'})
        for each in broken:
            self.assertLess(each.to_value, -0.005)
        for each in kept:
            self.assertLess(each.from_value, -0.005)
            self.assertGreaterEqual(each.to_value, -0.005)
        self.assertLessEqual(abs(len(broken) - len(kept)), 1)

    def test_tf_that_stops_is_told_once_and_so_is_its_return(self):
        self.put(0.0)
        late = self.eventually(lambda: self.told(CableEvent.TF_LATE), 'late tf')
        self.assertEqual(late[0].component, 'holder')
        self.assertGreater(late[0].to_value, 0.5)
        self.assertLess(late[0].to_value, 10.0)
        time.sleep(0.5)
        self.assertEqual(len(self.told(CableEvent.TF_LATE)), 1)

        def back():
            self.put(0.0)
            return self.told(CableEvent.TF_BACK)
        self.assertEqual(len(self.eventually(back, 'tf again')), 1)


if __name__ == '__main__':
    rospy.init_node('events_test')
    rostest.rosrun('cable_variation', 'events', EventsTest, sys.argv)
