#!/usr/bin/env python3
"""Ctrl-C ends each script with one line, and gives back the design as it was."""
import os
import signal
import subprocess
import sys
import time

import roslib.packages
import rosnode
import rospy
import rostest
from cable_variation.msg import DesignState
from node_client import NodeTest

INTERRUPTED = 130


def started(name, *arguments):
    program = roslib.packages.find_node('cable_variation', name)[0]
    return subprocess.Popen([sys.executable, program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True)


class InterruptedClientsTest(NodeTest):
    def expectInterrupted(self, name, process):
        process.send_signal(signal.SIGINT)
        printed, said = process.communicate(timeout=self.TIMEOUT)
        self.assertEqual((process.returncode, printed, said), (INTERRUPTED, '', '%s: interrupted\n' % name))

    def test_each_says_so_in_a_line_while_it_waits_for_the_solver(self):
        pid = self.pid('/cable_solver')
        for name, arguments in (('check_path', ('--clip', 'WH_Start', '--by', '0,0,10mm')), ('report_equilibrium', ()),
                                ('save_scene', ('copy',)), ('stability', ()), ('design_loop', ())):
            os.kill(pid, signal.SIGSTOP)  # so that it waits for certain
            try:
                process = started(name, *arguments)
                self.eventually(lambda: any(each.startswith('/' + name) for each in rosnode.get_node_names()), name)
                time.sleep(0.5)
                self.expectInterrupted(name, process)
            finally:
                os.kill(pid, signal.SIGCONT)

    def test_the_design_is_as_it_was(self):
        def edited():
            return self.latched('/cable_solver/design', DesignState).edited
        self.assertFalse(edited())
        process = started('design_loop')
        self.eventually(edited, 'a clip that is turned')
        self.expectInterrupted('design_loop', process)
        self.assertFalse(edited())


if __name__ == '__main__':
    rospy.init_node('interrupted_clients_test')
    rostest.rosrun('cable_variation', 'interrupted_clients', InterruptedClientsTest, sys.argv)
