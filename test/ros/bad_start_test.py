#!/usr/bin/env python3
"""Nodes that are started wrongly say all that is wrong and end with code 1; asked for help, they give it."""
import os
import subprocess
import sys
import unittest

import roslib.packages
import rospy
import rostest

NODES = ('static_geometry_node', 'moving_geometry_node', 'cable_solver')
DATA = 'package://cable_variation/test/ros/data/'


def run(node, *parameters):
    program = roslib.packages.find_node('cable_variation', node)[0]
    return subprocess.run([program] + ['_%s:=%s' % each for each in parameters], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=20, universal_newlines=True)


class BadStartTest(unittest.TestCase):
    def assertEnds(self, result, *parts):
        self.assertEqual(result.returncode, 1, result.stdout)
        for part in parts:
            self.assertIn(part, result.stdout)

    def test_a_broken_scene(self):
        for node in NODES:
            self.assertEnds(run(node, ('scene', DATA + 'broken.yaml')), 'FATAL', 'broken.yaml:3', '312 kg', 'wood')

    def test_no_scene(self):
        for node in NODES:
            rospy.delete_param('/' + node) if rospy.has_param('/' + node) else None
            self.assertEnds(run(node), '/%s/scene is missing' % node)
            self.assertEnds(run(node, ('scene', 'nowhere.yaml')), 'nowhere.yaml')

    def test_all_wrong_parameters_at_once(self):
        self.assertEnds(run('moving_geometry_node', ('scene', '3'), ('rate', '-5'), ('loop', '7'), ('speed', 'fast')),
                        'scene expected a string', 'rate is -5, expected above 0', 'loop expected true or false',
                        'speed expected a number')
        self.assertEnds(run('cable_solver', ('scene', DATA + 'strand.yaml'), ('live', 'true'), ('live_rate', '0')),
                        'live_rate is 0')
        self.assertEnds(run('cable_solver', ('scene', DATA + 'strand.yaml'), ('memory_limit', '3e9'), ('memory_total', '1e9')),
                        'memory_total is 1e+09, expected at least 3e+09')
        self.assertEnds(run('cable_solver', ('scene', DATA + 'strand.yaml'), ('live_rate', '50'), ('threads', '-1')),
                        'threads is -1, expected 0')
        self.assertEnds(run('cable_solver', ('threads', 'many')), 'threads expected a whole number')

    def test_help_takes_no_master(self):
        environment = dict(os.environ, ROS_MASTER_URI='http://localhost:1')
        for node in NODES:
            program = roslib.packages.find_node('cable_variation', node)[0]
            for option in ('--help', '-h'):
                result = subprocess.run([program, option], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=20,
                                        universal_newlines=True, env=environment)
                self.assertEqual(result.returncode, 0, result.stdout)
                self.assertIn('usage: %s [_PARAMETER:=VALUE ...]' % node, result.stdout)
                self.assertIn('  scene ', result.stdout)

    def test_a_broken_recording(self):
        self.assertEnds(run('moving_geometry_node', ('scene', DATA + 'broken_bag.yaml')),
                        "motion 'slide'", "no frame 'cart'", 'other, sled')


if __name__ == '__main__':
    rospy.init_node('bad_start_test')
    rostest.rosrun('cable_variation', 'bad_start', BadStartTest, sys.argv)
