#!/usr/bin/env python3
"""moving_geometry_node: motions from a TUM file and from a rosbag, on tf."""
import math
import sys

import rospy
import rostest
from cable_variation.msg import Status
from cable_variation.srv import Seek
from node_client import NodeTest, xyz
from std_srvs.srv import SetBool
from visualization_msgs.msg import MarkerArray


class MovingGeometryTest(NodeTest):
    def halt(self, node, time):
        """Stops the node's motion at `time`."""
        self.assertTrue(self.service(node + '/play', SetBool)(False).success)
        self.assertSuccess(self.service(node + '/seek', Seek)(time).status)

    def test_tum_file_plays_by_itself_and_again(self):
        self.assertTrue(self.service('/moving_tum/play', SetBool)(True).success)
        seen = []

        def turned_on_and_back():
            seen.append(self.transform('floor', 'table').translation.y)
            return len(seen) > 1 and min(seen[1:]) < seen[0] - 0.01 or seen[-1] < max(seen) - 0.01
        self.eventually(turned_on_and_back, 'the motion to start again')

    def test_seek_puts_a_tum_motion_there(self):
        self.halt('/moving_tum', 2.0)

        def there():
            where = self.transform('floor', 'table')
            # Half way from 1 s, (0.1, 0), 45 degrees to 3 s, (0.1, 0.2), 90 degrees.
            angle = 2 * math.atan2(where.rotation.z, where.rotation.w)
            return abs(where.translation.y - 0.1) < 1e-9 and abs(angle - math.radians(67.5)) < 1e-9
        self.eventually(there, 'table at 2 s')

    def test_what_rides_on_a_moving_part_moves_along(self):
        self.halt('/moving_tum', 3.0)

        def there():
            tool = xyz(self.transform('floor', 'tool').translation)
            return all(abs(a - b) < 1e-9 for a, b in zip(tool, (0.1, 1.2, 0.0)))
        self.eventually(there, 'tool at the turned table')

    def test_bag_plays_from_tf_and_from_a_pose_topic(self):
        self.halt('/moving_bag', 1.05)

        def there():
            sled = self.transform('world', 'sled').translation
            lid = self.transform('sled', 'lid').translation
            return abs(sled.x - 0.0525) < 1e-7 and abs(lid.z - 0.021) < 1e-7
        self.eventually(there, 'sled and lid at 1.05 s')

    def test_without_loop_it_stays_at_the_end(self):
        def height():
            return self.transform('once_world', 'once').translation.y
        self.eventually(lambda: abs(height() - 0.2) < 1e-12, 'the end')
        self.assertTrue(self.service('/moving_once/play', SetBool)(True).success)
        self.eventually(lambda: height() < 0.19, 'a new start')  # 3 s at twice the speed
        self.eventually(lambda: abs(height() - 0.2) < 1e-12, 'the end again')
        rospy.sleep(0.3)
        self.assertAlmostEqual(height(), 0.2)

    def test_refuses_times_outside_of_the_recording(self):
        seek = self.service('/moving_tum/seek', Seek)
        for time in (-0.1, 3.1, float('nan'), float('inf')):
            self.assertRefused(seek(time).status, Status.INVALID_ARGUMENT, 'expected 0 to 3 s')

    def test_a_scene_without_motions_says_so(self):
        answer = self.service('/moving_none/play', SetBool)(True)
        self.assertFalse(answer.success)
        self.assertIn('no motions', answer.message)

    def test_markers_of_moving_parts_only(self):
        markers = self.latched('/moving_tum/components', MarkerArray).markers
        self.assertEqual(sorted((each.ns, each.header.frame_id) for each in markers),
                         [('component/table', 'table'), ('component/tool', 'tool')])


if __name__ == '__main__':
    rospy.init_node('moving_geometry_test')
    rostest.rosrun('cable_variation', 'moving_geometry', MovingGeometryTest, sys.argv)
