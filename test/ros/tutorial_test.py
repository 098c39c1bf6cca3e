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
from cable_variation.msg import ClipEdit
from cable_variation.srv import AnalyzeStability, LoadScene, SaveScene, SetDesign, SolveEquilibrium
from geometry_msgs.msg import Vector3
from node_client import NodeTest

SOLVER = '/cable_solver/'
PACKAGE = pathlib.Path(rospkg.RosPack().get_path('cable_variation'))


class TutorialTest(NodeTest):
    def setUp(self):
        self.blocks = re.findall(r'^```yaml\n(.*?)^```', (PACKAGE / 'doc/tutorial.md').read_text(encoding='utf-8'),
                                 re.MULTILINE | re.DOTALL)
        self.assertEqual(len(self.blocks), 2)

    def load(self, path):
        answer = self.service(SOLVER + 'load_scene', LoadScene)(scene=str(path))
        self.assertSuccess(answer.status)
        self.assertEqual(answer.warnings, [])

    def test_from_a_part_to_the_report(self):
        with tempfile.TemporaryDirectory() as folder:
            part = os.path.join(folder, 'plate.stl')
            subprocess.run([str(PACKAGE / 'scripts/make_tutorial_part'), part], check=True)
            scene = pathlib.Path(folder) / 'first.yaml'
            self.assertIn('/tmp/first/plate.stl', self.blocks[0])
            scene.write_text(self.blocks[0].replace('/tmp/first/plate.stl', part), encoding='utf-8')
            self.load(scene)
            self.assertSuccess(self.service(SOLVER + 'set_design', SetDesign)(
                clips=[ClipEdit(clip='first', translation=Vector3(0, 0, 0.01))]).status)
            saved = self.service(SOLVER + 'save_scene', SaveScene)(name='second', overwrite=True)
            self.assertSuccess(saved.status)
            with open(saved.file, 'a', encoding='utf-8') as file:
                file.write(self.blocks[1])
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
