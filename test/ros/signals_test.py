#!/usr/bin/env python3
"""SIGINT and SIGTERM in the middle of each kind of work: the nodes end in two seconds, and leave whole files or none."""
import math
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import xml.dom.minidom

import actionlib
import roslib.packages
import rosgraph
import rospy
import rostest
from cable_variation.msg import (GenerateEnvelopeAction, GenerateEnvelopeGoal, SimulateVariationAction,
                                 SimulateVariationGoal)
from cable_variation.srv import (AnalyzeStability, CheckPath, GenerateEnvelope, LoadScene, SetDesign,
                                 SolveEquilibrium)
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from node_client import DATA, NodeTest, large_scene

SIGNALS = (signal.SIGINT, signal.SIGTERM)


def call(service, kind, **request):
    """On a thread of its own, for nobody may answer."""
    def ask():
        try:
            rospy.ServiceProxy(service, kind)(**request)
        except (rospy.ServiceException, rospy.ROSException):
            pass
    thread = threading.Thread(target=ask, daemon=True)
    thread.start()
    return thread


def long_path():
    """Poses that take some seconds to look at: each of them is."""
    path = Path()
    for i in range(15000):
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.z = 0.25, 0.005 * math.sin(0.05 * i)
        pose.pose.orientation.w = 1
        path.poses.append(pose)
    return path


class SignalsTest(NodeTest):
    ENDS = 5.0  # [s]; they promise two, on a machine that is not busy with other tests

    def end(self, process, number):
        """Tells it to, and how it did."""
        self.assertIsNone(process.poll())
        start = time.time()
        process.send_signal(number)
        code = process.wait(self.TIMEOUT)
        seconds = time.time() - start
        print('%s: %s, code %d, %.2f s' % (self.id().split('.')[-1], number.name, code, seconds))
        self.assertEqual(code, 0)
        self.assertLess(seconds, self.ENDS)

    def ended(self, begin, scene=DATA + 'envelope.yaml'):
        """For each signal: begin(out) begins some work of /ended, then it is told to end."""
        for number in SIGNALS:
            with tempfile.TemporaryDirectory() as folder:
                out = os.path.join(folder, 'out')
                process = self.start_solver('ended', scene, output_directory=out, state_file='state')
                begin()
                self.end(process, number)
                self.check(out)

    def check(self, folder):
        """Every file is whole, and none is left that should have become one."""
        for name in os.listdir(folder) if os.path.isdir(folder) else []:
            path = os.path.join(folder, name)
            self.assertFalse(name.endswith('.part'), name)
            with open(path, 'rb') as file:
                contents = file.read()
            if name.endswith('.stl'):
                self.assertEqual(len(contents), 84 + 50 * struct.unpack('<I', contents[80:84])[0])
            elif name.endswith(('.urdf', '.html')):
                xml.dom.minidom.parseString(contents)
            elif name == 'state':
                self.assertTrue(contents.startswith(b'cable_solver state 1\n'))
                self.assertTrue(contents.endswith((b'\nend\n', b'\nedited 0\n')))
            else:
                self.assertTrue(contents.endswith(b'\n'), name)

    def start(self, program, name, scene=DATA + 'envelope.yaml'):
        """A node that is not waited for."""
        process = subprocess.Popen([roslib.packages.find_node('cable_variation', program)[0], '__name:=' + name,
                                    '_scene:=' + scene])
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def begin(self, action, kind, goal, at_it):
        client = actionlib.SimpleActionClient('/ended/' + action, kind)
        self.assertTrue(client.wait_for_server(rospy.Duration(self.TIMEOUT)))
        told = []
        client.send_goal(goal, feedback_cb=told.append)
        self.eventually(lambda: told and at_it(told[-1]), 'progress')

    def test_idle(self):
        self.ended(lambda: time.sleep(0.5))

    def test_while_it_starts(self):
        """Its services come one after the other: told to end as soon as there is the first, the last, or some time
        later."""
        master = rosgraph.Master(rospy.get_name())

        def offered(service):
            try:
                return master.lookupService(service)
            except rosgraph.MasterException:
                return None
        for i, service in enumerate(('solve_equilibrium', 'get_scene', 'check_path', 'simulate_variation', 'simulate_variation')):
            process = self.start('cable_solver', 'starts_%d' % i)
            self.eventually(lambda asked='/starts_%d/%s' % (i, service): offered(asked), service)
            time.sleep(0.03 * i)
            self.end(process, SIGNALS[i % 2])

    def test_the_other_nodes(self):
        for program, topic in (('moving_geometry_node', 'motion_state'), ('static_geometry_node', 'components')):
            for number in SIGNALS:
                process = self.start(program, 'other')
                self.eventually(lambda asked='/other/' + topic: asked in dict(rospy.get_published_topics()), topic)
                self.end(process, number)

    def test_by_name(self):
        """As rosnode kill does, and the master if another node of the name starts."""
        first = self.start_solver('named')
        self.start_solver('named')
        self.assertEqual(first.wait(self.TIMEOUT), 0)

    def test_load(self):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            file.write(large_scene(4000))
            file.flush()

            def begin():
                thread = call('/ended/load_scene', LoadScene, scene=file.name)
                time.sleep(1)
                self.assertTrue(thread.is_alive())
            self.ended(begin)

    def test_equilibrium(self):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
            file.write(large_scene(1500))
            file.flush()

            def begin():
                threads = [call('/ended/solve_equilibrium', SolveEquilibrium) for _ in range(8)]
                time.sleep(0.5)
                self.assertTrue(any(thread.is_alive() for thread in threads))
            self.ended(begin, file.name)

    def test_edits(self):
        def begin():
            def edit():
                proxy = rospy.ServiceProxy('/ended/set_design', SetDesign, persistent=True)
                try:
                    for i in range(100000):
                        proxy(variables=['b_z'], values=[1e-6 * (i % 1000)])
                except (rospy.ServiceException, rospy.ROSException):
                    pass
            threading.Thread(target=edit, daemon=True).start()
            time.sleep(1)
        self.ended(begin)

    def test_stability(self):
        def begin():
            def ask():
                proxy = rospy.ServiceProxy('/ended/analyze_stability', AnalyzeStability)
                try:
                    for i in range(100000):
                        proxy(report='run_%d' % (i % 10))
                except (rospy.ServiceException, rospy.ROSException):
                    pass
            threading.Thread(target=ask, daemon=True).start()
            time.sleep(1)
        self.ended(begin)

    def test_path(self):
        def begin():
            thread = call('/ended/check_path', CheckPath, component='holder', path=long_path(), report='run')
            time.sleep(1)
            self.assertTrue(thread.is_alive())
        self.ended(begin)

    def test_envelope_by_service(self):
        def begin():
            thread = call('/ended/generate_envelope', GenerateEnvelope, variables=['*'], verification_shapes=10000000,
                          name='run')
            time.sleep(1)
            self.assertTrue(thread.is_alive())
        self.ended(begin)

    def test_envelope(self):
        """In each of its stages."""
        quick = dict(variables=['b_z'], motions=['sway'], verification_shapes=1, name='run')
        for stage, fields in (('shapes', dict(variables=['*'])), ('containment', dict(verification_shapes=10000000)),
                              ('tightness', dict(tightness_shapes=10000000)), ('surface', dict(mesh_excess=1.5e-4))):
            goal = GenerateEnvelopeGoal(**dict(quick, **fields))
            self.ended(lambda asked=goal, at=stage: self.begin(
                'generate_envelope_action', GenerateEnvelopeAction, asked, lambda feedback: feedback.stage == at))

    def test_simulation(self):
        goal = SimulateVariationGoal(variables=['*'], samples=1000000000, name='run')
        self.ended(lambda: self.begin('simulate_variation_action', SimulateVariationAction, goal,
                                      lambda feedback: feedback.samples > 1000))


if __name__ == '__main__':
    rospy.init_node('signals_test')
    rostest.rosrun('cable_variation', 'signals', SignalsTest, sys.argv)
