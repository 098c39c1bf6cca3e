#!/usr/bin/env python3
"""cable_solver: its services, asked well and badly, and its topics."""
import math
import os
import shutil
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import rospy
import rostest
from cable_variation.msg import CableEdit, CableShapes, ClipEdit, ComponentEdit, Status
from cable_variation.srv import GenerateEnvelope, GetScene, LoadScene, SetDesign, SolveEquilibrium
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Pose, Vector3
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

DATA = 'package://cable_variation/test/ros/data/'


class CableSolverTest(NodeTest):
    def setUp(self):
        self.solve = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)
        self.get_scene = self.service('/cable_solver/get_scene', GetScene)
        self.load_scene = self.service('/cable_solver/load_scene', LoadScene)
        self.set_design = self.service('/cable_solver/set_design', SetDesign)
        self.reset_design = self.service('/cable_solver/reset_design', Trigger)
        self.assertSuccess(self.load_scene(DATA + 'strand.yaml').status)

    def end_of_shape(self):
        return xyz(self.latched('/cable_solver/shapes', CableShapes).cables[0].section[-1].position)

    def test_nominal_equilibrium(self):
        answer = self.solve()
        self.assertSuccess(answer.status)
        shape = answer.shapes[0]
        self.assertEqual((shape.cable, shape.length, shape.radius), ('strand', 0.312, 0.004))
        for values in (shape.section, shape.force, shape.moment, shape.strain, shape.curvature):
            self.assertEqual(len(values), len(shape.arc_length))
        self.assertEqual((shape.arc_length[0], shape.arc_length[-1]), (0, 0.312))
        for value, expected in zip(xyz(shape.section[-1].position), (0.25, 0, 0)):
            self.assertAlmostEqual(value, expected, places=9)
        self.assertLess(shape.smallest_bend_radius, 0.312)
        self.assertGreater(shape.smallest_bend_radius, 0.01)
        self.assertGreater(answer.smallest_eigenvalue, 0)
        self.assertLess(answer.discretisation_error, 1e-4)
        # The clips carry the strand's weight: 2000 kg/m^3 of radius 4 mm, 312 mm long.
        self.assertEqual([each.clip for each in answer.clip_reactions], ['A', 'B'])
        weight = 2000 * math.pi * 0.004 ** 2 * 0.312 * 9.81
        self.assertAlmostEqual(sum(each.force.z for each in answer.clip_reactions), weight, places=6)

    def test_design_variables_move_the_shape_and_nothing_else(self):
        answer = self.solve(variables=['b_z'], values=[0.004])
        self.assertSuccess(answer.status)
        self.assertAlmostEqual(answer.shapes[0].section[-1].position.z, 0.004, places=9)
        self.assertAlmostEqual(self.end_of_shape()[2], 0, places=9)
        self.assertAlmostEqual(self.solve().shapes[0].section[-1].position.z, 0, places=9)

    def test_following_gives_the_same_shape(self):
        cold = self.solve(variables=['b_z'], values=[0.004]).shapes[0]
        warm = self.solve(variables=['b_z'], values=[0.004], follow=True).shapes[0]
        lowest = [min(point.z for point in shape.centreline) for shape in (cold, warm)]
        self.assertAlmostEqual(lowest[0], lowest[1], delta=2e-4)

    def test_bad_requests_are_refused_by_name(self):
        nan = float('nan')
        self.assertRefused(self.solve(variables=['b_zz'], values=[0]).status, Status.NOT_FOUND, "'b_zz'")
        self.assertRefused(self.solve(variables=['b_z'], values=[nan]).status, Status.INVALID_ARGUMENT, "'b_z'")
        self.assertRefused(self.solve(variables=['b_z'], values=[]).status, Status.INVALID_ARGUMENT,
                           '1 variables but 0 values')
        self.assertRefused(self.solve(variables=['b_z', 'b_z'], values=[0, 0]).status, Status.INVALID_ARGUMENT,
                           'twice')
        self.assertRefused(self.solve(variables=['strand_length'], values=[-1]).status,
                           Status.INVALID_ARGUMENT, '-1')
        self.assertRefused(self.solve(motion='ride').status, Status.NOT_FOUND, "'ride'")

    def test_an_impossible_shape_is_no_shape(self):
        answer = self.solve(variables=['strand_length'], values=[0.2])
        self.assertRefused(answer.status, Status.NOT_CONVERGED, 'strand')
        self.assertEqual((answer.shapes, answer.clip_reactions), ([], []))

    def test_motion_moves_the_components(self):
        self.assertSuccess(self.load_scene(DATA + 'moving_bag.yaml').status)
        answer = self.solve(motion='slide', time=1.0)
        self.assertSuccess(answer.status)
        self.assertAlmostEqual(answer.shapes[0].section[-1].position.x, 0.05, places=7)
        for time in (-1, 2.5, float('nan')):
            self.assertRefused(self.solve(motion='slide', time=time).status, Status.INVALID_ARGUMENT,
                               'expected 0 to 2 s')

    def test_a_component_that_is_moved_by_hand_is_elsewhere_on_its_motion_too(self):
        self.assertSuccess(self.load_scene(DATA + 'moving_bag.yaml').status)
        pose = Pose()
        pose.position.y, pose.orientation.w = 0.03, 1.0
        self.assertSuccess(self.set_design(components=[ComponentEdit(component='sled', pose=pose)]).status)
        self.assertAlmostEqual(self.end_of_shape()[1], 0.03, places=7)
        answer = self.solve(motion='slide', time=1.0)
        self.assertSuccess(answer.status)
        self.assertAlmostEqual(answer.shapes[0].section[-1].position.x, 0.05, places=7)
        self.assertAlmostEqual(answer.shapes[0].section[-1].position.y, 0.03, places=7)
        envelope = self.service('/cable_solver/generate_envelope', GenerateEnvelope)(
            motions=['slide'], motion_only=True, non_conservative=True)
        self.assertSuccess(envelope.status)
        self.assertGreater(max(vertex.y for vertex in envelope.mesh.vertices), 0.03)  # by the cable's radius

    def test_a_report_of_an_equilibrium(self):
        answer = self.solve(variables=['b_z'], values=[0.003], report='at_rest')
        self.assertSuccess(answer.status)
        text = ' '.join(ElementTree.parse(answer.report_file).getroot().itertext())
        self.assertIn('b_z = 3 mm', text)
        self.assertIn('The design at rest', text)
        self.assertRefused(self.solve(report='../up').status, Status.INVALID_ARGUMENT, '../up')
        self.assertEqual(self.solve().report_file, '')

    def test_get_scene(self):
        scene = self.get_scene()
        self.assertSuccess(scene.status)
        self.assertTrue(scene.source.endswith('/test/ros/data/strand.yaml'))
        self.assertEqual(xyz(scene.gravity), (0, 0, -9.81))
        self.assertEqual([each.name for each in scene.components], ['holder', 'post'])
        self.assertEqual(scene.components[1].triangles, 4)
        self.assertEqual([(each.name, each.length, each.uniform) for each in scene.cables],
                         [('strand', 0.312, True)])
        self.assertAlmostEqual(scene.cables[0].mass, 2000 * math.pi * 0.004 ** 2 * 0.312)
        clip = scene.clips[1]
        self.assertEqual((clip.name, clip.type, clip.cable, clip.component), ('B', 'fixed', 'strand', 'holder'))
        self.assertEqual((clip.pose.position.x, clip.world_pose.position.x), (0, 0.25))
        self.assertEqual([(each.name, each.kind, each.target, each.member, each.unit)
                          for each in scene.design_variables],
                         [('b_z', 'clip_translation', 'B', 'z', 'm'), ('a_ry', 'clip_rotation', 'A', 'y', 'rad'),
                          ('strand_length', 'cable_property', 'strand', 'length', 'm')])

    def test_set_design_shows_and_reset_restores(self):
        edit = ClipEdit(clip='B', translation=Vector3(0, 0.01, 0))
        self.assertSuccess(self.set_design(variables=['b_z'], values=[0.003], cables=[CableEdit('strand', 0.32)],
                                           clips=[edit]).status)
        for value, expected in zip(self.end_of_shape(), (0.25, 0.01, 0.003)):
            self.assertAlmostEqual(value, expected, places=9)
        scene = self.get_scene()
        self.assertEqual(scene.cables[0].length, 0.32)
        self.assertEqual([each.nominal for each in scene.design_variables], [0.003, 0, 0.32])
        self.assertAlmostEqual(self.solve().shapes[0].section[-1].position.z, 0.003, places=9)

        self.assertTrue(self.reset_design().success)
        self.assertAlmostEqual(self.end_of_shape()[1], 0, places=9)
        self.assertEqual(self.get_scene().cables[0].length, 0.312)

    def test_clip_edits(self):
        pose = Pose()
        pose.position.z, pose.orientation.w = 0.02, 1.0
        self.assertSuccess(self.set_design(clips=[ClipEdit(clip='B', set_pose=True, pose=pose)]).status)
        self.assertAlmostEqual(self.end_of_shape()[2], 0.02, places=9)
        self.assertSuccess(self.set_design(clips=[ClipEdit(clip='A', rotation=Vector3(0, 0, 0.1))]).status)
        start = self.latched('/cable_solver/shapes', CableShapes).cables[0].section[0].orientation
        self.assertAlmostEqual(2 * math.asin(start.z), 0.1, places=6)

    def test_what_an_edit_hardly_means_is_told_until_it_is_undone(self):
        answer = self.set_design(variables=['a_ry'], values=[2.0])
        self.assertSuccess(answer.status)
        self.assertEqual(answer.warnings, ["design variable 'a_ry': it is 2 rad, which is 114.592 deg; in deg?"])
        self.assertEqual(self.get_scene().warnings, ['set_design: ' + answer.warnings[0]])
        # It is still so after another edit, and one that is refused is told of too.
        self.assertEqual(self.set_design(variables=['b_z'], values=[0.001]).warnings, answer.warnings)
        refused = self.set_design(variables=['b_z'], values=[5.0])
        self.assertNotEqual(refused.status.code, Status.SUCCESS)
        self.assertIn("design variable 'b_z': it is 5 m, where the longest cable has 0.312 m; in mm?", refused.warnings)
        turned = self.set_design(variables=['a_ry'], values=[0.0], clips=[ClipEdit(clip='A', rotation=Vector3(0, 0, 3))])
        self.assertEqual(turned.warnings, ["clip 'A', rotation: it is 3 rad, which is 171.887 deg; in deg?"])
        self.assertTrue(self.reset_design().success)
        self.assertEqual(self.get_scene().warnings, [])

    def test_a_refused_design_changes_nothing(self):
        before = self.latched('/cable_solver/shapes', CableShapes)
        scene = self.get_scene()
        for request, code, part in (
                (dict(variables=['b_z'], values=[float('inf')]), Status.INVALID_ARGUMENT, 'b_z'),
                (dict(cables=[CableEdit('rope', 0.3)]), Status.NOT_FOUND, "'rope'"),
                (dict(cables=[CableEdit('strand', 0.0)]), Status.INVALID_ARGUMENT, 'strand'),
                (dict(cables=[CableEdit('strand', 0.2)]), Status.NOT_CONVERGED, 'strand'),
                (dict(clips=[ClipEdit(clip='B', set_pose=True)]), Status.INVALID_ARGUMENT, 'norm 0'),
                (dict(clips=[ClipEdit(clip='B', set_arc_length=True, arc_length=0.4)]),
                 Status.INVALID_ARGUMENT, 'B'),
                # The first edit is fine, but all or nothing.
                (dict(variables=['b_z'], values=[0.004], clips=[ClipEdit(clip='Q')]), Status.NOT_FOUND, "'Q'")):
            self.assertRefused(self.set_design(**request).status, code, part)
        self.assertEqual(self.latched('/cable_solver/shapes', CableShapes), before)
        self.assertEqual(self.get_scene(), scene)

    def test_a_scene_that_cannot_be_had_leaves_the_old_one(self):
        scene = self.get_scene()
        for name, code, parts in (
                ('broken.yaml', Status.INVALID_ARGUMENT, ('broken.yaml:3', '312 kg', 'wood')),
                ('apart.yaml', Status.NOT_CONVERGED, ('strand',)),
                ('none.yaml', Status.NOT_FOUND, ('none.yaml',))):
            self.assertRefused(self.load_scene(DATA + name).status, code, *parts)
        self.assertRefused(self.load_scene('package://no_such_package/a.yaml').status, Status.NOT_FOUND,
                           'no_such_package')
        self.assertRefused(self.load_scene('http://example.com/a.yaml').status, Status.NOT_FOUND, 'http')
        self.assertRefused(self.load_scene('').status, Status.NOT_FOUND)
        self.assertEqual(self.get_scene(), scene)

    def test_markers_and_what_becomes_of_them(self):
        markers = self.latched('/cable_solver/cables', MarkerArray).markers
        shown = {(each.ns, each.id) for each in markers if each.action == Marker.ADD}
        self.assertEqual({name for name, _ in shown}, {'cable/strand', 'clip/A', 'clip/B'})
        for each in markers:
            self.assertEqual((each.header.stamp, each.header.frame_id), (rospy.Time(0), 'world'))
        names = {each.text for each in markers if each.type == Marker.TEXT_VIEW_FACING and each.ns[:5] == 'clip/'}
        self.assertEqual(names, {'A', 'B'})

        self.assertSuccess(self.load_scene(DATA + 'other.yaml').status)
        after = self.latched('/cable_solver/cables', MarkerArray).markers
        self.assertEqual({each.ns for each in after if each.action == Marker.ADD},
                         {'cable/rope', 'clip/C', 'clip/D'})
        self.assertEqual({(each.ns, each.id) for each in after if each.action == Marker.DELETE}, shown)

    def test_diagnostics(self):
        def reported():
            array = rospy.wait_for_message('/diagnostics', DiagnosticArray, timeout=self.TIMEOUT)
            return [each for each in array.status if each.name == 'cable_solver: equilibrium']
        status = self.eventually(reported, 'diagnostics')[0]
        self.assertEqual((status.level, status.message), (0, 'stable equilibrium'))
        values = {each.key: each.value for each in status.values}
        self.assertGreater(float(values['smallest eigenvalue [N/m]']), 0)
        self.assertIn('residual [N]', values)

    def scene_status(self):
        array = rospy.wait_for_message('/diagnostics', DiagnosticArray, timeout=self.TIMEOUT)
        found = [each for each in array.status if each.name == 'cable_solver: scene']
        return found[0] if found else None

    def test_what_a_scene_hardly_means_is_told(self):
        self.assertEqual(self.get_scene().warnings, [])
        self.eventually(lambda: getattr(self.scene_status(), 'level', -1) == 0, 'nothing odd in the scene')
        answer = self.load_scene(DATA + 'slips.yaml')
        self.assertSuccess(answer.status)
        self.assertEqual(len(answer.warnings), 2)
        for warning, parts in zip(answer.warnings, (("slips.yaml:10: design variable 'a_ry', tolerance", 'in deg?'),
                                                    ("slips.yaml:11: design variable 'b_z', tolerance", 'in mm?'))):
            for part in parts:
                self.assertIn(part, warning)
        self.assertEqual(self.get_scene().warnings, answer.warnings)
        status = self.eventually(lambda: getattr(self.scene_status(), 'level', -1) == 1 and self.scene_status(),
                                 'a warning')
        self.assertIn('in deg?', status.message)
        self.assertEqual([each.value for each in status.values], answer.warnings)

    def test_what_a_scene_hardly_means_is_told_where_it_fails(self):
        answer = self.load_scene(DATA + 'out_of_reach.yaml')
        self.assertRefused(answer.status, Status.NOT_CONVERGED)
        self.assertEqual(len(answer.warnings), 1)
        self.assertIn("clip 'B': it is 250 m from clip 'A'", answer.warnings[0])
        self.assertEqual(self.get_scene().warnings, [])

    def test_scenes_that_are_no_files_are_refused_at_once(self):
        folder = tempfile.mkdtemp()
        pipe = os.path.join(folder, 'pipe.yaml')
        os.mkfifo(pipe)
        try:
            for address in (pipe, 'file://' + pipe):
                self.assertRefused(self.load_scene(address).status, Status.NOT_FOUND, 'is a named pipe')
            self.assertRefused(self.load_scene(folder).status, Status.NOT_FOUND, 'is a folder')
            self.assertRefused(self.load_scene('/dev/zero').status, Status.NOT_FOUND, 'is a device')
            self.assertRefused(self.load_scene(DATA + 'nowhere.yaml').status, Status.NOT_FOUND, 'does not exist')
        finally:
            shutil.rmtree(folder)
        self.assertSuccess(self.solve().status)


if __name__ == '__main__':
    rospy.init_node('cable_solver_test')
    rostest.rosrun('cable_variation', 'cable_solver', CableSolverTest, sys.argv)
