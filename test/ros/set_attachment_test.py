#!/usr/bin/env python3
"""cable_solver closes and opens clips, asked by ~set_attachment or by the time of a motion."""
import math
import sys
import threading

import rospy
import rostest
from cable_variation.msg import CableEvent, MotionState, Status
from cable_variation.srv import GetScene, SetAttachment, SetAttachmentRequest
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger


def places(answer):
    return [xyz(section.position) for section in answer.shapes[0].section]


class SetAttachmentTest(NodeTest):
    def setUp(self):
        self.events = []
        self.lock = threading.Lock()
        self.subscriber = rospy.Subscriber('/cable_solver/events', CableEvent, self.take, queue_size=100)
        self.ask = self.service('/cable_solver/set_attachment', SetAttachment)
        self.assertTrue(self.service('/cable_solver/reset_design', Trigger)().success)
        self.eventually(self.subscriber.get_num_connections, 'cable_solver')
        self.motion = rospy.Publisher('/cable_solver/motion_state', MotionState, queue_size=1)
        self.eventually(self.motion.get_num_connections, 'cable_solver hears the motion')
        with self.lock:
            self.events = []

    def take(self, event):
        with self.lock:
            self.events.append(event)

    def told(self, kind):
        with self.lock:
            return [event for event in self.events if event.kind == kind]

    def attached(self):
        scene = self.service('/cable_solver/get_scene', GetScene)()
        return {clip.name: clip.attached for clip in scene.clips}

    def test_an_opened_clip_lets_go_and_takes_hold_again(self):
        opened = self.ask(clip='B', attached=False)
        self.assertSuccess(opened.status)
        self.assertEqual(self.attached(), {'A': True, 'B': False, 'C': False, 'ring': False})
        self.assertLess(opened.energy.total, opened.energy_before)
        self.assertGreater(opened.distance, 0.05)
        self.assertGreater(opened.smallest_eigenvalue, 0)
        reactions = {each.clip: each.force for each in opened.clip_reactions}
        self.assertEqual(xyz(reactions['B']), (0, 0, 0))
        weight = 0.312 * math.pi * 0.004 ** 2 * 2000 * 9.81
        self.assertAlmostEqual(reactions['A'].z, weight, delta=1e-6 * weight)
        self.assertEqual({each.name: each.value for each in opened.measures}['end_force'], 0)
        self.assertEqual([event.clip for event in opened.events], ['B'])
        self.eventually(lambda: self.told(CableEvent.CLIP_OPENED), 'the event')
        self.assertAlmostEqual(self.told(CableEvent.CLIP_OPENED)[0].distance, opened.distance)

        self.assertRefused(self.ask(clip='B', attached=True).status, Status.INVALID_ARGUMENT,
                           "clip 'B' cannot take hold of cable 'strand'", 'mm away, expected at most 20 mm')
        self.assertFalse(self.attached()['B'])
        closed = self.ask(clip='B', attached=True, reach=1.0)
        self.assertSuccess(closed.status)
        self.assertGreater(closed.gap, 0.02)
        for got, wanted in zip(xyz(closed.shapes[0].section[-1].position), (0.25, 0, 0)):
            self.assertAlmostEqual(got, wanted, delta=1e-9)
        self.eventually(lambda: self.told(CableEvent.CLIP_CLOSED), 'the event')

    def test_a_connector_is_handed_over_where_it_is(self):
        self.assertRefused(self.ask(clip='C', attached=True).status, Status.INVALID_ARGUMENT,
                           "clip 'B' and clip 'C' both hold cable 'strand'")
        handed = self.ask(clip='C', attached=True, opens=['B'])
        self.assertSuccess(handed.status)
        self.assertLess(handed.distance, 1e-4)
        self.assertEqual(self.attached(), {'A': True, 'B': False, 'C': True, 'ring': False})
        self.assertEqual(sorted(event.clip for event in handed.events), ['B', 'C'])

    def test_a_ring_takes_the_closest_section(self):
        taken = self.ask(clip='ring', attached=True, reach=0.1)
        self.assertSuccess(taken.status)
        self.assertGreater(taken.gap, 0)
        ring = [each for each in taken.clip_reactions if each.clip == 'ring'][0]
        for got, wanted in zip(xyz(ring.section.position), (0.12, 0, -0.05)):
            self.assertAlmostEqual(got, wanted, delta=1e-6)

    def test_what_cannot_be_is_refused_and_changes_nothing(self):
        before = self.attached()
        for request, code, part in (
                ({'clip': 'Z'}, Status.NOT_FOUND, "no clip named 'Z'"),
                ({'clip': 'A', 'attached': True}, Status.INVALID_ARGUMENT, "clip 'A' is closed already"),
                ({'clip': 'C', 'attached': False}, Status.INVALID_ARGUMENT, "clip 'C' is open already"),
                ({'clip': 'A', 'opens': ['B']}, Status.INVALID_ARGUMENT, 'held by no attached clip'),
                ({'clip': 'A', 'opens': ['A']}, Status.INVALID_ARGUMENT, 'given twice'),
                ({'clip': 'B', 'reach': -1.0}, Status.INVALID_ARGUMENT, 'reach'),
                ({'clip': 'B', 'section': 7}, Status.INVALID_ARGUMENT, 'section')):
            answer = self.ask(SetAttachmentRequest(**request))
            self.assertRefused(answer.status, code, part)
            self.assertEqual(answer.shapes, [])
        self.assertEqual(self.attached(), before)

    def test_the_scene_closes_and_opens_clips_by_the_time_of_its_motion(self):
        self.motion.publish(time=0.6, duration=2, playing=True)
        self.eventually(lambda: self.told(CableEvent.CLIP_CLOSED), 'C closes')
        self.assertEqual(self.attached(), {'A': True, 'B': False, 'C': True, 'ring': False})
        self.motion.publish(time=0.1, duration=2, playing=True)  # again from the start
        self.eventually(lambda: self.attached() == {'A': True, 'B': True, 'C': False, 'ring': False}, 'back')

    def test_a_clip_that_is_too_far_at_its_time_is_told_once(self):
        self.assertSuccess(self.ask(clip='B', attached=False).status)
        for time in (0.6, 0.65, 0.7):
            self.motion.publish(time=time, duration=2, playing=True)
            rospy.sleep(0.1)
        refused = self.eventually(lambda: self.told(CableEvent.CLIP_REFUSED), 'C is refused')
        self.assertEqual(len(refused), 1)
        self.assertEqual(refused[0].clip, 'C')
        self.assertIn('mm away, expected at most 30 mm', refused[0].text)
        self.motion.publish(time=0.1, duration=2, playing=True)  # back: B holds what it then held, far as it fell
        self.eventually(lambda: self.attached() == {'A': True, 'B': True, 'C': False, 'ring': False}, 'back')
        self.assertEqual(len(self.told(CableEvent.CLIP_REFUSED)), 1)


if __name__ == '__main__':
    rospy.init_node('set_attachment_test')
    rostest.rosrun('cable_variation', 'set_attachment', SetAttachmentTest, sys.argv)
