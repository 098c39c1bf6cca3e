"""What the tests of the nodes share."""
import time
import unittest

import actionlib
import rospy
import tf2_ros
from cable_variation.msg import Status


class NodeTest(unittest.TestCase):
    """A test case with tf, topics and services, none of which can hang it."""

    TIMEOUT = 20.0  # [s]; generous, the machine may be busy

    @classmethod
    def setUpClass(cls):
        cls.buffer = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.buffer)

    def service(self, name, kind):
        rospy.wait_for_service(name, timeout=self.TIMEOUT)
        return rospy.ServiceProxy(name, kind)

    def latched(self, topic, kind):
        return rospy.wait_for_message(topic, kind, timeout=self.TIMEOUT)

    def eventually(self, question, what):
        """The first true answer of question()."""
        end = time.time() + self.TIMEOUT
        while time.time() < end:
            answer = question()
            if answer:
                return answer
            time.sleep(0.02)
        return self.fail('not within %g s: %s' % (self.TIMEOUT, what))

    def finished(self, client, patience=TIMEOUT):
        """Whether a goal ended in time. Other than wait_for_result(), this does not miss an answer that overtook
        the return of send_goal()."""
        end = time.time() + patience
        while time.time() < end:
            if client.gh is not None and client.gh.get_comm_state() == actionlib.CommState.DONE:
                return True
            time.sleep(0.005)
        return False

    def transform(self, parent, frame):
        def lookup():
            try:
                return self.buffer.lookup_transform(parent, frame, rospy.Time(0)).transform
            except tf2_ros.TransformException:
                return None
        return self.eventually(lookup, 'tf from %s to %s' % (parent, frame))

    def assertSuccess(self, status):
        self.assertEqual((status.code, status.message), (Status.SUCCESS, ''))

    def assertRefused(self, status, code, *parts):
        self.assertEqual(status.code, code, status.message)
        for part in parts:
            self.assertIn(part, status.message)


def xyz(vector):
    return (vector.x, vector.y, vector.z)
