#!/usr/bin/env python3
"""compare_answers finds what differs between two answers, and nothing else."""
import io
import os
import struct
import subprocess
import sys
import tempfile
import unittest

import cable_variation.msg
import cable_variation.srv
import rospy
from cable_variation.msg import CableInfo, ClipInfo, DesignVariableInfo, Energy, MeasureInfo, MotionInfo, Status
from cable_variation.srv import GetSceneResponse, SolveEquilibriumResponse
from geometry_msgs.msg import Point, PoseStamped

SCRIPTS = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'scripts')
sys.path.insert(0, SCRIPTS)
from answers import NO_ANSWER, definition_differences, definitions, differences, plain  # noqa: E402
from ask_nodes import filled, service_kind, title  # noqa: E402
from fixed_requests import fixed_requests  # noqa: E402


def compared(old, new, folder='/nowhere'):
    return list(differences(plain(old, folder), plain(new, folder)))


def equilibrium():
    answer = SolveEquilibriumResponse(smallest_eigenvalue=271.5, warnings=['near a snap'])
    answer.energy = Energy(elastic=0.25, total=0.25)
    return answer


class ComparisonTest(unittest.TestCase):
    def test_equal_answers_have_no_differences(self):
        self.assertEqual(compared(equilibrium(), equilibrium()), [])

    def test_every_field_that_is_not_left_out_counts(self):
        """Each number and text of an answer, changed by itself, is found with its path and both values."""
        for field, value in (('smallest_eigenvalue', 271.0), ('iterations', 3), ('residual', 1e-12),
                             ('discretisation_error', 1e-9)):
            answer = equilibrium()
            was = getattr(answer, field)
            setattr(answer, field, value)
            self.assertEqual(compared(equilibrium(), answer), [(field, was, value)])

    def test_the_last_bit_of_a_nested_number_is_found(self):
        answer = equilibrium()
        next_one = struct.unpack('<d', struct.pack('<q', struct.unpack('<q', struct.pack('<d', 0.25))[0] + 1))[0]
        answer.energy.total = next_one
        self.assertEqual(compared(equilibrium(), answer), [('energy.total', 0.25, next_one)])

    def test_zeros_of_two_signs_differ_and_what_is_no_number_does_not(self):
        self.assertEqual(len(compared(Point(x=0.0), Point(x=-0.0))), 1)
        self.assertEqual(compared(Point(x=float('nan')), Point(x=-float('nan'))), [])
        self.assertEqual(len(compared(Point(x=float('nan')), Point(x=0.0))), 1)

    def test_lists_of_two_lengths_differ_also_where_both_have_an_entry(self):
        old, new = GetSceneResponse(warnings=['a', 'b']), GetSceneResponse(warnings=['c'])
        self.assertEqual(compared(old, new), [('length of warnings', 2, 1), ('warnings[0]', 'a', 'c')])
        old, new = GetSceneResponse(measures=[MeasureInfo(lower=1.0)]), GetSceneResponse(measures=[MeasureInfo()])
        self.assertEqual(compared(old, new), [('measures[0].lower', 1.0, 0.0)])

    def test_durations_times_of_day_and_the_folder_of_the_sources_do_not_count(self):
        fast, slow = equilibrium(), equilibrium()
        fast.solve_time, slow.solve_time = 1e-3, 2e-3
        self.assertEqual(compared(fast, slow), [])
        early, late = PoseStamped(), PoseStamped()
        early.header.stamp, late.header.stamp = rospy.Time(1), rospy.Time(2)
        self.assertEqual(compared(early, late), [])
        here, there = Status(message='/here/a.yaml:3: no'), Status(message='/there/a.yaml:3: no')
        self.assertEqual(list(differences(plain(here, '/here'), plain(there, '/there'))), [])
        self.assertEqual(len(compared(here, there)), 1)
        early, late = (plain('at 2024-01-02 %s' % time, '/here') for time in ('03:04', '05:06'))
        self.assertEqual(list(differences(early, late)), [])

    def test_a_time_of_a_motion_counts(self):
        """Only names of durations are left out, not all that end like them."""
        old, new = {'nominal_time': 1.0, 'time': 2.0}, {'nominal_time': 1.5, 'time': 2.5}
        self.assertEqual(len(list(differences(old, new))), 2)

    def test_no_answer_is_no_answer_without_fields(self):
        self.assertEqual(len(list(differences({NO_ANSWER: 'ended'}, plain(equilibrium(), '')))), 1)

    def test_fields_that_one_has_are_told_and_the_others_compared(self):
        old, new = {'Point': {'x': 'float64', 'y': 'float64'}}, {'Point': {'x': 'float32', 'z': 'float64'}, 'Line': {}}
        self.assertEqual(list(definition_differences(old, new)),
                         ['Line: only in NEW', 'Point.x: float64 in OLD, float32 in NEW', 'Point.y: only in OLD',
                          'Point.z: only in NEW'])
        self.assertEqual(list(differences({'x': 1.0, 'y': 2.0}, {'x': 3.0, 'z': 4.0})), [('x', 1.0, 3.0)])

    def test_definitions_have_fields_and_constants(self):
        found = definitions(cable_variation.msg)
        self.assertEqual(found['Energy']['total'], 'float64')
        self.assertEqual(found['Status']['UNSTABLE'], 'constant')
        self.assertEqual(list(definition_differences(found, found)), [])


class RequestTest(unittest.TestCase):
    def requests(self):
        return list(fixed_requests(GetSceneResponse(
            design_variables=[DesignVariableInfo(name='x', lower=-1.0, upper=1.0)], measures=[MeasureInfo(name='m')],
            cables=[CableInfo(name='c', length=1.0)], clips=[ClipInfo(name='k')],
            motions=[MotionInfo(name='run', duration=2.0)]), 'scene.yaml'))

    def test_no_two_requests_have_one_title(self):
        titles = [title(each) for each in self.requests()]
        self.assertEqual(sorted(titles), sorted(set(titles)))

    def test_all_fields_asked_with_are_those_of_the_messages(self):
        """One that an older build does not have is left out there, so a wrong name would not be noticed."""
        for request in self.requests():
            if request['how'] != 'topic':
                message = service_kind(request['kind'])._request_class()
                self.assertLessEqual(set(request['fields']), set(message.__slots__), title(request))
                filled(message, request['fields']).serialize(io.BytesIO())

    def test_every_service_and_action_of_the_package_is_called(self):
        asked = {each['kind'] for each in self.requests() if each['how'] == 'service'}
        services = {name for name, kind in vars(cable_variation.srv).items() if hasattr(kind, '_request_class')}
        self.assertEqual(services - asked, set())
        acted = {each['kind'] + 'Action' for each in self.requests() if each['how'] == 'action'}
        actions = {name for name in vars(cable_variation.msg) if name.endswith('Action') and not name.startswith('_')}
        self.assertEqual(actions - acted, set())


class ProgramTest(unittest.TestCase):
    def test_a_folder_that_is_no_build_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, os.path.join(SCRIPTS, 'compare_answers'), folder, folder],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("'%s' is no build: it has no devel/env.sh" % folder, done.stderr)


if __name__ == '__main__':
    unittest.main()
