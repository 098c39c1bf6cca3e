#!/usr/bin/env python3
"""scripts/simulate: what it prints, its one line for what is wrong, Ctrl-C."""
import os
import pty
import re
import signal
import subprocess
import sys
import time

import roslib.packages
import rospy
import rostest
from cable_variation.srv import GetScene, SimulateVariation
from node_client import NodeTest

CLIENT = roslib.packages.find_node('cable_variation', 'simulate')[0]


def command(*arguments):
    return [sys.executable, CLIENT, *arguments]


class SimulateClientTest(NodeTest):
    def setUp(self):
        self.service('/cable_solver/get_scene', GetScene)

    def run_client(self, *arguments):
        return subprocess.run(command(*arguments), capture_output=True, text=True, timeout=120, check=False)

    def test_prints_the_figures_that_were_answered(self):
        result = self.run_client('--samples', '2000', '--seed', '4')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertLessEqual(max(len(line) for line in result.stdout.splitlines()), 100)
        answer = self.service('/cable_solver/simulate_variation', SimulateVariation)(
            variables=['*'], samples=2000, seed=4)
        clearance = answer.measures[0]
        line = re.search(r'^ +clearance +mm .*$', result.stdout, re.MULTILINE).group()
        self.assertIn(' %.4g ' % (1e3 * clearance.nominal), line)
        for value in (clearance.min, clearance.max):
            self.assertIn(' %.3g ' % (1e3 * value), line)
        self.assertIn(' %.2f ' % clearance.capability.cpk, line)
        (mean, half), (sigma, percent) = re.findall(r'([-\d.]+) \+- ([\d.]+)', line)
        self.assertAlmostEqual(float(mean), 1e3 * clearance.best_mean, delta=0.51 * float(half))
        # To one digit or two: at most half of the first one off.
        self.assertAlmostEqual(float(half), 1e3 * (clearance.best_mean_high - clearance.best_mean),
                               delta=0.51 * float(half))
        self.assertAlmostEqual(float(sigma), 1e3 * clearance.best_sigma, delta=1e-3 * 1e3 * clearance.best_sigma)
        self.assertAlmostEqual(float(percent), 100 * (clearance.best_sigma_high / clearance.best_sigma - 1),
                               delta=0.1 * float(percent))
        self.assertEqual('*' in line, clearance.best_mean_controlled or clearance.best_sigma_controlled)
        self.assertIn('2,000 samples: all solved', result.stdout)
        self.assertRegex(result.stdout, r'end_height +100 % +b_z \d+ %')
        self.assertRegex(result.stdout, r'strand +%.2f' % (1e3 * max(answer.cables[0].six_sigma)))
        self.assertRegex(result.stdout, r'monte_carlo, seed 4; [\d.]+ s, [\d,]+ a second')

    def test_tells_when_over_a_motion(self):
        result = self.run_client('--motions', 'sway', '--samples', '200')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertRegex(result.stdout, r'solved at \d+ times? of the motion')
        at = self.run_client('--motions', 'sway', '--samples', '200', '--at', '0')
        self.assertEqual((at.returncode, at.stderr), (0, ''))
        self.assertIn('solved at 1 time of the motion; cables vary most at t = 0.00 s', at.stdout)

    def test_says_what_is_wrong_in_a_line(self):
        for arguments, part in ((('--variables', 'b_zz'), "'b_zz'"), (('--measures', 'gap'), "'gap'"),
                                (('--motions', 'swing'), "'swing'"), (('--sampler', 'halton'), "'halton'"),
                                (('--sigma-error', '200%'), 'sigma_error: is 2'), (('--set', 'b_y=1mm'), "'b_y'"),
                                (('--name', '../out'), '../out')):
            result = self.run_client(*arguments)
            self.assertEqual((result.returncode, result.stdout), (1, ''), arguments)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(part, result.stderr)

    def test_shows_progress_on_a_terminal_and_prints_what_was_done_at_ctrl_c(self):
        ours, theirs = pty.openpty()
        process = subprocess.Popen(command('--samples', '1000000000'), stdout=subprocess.PIPE, stderr=theirs,
                                   text=True)
        os.close(theirs)
        shown = b''
        while b'clearance' not in shown:
            shown += os.read(ours, 1000)
        process.send_signal(signal.SIGINT)
        asked = time.time()
        printed, _ = process.communicate(timeout=self.TIMEOUT)
        took = time.time() - asked
        shown += os.read(ours, 100000)
        os.close(ours)
        self.assertEqual(process.returncode, 130)
        self.assertRegex(shown, rb'of 1,000,000,000 \[#*\.*\] +\d+ %.* clearance [\d.]+ \+- [\d.]+ mm')
        self.assertRegex(shown, rb'cancelled after \d+ of 1000000000 samples')
        self.assertRegex(printed, r'clearance +mm')
        self.assertRegex(printed, r'[\d,]+ samples: ')
        self.assertPrompt(took, 'the end at Ctrl-C')


if __name__ == '__main__':
    rospy.init_node('simulate_client_test')
    rostest.rosrun('cable_variation', 'simulate_client', SimulateClientTest)
