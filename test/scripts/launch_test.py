#!/usr/bin/env python3
"""What the launch files start RViz with."""
import os
import subprocess
import unittest


def rviz(launch_file, *arguments, **environment):
    """The command line of RViz, of which nothing is started."""
    command = ['roslaunch', '--args', 'rviz', 'cable_variation', launch_file] + list(arguments)
    clean = {name: value for name, value in os.environ.items() if name != 'LIBGL_ALWAYS_SOFTWARE'}
    done = subprocess.run(command, env={**clean, **environment}, capture_output=True, text=True)
    return done.stdout + done.stderr


class LaunchTest(unittest.TestCase):
    PLAIN = '--disable-anti-aliasing'

    def test_each_shows_its_own_view_with_plain_edges_where_the_processor_draws(self):
        for name in ('harness', 'hose', 'rear_lamp', 'robot_assembly'):
            self.assertRegex(rviz(name + '.launch', LIBGL_ALWAYS_SOFTWARE='1'),
                             '-d [^ ]*/rviz/%s.rviz %s' % (name, self.PLAIN))

    def test_edges_are_smooth_elsewhere_and_as_asked(self):
        self.assertNotIn(self.PLAIN, rviz('harness.launch'))
        self.assertIn(self.PLAIN, rviz('harness.launch', 'anti_aliasing:=false'))


if __name__ == '__main__':
    unittest.main()
