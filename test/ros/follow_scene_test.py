#!/usr/bin/env python3
"""What ~load_scene changes is shown by all nodes, and told by the solver's ~design."""
import sys

import rospy
import rostest
from cable_variation.msg import DesignState, MotionState, Status
from cable_variation.srv import LoadScene, Seek, SetDesign
from node_client import NodeTest
from std_srvs.srv import SetBool, Trigger
from visualization_msgs.msg import Marker, MarkerArray

DATA = 'package://cable_variation/test/ros/data/'


class FollowSceneTest(NodeTest):
    def setUp(self):
        self.load_scene = self.service('/cable_solver/load_scene', LoadScene)
        self.assertSuccess(self.load_scene(DATA + 'strand.yaml').status)

    def design(self):
        return self.latched('/cable_solver/design', DesignState)

    def components(self, node):
        """Names of the components that a node has added last, by its latched topic."""
        markers = self.latched('/%s/components' % node, MarkerArray).markers
        return {each.ns for each in markers if each.action == Marker.ADD}

    def shown(self, node, expected):
        expected = {'component/' + name for name in expected}
        self.eventually(lambda: self.components(node) == expected, '%s shows %s' % (node, expected))

    def test_parts_and_motions_of_another_scene_take_the_place_of_the_old_ones(self):
        self.assertSuccess(self.load_scene(DATA + 'envelope.yaml').status)
        self.shown('static_geometry_node', {'floor', 'shelf'})
        self.eventually(lambda: self.latched('/moving_geometry_node/motion_state', MotionState).duration > 0,
                        'the motion of the scene loaded')
        self.assertTrue(self.service('/moving_geometry_node/play', SetBool)(False).success)
        self.assertSuccess(self.service('/moving_geometry_node/seek', Seek)(0.5).status)

        def halted():
            state = self.latched('/moving_geometry_node/motion_state', MotionState)
            return not state.playing and state.time == 0.5
        self.eventually(halted, 'the state of a motion that is halted')
        self.assertSuccess(self.load_scene(DATA + 'other.yaml').status)
        self.shown('static_geometry_node', set())
        self.eventually(lambda: self.latched('/moving_geometry_node/motion_state', MotionState).duration == 0,
                        'a scene without a motion')
        self.assertFalse(self.service('/moving_geometry_node/play', SetBool)(True).success)

    def test_a_broken_scene_changes_nothing(self):
        self.assertSuccess(self.load_scene(DATA + 'envelope.yaml').status)
        self.shown('static_geometry_node', {'floor', 'shelf'})
        before = self.design()
        self.assertRefused(self.load_scene(DATA + 'broken.yaml').status, Status.INVALID_ARGUMENT, 'broken.yaml:3')
        self.assertEqual(self.design(), before)
        self.assertEqual(self.components('static_geometry_node'), {'component/floor', 'component/shelf'})

    def test_the_design_in_force_is_told(self):
        loaded = self.design()
        self.assertTrue(loaded.source.startswith('/') and loaded.source.endswith('/strand.yaml'), loaded.source)
        self.assertFalse(loaded.edited)
        self.assertEqual(loaded.nominal, loaded.loaded)
        at = loaded.variables.index('strand_length')
        edit = self.service('/cable_solver/set_design', SetDesign)
        self.assertSuccess(edit(variables=['strand_length'], values=[0.315]).status)
        self.eventually(lambda: self.design().nominal[at] == 0.315, 'the new length')
        edited = self.design()
        self.assertTrue(edited.edited)
        self.assertEqual((edited.loaded, edited.loads), (loaded.loaded, loaded.loads))
        self.assertTrue(self.service('/cable_solver/reset_design', Trigger)().success)
        self.eventually(lambda: not self.design().edited, 'the design as loaded')
        self.assertEqual(self.design(), loaded)
        self.assertSuccess(self.load_scene(DATA + 'strand.yaml').status)
        self.eventually(lambda: self.design().loads == loaded.loads + 1, 'the same scene loaded again')


if __name__ == '__main__':
    rospy.init_node('follow_scene_test')
    rostest.rosrun('cable_variation', 'follow_scene', FollowSceneTest, sys.argv)
