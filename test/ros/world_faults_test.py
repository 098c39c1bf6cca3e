#!/usr/bin/env python3
"""What breaks around a solver: files of its scene vanish or become others after it was loaded, and the master goes and
comes back."""
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import unittest.mock

import roslib.packages
import rosgraph
import rospy
import rostest
from cable_variation.msg import Status
from cable_variation.srv import (CheckForbiddenRegion, GenerateEnvelope, GetScene, LoadScene, SetDesign,
                                 SolveEquilibrium)
from node_client import NodeTest, xyz
from std_srvs.srv import Trigger

SOLVER = '/world/'
TEST = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
FILES = ('test/ros/data/envelope.yaml', 'test/ros/data/holder.tum', 'test/data/meshes/tetrahedron_binary.stl')


def centreline(answer):
    return [xyz(section.position) for section in answer.shapes[0].section]


class WorldFaultsTest(NodeTest):
    def ask(self, service, kind, **request):
        return self.service(SOLVER + service, kind)(**request)

    def own_scene(self):
        """A copy of a scene with all its files in a folder of its own, and its path."""
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        for file in FILES:
            shutil.copy(os.path.join(os.path.dirname(TEST), file), folder)
        path = os.path.join(folder, os.path.basename(FILES[0]))
        with open(path) as file:
            text = file.read()
        for file in FILES[1:]:
            text = text.replace('package://cable_variation/' + file, 'file://' + os.path.join(folder, os.path.basename(file)))
        with open(path, 'w') as file:
            file.write(text)
        return path

    def figures(self):
        solved = self.ask('solve_equilibrium', SolveEquilibrium)
        self.assertSuccess(solved.status)
        envelope = self.ask('generate_envelope', GenerateEnvelope, variables=['b_z'], motions=['sway'], to_time=0.1,
                            verification_shapes=10, mesh_excess=5e-3)
        self.assertSuccess(envelope.status)
        return ([each.value for each in solved.measures], centreline(solved),
                [each.distance for each in envelope.clearances])

    def test_files_that_vanish_after_they_were_loaded(self):
        path = self.own_scene()
        self.start_solver('world', path)
        before, scene = self.figures(), self.ask('get_scene', GetScene)
        for file in FILES[1:]:
            os.remove(os.path.join(os.path.dirname(path), os.path.basename(file)))
        # what was read is what is measured and played
        self.assertEqual(self.figures(), before)
        self.assertSuccess(self.ask('set_design', SetDesign, variables=['b_z'], values=[0.003]).status)
        self.assertTrue(self.ask('reset_design', Trigger).success)
        self.assertEqual(self.figures(), before)
        # what must be read again is named, and changes nothing
        for file in FILES[1:]:
            missing = os.path.join(os.path.dirname(path), os.path.basename(file))
            self.assertRefused(self.ask('load_scene', LoadScene, scene=path).status, Status.INVALID_ARGUMENT, missing)
        mesh = os.path.join(os.path.dirname(path), os.path.basename(FILES[2]))
        refused = self.ask('check_forbidden_region', CheckForbiddenRegion, region='file://' + mesh)
        self.assertRefused(refused.status, Status.NOT_FOUND, mesh)
        os.remove(path)
        self.assertRefused(self.ask('load_scene', LoadScene, scene=path).status, Status.NOT_FOUND, path)
        self.assertEqual(self.ask('get_scene', GetScene), scene)
        self.assertEqual(self.figures(), before)

    def test_a_file_that_becomes_another_one(self):
        path = self.own_scene()
        self.start_solver('world', path)
        before = self.figures()
        mesh = os.path.join(os.path.dirname(path), os.path.basename(FILES[2]))
        with open(mesh, 'r+b') as file:
            file.truncate(100)
        self.assertEqual(self.figures(), before)
        self.assertRefused(self.ask('load_scene', LoadScene, scene=path).status, Status.INVALID_ARGUMENT, mesh)
        self.assertEqual(self.figures(), before)

    def test_the_master_goes_and_comes_back(self):
        """Who is connected is answered all the while; the node can still be told to end, as nodes of ROS 1 must to be
        known to the new master."""
        with socket.socket() as tried:
            tried.bind(('', 0))
            port = tried.getsockname()[1]
        uri = 'http://localhost:%d' % port

        def master():
            process = subprocess.Popen(['rosmaster', '--core', '-p', str(port)], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)
            self.eventually(rosgraph.Master('/world_faults', master_uri=uri).is_online, 'a master')
            return process

        def solver():
            return subprocess.Popen([roslib.packages.find_node('cable_variation', 'cable_solver')[0], '__name:=world',
                                     '_output_directory:=' + folder, '_state_file:=state',
                                     '_scene:=' + os.path.join(os.path.dirname(TEST), FILES[0])])

        def offered():
            """Where the solver's service is, as the master knows."""
            try:
                return rosgraph.Master('/world_faults', master_uri=uri).lookupService(SOLVER + 'solve_equilibrium')
            except (rosgraph.MasterException, OSError):
                return None
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        with unittest.mock.patch.dict(os.environ, ROS_MASTER_URI=uri):
            first = master()
            node = solver()
            self.addCleanup(lambda: node.poll() is None and node.kill())
            self.eventually(offered, 'services')
            asked = rospy.ServiceProxy(SOLVER + 'solve_equilibrium', SolveEquilibrium, persistent=True)
            before = centreline(asked())
            first.kill()
            first.wait()
            self.assertEqual(centreline(asked()), before)
            master()
            self.assertEqual(centreline(asked()), before)
            self.assertIsNone(offered())  # nobody tells a node of ROS 1 that its master is another one
            node.send_signal(signal.SIGTERM)
            self.assertEqual(node.wait(self.TIMEOUT), 0)
            node = solver()
            self.eventually(offered, 'services again')
            again = rospy.ServiceProxy(SOLVER + 'solve_equilibrium', SolveEquilibrium)
            self.assertEqual(centreline(again()), before)
            node.send_signal(signal.SIGTERM)
            self.assertEqual(node.wait(self.TIMEOUT), 0)


if __name__ == '__main__':
    rospy.init_node('world_faults_test')
    rostest.rosrun('cable_variation', 'world_faults', WorldFaultsTest, sys.argv)
