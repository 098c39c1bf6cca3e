#!/usr/bin/env python3
"""cable_solver is asked what happens along a path, and nothing of it happens."""
import csv
import math
import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import rospkg
import rospy
import rostest
from cable_variation.msg import CableEvent, CableShapes, Label, Labels, Status
from cable_variation.srv import CheckPath, GetScene, SolveEquilibrium
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from node_client import NodeTest
from visualization_msgs.msg import Marker, MarkerArray


def pose(position, stamp=0.0):
    stamped = PoseStamped()
    stamped.header.stamp = rospy.Time.from_sec(stamp)
    stamped.pose.position.x, stamped.pose.position.y, stamped.pose.position.z = position
    stamped.pose.orientation.w = 1.0
    return stamped


def path_of(*poses, frame='world'):
    path = Path()
    path.header.frame_id = frame
    path.poses = list(poses)
    return path


def size(vector):
    return math.sqrt(vector.x ** 2 + vector.y ** 2 + vector.z ** 2)


class CheckPathTest(NodeTest):
    def setUp(self):
        self.ask = self.service('/cable_solver/check_path', CheckPath)

    def test_a_component_goes_along_a_path(self):
        before = rospy.wait_for_message('/cable_solver/shapes', CableShapes, 10)
        answer = self.ask(component='holder', path=path_of(pose((0.25, 0, 0), 3.0), pose((0.2, 0.03, 0), 5.0)))
        self.assertSuccess(answer.status)
        self.assertEqual(answer.warnings, [])
        count = len(answer.times)
        self.assertGreaterEqual(count, 12)
        self.assertEqual((answer.times[0], answer.times[-1]), (0.0, 2.0))
        self.assertAlmostEqual(answer.lengths[-1], math.hypot(0.05, 0.03), delta=1e-12)
        self.assertTrue(answer.kept and all(answer.solved))
        self.assertAlmostEqual(answer.poses[-1].position.x, 0.2)
        force = {each.name: each for each in answer.measures}['end_force']
        reaction = {each.clip: each for each in answer.reactions}['B']
        self.assertEqual(len(force.values), count)
        self.assertEqual(len(reaction.wrenches), count)
        for value, wrench in zip(force.values, reaction.wrenches):
            self.assertAlmostEqual(value, size(wrench.force), delta=1e-12)
        self.assertAlmostEqual(reaction.largest_force, max(force.values), delta=1e-12)
        self.assertEqual(force.worst, force.largest)
        self.assertEqual(answer.bends[0].cable, 'strand')
        self.assertAlmostEqual(min(answer.bends[0].smallest_bend_radius), answer.bends[0].smallest)
        solved = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)()
        self.assertAlmostEqual(answer.smallest_eigenvalue[0] / solved.smallest_eigenvalue, 1.0, delta=1e-3)
        after = rospy.wait_for_message('/cable_solver/shapes', CableShapes, 10)
        self.assertEqual(before.header.stamp, after.header.stamp)  # nothing has moved

    def test_poses_are_in_a_frame_and_of_a_clip(self):
        answer = self.ask(clip='B', path=path_of(pose((0, 0, 0)), pose((0, 0, 0.02)), frame='tray'))
        self.assertSuccess(answer.status)
        self.assertEqual([answer.times[0], answer.times[-1]], [0.0, 1.0])  # a pose a second
        self.assertAlmostEqual(answer.poses[-1].position.x, 0.25)
        self.assertAlmostEqual(answer.poses[-1].position.z, 0.02)

    def test_a_path_out_of_reach(self):
        answer = self.ask(component='holder', path=path_of(pose((0.25, 0, 0)), pose((0.35, 0, 0))), report='reach')
        self.assertSuccess(answer.status)
        self.assertFalse(answer.kept)
        self.assertEqual([each.event.kind for each in answer.events], [CableEvent.OVERSTRETCHED])
        self.assertGreater(0.25 + answer.events[0].length, 0.312)
        self.assertFalse(answer.solved[-1])
        self.assertTrue(math.isnan(answer.smallest_eigenvalue[-1]))
        self.assertTrue(math.isnan(answer.measures[0].values[-1]))
        self.assertTrue(math.isnan(answer.reactions[0].wrenches[-1].force.x))
        with open(answer.csv_path, newline='', encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(answer.times))
        self.assertEqual([float(row['way [m]']) for row in rows], list(answer.lengths))
        self.assertEqual(rows[-1]['end_force [N]'], 'nan')
        page = ElementTree.parse(answer.report_path)
        text = ' '.join(page.getroot().itertext())
        self.assertIn('Along the path', text)
        self.assertIn('FAIL', text)
        self.assertIn('no equilibrium at', text)

    def test_a_motion_with_what_clips_do(self):
        answer = self.ask(motions=['away'])
        self.assertSuccess(answer.status)
        self.assertEqual([(each.event.kind, each.event.clip) for each in answer.events],
                         [(CableEvent.CLIP_OPENED, 'B'), (CableEvent.CLIP_CLOSED, 'C')])
        self.assertEqual(answer.events[0].time, 0.5)
        scene = self.service('/cable_solver/get_scene', GetScene)()
        self.assertEqual({clip.name: clip.attached for clip in scene.clips},
                         {'A': True, 'B': True, 'C': False, 'ring': False})
        part = self.ask(motions=['away'], from_time=1.0, to_time=1.5)
        self.assertSuccess(part.status)
        self.assertEqual((part.times[0], part.times[-1]), (1.0, 1.5))

    def test_it_is_shown(self):
        self.assertSuccess(self.ask(component='holder', path=path_of(pose((0.25, 0, 0)), pose((0.35, 0, 0)))).status)
        markers = rospy.wait_for_message('/cable_solver/path_check', MarkerArray, 10).markers
        names = {marker.ns for marker in markers if marker.action == Marker.ADD}
        self.assertEqual(names, {'path/strand', 'path/way', 'path/events'})
        texts = [marker.text for marker in markers if marker.type == Marker.TEXT_VIEW_FACING]
        self.assertEqual(len(texts), 1)
        self.assertIn('overstretched', texts[0])
        labels = self.latched('/cable_solver/labels', Labels).labels
        self.assertEqual([label.text for label in labels if label.kind == Label.FAULT], texts)
        marks = self.latched('/cable_solver/marks/path_check', MarkerArray).markers
        self.assertEqual([mark for mark in marks if mark.type == Marker.TEXT_VIEW_FACING], [])

    def test_what_is_wrong_is_refused(self):
        two = path_of(pose((0.25, 0, 0)), pose((0.2, 0, 0)))
        crooked = path_of(pose((0.25, 0, 0)), pose((0.2, 0, 0)))
        crooked.poses[1].pose.orientation.w = 0.5
        endless = path_of(pose((0.25, 0, 0)), pose((float('nan'), 0, 0)))
        for request, code, words in (
                ({}, Status.INVALID_ARGUMENT, 'none is given'),
                ({'component': 'holder', 'motions': ['away']}, Status.INVALID_ARGUMENT, 'more than one'),
                ({'component': 'holdr', 'path': two}, Status.NOT_FOUND, "did you mean 'holder'"),
                ({'clip': 'A', 'path': two}, Status.INVALID_ARGUMENT, 'on the world'),
                ({'component': 'holder'}, Status.INVALID_ARGUMENT, 'has 0 poses'),
                ({'component': 'holder', 'path': crooked}, Status.INVALID_ARGUMENT, 'pose 2'),
                ({'component': 'holder', 'path': endless}, Status.INVALID_ARGUMENT, 'pose 2'),
                ({'component': 'holder', 'path': path_of(*two.poses, frame='nowhere')}, Status.NOT_FOUND, 'nowhere'),
                ({'component': 'holder', 'path': two, 'step': 1e-7}, Status.INVALID_ARGUMENT, '20000'),
                ({'component': 'holder', 'path': two, 'step': -1.0}, Status.INVALID_ARGUMENT, 'step'),
                ({'component': 'holder', 'path': two, 'from_time': 1.0}, Status.INVALID_ARGUMENT, 'from_time'),
                ({'motions': ['away'], 'to_time': 77.0}, Status.INVALID_ARGUMENT, 'to_time'),
                ({'motions': ['away'], 'path': two}, Status.INVALID_ARGUMENT, 'path'),
                ({'motions': ['nowhere']}, Status.NOT_FOUND, 'nowhere'),
                ({'motions': ['away'], 'report': '../up'}, Status.INVALID_ARGUMENT, '../up')):
            answer = self.ask(**request)
            self.assertRefused(answer.status, code, words)
            self.assertEqual(answer.times, ())

    def test_the_command(self):
        script = os.path.join(rospkg.RosPack().get_path('cable_variation'), 'scripts', 'check_path')
        done = subprocess.run([script, '--clip', 'B', '--by', '-20mm,0,10mm'], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('kept: yes', done.stdout)
        self.assertIn('a way of 22.36 mm', done.stdout)
        wrong = subprocess.run([script, '--clip', 'nobody', '--by', '0,0,1mm'], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, universal_newlines=True, timeout=60)
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("no clip named 'nobody'", wrong.stderr)


if __name__ == '__main__':
    rospy.init_node('check_path_test')
    rostest.rosrun('cable_variation', 'check_path', CheckPathTest, sys.argv)
