#!/usr/bin/env python3
"""~simulate_variation on the shipped cases: the harness at rest, the hose on an engine that moves."""
import csv
import os
import subprocess
import sys
import tempfile

import numpy
import roslib.packages
import rospy
import rostest
from cable_variation.srv import AnalyzeStability, SimulateVariation, SolveEquilibrium
from node_client import NodeTest

CONFIG = 'package://cable_variation/config/'
COOLER = ['cooler_x', 'cooler_y', 'cooler_z']
MEASURES = ['D_BAY', 'bend', 'middle_height', 'outlet_force']
AS_SOLVED = 2e-5  # of what differs by the path to a shape: a fifth of the scene's accuracy [m]


def samples(path, names):
    with open(path, newline='') as file:
        rows = list(csv.reader(file))
    places = [[name.split(' [')[0] for name in rows[0]].index(name) for name in names]
    return numpy.array([[float(row[place]) for place in places] for row in rows[1:]])


class SimulateCasesTest(NodeTest):
    def start(self, scene):
        """A solver of the scene: a function that asks its services, and the folder it writes to."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        name = 'solver_' + scene
        program = roslib.packages.find_node('cable_variation', 'cable_solver')[0]
        process = subprocess.Popen([program, '__name:=' + name, '_scene:=%s%s.yaml' % (CONFIG, scene),
                                    '_output_directory:=' + folder.name])
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)

        def ask(service, kind, **request):
            return self.service('/%s/%s' % (name, service), kind)(**request)
        return ask, folder.name

    def test_the_harness(self):
        ask, _ = self.start('harness')
        answer = ask('simulate_variation', SimulateVariation, variables=['*'], samples=1000)
        self.assertSuccess(answer.status)
        self.assertEqual((answer.samples, len(answer.measures), len(answer.variables)), (1000, 13, 10))
        self.assertEqual(answer.not_converged + answer.impossible, 0)
        self.assertEqual([each.cable for each in answer.cables], ['main', 'branch'])
        linear = ask('analyze_stability', AnalyzeStability, skip_low_high=True)
        for each, sigma, nominal in zip(answer.measures, linear.sigma, linear.measures):
            self.assertEqual((each.name, each.count + each.missing), (nominal.name, 1000))
            self.assertAlmostEqual(each.nominal, nominal.value, delta=1e-6 * max(abs(nominal.value), 1e-3))
            if each.name == 'middle_height':  # within what is nearly linear, as the regression says
                self.assertGreater(each.r_squared, 0.9)
                self.assertAlmostEqual(each.sigma, sigma, delta=0.1 * sigma)

    def test_the_hose_at_a_time_of_its_motion(self):
        ask, folder = self.start('hose')
        moment = 31.15  # in the pothole
        answer = ask('simulate_variation', SimulateVariation, variables=COOLER, measures=MEASURES, samples=20,
                     motions=['engine_run'], from_time=moment, to_time=moment, name='at')
        self.assertSuccess(answer.status)
        self.assertEqual([each.time for each in answer.times], [moment])
        self.assertEqual(answer.shown_time, moment)
        table = samples(os.path.join(folder, 'at.csv'), COOLER + MEASURES)
        for row in table[:3]:
            solved = ask('solve_equilibrium', SolveEquilibrium, variables=COOLER, values=list(row[:3]),
                         motion='engine_run', time=moment, follow=True)
            self.assertSuccess(solved.status)
            found = {each.name: each.value for each in solved.measures}
            numpy.testing.assert_allclose(row[3:6], [found[name] for name in MEASURES[:3]], atol=AS_SOLVED)

    def test_the_hose_at_its_worst_over_the_motion(self):
        ask, folder = self.start('hose')
        answer = ask('simulate_variation', SimulateVariation, variables=COOLER, measures=['D_BAY'], samples=20,
                     motions=['engine_run'], name='worst')
        self.assertSuccess(answer.status)
        times = [each.time for each in answer.times]
        self.assertTrue(1 < len(times) <= 16 and times == sorted(times), times)
        self.assertEqual(sum(each.worst for each in answer.times), 20)
        self.assertIn(answer.shown_time, times)
        self.assertEqual(max(answer.times, key=lambda each: each.largest_six_sigma).time, answer.shown_time)
        table = samples(os.path.join(folder, 'worst.csv'), COOLER + ['D_BAY'])
        missed = answer.measures[0].missed
        self.assertTrue(0 <= missed < 1e-3, missed)
        random = numpy.random.default_rng(7)
        for row in table[:2]:
            def distance(moment):
                solved = ask('solve_equilibrium', SolveEquilibrium, variables=COOLER, values=list(row[:3]),
                             motion='engine_run', time=moment, follow=True)
                self.assertSuccess(solved.status)
                return {each.name: each.value for each in solved.measures}['D_BAY']
            self.assertAlmostEqual(min(distance(each) for each in times), row[3], delta=AS_SOLVED)
            # At no other time is it closer; what the first-order model misses is small against the distance.
            others = [distance(each) for each in random.uniform(0, 50, 40)]
            self.assertGreater(min(others), row[3] - missed - 2e-4)


if __name__ == '__main__':
    rospy.init_node('simulate_cases_test')
    rostest.rosrun('cable_variation', 'simulate_cases', SimulateCasesTest)
