#!/usr/bin/env python3
"""The program cable_variation answers what the services answer, bit for bit."""
import json
import math
import os
import subprocess
import sys

import roslib.packages
import rospy
import rostest
from cable_variation.srv import AnalyzeStability, GenerateEnvelope, SimulateVariation, SolveEquilibrium
from node_client import NodeTest

PROGRAM = roslib.packages.find_node('cable_variation', 'cable_variation')[0]
HARNESS = 'package://cable_variation/config/harness.yaml'

# How long it took, and what is shown in RViz or for planners.
LEFT_OUT = {'solve_time', 'linear_time', 'resolve_time', 'verify_time', 'clearance_time', 'surface_time',
            'simulation_time', 'samples_per_second', 'report_time', 'shown', 'header', 'mesh'}


def differences(message, answer, path=''):
    """Where a message and the same fields of an answer in JSON are not the same."""
    if hasattr(message, '__slots__'):
        if not isinstance(answer, dict):
            yield path, message, answer
            return
        for field in message.__slots__:
            if field in LEFT_OUT:
                continue
            if field in ('capability', 'controlled') and field not in answer:
                if getattr(message, 'has_' + field):
                    yield path + '.' + field, 'there', 'missing'
            elif field not in answer:
                yield path + '.' + field, 'there', 'missing'
            else:
                yield from differences(getattr(message, field), answer[field], path + '.' + field)
    elif isinstance(message, (list, tuple)):
        if len(message) != len(answer):
            yield 'length of ' + path, len(message), len(answer)
        for i, (a, b) in enumerate(zip(message, answer)):
            yield from differences(a, b, '%s[%d]' % (path, i))
    elif isinstance(message, float):
        same = answer is None if math.isnan(message) else \
            answer == ('infinite' if message > 0 else '-infinite') if math.isinf(message) else message == answer
        if not same:
            yield path, message, answer
    elif message != answer:
        yield path, message, answer


class CommandLineTest(NodeTest):
    def command(self, *words):
        done = subprocess.run([PROGRAM, *words, '--json'], capture_output=True, text=True, timeout=150, check=False,
                              cwd=os.environ.get('ROS_HOME', '/tmp'))
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        return json.loads(done.stdout)

    def same(self, message, answer):
        self.assertEqual(list(differences(message, answer))[:5], [])

    def test_solve(self):
        ask = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)
        for follow in (False, True):
            words = ['--variables', 'wh_start_rz', 'main_length', '--values', '0.05', '0.315']
            self.same(ask(variables=['wh_start_rz', 'main_length'], values=[0.05, 0.315], follow=follow),
                      self.command('solve', HARNESS, *words, *(['--follow'] if follow else [])))

    def test_stability(self):
        ask = self.service('/cable_solver/analyze_stability', AnalyzeStability)
        self.same(ask(), self.command('stability', HARNESS))
        self.same(ask(nominal_variables=['wh_start_rz'], nominal_values=[-0.1], measures=['D_CAR']),
                  self.command('stability', HARNESS, '--set', 'wh_start_rz=-0.1', '--measures', 'D_CAR'))

    def test_simulate(self):
        ask = self.service('/cable_solver/simulate_variation', SimulateVariation)
        self.same(ask(variables=['*'], samples=3000, seed=5, sampler='sobol'),
                  self.command('simulate', HARNESS, '--samples', '3000', '--seed', '5', '--sampler', 'sobol'))

    def test_envelope(self):
        ask = self.service('/cable_solver/generate_envelope', GenerateEnvelope)
        self.same(ask(variables=['wh_start_ry', 'wh_start_rz'], verification_shapes=500),
                  self.command('envelope', HARNESS, '--variables', 'wh_start_ry', 'wh_start_rz',
                               '--verification_shapes', '500'))


if __name__ == '__main__':
    rospy.init_node('command_line_test')
    rostest.rosrun('cable_variation', 'command_line', CommandLineTest, sys.argv)
