"""What the tests of the nodes share."""
import os
import signal
import subprocess
import time
import unittest
import xmlrpc.client

import actionlib
import roslib.packages
import rosgraph
import rospy
import tf2_ros
from cable_variation.msg import Status


DATA = 'package://cable_variation/test/ros/data/'


class NodeTest(unittest.TestCase):
    """A test case with tf, topics and services, none of which can hang it."""

    TIMEOUT = 20.0  # [s]; generous, the machine may be busy
    PROMPT = 5.0  # [s] for what takes a fraction of a second, likewise; how long it took is printed

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

    def assertPrompt(self, seconds, what):
        print('%s took %.3f s' % (what, seconds))
        self.assertLess(seconds, self.PROMPT, what)

    def finished(self, client, patience=TIMEOUT):
        """Whether a goal ended in time. Other than wait_for_result(), this does not miss an answer that overtook
        the return of send_goal()."""
        end = time.time() + patience
        while time.time() < end:
            if client.gh is not None and client.gh.get_comm_state() == actionlib.CommState.DONE:
                return True
            time.sleep(0.005)
        return False

    def start_solver(self, name, scene=DATA + 'envelope.yaml', **parameters):
        """A solver of its own with that name, up; ended with the test."""
        program = roslib.packages.find_node('cable_variation', 'cable_solver')[0]
        process = subprocess.Popen([program, '__name:=' + name, '_scene:=' + scene] +
                                   ['_%s:=%s' % each for each in parameters.items()])
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        rospy.wait_for_service('/%s/get_scene' % name, timeout=self.TIMEOUT)
        return process

    def pid(self, node):
        """Of a node that answers."""
        def ask():
            try:
                api = rosgraph.Master(rospy.get_name()).lookupNode(node)
                code, _, number = xmlrpc.client.ServerProxy(api).getPid(rospy.get_name())
                return number if code == 1 else None
            except (OSError, rosgraph.MasterException):
                return None
        return self.eventually(ask, '%s answers' % node)

    def kill(self, node):
        """Ends a node without a word to it; its process id."""
        number = self.pid(node)
        os.kill(number, signal.SIGKILL)
        return number

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


def large_scene(clips=1500):
    """A scene that takes a second or more to load: a straight cable held by many clips."""
    lines = ['materials: {bundle: {young_modulus: 1.0e8, poisson_ratio: 0.25, density: 2000}}',
             'cables: [{name: strand, length: %g, section: {type: solid, radius: 2 mm, material: bundle}}]' %
             (0.1 * (clips - 1)), 'clips:']
    for i in range(clips):
        at = {0: 'start', clips - 1: 'end'}.get(i, '%g' % (0.1 * i))
        lines.append('  - {name: C%d, type: fixed, cable: strand, at: %s, pose: {position: [%g, 0, 0]}}' % (i, at, 0.1 * i))
    return '\n'.join(lines)
