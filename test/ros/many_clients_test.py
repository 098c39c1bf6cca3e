#!/usr/bin/env python3
"""A hundred clients at once: none is refused, none is answered wrongly; quick answers while an envelope is made; and
more long runs than may wait are told so."""
import sys
import threading
import time

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from cable_variation.msg import GenerateEnvelopeAction, GenerateEnvelopeGoal, Status
from cable_variation.srv import AnalyzeStability, GetScene, SimulateVariation, SolveEquilibrium
from node_client import NodeTest, xyz

CLIENTS = 100
ROUNDS = 3  # of each


def places(answer):
    return [xyz(section.position) for section in answer.shapes[0].section]


class ManyClientsTest(NodeTest):
    def setUp(self):
        self.solve = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)

    def test_a_hundred_at_once_are_answered_as_one(self):
        values = [1e-4 * (i - CLIENTS // 2) for i in range(CLIENTS)]
        start = time.time()
        alone = [places(self.solve(variables=['b_z'], values=[value])) for value in values]
        single = (time.time() - start) / CLIENTS
        answers = [[] for _ in values]
        times = []
        begin = threading.Barrier(CLIENTS)

        def ask(i):
            proxy = rospy.ServiceProxy('/cable_solver/solve_equilibrium', SolveEquilibrium)
            begin.wait()
            for _ in range(ROUNDS):
                start = time.time()
                answers[i].append(proxy(variables=['b_z'], values=[values[i]]))
                times.append(time.time() - start)
        threads = [threading.Thread(target=ask, args=(i,)) for i in range(CLIENTS)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for mine, right in zip(answers, alone):
            self.assertEqual(len(mine), ROUNDS)
            for answer in mine:
                self.assertSuccess(answer.status)
                self.assertEqual(places(answer), right)
        print('one alone %.1f ms, 95 %% of a hundred at once within %.0f ms' % (
            1e3 * single, 1e3 * sorted(times)[int(0.95 * len(times))]))

    def test_quick_answers_while_an_envelope_is_made(self):
        def latencies():
            times = []
            for i in range(50):
                start = time.time()
                self.assertSuccess(self.solve(variables=['b_z'], values=[1e-4 * (i - 25)]).status)
                self.service('/cable_solver/get_scene', GetScene)()
                self.assertSuccess(self.service('/cable_solver/analyze_stability', AnalyzeStability)().status)
                times.append(time.time() - start)
            return sorted(times)
        before = latencies()
        client = actionlib.SimpleActionClient('/cable_solver/generate_envelope_action', GenerateEnvelopeAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(self.TIMEOUT)))
        told = []
        client.send_goal(GenerateEnvelopeGoal(variables=['*'], motions=['sway'], verification_shapes=10000000),
                         feedback_cb=told.append)
        self.eventually(lambda: told and told[-1].solves > 0, 'progress')
        meanwhile = latencies()
        self.assertEqual(client.get_state(), GoalStatus.ACTIVE)
        client.cancel_goal()
        self.assertTrue(self.finished(client))
        self.assertEqual(client.get_result().status.code, Status.CANCELLED)
        print('three services, median and 95 %%: alone %.1f and %.1f ms, meanwhile %.1f and %.1f ms' % tuple(
            1e3 * times[int(share * len(times))] for times in (before, meanwhile) for share in (0.5, 0.95)))
        self.assertPrompt(meanwhile[-1], 'the slowest three services beside an envelope')

    def test_more_than_may_wait_are_busy_at_once(self):
        answers = []  # (seconds, its status, mean of the first measure), as they come
        clients, served = 12, 5  # one at work and four that wait
        begin = threading.Barrier(clients)

        def ask():
            proxy = self.service('/cable_solver/simulate_variation', SimulateVariation)
            begin.wait()
            start = time.time()
            answer = proxy(variables=['*'], samples=20000, seed=3)
            answers.append((time.time() - start, answer.status, [each.mean for each in answer.measures]))
        threads = [threading.Thread(target=ask) for _ in range(clients)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        right = [each for each in answers if each[1].code == Status.SUCCESS]
        busy = [each for each in answers if each[1].code != Status.SUCCESS]
        self.assertGreaterEqual(len(right), served)
        self.assertEqual(len(right) + len(busy), clients)
        for _, status, _ in busy:
            self.assertRefused(status, Status.CANCELLED, 'busy', '4 wait')
        for _, _, means in right:
            self.assertEqual(means, right[0][2])
        print('%d of %d simulations served, the others told to be busy within %.0f ms' % (
            len(right), clients, 1e3 * max([each[0] for each in busy], default=0.0)))
        # who comes later is served
        self.assertSuccess(self.service('/cable_solver/simulate_variation', SimulateVariation)(
            variables=['*'], samples=10).status)


if __name__ == '__main__':
    rospy.init_node('many_clients_test')
    rostest.rosrun('cable_variation', 'many_clients', ManyClientsTest, sys.argv)
