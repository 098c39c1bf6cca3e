#!/usr/bin/env python3
"""~analyze_stability, asked well and badly; what it shows, and its client on the console."""
import math
import os
import subprocess
import sys
import tempfile
import xml.dom.minidom

import numpy
import roslib.packages
import rospy
import rostest
from cable_variation.msg import Legend, Status
from cable_variation.srv import AnalyzeStability, LoadScene, SetDesign, SolveEquilibrium
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

DATA = 'package://cable_variation/test/ros/data/'
VARIABLES = ['b_z', 'a_ry', 'strand_length', 'floor_z']
MEASURES = ['clearance', 'change', 'height', 'end_force']


def matrix(values, answer):
    return numpy.array(values).reshape(len(answer.measures), len(answer.variables))


class AnalyzeStabilityTest(NodeTest):
    def setUp(self):
        self.analyze = self.service('/cable_solver/analyze_stability', AnalyzeStability)
        self.solve = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)
        self.set_design = self.service('/cable_solver/set_design', SetDesign)
        self.reset_design = self.service('/cable_solver/reset_design', Trigger)
        self.load_scene = self.service('/cable_solver/load_scene', LoadScene)
        self.assertTrue(self.reset_design().success)

    def measured(self, **values):
        """Measures by name with design variables off their nominal values."""
        answer = self.solve(variables=list(values), values=list(values.values()), follow=True)
        self.assertSuccess(answer.status)
        return {each.name: each for each in answer.measures}

    def shown(self, topic):
        return {each.ns for each in self.latched('/cable_solver/' + topic, MarkerArray).markers
                if each.action == Marker.ADD}

    def test_solve_equilibrium_measures(self):
        answer = self.solve()
        self.assertSuccess(answer.status)
        measures = {each.name: each for each in answer.measures}
        self.assertEqual([each.name for each in answer.measures], MEASURES)
        # The floor is the plane z = -0.2 m below the strand of radius 4 mm.
        lowest = min(point.z for point in answer.shapes[0].centreline)
        clearance = measures['clearance']
        self.assertAlmostEqual(clearance.value, lowest + 0.2 - 0.004, delta=1e-5)
        self.assertAlmostEqual(clearance.other.z, -0.2, places=9)
        self.assertAlmostEqual(clearance.point.z - clearance.other.z, clearance.value, places=7)
        self.assertEqual((clearance.cable, clearance.unit, clearance.type), ('strand', 'm', 'distance'))
        self.assertEqual((clearance.has_lower, clearance.lower, clearance.has_upper, clearance.upper),
                         (True, 0.08, True, 1.0))
        self.assertEqual(clearance.within, 0.08 <= clearance.value <= 1.0)
        self.assertEqual(measures['change'].value, 0)
        force = numpy.linalg.norm(xyz(answer.clip_reactions[1].force))
        self.assertAlmostEqual(measures['end_force'].value, force, places=9)
        self.assertGreater(self.measured(b_z=0.004)['change'].value, 1e-3)

    def test_the_answer_is_whole(self):
        answer = self.analyze()
        self.assertSuccess(answer.status)
        self.assertEqual([each.name for each in answer.variables], VARIABLES)
        self.assertEqual([each.unit for each in answer.variables], ['m', 'rad', 'm', 'm'])
        self.assertEqual([each.name for each in answer.measures], MEASURES)
        self.assertEqual(list(answer.one_sided), [False, True, False, False])
        for values in (answer.jacobian, answer.contribution, answer.low, answer.high):
            self.assertEqual(len(values), 16)
        for values in (answer.mean_shift, answer.sigma, answer.worst_low, answer.worst_high,
                       answer.variable_sigma, answer.eigenvalue_low, answer.eigenvalue_high):
            self.assertEqual(len(values), 4)
        self.assertGreater(answer.smallest_eigenvalue, 0)
        self.assertIn(answer.coupling, ('uncoupled', 'decoupled', 'coupled'))
        self.assertEqual([each.component for each in answer.components], ['floor'])
        # A translation of +-2 mm at 3 sigma moves every vertex alike: 6 sigma are 4 mm.
        self.assertAlmostEqual(answer.components[0].largest_six_sigma, 0.004, places=12)
        self.assertEqual((answer.csv_file, answer.report_file), ('', ''))

    def test_spread_follows_from_the_derivatives(self):
        answer = self.analyze(skip_low_high=True)
        self.assertSuccess(answer.status)
        self.assertEqual((answer.low, answer.high, answer.eigenvalue_low, answer.eigenvalue_high), ((),) * 4)
        # Normal at 3 sigma: tolerance / 3; uniform: its width / sqrt(12).
        sigmas = [0.005 / 3, math.radians(5) / 3, 0.006 / math.sqrt(12), 0.002 / 3]
        numpy.testing.assert_allclose(answer.variable_sigma, sigmas, rtol=1e-9)
        parts = matrix(answer.jacobian, answer) * sigmas
        numpy.testing.assert_allclose(answer.sigma, numpy.sqrt((parts ** 2).sum(axis=1)), rtol=1e-9)
        shares = parts ** 2 / (parts ** 2).sum(axis=1, keepdims=True)
        numpy.testing.assert_allclose(matrix(answer.contribution, answer), shares, atol=1e-9)
        tolerances = [0.005, math.radians(5), 0.003, 0.002]
        worst = (abs(matrix(answer.jacobian, answer)) * tolerances).sum(axis=1)
        numpy.testing.assert_allclose(answer.worst_high, worst, rtol=1e-9)

    def test_derivatives_are_what_solving_gives(self):
        answer = self.analyze(skip_low_high=True)
        jacobian = matrix(answer.jacobian, answer)
        # Central differences: 1 um and 1e-5 rad leave 1e-5 of curvature and of what a solve leaves out of balance.
        for column, (name, nominal, step) in enumerate((('b_z', 0, 1e-5), ('a_ry', 0, 1e-4),
                                                        ('strand_length', 0.312, 1e-5), ('floor_z', 0, 1e-5))):
            up, down = self.measured(**{name: nominal + step}), self.measured(**{name: nominal - step})
            for row, measure in enumerate(MEASURES):
                if measure == 'change':
                    slope = 0.5 * (up[measure].value + down[measure].value) / step
                else:
                    slope = 0.5 * (up[measure].value - down[measure].value) / step
                scale = abs(jacobian[row]).max()
                self.assertAlmostEqual(jacobian[row, column], slope, delta=2e-3 * max(abs(slope), 1e-3 * scale),
                                       msg='%s by %s' % (measure, name))

    def test_low_and_high_are_solved(self):
        answer = self.analyze()
        high = self.measured(strand_length=0.315)
        for row, name in enumerate(MEASURES):
            self.assertAlmostEqual(matrix(answer.high, answer)[row, 2], high[name].value, delta=2e-5, msg=name)

    def test_rows_and_columns_as_asked(self):
        whole, part = self.analyze(), self.analyze(variables=['floor_z', 'b_z'], measures=['height', 'clearance'])
        self.assertSuccess(part.status)
        self.assertEqual([each.name for each in part.variables], ['floor_z', 'b_z'])
        expected = matrix(whole.jacobian, whole)[numpy.ix_([2, 0], [3, 0])]
        numpy.testing.assert_allclose(matrix(part.jacobian, part), expected, rtol=1e-6, atol=1e-9)

    def test_nominal_values_are_those_of_another_design(self):
        asked = self.analyze(nominal_variables=['b_z', 'strand_length'], nominal_values=[0.004, 0.32])
        self.assertSuccess(asked.status)
        self.assertEqual([each.nominal for each in asked.variables], [0.004, 0, 0.32, 0])
        self.assertSuccess(self.set_design(variables=['b_z', 'strand_length'], values=[0.004, 0.32]).status)
        there = self.analyze()
        self.assertEqual([each.nominal for each in there.variables], [0.004, 0, 0.32, 0])
        numpy.testing.assert_allclose(asked.jacobian, there.jacobian, rtol=1e-4, atol=1e-6)
        numpy.testing.assert_allclose(asked.low, there.low, rtol=1e-4, atol=1e-6)
        self.assertEqual(there.measures[1].value, 0)

    def test_bad_requests_are_refused_by_name(self):
        nan = float('nan')
        for request, code, part in (
                (dict(variables=['b_zz']), Status.NOT_FOUND, "design variable named 'b_zz'"),
                (dict(measures=['clear']), Status.NOT_FOUND, "measure named 'clear'"),
                (dict(variables=['b_z', 'b_z']), Status.INVALID_ARGUMENT, "'b_z' is given twice"),
                (dict(nominal_variables=['b_z'], nominal_values=[nan]), Status.INVALID_ARGUMENT, "'b_z'"),
                (dict(nominal_variables=['b_z']), Status.INVALID_ARGUMENT, '1 variables but 0 values'),
                (dict(nominal_variables=['up'], nominal_values=[0]), Status.NOT_FOUND, "'up'"),
                (dict(nominal_variables=['strand_length'], nominal_values=[0.2]), Status.NOT_CONVERGED, 'strand'),
                (dict(nominal_variables=['strand_length'], nominal_values=[-1]), Status.INVALID_ARGUMENT, '-1'),
                (dict(show='up'), Status.NOT_FOUND, "'up'"),
                (dict(variables=['b_z'], show='a_ry'), Status.INVALID_ARGUMENT, "'a_ry'"),
                (dict(report='../x'), Status.INVALID_ARGUMENT, "'../x'"),
                (dict(report='/tmp/x'), Status.INVALID_ARGUMENT, "'/tmp/x'")):
            answer = self.analyze(**request)
            self.assertRefused(answer.status, code, part)
            self.assertEqual((answer.measures, answer.jacobian, answer.shown), ([], (), ''))

    def test_the_view_goes_with_the_shape(self):
        answer = self.analyze(show='a_ry')
        self.assertEqual(answer.shown, 'a_ry')
        self.assertEqual(self.shown('variation'), {'sensitivity/strand'})
        legend = self.latched('/cable_solver/legend', Legend)
        self.assertIn('a_ry', legend.title)
        self.assertEqual((legend.unit, legend.topic), ('mm/deg', '/cable_solver/variation'))

        first = self.latched('/cable_solver/variation', MarkerArray)
        self.assertSuccess(self.set_design(variables=['strand_length'], values=[0.32]).status)
        after = self.latched('/cable_solver/variation', MarkerArray)
        self.assertEqual(self.shown('variation'), {'sensitivity/strand'})
        self.assertNotEqual(first, after)

        self.assertEqual(self.analyze(show_components=True).shown, '')
        self.assertEqual(self.shown('variation'), {'variation/floor'})
        self.assertIn('sigma', self.latched('/cable_solver/legend', Legend).quantity)

        self.assertSuccess(self.set_design(variables=['b_z'], values=[0.001]).status)
        self.assertEqual(self.shown('variation'), set())
        self.assertEqual(self.latched('/cable_solver/legend', Legend).title, '')

    def test_the_variable_that_matters_most_is_shown(self):
        answer = self.analyze()
        # Only the clearance has limits.
        self.assertEqual(answer.shown, VARIABLES[int(numpy.argmax(matrix(answer.contribution, answer)[0]))])

    def test_interference_follows_the_design(self):
        def text():
            return [each.text for each in self.latched('/cable_solver/interference', MarkerArray).markers
                    if each.type == Marker.TEXT_VIEW_FACING and each.action == Marker.ADD]
        self.assertEqual(self.shown('interference'), {'interference/clearance'})
        before = self.measured()['clearance']
        self.assertIn('clearance %.0f mm at s = %.0f mm' % (1e3 * before.value, 1e3 * before.arc_length), text())
        self.assertSuccess(self.set_design(variables=['floor_z'], values=[-0.01]).status)  # points down
        after = self.measured()['clearance']
        self.assertAlmostEqual(after.value, before.value - 0.01, places=7)
        self.assertIn('clearance %.0f mm at s = %.0f mm' % (1e3 * after.value, 1e3 * after.arc_length), text())

    def run_client(self, *arguments):
        program = roslib.packages.find_node('cable_variation', 'stability')[0]
        return subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60,
                              universal_newlines=True)

    def test_the_client_prints_tables(self):
        result = self.run_client('--set', 'b_z=4mm', 'strand_length=320mm', '--show', 'b_z', '--least', '0')
        self.assertEqual((result.returncode, result.stderr), (0, ''))
        self.assertLessEqual(max(len(line) for line in result.stdout.splitlines()), 100)
        for name in VARIABLES + MEASURES + ['mm/deg', '+-5 deg', '80 to 1000']:
            self.assertIn(name, result.stdout)
        value = self.measured(b_z=0.004, strand_length=0.32)['end_force'].value
        self.assertIn('%.3g' % value, result.stdout)

    def test_the_client_says_what_is_wrong_in_a_line(self):
        result = self.run_client('--variables', 'b_zz')
        self.assertEqual((result.returncode, result.stdout), (1, ''))
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("'b_zz'", result.stderr)

    def writer(self, output_directory):
        """A solver of its own that writes there."""
        program = roslib.packages.find_node('cable_variation', 'cable_solver')[0]
        process = subprocess.Popen([program, '__name:=writer', '_scene:=' + DATA + 'measured.yaml',
                                    '_output_directory:=' + output_directory])
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return self.service('/writer/analyze_stability', AnalyzeStability)

    def test_reports_are_written_where_they_may(self):
        with tempfile.TemporaryDirectory() as folder:
            answer = self.writer(os.path.join(folder, 'new', 'out'))(report='run_1')
            self.assertSuccess(answer.status)
            self.assertEqual((answer.csv_file, answer.report_file),
                             tuple(os.path.join(folder, 'new', 'out', 'run_1' + end) for end in ('.csv', '.html')))
            self.assertEqual(sorted(os.listdir(os.path.join(folder, 'new', 'out'))), ['run_1.csv', 'run_1.html'])
            with open(answer.csv_file) as file:
                self.assertEqual(len(file.readlines()), 1 + 16)
            xml.dom.minidom.parse(answer.report_file)
            with open(answer.report_file, 'rb') as page, open(answer.csv_file, 'rb') as table:
                older = page.read(), table.read()
            # another kind of report of the same name: the older one is kept with its table
            solved = self.service('/writer/solve_equilibrium', SolveEquilibrium)(report='run_1')
            self.assertSuccess(solved.status)
            self.assertEqual(solved.report_file, answer.report_file)
            kept = [answer.report_file.replace('run_1.html', 'run_1_stability_analysis' + end) for end in ('.html', '.csv')]
            self.assertEqual(sorted(os.listdir(os.path.join(folder, 'new', 'out'))),
                             ['run_1.html', 'run_1_stability_analysis.csv', 'run_1_stability_analysis.html'])
            for path, contents in zip(kept, older):
                with open(path, 'rb') as file:
                    self.assertEqual(file.read(), contents)

    def test_a_folder_that_cannot_be_written_is_named(self):
        with tempfile.NamedTemporaryFile() as file:
            folder = os.path.join(file.name, 'below')
            answer = self.writer(folder)(report='run_1')
            self.assertRefused(answer.status, Status.IO_ERROR, folder)
            self.assertEqual((answer.csv_file, answer.report_file), ('', ''))
            self.assertEqual(len(answer.measures), 4)
            self.assertEqual(len(answer.jacobian), 16)

    def test_what_is_not_defined_is_said_and_never_nan(self):
        self.assertSuccess(self.load_scene(DATA + 'straight.yaml').status)
        try:
            answer = self.analyze(nominal_variables=['rod_length'], nominal_values=[0.004])
            self.assertSuccess(answer.status)
            self.assertEqual([each.name for each in answer.measures], ['bend', 'tip', 'moment'])
            self.assertIn('infinite', answer.undefined[0])
            self.assertEqual(answer.undefined[1:], ['', ''])
            self.assertTrue(math.isinf(answer.measures[0].value) and math.isnan(answer.sigma[0]))
            # As far down as the tolerance goes the length is negative.
            low = matrix(answer.low, answer)[1]
            self.assertTrue(math.isnan(low[1]) and math.isfinite(low[0]))
            result = self.run_client('--set', 'rod_length=4mm')
            self.assertEqual((result.returncode, result.stderr), (0, ''))
            self.assertNotIn('nan', result.stdout)
            self.assertRegex(result.stdout, r'bend: not defined: the value is infinite')
            self.assertRegex(result.stdout, r'rod_length: low and high are not defined \(-\) at its lower limit')
        finally:
            self.assertSuccess(self.load_scene(DATA + 'measured.yaml').status)

    def test_a_snap_within_a_tolerance_is_told(self):
        self.assertSuccess(self.load_scene(DATA + 'flat_strip.yaml').status)
        try:
            answer = self.analyze()
            self.assertSuccess(answer.status)
            self.assertEqual([each.variable for each in answer.snaps], ['r'])
            snap = answer.snaps[0]
            self.assertTrue(20 < abs(snap.deviation) * 180 / math.pi < 30, snap.deviation)
            self.assertGreater(snap.jump, 0.04)
            self.assertEqual(snap.cable, 'strip')
            self.assertIn('snap to another equilibrium', ' '.join(answer.warnings))
            result = self.run_client()
            self.assertEqual((result.returncode, result.stderr), (0, ''))
            self.assertRegex(result.stdout, r'warning: r at its (lower|upper) limit: from -?[0-9.]+ deg on')
        finally:
            self.assertSuccess(self.load_scene(DATA + 'measured.yaml').status)

    def test_the_harness_case(self):
        self.assertSuccess(self.load_scene('package://cable_variation/config/harness.yaml').status)
        try:
            answer = self.analyze(skip_low_high=True)
            self.assertSuccess(answer.status)
            names = [each.name for each in answer.measures]
            row, step = names.index('D_CAR'), 1e-4
            column = [each.name for each in answer.variables].index('wh_start_ry')
            up, down = self.measured(wh_start_ry=step), self.measured(wh_start_ry=-step)
            slope = 0.5 * (up['D_CAR'].value - down['D_CAR'].value) / step
            self.assertAlmostEqual(matrix(answer.jacobian, answer)[row, column], slope, delta=1e-3 * abs(slope))
        finally:
            self.assertSuccess(self.load_scene(DATA + 'measured.yaml').status)


if __name__ == '__main__':
    rospy.init_node('analyze_stability_test')
    rostest.rosrun('cable_variation', 'analyze_stability', AnalyzeStabilityTest, sys.argv)
