#!/usr/bin/env python3
"""An output folder that fills up, and one that somebody has put links and pipes into: answers are whole, nothing is
written elsewhere, nobody waits."""
import os
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from cable_variation.msg import Status
from cable_variation.srv import (AnalyzeStability, CheckForbiddenRegion, GenerateEnvelope, SaveScene, SetDesign,
                                 SimulateVariation)
from node_client import NodeTest

FULL = os.strerror(28)  # ENOSPC


class OutputFaultsTest(NodeTest):
    def ask(self, service, kind, **request):
        return self.service('/out/' + service, kind)(**request)

    def small_disk(self, size):
        folder = tempfile.mkdtemp()
        self.addCleanup(os.rmdir, folder)
        mounted = subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=%d' % size, 'tmpfs', folder],
                                 stderr=subprocess.DEVNULL, check=False).returncode == 0
        if not mounted:
            raise unittest.SkipTest('takes the right to mount a small disk')
        self.addCleanup(subprocess.run, ['umount', '-l', folder], check=False)
        return folder

    def test_a_full_disk_costs_files_and_nothing_else(self):
        folder = self.small_disk(200000)
        self.start_solver('out', output_directory=folder, state_file='state')
        with open(os.path.join(folder, 'ballast'), 'wb') as file:
            file.write(bytes(150000))
        envelope = self.ask('generate_envelope', GenerateEnvelope, variables=['b_z'], name='run')
        self.assertRefused(envelope.status, Status.IO_ERROR, 'run.stl', FULL)
        self.assertGreater(len(envelope.mesh.triangles), 100)
        simulated = self.ask('simulate_variation', SimulateVariation, variables=['*'], samples=20000, name='run')
        self.assertRefused(simulated.status, Status.IO_ERROR, 'run.csv.partial', FULL)
        self.assertEqual(simulated.solved, 20000)
        os.remove(os.path.join(folder, 'run.csv.partial'))
        with open(os.path.join(folder, 'ballast'), 'ab') as file:
            try:
                file.write(bytes(200000))
                file.flush()
            except OSError:
                pass
        analysed = self.ask('analyze_stability', AnalyzeStability, report='run')
        self.assertRefused(analysed.status, Status.IO_ERROR, FULL)
        self.assertEqual(len(analysed.measures), 1)
        self.assertRefused(self.ask('save_scene', SaveScene, name='saved').status, Status.IO_ERROR, FULL)
        self.assertSuccess(self.ask('set_design', SetDesign, variables=['b_z'], values=[0.003]).status)
        self.assertFalse([each for each in os.listdir(folder) if each.endswith('.part')])
        os.remove(os.path.join(folder, 'ballast'))
        self.assertSuccess(self.ask('save_scene', SaveScene, name='saved').status)
        self.assertSuccess(self.ask('analyze_stability', AnalyzeStability, report='run').status)

    def test_links_and_pipes_lead_nowhere(self):
        with tempfile.TemporaryDirectory() as folder:
            out, elsewhere = os.path.join(folder, 'out'), os.path.join(folder, 'elsewhere')
            os.mkdir(out)
            with open(elsewhere, 'w') as file:
                file.write('kept')
            names = ['run' + end for end in ('.stl', '.urdf', '.obj', '.html', '.csv', '.csv.partial', '_statistics.csv',
                                             '_contributions.csv', '.yaml')]
            self.start_solver('out', output_directory=out, state_file='state')

            def all_of_them():
                for name, kind, request in (
                        ('generate_envelope', GenerateEnvelope, dict(variables=['b_z'], name='run')),
                        ('simulate_variation', SimulateVariation, dict(variables=['*'], samples=100, name='run')),
                        ('analyze_stability', AnalyzeStability, dict(report='run')),
                        ('save_scene', SaveScene, dict(name='run', overwrite=True))):
                    self.assertSuccess(self.ask(name, kind, **request).status)
                for name in names:
                    if not name.endswith('.partial'):
                        self.assertTrue(os.path.isfile(os.path.join(out, name)), name)
                        self.assertFalse(os.path.islink(os.path.join(out, name)), name)
                        os.remove(os.path.join(out, name))
            for name in names:
                os.symlink(elsewhere, os.path.join(out, name))
            all_of_them()
            with open(elsewhere) as file:
                self.assertEqual(file.read(), 'kept')
            for name in names:
                if os.path.lexists(os.path.join(out, name)):
                    os.remove(os.path.join(out, name))
                os.mkfifo(os.path.join(out, name))
            all_of_them()

            # a region is read from a file of the folder itself
            self.assertSuccess(self.ask('generate_envelope', GenerateEnvelope, variables=['b_z'], name='run').status)
            os.rename(os.path.join(out, 'run.obj'), elsewhere)
            os.symlink(elsewhere, os.path.join(out, 'run.obj'))
            self.assertRefused(self.ask('check_forbidden_region', CheckForbiddenRegion, region='run').status,
                               Status.NOT_FOUND, 'link')
            os.remove(os.path.join(out, 'run.obj'))
            os.mkfifo(os.path.join(out, 'run.obj'))
            self.assertRefused(self.ask('check_forbidden_region', CheckForbiddenRegion, region='run').status,
                               Status.NOT_FOUND, 'pipe')


if __name__ == '__main__':
    rospy.init_node('output_faults_test')
    rostest.rosrun('cable_variation', 'output_faults', OutputFaultsTest, sys.argv)
