#!/usr/bin/env python3
"""~simulate_variation and its action, asked well and badly; what they show and write."""
import csv
import os
import resource
import subprocess
import sys
import tempfile
import time
import xml.dom.minidom

import actionlib
import numpy
import roslib.packages
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from cable_variation.msg import Legend, SimulateVariationAction, SimulateVariationGoal, Status
from cable_variation.srv import AnalyzeStability, LoadScene, SetDesign, SimulateVariation, SolveEquilibrium
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

DATA = 'package://cable_variation/test/ros/data/'
CONFIG = 'package://cable_variation/config/'
VARIABLES = ['b_z', 'a_ry', 'floor_z']
MEASURES = ['clearance', 'change', 'end_height']
UP = 0.5 ** 0.5  # z of the clip's z axis, along which b_z alone moves the strand's end, by its tolerance of 3 sigma
END_SIGMA = UP * 0.005 / 3  # of the end's height [m]
ENDLESS = dict(variables=['*'], samples=1000000000)  # a day


def columns(path):
    """A file of samples or statistics: columns by the names before their units."""
    with open(path, newline='') as file:
        rows = list(csv.reader(file))
    return {name.split(' [')[0]: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def numbers(path, *names):
    found = columns(path)
    return numpy.array([[float(value) for value in found[name]] for name in names])


def figures(answer):
    """All digits of an answer but what depends on the clock, as text: nan is like nan."""
    answer.simulation_time = answer.samples_per_second = answer.report_time = 0
    return str(answer).splitlines()


class SimulateVariationTest(NodeTest):
    def setUp(self):
        self.simulate = self.service('/cable_solver/simulate_variation', SimulateVariation)
        self.set_design = self.service('/cable_solver/set_design', SetDesign)
        self.reset_design = self.service('/cable_solver/reset_design', Trigger)
        self.assertTrue(self.reset_design().success)

    def client(self, node='/cable_solver'):
        client = actionlib.SimpleActionClient(node + '/simulate_variation_action', SimulateVariationAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(self.TIMEOUT)))
        return client

    def solver(self, scene=DATA + 'production.yaml', output_directory='', threads=1, largest_file=None):
        """A solver of its own, with a name of its own, and the folder it writes to."""
        if not output_directory:
            folder = tempfile.TemporaryDirectory()
            self.addCleanup(folder.cleanup)
            output_directory = folder.name
        name = 'solver_%d' % time.monotonic_ns()

        def limit():
            # Not a full disk, but to a program the same: no byte more goes into a file. It is told so by an error
            # code, for Python ignores the signal and the program inherits that.
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))
        program = roslib.packages.find_node('cable_variation', 'cable_solver')[0]
        process = subprocess.Popen([program, '__name:=' + name, '_scene:=' + scene, '_threads:=%d' % threads,
                                    '_output_directory:=' + output_directory],
                                   preexec_fn=limit if largest_file else None, restore_signals=not largest_file)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return '/' + name, output_directory

    def markers(self):
        return {(each.ns, each.id): each for each in self.latched('/cable_solver/variation', MarkerArray).markers}

    def namespaces(self):
        return {ns for (ns, _), each in self.markers().items() if each.action == Marker.ADD}

    def legend(self):
        return self.latched('/cable_solver/legend', Legend)

    def begin(self, client, **goal):
        """Sends a goal and waits until there are samples."""
        told = []
        client.send_goal(SimulateVariationGoal(**goal), feedback_cb=told.append)
        self.eventually(lambda: told and told[-1].samples > 1000, 'progress')

    def test_the_answer_is_whole(self):
        answer = self.simulate(variables=['*'], samples=2000, sample_shapes=5)
        self.assertSuccess(answer.status)
        self.assertEqual((answer.samples, answer.wanted, answer.seed, answer.sampler), (2000, 2000, 1, 'monte_carlo'))
        self.assertEqual((answer.solved, answer.snapped, answer.not_converged, answer.impossible), (2000, 0, 0, 0))
        self.assertEqual((answer.listed, answer.warnings), ([], []))
        self.assertEqual([each.name for each in answer.variables], VARIABLES)
        self.assertEqual([each.name for each in answer.measures], MEASURES)
        self.assertEqual([(each.time, each.worst) for each in answer.times], [(0, 2000 * 3)])
        self.assertGreater(answer.samples_per_second, 0)
        self.assertEqual(answer.samples_file + answer.statistics_file + answer.report_file, '')

        end = answer.measures[2]
        self.assertEqual((end.count, end.infinite, end.missing, end.unit, end.confidence), (2000, 0, 0, 'm', 0.95))
        self.assertEqual((end.has_lower, end.has_capability), (False, False))
        # The end is at b_z exactly: normal of a known sigma. Five standard errors of 2000 samples; fixed seed.
        self.assertAlmostEqual(end.mean, 0, delta=5 * END_SIGMA / 2000 ** 0.5)
        self.assertAlmostEqual(end.sigma, END_SIGMA, delta=5 * END_SIGMA / 4000 ** 0.5)
        self.assertTrue(end.mean_low < 0 < end.mean_high and end.sigma_low < END_SIGMA < end.sigma_high)
        self.assertTrue(end.has_controlled)  # and so linear that its mean is known better than from samples
        self.assertAlmostEqual(end.controlled.mean, 0, delta=1e-9)
        self.assertAlmostEqual(end.linear_sigma, END_SIGMA, places=9)
        self.assertEqual(sum(end.histogram_count), 2000)
        self.assertAlmostEqual(end.percentile[list(end.percentile_share).index(0.5)], 0, delta=0.1 * END_SIGMA)

        clearance = answer.measures[0]
        self.assertEqual((clearance.has_lower, clearance.lower, clearance.has_capability), (True, 0.08, True))
        self.assertEqual(clearance.capability.ppm_outside,
                         1e6 * (clearance.capability.below + clearance.capability.above))
        self.assertAlmostEqual(clearance.capability.cpk, min(clearance.mean - 0.08, 1 - clearance.mean) /
                               (3 * clearance.sigma), places=9)

        for shares in (answer.first_order, answer.regression_share, answer.linear_contribution):
            self.assertEqual(len(shares), 9)
        self.assertAlmostEqual(answer.regression_share[6], 1, places=9)  # of b_z in end_height
        self.assertAlmostEqual(answer.regression_slope[6], UP, places=9)
        self.assertAlmostEqual(answer.linear_contribution[6], 1, places=9)
        self.assertGreater(answer.first_order[6], 0.9)

    def test_the_variation_along_the_cable(self):
        answer = self.simulate(variables=['*'], samples=4000, sections=11)
        self.assertSuccess(answer.status)
        strand, = answer.cables
        self.assertEqual(strand.cable, 'strand')
        numpy.testing.assert_allclose(strand.arc_length, numpy.linspace(0, 0.312, 11), atol=1e-12)
        for values in (strand.mean, strand.six_sigma, strand.range, strand.direction, strand.second, strand.third,
                       strand.sigma):
            self.assertEqual(len(values), 11)
        # A turn about the start leaves it where it is, b_z takes the end along.
        self.assertAlmostEqual(strand.six_sigma[0], 0, places=9)
        self.assertAlmostEqual(strand.six_sigma[-1], 6 * answer.measures[2].sigma / UP, places=9)
        self.assertAlmostEqual(strand.range[-1], (answer.measures[2].max - answer.measures[2].min) / UP, places=9)
        self.assertAlmostEqual(abs(strand.direction[-1].z), UP, places=9)
        for each in zip(strand.direction, strand.second, strand.third):
            axes = numpy.array([xyz(axis) for axis in each])
            numpy.testing.assert_allclose(axes @ axes.T, numpy.eye(3), atol=1e-9)

    def test_the_same_seed_gives_the_same_figures_on_one_thread_and_on_two(self):
        request = dict(variables=['*'], samples=3000, seed=5, sample_shapes=3)
        one = self.simulate(**request)
        self.assertSuccess(one.status)
        node, _ = self.solver(threads=2)
        two = self.service(node + '/simulate_variation', SimulateVariation)(**request)
        self.assertEqual(figures(one), figures(two))
        other = self.simulate(**dict(request, seed=6))
        self.assertNotEqual(one.measures[0].mean, other.measures[0].mean)

    def test_files_hold_what_was_answered_and_what_can_be_solved_again(self):
        node, folder = self.solver()
        answer = self.service(node + '/simulate_variation', SimulateVariation)(
            variables=['*'], samples=500, sampler='sobol', name='run_1', nominal_variables=['a_ry'],
            nominal_values=[0.05])
        self.assertSuccess(answer.status)
        base = os.path.join(folder, 'run_1')
        self.assertEqual(
            (answer.samples_file, answer.statistics_file, answer.contributions_file, answer.report_file),
            (base + '.csv', base + '_statistics.csv', base + '_contributions.csv', base + '.html'))
        self.assertEqual(len(os.listdir(folder)), 4)
        samples = numbers(answer.samples_file, *MEASURES)
        self.assertEqual(samples.shape, (3, 500))
        for measure, values in zip(answer.measures, samples):
            self.assertAlmostEqual(measure.mean, values.mean(), places=12)
            self.assertAlmostEqual(measure.sigma, values.std(ddof=1), places=12)
            self.assertEqual((measure.min, measure.max), (values.min(), values.max()))
        written = columns(answer.statistics_file)
        self.assertEqual(written['measure'], MEASURES)
        self.assertEqual([float(each) for each in written['sigma']], [each.sigma for each in answer.measures])
        self.assertEqual(len(columns(answer.contributions_file)['variable']), 9)
        xml.dom.minidom.parse(answer.report_file)
        self.assertAlmostEqual(answer.variables[1].nominal, 0.05)

        # Single samples, solved on their own; a millimetre of the scene's accuracy is ten times what is asked here.
        self.assertSuccess(self.service(node + '/set_design', SetDesign)(variables=['a_ry'], values=[0.05]).status)
        solve = self.service(node + '/solve_equilibrium', SolveEquilibrium)
        values = numbers(answer.samples_file, *VARIABLES)
        for i in (0, 7, 499):
            solved = solve(variables=VARIABLES, values=list(values[:, i]), follow=True)
            self.assertSuccess(solved.status)
            numpy.testing.assert_allclose([each.value for each in solved.measures], samples[:, i], atol=1e-5)

    def test_until_sigma_is_known(self):
        answer = self.simulate(variables=['*'], sigma_error=0.05, confidence=0.9)
        self.assertSuccess(answer.status)
        self.assertTrue(100 < answer.samples < 10000, answer.samples)  # normal: 550, the half width being 1.645/√2n
        for each in answer.measures:
            best = each.controlled if each.has_controlled else each
            self.assertLessEqual(max(best.sigma_high - best.sigma, best.sigma - best.sigma_low), 0.05 * best.sigma)
        # The bound holds, and says so.
        bound = self.simulate(variables=['*'], sigma_error=0.001, samples=300)
        self.assertEqual((bound.status.code, bound.samples), (Status.SUCCESS, 300))
        self.assertIn('after 300 samples', ' '.join(bound.warnings))

    def test_bad_requests_are_refused_by_name(self):
        nan, shown = float('nan'), self.latched('/cable_solver/variation', MarkerArray)
        some = dict(variables=['b_z'], samples=10)
        for request, code, part in (
                (dict(), Status.INVALID_ARGUMENT, 'variables: is empty'),
                (dict(variables=['b_zz']), Status.NOT_FOUND, "design variable named 'b_zz'"),
                (dict(variables=['b_z', 'b_z']), Status.INVALID_ARGUMENT, "'b_z' is given twice"),
                (dict(some, measures=['gap']), Status.NOT_FOUND, "measure named 'gap'"),
                (dict(some, motions=['walk']), Status.NOT_FOUND, "motion named 'walk'"),
                (dict(some, samples=1000000001), Status.INVALID_ARGUMENT, 'samples: is 1000000001'),
                (dict(some, sampler='halton'), Status.INVALID_ARGUMENT, "'halton'"),
                (dict(some, sigma_error=-0.1), Status.INVALID_ARGUMENT, 'sigma_error: is -0.1'),
                (dict(some, sigma_error=nan), Status.INVALID_ARGUMENT, 'sigma_error: is nan'),
                (dict(some, sigma_error=0.1, sampler='latin_hypercube'), Status.INVALID_ARGUMENT, 'latin_hypercube'),
                (dict(some, confidence=1), Status.INVALID_ARGUMENT, 'confidence: is 1'),
                (dict(some, sections=1), Status.INVALID_ARGUMENT, 'sections: is 1, expected 2 to 2000'),
                (dict(some, sections=2001), Status.INVALID_ARGUMENT, 'sections: is 2001'),
                (dict(some, sample_shapes=501), Status.INVALID_ARGUMENT, 'sample_shapes: is 501'),
                (dict(some, show='sigma'), Status.INVALID_ARGUMENT, "show: is 'sigma'"),
                (dict(some, from_time=1), Status.INVALID_ARGUMENT, 'from_time: is 1'),
                (dict(some, motions=['sway'], to_time=3), Status.INVALID_ARGUMENT, 'to_time: is 3'),
                (dict(some, name='../x'), Status.INVALID_ARGUMENT, "'../x'"),
                (dict(some, nominal_variables=['b_z']), Status.INVALID_ARGUMENT, '0 values'),
                (dict(some, nominal_variables=['b_z'], nominal_values=[1]), Status.NOT_CONVERGED, '')):
            answer = self.simulate(**request)
            self.assertRefused(answer.status, code, part)
            self.assertEqual((answer.samples, answer.measures, answer.cables), (0, [], []))
        self.assertEqual(self.latched('/cable_solver/variation', MarkerArray), shown)

    def test_tolerances_that_leave_the_physical_are_refused_by_name(self):
        # That of the scene itself is refused with the scene; this is of another design.
        node, _ = self.solver(scene=DATA + 'hanging.yaml')
        answer = self.service(node + '/simulate_variation', SimulateVariation)(
            variables=['*'], samples=10, nominal_variables=['tail_length'], nominal_values=[0.0045])
        self.assertRefused(answer.status, Status.INVALID_ARGUMENT, "'tail_length'", '-0.005 m')

    def test_it_is_shown_until_the_design_changes(self):
        answer = self.simulate(variables=['*'], samples=200, sample_shapes=7, sections=21)
        self.assertSuccess(answer.status)
        self.assertEqual(self.namespaces(), {'variation/strand', 'variation_shapes/strand'})
        lines = self.markers()['variation_shapes/strand', 0]
        self.assertEqual((lines.type, len(lines.points)), (Marker.LINE_LIST, 7 * 20 * 2))
        self.assertTrue(0 < lines.color.a < 1)
        legend = self.legend()
        self.assertEqual((legend.unit, legend.samples, legend.topic), ('mm', 200, '/cable_solver/variation'))
        self.assertIn('6 sigma', legend.quantity)
        self.assertIn('7 of the samples', legend.note)
        self.assertAlmostEqual(legend.maximum, 1e3 * max(answer.cables[0].six_sigma), places=9)
        colours = {(each.color.r, each.color.g, each.color.b) for (ns, _), each in self.markers().items()
                   if ns == 'variation/strand'}
        self.assertGreater(len(colours), 20)

        answer = self.simulate(variables=['*'], samples=200, show='range')
        self.assertIn('range', self.legend().quantity)
        self.assertAlmostEqual(self.legend().maximum, 1e3 * max(answer.cables[0].range), places=9)
        self.assertEqual(self.markers()['variation_shapes/strand', 0].action, Marker.DELETE)

        self.assertSuccess(self.set_design(variables=['b_z'], values=[0.001]).status)
        self.assertEqual((self.namespaces(), self.legend().title), (set(), ''))

        # It takes the place of an analysis, which then no longer follows the design, and the other way round.
        analyze = self.service('/cable_solver/analyze_stability', AnalyzeStability)
        self.assertSuccess(analyze(skip_low_high=True).status)
        self.assertEqual(self.namespaces(), {'sensitivity/strand'})
        self.assertSuccess(self.simulate(variables=['*'], samples=200).status)
        self.assertEqual(self.namespaces(), {'variation/strand'})
        self.assertSuccess(self.set_design(variables=['b_z'], values=[0.0]).status)
        self.assertEqual(self.namespaces(), set())
        self.assertSuccess(analyze(skip_low_high=True).status)
        self.assertSuccess(self.set_design(variables=['b_z'], values=[0.001]).status)
        self.assertEqual(self.namespaces(), {'sensitivity/strand'})

    def test_the_action_tells_how_far_it_is(self):
        client, told = self.client(), []
        client.send_goal(SimulateVariationGoal(variables=['*'], samples=20000, seed=3), feedback_cb=told.append)
        self.assertTrue(self.finished(client, 3 * self.TIMEOUT))
        self.assertEqual(client.get_state(), GoalStatus.SUCCEEDED)
        result = client.get_result()
        self.assertSuccess(result.status)
        self.assertGreater(len(told), 1)
        self.assertTrue(all(a.elapsed < b.elapsed and a.samples <= b.samples for a, b in zip(told, told[1:])))
        self.assertGreater(len({each.samples for each in told}), len(told) // 3)  # figures keep up
        last = told[-1]
        self.assertTrue(0 < last.samples <= 20000 and last.wanted == 20000 and last.measures == MEASURES)
        self.assertTrue(0 <= last.remaining < 60)
        self.assertEqual((len(last.mean), len(last.sigma), last.failed), (3, 3, 0))
        # What runs ahead of the end is near it: five standard errors.
        self.assertAlmostEqual(last.sigma[2], END_SIGMA, delta=5 * END_SIGMA / (2 * last.samples) ** 0.5)
        same = self.simulate(variables=['*'], samples=20000, seed=3)
        self.assertEqual(figures(same), figures(result))

    def test_bad_goals_are_aborted(self):
        client = self.client()
        client.send_goal(SimulateVariationGoal(variables=['b_zz']))
        self.assertTrue(self.finished(client))
        self.assertEqual(client.get_state(), GoalStatus.ABORTED)
        self.assertRefused(client.get_result().status, Status.NOT_FOUND, "'b_zz'")

    def test_a_cancel_keeps_what_was_done_and_others_are_answered_meanwhile(self):
        node, folder = self.solver()
        client = self.client(node)
        self.begin(client, name='run_1', **ENDLESS)
        self.assertSuccess(self.service(node + '/solve_equilibrium', SolveEquilibrium)().status)
        busy = self.service(node + '/simulate_variation', SimulateVariation)(variables=['b_z'], name='run_1')
        self.assertRefused(busy.status, Status.INVALID_ARGUMENT, "'run_1'")
        start = time.time()
        client.cancel_goal()
        self.assertTrue(self.finished(client))
        self.assertPrompt(time.time() - start, 'a cancel')
        self.assertEqual(client.get_state(), GoalStatus.PREEMPTED)
        result = client.get_result()
        self.assertRefused(result.status, Status.CANCELLED, '%d of 1000000000 samples' % result.samples)
        self.assertGreater(result.samples, 1000)
        self.assertEqual(result.samples_file, os.path.join(folder, 'run_1.csv.partial'))
        values, = numbers(result.samples_file, 'end_height')
        self.assertEqual(len(values), result.samples)
        self.assertAlmostEqual(result.measures[2].sigma, values.std(ddof=1), places=12)
        self.assertIn('Ended early', open(result.report_file).read())

    def test_a_new_goal_takes_the_place_of_the_old_one(self):
        first, second = self.client(), self.client()
        self.begin(first, **ENDLESS)
        second.send_goal(SimulateVariationGoal(variables=['b_z'], samples=100))
        self.assertTrue(self.finished(first))
        self.assertEqual(first.get_result().status.code, Status.CANCELLED)
        self.assertTrue(self.finished(second))
        self.assertEqual(second.get_state(), GoalStatus.SUCCEEDED)

    def test_what_is_late_is_not_shown(self):
        client = self.client()
        self.begin(client, variables=['*'], samples=30000)
        self.assertSuccess(self.set_design(variables=['b_z'], values=[0.002]).status)
        self.assertTrue(self.finished(client, 3 * self.TIMEOUT))
        self.assertSuccess(client.get_result().status)
        self.assertIn('not shown', ' '.join(client.get_result().warnings))
        self.assertEqual(self.namespaces(), set())

    def test_a_full_disk_costs_no_statistics(self):
        node, folder = self.solver(largest_file=300000)
        answer = self.service(node + '/simulate_variation', SimulateVariation)(
            variables=['*'], samples=20000, name='run_1')
        partial = os.path.join(folder, 'run_1.csv.partial')
        self.assertRefused(answer.status, Status.IO_ERROR, partial, os.strerror(27))  # EFBIG
        self.assertEqual((answer.samples, answer.samples_file), (20000, partial))
        self.assertEqual(os.path.getsize(partial), 300000)
        node, _ = self.solver()
        whole = self.service(node + '/simulate_variation', SimulateVariation)(variables=['*'], samples=20000)
        self.assertEqual(str(whole.measures), str(answer.measures))
        xml.dom.minidom.parse(answer.report_file)

    def test_a_folder_that_cannot_be_written_is_named_at_once(self):
        with tempfile.NamedTemporaryFile() as file:
            below = os.path.join(file.name, 'below')
            node, _ = self.solver(output_directory=below)
            answer = self.service(node + '/simulate_variation', SimulateVariation)(name='run_1', **ENDLESS)
            self.assertRefused(answer.status, Status.IO_ERROR, below)
            self.assertEqual(answer.samples, 0)

    def test_a_node_ends_in_the_middle_of_a_run(self):
        node, _ = self.solver()
        self.begin(self.client(node), **ENDLESS)  # the clean-up waits for its end


if __name__ == '__main__':
    rospy.init_node('simulate_variation_test')
    rostest.rosrun('cable_variation', 'simulate_variation', SimulateVariationTest, sys.argv)
