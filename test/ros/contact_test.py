#!/usr/bin/env python3
"""cable_solver with a cable that lies on a table: what is answered, shown, and refused."""
import math
import sys

import rospy
import rostest
from cable_variation.msg import ClipEdit, Labels, Status
from cable_variation.srv import (AnalyzeStability, GenerateEnvelope, GetScene, SetDesign, SimulateVariation,
                                 SolveEquilibrium)
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger
from visualization_msgs.msg import MarkerArray

WEIGHT = 0.4 * 0.07 * 9.81  # [N]


class ContactTest(NodeTest):
    def arrows(self):
        markers = self.latched('/cable_solver/cables', MarkerArray).markers
        return [marker for marker in markers if marker.ns == 'contact/cable' and marker.action == marker.ADD]

    def test_what_touches_is_answered(self):
        answer = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)()
        self.assertSuccess(answer.status)
        self.assertLess(abs(answer.smallest_gap), 1e-5)
        self.assertTrue(math.isnan(answer.smallest_eigenvalue))
        self.assertEqual({(each.cable, each.component) for each in answer.contacts}, {('cable', 'table')})
        lifted = sum(each.force.z for each in answer.contacts)
        held = answer.clip_reactions[0].force.z
        self.assertAlmostEqual(lifted + held, WEIGHT, delta=1e-4 * WEIGHT)
        self.assertGreater(lifted, 0.4 * WEIGHT)
        for each in answer.contacts:
            self.assertAlmostEqual(sum(force.z for force in each.place_force), each.force.z, delta=1e-9)
            self.assertTrue(all(each.start <= s <= each.end for s in each.arc_length))
            self.assertTrue(all(abs(point.z) < 1e-9 for point in each.on_component))
        self.assertAlmostEqual(max(each.end for each in answer.contacts), 0.4, delta=4e-3)
        lowest = min(point.z for point in answer.shapes[0].centreline)
        self.assertAlmostEqual(lowest, 0.004, delta=1e-5)

        measures = {each.name: each for each in answer.measures}
        self.assertAlmostEqual(measures['pressed'].value, sum(each.total for each in answer.contacts), delta=1e-9)
        self.assertAlmostEqual(measures['lying'].value, sum(each.end - each.start for each in answer.contacts), delta=1e-9)
        lifted = (72 * 2e-4 * 0.04 / (0.07 * 9.81)) ** 0.25  # of a long cable that bends little
        self.assertAlmostEqual(measures['lying'].value, 0.4 - lifted, delta=0.02)
        self.assertTrue(measures['lying'].within)
        self.assertLess(abs(measures['gap'].value), 1e-5)
        self.assertTrue(math.isnan(measures['moment'].value))
        self.assertFalse(measures['moment'].within)
        self.assertIn('not yet known where a cable touches a part', measures['moment'].note)

    def test_the_scene_tells_what_may_touch(self):
        contacts = self.service('/cable_solver/get_scene', GetScene)().contacts
        self.assertEqual([(each.cable, each.component, each.stand_off) for each in contacts], [('cable', 'table', 0)])

    def test_forces_are_shown_and_follow_the_design(self):
        shown = self.arrows()
        self.assertGreater(len(shown), 3)
        for arrow in shown:
            start, end = (xyz(point) for point in arrow.points)
            self.assertGreater(end[2], start[2])
            self.assertAlmostEqual(start[2], 0.008, delta=1e-4)
        first = min(arrow.points[0].x for arrow in shown)
        labels = self.latched('/cable_solver/labels', Labels).labels
        self.assertTrue(any(label.text.endswith(' N') for label in labels), labels)

        edit = ClipEdit(clip='A')
        edit.translation.z = 0.04
        self.assertSuccess(self.service('/cable_solver/set_design', SetDesign)(clips=[edit]).status)
        higher = self.eventually(lambda: [a for a in [self.arrows()] if a and a[0] != shown[0]], 'other arrows')[0]
        self.assertGreater(min(arrow.points[0].x for arrow in higher), first + 0.01)
        self.assertTrue(self.service('/cable_solver/reset_design', Trigger)().success)

    def test_analyses_count_contact(self):
        answer = self.service('/cable_solver/analyze_stability', AnalyzeStability)()
        self.assertSuccess(answer.status)
        self.assertTrue(answer.variables)
        answer = self.service('/cable_solver/simulate_variation', SimulateVariation)(samples=20, variables=['*'])
        self.assertSuccess(answer.status)
        self.assertEqual(answer.solved, 20)

    def test_what_does_not_know_contact_says_so(self):
        answer = self.service('/cable_solver/generate_envelope', GenerateEnvelope)(variables=['*'])
        self.assertRefused(answer.status, Status.INVALID_ARGUMENT, 'contact is not yet known to',
                           "cable 'cable' has contact with part 'table'")


if __name__ == '__main__':
    rospy.init_node('contact_test')
    rostest.rosrun('cable_variation', 'contact', ContactTest, sys.argv)
