#!/usr/bin/env python3
"""A solver that was killed and started again by roslaunch answers as before: with its scene, design and shape."""
import math
import os
import sys
import tempfile
import time

import rospy
import rostest
from cable_variation.msg import CableEdit, ClipEdit, ComponentEdit, DesignState, NewClip
from cable_variation.srv import GetScene, LoadScene, SetAttachment, SetDesign, SolveEquilibrium
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from node_client import DATA, NodeTest, xyz
from std_srvs.srv import Trigger

SOLVER = '/cable_solver/'
ACCURACY = 1e-4  # of every centreline [m], as the scenes have it by default


class RespawnTest(NodeTest):
    def setUp(self):
        self.assertSuccess(self.ask('load_scene', LoadScene, scene=DATA + 'attachments.yaml').status)

    def ask(self, service, kind, node=SOLVER, **request):
        return self.service(node + service, kind)(**request)

    def figures(self, node=SOLVER):
        """The scene as the solver tells it, and the shape in force with what is measured there."""
        return (self.ask('get_scene', GetScene, node), self.ask('solve_equilibrium', SolveEquilibrium, node, follow=True))

    def assertSameFigures(self, now, before):
        self.assertEqual(now[0], before[0])  # nominal values, poses, clips: to the last bit
        self.assertSuccess(now[1].status)
        self.assertSuccess(before[1].status)
        # The grid may be another one, of the same accuracy.
        for get in (lambda answer: answer.energy.total, lambda answer: answer.smallest_eigenvalue):
            self.assertAlmostEqual(get(now[1]), get(before[1]), delta=0.01 * abs(get(before[1])))
        for here, there in zip(now[1].shapes, before[1].shapes):
            for end in (0, -1):
                for a, b in zip(xyz(here.section[end].position), xyz(there.section[end].position)):
                    self.assertAlmostEqual(a, b, delta=ACCURACY)
        for here, there in zip(now[1].measures, before[1].measures):
            self.assertAlmostEqual(here.value, there.value, delta=ACCURACY + 1e-3 * abs(there.value))

    def respawned(self):
        """Kills the solver, and returns how long the next one was up before it answered."""
        dead = self.kill(SOLVER[:-1])
        self.eventually(lambda: self.pid(SOLVER[:-1]) != dead, 'another solver')
        up = time.time()

        def answers():
            try:
                return self.ask('get_scene', GetScene).cables
            except rospy.ServiceException:
                return None
        self.eventually(answers, 'an answer')
        return time.time() - up

    def test_the_design_is_the_one_before(self):
        turned = Pose(orientation=Quaternion(0, 0, 0.05, 0.99875))
        turned.position.z = 0.002
        added = Pose(position=Point(0.11, 0.001, -0.06), orientation=Quaternion(w=1))
        self.assertSuccess(self.ask(
            'set_design', SetDesign, variables=['b_z'], values=[0.0123],
            cables=[CableEdit(cable='strand', length=0.3157)],
            components=[ComponentEdit(component='tray', pose=turned)],
            new_clips=[NewClip(name='more than a ring', type='eyelet', cable='strand', arc_length=0.17, pose=added)],
            clips=[ClipEdit(clip='A', rotation=Vector3(0.02, 0, 0.01))]).status)
        self.assertSuccess(self.ask('set_attachment', SetAttachment, clip='ring', attached=True, reach=0.2).status)
        time.sleep(1)  # so it is in the file
        before = self.figures()
        self.assertEqual(len(before[0].clips), 5)
        seconds = self.respawned()
        self.assertSameFigures(self.figures(), before)
        self.assertPrompt(seconds, 'an answer of the solver that is up again')
        # the next edit goes on from there, and a reset leads back
        self.assertSuccess(self.ask('set_design', SetDesign, variables=['b_z'], values=[0.01]).status)
        self.respawned()
        nominal = {each.name: each.nominal for each in self.figures()[0].design_variables}
        self.assertEqual(nominal['b_z'], 0.01)
        self.assertTrue(self.ask('reset_design', Trigger).success)
        self.assertEqual(len(self.figures()[0].clips), 4)
        time.sleep(1)
        self.respawned()
        self.assertEqual(len(self.figures()[0].clips), 4)

    def test_it_is_in_force_as_soon_as_it_is_answered(self):
        """What was answered SUCCESS is not lost, unless it came within a tenth of a second after another edit."""
        time.sleep(1)
        self.assertSuccess(self.ask('set_design', SetDesign, variables=['b_z'], values=[0.004]).status)
        self.respawned()
        self.assertEqual(self.latched('/cable_solver/design', DesignState).nominal, (0.004,))

    def test_the_scene_is_the_one_that_was_loaded(self):
        self.assertSuccess(self.ask('load_scene', LoadScene, scene=DATA + 'snapping.yaml').status)
        # a strip that has flipped over stays so, be the other shape of lower energy or not
        for degrees in (60, 20, -20, 20):
            half = math.radians(degrees) / 2
            pose = Pose(Point(0.3, 0, 0), Quaternion(0, math.sin(half), 0, math.cos(half)))
            self.assertSuccess(self.ask('set_design', SetDesign, components=[
                ComponentEdit(component='holder', pose=pose)]).status)
        time.sleep(1)
        before = self.figures()
        self.respawned()
        state = self.latched('/cable_solver/design', DesignState)
        self.assertTrue(state.source.endswith('snapping.yaml'))
        self.assertTrue(state.edited)
        self.assertSameFigures(self.figures(), before)

    def test_a_file_that_is_no_good_is_told_and_kept(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'state')
            scene = os.path.join(folder, 'scene.yaml')
            with open(self.source()) as file:
                text = file.read()
            write(scene, text)

            def run(**parameters):
                return self.start_solver('kept', **{'scene': scene, 'state_file': path, **parameters})

            def nominal():
                return self.ask('get_scene', GetScene, '/kept/').design_variables[0].nominal

            def end(process):
                process.terminate()
                process.wait(self.TIMEOUT)
            process = run()
            self.assertSuccess(self.ask('set_design', SetDesign, '/kept/', variables=['b_z'], values=[0.004]).status)
            time.sleep(1)
            end(process)
            with open(path, 'rb') as file:
                whole = file.read()
            process = run()  # told to end, and started again
            self.assertEqual(nominal(), 0.004)
            end(process)
            for broken in (whole[:-40], whole.replace(b'nominal 0 ', b'nominal 7 '), whole.replace(b'sha256 ', b'sha256 0'),
                           whole.replace(b'asked ', b'asked x'), whole[:30], b'cable_solver state 1\n' + bytes(range(256))):
                write(path, broken)
                process = run()
                self.assertEqual(nominal(), 0)
                end(process)
                with open(path + '.old', 'rb') as file:
                    self.assertEqual(file.read(), broken)
                self.assertTrue(os.path.isfile(path))
            write(path, whole)
            write(scene, text + '\n# another one\n')
            process = run()
            self.assertEqual(nominal(), 0)
            end(process)
            # what is no state is nobody's to replace
            write(scene, text)
            for other in (b'dear diary\n', b''):
                write(path, other)
                process = run()
                self.assertEqual(nominal(), 0)
                self.assertSuccess(self.ask('set_design', SetDesign, '/kept/', variables=['b_z'], values=[0.004]).status)
                time.sleep(1)
                end(process)
                with open(path, 'rb') as file:
                    self.assertEqual(file.read(), other)
            os.remove(path)
            os.mkfifo(path)
            process = run()
            self.assertEqual(nominal(), 0)
            end(process)
            os.remove(path)
            os.mkdir(path)
            process = run()
            self.assertEqual(nominal(), 0)
            end(process)

    def source(self):
        return self.latched('/cable_solver/design', DesignState).source


def write(path, contents):
    with open(path, 'wb') as file:
        file.write(contents if isinstance(contents, bytes) else contents.encode())


if __name__ == '__main__':
    rospy.init_node('respawn_test')
    rostest.rosrun('cable_variation', 'respawn', RespawnTest, sys.argv)
