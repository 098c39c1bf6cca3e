#!/usr/bin/env python3
"""A client that is killed in the middle of a long action: its run ends, and others go on. Run with the name of an action,
this is such a client."""
import subprocess
import sys
import time

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from cable_variation.msg import (GenerateEnvelopeAction, GenerateEnvelopeActionFeedback, GenerateEnvelopeGoal,
                                 SimulateVariationAction, SimulateVariationActionFeedback, SimulateVariationActionGoal,
                                 SimulateVariationGoal)
from node_client import NodeTest

ACTIONS = {
    'generate_envelope': (GenerateEnvelopeAction, GenerateEnvelopeActionFeedback, GenerateEnvelopeGoal(
        variables=['*'], motions=['sway'], verification_shapes=10000000)),
    'simulate_variation': (SimulateVariationAction, SimulateVariationActionFeedback, SimulateVariationGoal(
        variables=['*'], samples=1000000000)),
}


def topic(name, which):
    return '/cable_solver/%s_action/%s' % (name, which)


class VanishedClientTest(NodeTest):
    def goals(self, name):
        """What has become of each."""
        told = rospy.wait_for_message(topic(name, 'status'), GoalStatusArray, timeout=self.TIMEOUT).status_list
        return {goal.goal_id.id: goal.status for goal in told}

    def client(self, how, name):
        """A process that has an endless goal at work, and the goal."""
        before = self.goals(name)
        client = subprocess.Popen([sys.executable, __file__, how, name])
        self.addCleanup(client.wait)
        self.addCleanup(client.kill)

        def begun():
            return [goal for goal, status in self.goals(name).items() if goal not in before and status == GoalStatus.ACTIVE]
        goal = self.eventually(begun, 'a goal of %s at work' % name)[0]
        rospy.wait_for_message(topic(name, 'feedback'), ACTIONS[name][1], timeout=self.TIMEOUT)
        return client, goal

    def vanish(self, name):
        client, goal = self.client('client', name)
        client.kill()
        self.eventually(lambda: self.goals(name)[goal] == GoalStatus.PREEMPTED, 'the run of %s ends' % name)

    def test_the_run_ends(self):
        for name in ACTIONS:
            self.vanish(name)

    def test_the_next_client_is_served(self):
        for name, (kind, _, _) in ACTIONS.items():
            self.vanish(name)
            client = actionlib.SimpleActionClient('/cable_solver/%s_action' % name, kind)
            self.assertTrue(client.wait_for_server(rospy.Duration(self.TIMEOUT)))
            goal = type(ACTIONS[name][2])(variables=['b_z'])
            client.send_goal(goal)
            self.assertTrue(self.finished(client, 3 * self.TIMEOUT))
            self.assertEqual(client.get_state(), GoalStatus.SUCCEEDED)

    def test_who_never_listened_is_not_missed(self):
        client, goal = self.client('publisher', 'simulate_variation')
        client.kill()
        client.wait()
        time.sleep(1)
        self.assertEqual(self.goals('simulate_variation')[goal], GoalStatus.ACTIVE)
        self.vanish('simulate_variation')  # its goal takes the place of that one
        self.assertEqual(self.goals('simulate_variation')[goal], GoalStatus.PREEMPTED)


def be_publisher(name):
    """As `rostopic pub` is."""
    rospy.init_node('publisher', anonymous=True)
    publisher = rospy.Publisher(topic(name, 'goal'), SimulateVariationActionGoal, queue_size=1, latch=True)
    publisher.publish(SimulateVariationActionGoal(goal=ACTIONS[name][2]))
    rospy.spin()


def be_client(name):
    rospy.init_node('client', anonymous=True)
    kind, _, goal = ACTIONS[name]
    client = actionlib.SimpleActionClient('/cable_solver/%s_action' % name, kind)
    client.wait_for_server()
    client.send_goal(goal)
    rospy.spin()


if __name__ == '__main__':
    if sys.argv[1:2] == ['client']:
        be_client(sys.argv[2])
    elif sys.argv[1:2] == ['publisher']:
        be_publisher(sys.argv[2])
    else:
        rospy.init_node('vanished_client_test')
        rostest.rosrun('cable_variation', 'vanished_client', VanishedClientTest, sys.argv)
