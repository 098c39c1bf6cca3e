#!/usr/bin/env python3
"""The scenes printed in doc/tutorial.md, with the part that its script makes: they load, are edited, saved, go on, and
end in a report."""
import os
import pathlib
import re
import subprocess
import tempfile

import rospkg
import rospy
import rostest
from cable_variation.msg import CableShapes, ClipEdit, ComponentEdit, LiveMeasures, Status
from cable_variation.srv import (
    AnalyzeStability, CheckForbiddenRegion, CheckPath, GenerateEnvelope, GetScene, LoadScene, SaveScene, SetAttachment,
    SetDesign, SimulateVariation, SolveEquilibrium)
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from node_client import NodeTest
from std_srvs.srv import Trigger
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerInit

SOLVER = '/cable_solver/'
PACKAGE = pathlib.Path(rospkg.RosPack().get_path('cable_variation'))


class TutorialTest(NodeTest):
    def setUp(self):
        self.blocks = re.findall(r'^```yaml\n(.*?)^```', (PACKAGE / 'doc/tutorial.md').read_text(encoding='utf-8'),
                                 re.MULTILINE | re.DOTALL)
        self.assertEqual(len(self.blocks), 3)

    def load(self, path):
        answer = self.service(SOLVER + 'load_scene', LoadScene)(scene=str(path))
        self.assertSuccess(answer.status)
        self.assertEqual(answer.warnings, [])

    def part_alone(self):
        """A scene without a cable is shown and edited; what asks for a cable is told that there is none."""
        info = self.service(SOLVER + 'get_scene', GetScene)()
        self.assertEqual(([each.name for each in info.components], info.cables, info.clips), (['plate'], [], []))
        self.assertEqual(self.latched(SOLVER + 'shapes', CableShapes).cables, [])
        live = self.latched(SOLVER + 'measures', LiveMeasures)
        self.assertSuccess(live.status)
        self.assertEqual(live.measures, [])
        pose = Pose(position=Point(0, 0, 0.1), orientation=Quaternion(0, 0, 0, 1))
        self.assertSuccess(self.service(SOLVER + 'set_design', SetDesign)(
            components=[ComponentEdit(component='plate', pose=pose)]).status)
        saved = self.service(SOLVER + 'save_scene', SaveScene)(name='moved_plate', overwrite=True)
        self.assertSuccess(saved.status)
        self.load(saved.file)
        info = self.service(SOLVER + 'get_scene', GetScene)()
        self.assertAlmostEqual(info.components[0].pose.position.z, 0.1)
        self.assertTrue(self.service(SOLVER + 'reset_design', Trigger)().success)
        no_cable = 'no cable'
        self.assertRefused(self.service(SOLVER + 'solve_equilibrium', SolveEquilibrium)().status,
                           Status.INVALID_ARGUMENT, no_cable)
        self.assertRefused(self.service(SOLVER + 'generate_envelope', GenerateEnvelope)().status,
                           Status.INVALID_ARGUMENT)
        self.assertRefused(self.service(SOLVER + 'simulate_variation', SimulateVariation)(samples=10).status,
                           Status.INVALID_ARGUMENT)
        for kind, name in ((AnalyzeStability, 'analyze_stability'), (CheckPath, 'check_path'),
                           (SetAttachment, 'set_attachment'), (CheckForbiddenRegion, 'check_forbidden_region')):
            self.assertNotIn(self.service(SOLVER + name, kind)().status.code, (Status.SUCCESS, Status.INTERNAL_ERROR))

    def first_cable(self):
        """The menu of a part in an otherwise empty scene makes a cable; it is dragged and saved."""
        publisher = rospy.Publisher(SOLVER + 'interaction/feedback', InteractiveMarkerFeedback, queue_size=10)
        self.eventually(lambda: publisher.get_num_connections() > 0, 'the solver hears feedback')

        def marker(name):
            full = self.latched(SOLVER + 'interaction/update_full', InteractiveMarkerInit)
            return next((each for each in full.markers if each.name == name), None)

        def send(to, event, **fields):
            feedback = InteractiveMarkerFeedback(marker_name=to.name, event_type=event, pose=to.pose, **fields)
            feedback.header.frame_id = 'world'
            publisher.publish(feedback)
        plate = self.eventually(lambda: marker('component/plate'), 'the marker of the plate')
        entry = next(each for each in plate.menu_entries if each.title == 'Add a cable here')
        send(plate, InteractiveMarkerFeedback.MENU_SELECT, menu_entry_id=entry.id, mouse_point=Point(0.15, 0.06, 0.02),
             mouse_point_valid=True)
        cables = self.eventually(lambda: self.latched(SOLVER + 'shapes', CableShapes).cables, 'a cable')
        self.assertEqual([each.cable for each in cables], ['cable_1'])
        end = self.eventually(lambda: marker('clip/clip_2'), 'the marker of its end')
        end.pose.position.z += 0.01
        send(end, InteractiveMarkerFeedback.POSE_UPDATE)
        send(end, InteractiveMarkerFeedback.MOUSE_UP)

        def height():
            return self.latched(SOLVER + 'shapes', CableShapes).cables[0].section[-1].position.z
        self.eventually(lambda: abs(height() - end.pose.position.z) < 1e-6, 'the cable has followed')
        saved = self.service(SOLVER + 'save_scene', SaveScene)(name='first_cable', overwrite=True)
        self.assertSuccess(saved.status)
        self.load(saved.file)
        self.assertAlmostEqual(height(), end.pose.position.z, places=6)
        info = self.service(SOLVER + 'get_scene', GetScene)()
        self.assertEqual([(each.name, each.component) for each in info.clips], [('clip_1', 'plate'), ('clip_2', 'plate')])

    def test_from_a_part_to_the_report(self):
        with tempfile.TemporaryDirectory() as folder:
            part = os.path.join(folder, 'plate.stl')
            subprocess.run([str(PACKAGE / 'scripts/make_tutorial_part'), part], check=True)
            scene = pathlib.Path(folder) / 'first.yaml'
            self.assertIn('/tmp/first/plate.stl', self.blocks[0])
            scene.write_text(self.blocks[0].replace('/tmp/first/plate.stl', part), encoding='utf-8')
            self.load(scene)
            self.part_alone()
            self.load(scene)
            self.first_cable()
            with open(scene, 'a', encoding='utf-8') as file:
                file.write(self.blocks[1])
            self.load(scene)
            self.assertSuccess(self.latched(SOLVER + 'measures', LiveMeasures).status)
            self.assertSuccess(self.service(SOLVER + 'set_design', SetDesign)(
                clips=[ClipEdit(clip='first', translation=Vector3(0, 0, 0.01))]).status)
            saved = self.service(SOLVER + 'save_scene', SaveScene)(name='second', overwrite=True)
            self.assertSuccess(saved.status)
            with open(saved.file, 'a', encoding='utf-8') as file:
                file.write(self.blocks[2])
            self.load(saved.file)
            answer = self.service(SOLVER + 'solve_equilibrium', SolveEquilibrium)()
            self.assertSuccess(answer.status)
            self.assertEqual([each.name for each in answer.measures if each.within], ['gap', 'bend'])
            analysis = self.service(SOLVER + 'analyze_stability', AnalyzeStability)(report='second')
            self.assertSuccess(analysis.status)
            self.assertTrue(os.path.isfile(os.path.join(os.path.dirname(saved.file), 'second.html')))


if __name__ == '__main__':
    rospy.init_node('tutorial_test')
    rostest.rosrun('cable_variation', 'tutorial', TutorialTest)
