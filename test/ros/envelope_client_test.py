#!/usr/bin/env python3
"""scripts/envelope: what it prints, its one line for what is wrong, Ctrl-C."""
import os
import pty
import signal
import subprocess
import sys
import time

import roslib.packages
import rospy
import rostest
from cable_variation.srv import GetScene
from node_client import NodeTest

CLIENT = roslib.packages.find_node('cable_variation', 'envelope')[0]


def command(*arguments):
    return [sys.executable, CLIENT, *arguments]


class EnvelopeClientTest(NodeTest):
    def setUp(self):
        self.service('/cable_solver/get_scene', GetScene)

    def run_client(self, *arguments):
        return subprocess.run(command(*arguments), capture_output=True, text=True, timeout=120, check=False)

    def test_prints_how_sure_it_is_and_what_it_keeps_clear_of(self):
        result = self.run_client('--variables', 'b_z', 'a_ry', '--verification', '200', '--tightness', '200')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertLessEqual(max(len(line) for line in result.stdout.splitlines()), 100)
        for part in ('strand at rest; b_z, a_ry', '0 outside', 'of 200 independent shapes', 'cm3',
                     'of the volume of 200 random shapes together', 'strand - floor', 'strand - shelf'):
            self.assertIn(part, result.stdout)
        # The shelf is in the way of the sagging strand itself: what was solved meets it.
        self.assertRegex(result.stdout, r'strand - shelf +-\d.* OVERLAP')
        self.assertRegex(result.stdout, r'strand - shelf is closest with .*b_z [+-][\d.]+ mm')

    def test_tells_which_share_of_production_it_holds(self):
        result = self.run_client('--probability', '0.95')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertLessEqual(max(len(line) for line in result.stdout.splitlines()), 100)
        self.assertIn('95 % of production', result.stdout)
        self.assertRegex(result.stdout, r'production +9[5-9][.\d]* % +held of [\d,]+ fresh samples; 9[5-9][.\d]* % at least')

    def test_tells_when_over_a_motion(self):
        result = self.run_client('--motions', 'sway', '--motion-only', '--verification', '50')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertRegex(result.stdout, r'over sway, [\d,]+ poses? in \d+ phases?; nothing varies')
        self.assertRegex(result.stdout, r'clearance .* t\b')

    def test_says_what_is_wrong_in_a_line(self):
        for arguments, part in ((('--variables', 'b_zz'), "'b_zz'"), (('--cables', 'rope'), "'rope'"),
                                (('--motions', 'swing'), "'swing'"), (('--margin=-1mm',), '-0.001'),
                                (('--set', 'b_y=1mm'), "'b_y'"), (('--probability', '2'), 'probability: is 2'), (('--name', '../out'), '../out')):
            result = self.run_client(*arguments)
            self.assertEqual((result.returncode, result.stdout), (1, ''), arguments)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(part, result.stderr)

    def test_shows_progress_on_a_terminal_and_cancels_at_ctrl_c(self):
        ours, theirs = pty.openpty()
        # Far more shapes than it has time for.
        process = subprocess.Popen(command('--verification', '1000000'), stdout=subprocess.PIPE, stderr=theirs)
        os.close(theirs)
        shown = b''
        while b'%' not in shown:
            shown += os.read(ours, 1000)
        process.send_signal(signal.SIGINT)
        asked = time.time()
        printed, _ = process.communicate(timeout=self.TIMEOUT)
        took = time.time() - asked
        shown += os.read(ours, 100000)
        os.close(ours)
        self.assertEqual((process.returncode, printed), (130, b''))
        self.assertIn(b'cancelled after', shown)
        self.assertRegex(shown, rb'[a-z]+ +\[#*\.*\] +\d+ %')
        self.assertPrompt(took, 'the end at Ctrl-C')


if __name__ == '__main__':
    rospy.init_node('envelope_client_test')
    rostest.rosrun('cable_variation', 'envelope_client', EnvelopeClientTest)
