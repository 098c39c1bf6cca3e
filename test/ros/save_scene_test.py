#!/usr/bin/env python3
"""~save_scene: the design in force as a scene file that loads again to the same shape."""
import os

import rospy
import rostest
from cable_variation.msg import CableShapes, ClipEdit, ComponentEdit, NewClip, Status
from cable_variation.srv import GetScene, LoadScene, SaveScene, SetDesign
from geometry_msgs.msg import Vector3
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger

SOLVER = '/cable_solver/'
HARNESS = 'package://cable_variation/config/harness.yaml'


class SaveSceneTest(NodeTest):
    def setUp(self):
        self.save = self.service(SOLVER + 'save_scene', SaveScene)
        self.set_design = self.service(SOLVER + 'set_design', SetDesign)
        self.get_scene = self.service(SOLVER + 'get_scene', GetScene)
        self.load = self.service(SOLVER + 'load_scene', LoadScene)
        self.assertSuccess(self.load(HARNESS).status)

    def tearDown(self):
        self.service(SOLVER + 'reset_design', Trigger)()

    def shape(self):
        return [xyz(point) for cable in self.latched(SOLVER + 'shapes', CableShapes).cables
                for point in (pose.position for pose in cable.section)]

    def assertSameShape(self, found, expected):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            for x, y in zip(a, b):
                self.assertAlmostEqual(x, y, places=6)

    def test_the_design_loads_again_to_its_shape(self):
        scene = self.get_scene()
        bracket = next(each for each in scene.components if each.name == 'start_bracket')
        bracket.pose.position.z += 0.004
        self.assertSuccess(self.set_design(
            variables=['wh_start_rz', 'main_length', 'engine_z'], values=[0.05, 0.314, 0.001],
            components=[ComponentEdit('start_bracket', bracket.pose)],
            clips=[ClipEdit(clip='WH_End', translation=Vector3(0.002, 0, 0))]).status)
        shape = self.shape()
        answer = self.save(name='edited', overwrite=True)
        self.assertSuccess(answer.status)
        self.assertTrue(os.path.isabs(answer.file) and answer.file.endswith('/edited.yaml'), answer.file)
        self.assertSuccess(self.load(answer.file).status)
        self.assertSameShape(self.shape(), shape)
        with open(answer.file, encoding='utf-8') as file:
            text = file.read()
        self.assertIn('# holds the connector WH_Start on the fuse box', text)
        self.assertIn('length: 314 mm', text)
        for variable in self.get_scene().design_variables:
            expected = {'main_length': 0.314, 'branch_length': 0.105, 'breakout_at': 0.258}.get(variable.name, 0)
            self.assertAlmostEqual(variable.nominal, expected, places=9)

    def test_a_clip_that_was_added_is_saved(self):
        scene = self.get_scene()
        end = next(each for each in scene.clips if each.name == 'WH_End')
        clip = NewClip(name='C', type='eyelet', cable='branch', arc_length=0.05, component='engine', pose=end.pose)
        clip.pose.position.z -= 0.05
        answer = self.set_design(new_clips=[clip])
        self.assertSuccess(answer.status)
        self.assertSuccess(self.save(name='clip', overwrite=True).status)
        self.assertSuccess(self.load(self.save(name='clip', overwrite=True).file).status)
        added = self.get_scene().clips[-1]
        self.assertEqual((added.name, added.type, added.cable, added.component), ('C', 'eyelet', 'branch', 'engine'))
        self.assertAlmostEqual(added.arc_length, 0.05)

    def test_an_older_file_stays_unless_it_is_said(self):
        self.assertSuccess(self.save(name='older', overwrite=True).status)
        refused = self.save(name='older')
        self.assertRefused(refused.status, Status.INVALID_ARGUMENT, "name 'older'", 'already')
        self.assertEqual(refused.file, '')
        self.assertSuccess(self.save(name='older.yaml', overwrite=True).status)

    def test_bad_names_are_refused(self):
        for name in ('', '../up', 'a/b', '.hidden'):
            self.assertRefused(self.save(name=name).status, Status.INVALID_ARGUMENT, "'%s'" % name)

    def test_edits_name_what_is_wrong(self):
        pose = self.get_scene().clips[0].pose
        for request, code, parts in (
                (dict(components=[ComponentEdit('engin', pose)]), Status.NOT_FOUND, ["'engin'", "did you mean 'engine'"]),
                (dict(variables=['wh_strat_rz'], values=[0]), Status.NOT_FOUND, ["did you mean 'wh_start_rz'"]),
                (dict(new_clips=[NewClip(name='WH_End', type='fixed', cable='main', pose=pose)]),
                 Status.INVALID_ARGUMENT, ["'WH_End' already"]),
                (dict(new_clips=[NewClip(name='X', type='hinge', cable='main', pose=pose)]),
                 Status.INVALID_ARGUMENT, ["'hinge'", 'expected one of fixed']),
                (dict(new_clips=[NewClip(name='X', type='fixed', cable='mian', pose=pose)]),
                 Status.NOT_FOUND, ["did you mean 'main'"])):
            self.assertRefused(self.set_design(**request).status, code, *parts)


if __name__ == '__main__':
    rospy.init_node('save_scene_test')
    rostest.rosrun('cable_variation', 'save_scene', SaveSceneTest)
