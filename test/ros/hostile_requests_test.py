#!/usr/bin/env python3
"""Every field of every request with values that nobody means, and requests of bytes that are none: the nodes live, and
answer the next one as before."""
import copy
import io
import math
import random
import sys
import time

import genmsg.msgs
import roslib.message
import rospy
import rostest
from cable_variation.msg import Status
from cable_variation.srv import (AnalyzeStability, CheckForbiddenRegion, CheckPath, GenerateEnvelope, GetScene,
                                 LoadScene, SaveScene, Seek, SetAttachment, SetDesign, SimulateVariation,
                                 SolveEquilibrium)
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from nav_msgs.msg import Path
from node_client import DATA, NodeTest, xyz
from std_srvs.srv import Trigger


class Bytes(str):
    """A string that is sent as bytes which need not be UTF-8."""

    def __new__(cls, raw):
        text = super().__new__(cls, raw.decode('latin-1'))
        text.raw = raw
        return text

    def encode(self, *_):
        return self.raw


NUMBERS = [math.nan, math.inf, -math.inf, 1e300, -1e300, 5e-324, -1.0]
INNER_ENOUGH = ('-inf', '-1e+300', '5e-324', '-1.0')  # of which elements and members are not tried as well
NAMES = ['', 'nobody', 'x' * 1000000, Bytes(b'\xff\xfe\x80'), Bytes(b'\0'), Bytes(b'a\0b'), '%s%n%p', '\x1b[2J', '../../x',
         '/', '*', ' ', '"\'`$(id);', '\N{GRINNING FACE}' * 1000, 'file:///dev/zero', 'package://', 'http://localhost/x']
MANY, MILLION = 50000, 1000000
# What a request says of how much is to be computed: so much is for actions, which can be cancelled.
AMOUNTS = {'samples', 'verification_shapes', 'tightness_shapes'}
LONG = {'check_path', 'generate_envelope', 'simulate_variation'}


def path(*places):
    return Path(poses=[PoseStamped(pose=Pose(Point(*place), Quaternion(0, 0, 0, 1))) for place in places])


# Requests that are answered well, and quickly: one field after another is made another one.
SOLVER = {
    'solve_equilibrium': (SolveEquilibrium, dict(variables=['b_z'], values=[0.001], motion='away', time=0.1)),
    'analyze_stability': (AnalyzeStability, dict(variables=['b_z'], measures=['height'], nominal_variables=['b_z'],
                                                 nominal_values=[0.001], show='b_z', report='hostile')),
    'generate_envelope': (GenerateEnvelope, dict(variables=['b_z'], cables=['strand'], motions=['away'], to_time=0.01,
                                                 verification_shapes=1, mesh_excess=5e-3, name='hostile')),
    'simulate_variation': (SimulateVariation, dict(variables=['b_z'], measures=['height'], samples=10, name='hostile')),
    'check_forbidden_region': (CheckForbiddenRegion, dict(region='hostile', components=['holder'])),
    'check_path': (CheckPath, dict(component='holder', path=path((0.25, 0, 0), (0.24, 0, 0)), step=0.5, report='hostile')),
    'load_scene': (LoadScene, dict(scene=DATA + 'attachments.yaml')),
    'save_scene': (SaveScene, dict(name='hostile', overwrite=True)),
    'set_attachment': (SetAttachment, dict(clip='ring', attached=True, reach=0.2, opens=['B'])),
    'set_design': (SetDesign, dict(variables=['b_z'], values=[0.001])),
}
ELEMENTS = {'cable': 'strand', 'component': 'holder', 'clip': 'B'}  # of edits


def variants(value, kind):
    """What a field may be instead of its value, for each a label."""
    base, is_array, _ = genmsg.msgs.parse_type(kind)
    if is_array:
        element = value[0] if value else default(base)
        yield 'empty', type(value)()
        yield 'many', [element] * MANY
        yield 'two', [element] * 2
        for label, each in variants(element, base):
            yield label, [each] + list(value[1:])
    elif base == 'time':
        for time_of_day in (rospy.Time(1), rospy.Time(0xffffffff, 999999999)):
            yield repr(time_of_day), time_of_day
    elif base == 'string':
        for name in NAMES:
            yield repr(name[:20]), name
    elif base in ('float32', 'float64'):
        for number in NUMBERS:
            yield repr(number), number
    elif base == 'bool':
        yield 'other', not value
        yield '255', 255
    elif base.startswith(('int', 'uint')):
        bits = int(base.lstrip('uint'))
        for number in {0, 1, (1 << bits) - 1 if base[0] == 'u' else (1 << bits - 1) - 1}:
            yield repr(number), number
    elif base not in ('Header', 'std_msgs/Header'):  # all of it is data that nobody looks at but for its frame
        for name, inner in zip(value.__slots__, value._slot_types):
            for label, each in variants(getattr(value, name), inner):
                if label.endswith(INNER_ENOUGH):
                    continue
                other = copy.deepcopy(value)
                setattr(other, name, each)
                yield '%s %s' % (name, label), other


def default(kind):
    if kind in genmsg.msgs.BUILTIN_TYPES:
        return 'b_z' if kind == 'string' else 0
    message = roslib.message.get_message_class(kind)()
    for name, value in ELEMENTS.items():
        if hasattr(message, name):
            setattr(message, name, value)
    return message


def requests(kind, fields):
    """The good request with one field after the other made another one, with labels."""
    good = kind._request_class(**fields)
    for name, inner in zip(good.__slots__, good._slot_types):
        for label, value in variants(getattr(good, name), inner):
            if name in AMOUNTS and isinstance(value, int) and value > 100:
                continue
            request = copy.copy(good)
            setattr(request, name, value)
            yield '%s %s' % (name, label), request


def damaged(kind, fields, count, seed=1):
    """The good request's bytes: cut off, continued, counts and lengths that are too large, some changed at random."""
    good = kind._request_class(**fields)
    buffer = io.BytesIO()
    good.serialize(buffer)
    good = buffer.getvalue()

    class Raw(kind._request_class):
        def serialize(self, buff):
            buff.write(self.raw)
    draw = random.Random(seed)
    for i in range(count):
        raw = bytearray(good)
        place = draw.randrange(len(raw))
        if i % 4 == 0:
            raw = raw[:place]
        elif i % 4 == 1:
            raw[place:place + 4] = draw.choice((b'\xff\xff\xff\xff', b'\xff\xff\xff\x7f', b'\0\0\0\x80'))
        elif i % 4 == 2:
            raw += bytes(draw.randrange(256) for _ in range(draw.randrange(1, 100)))
        else:
            for _ in range(draw.randrange(1, 10)):
                raw[draw.randrange(len(raw))] = draw.randrange(256)
        request = Raw()
        request.raw = bytes(raw)
        yield request


class HostileRequestsTest(NodeTest):
    LONGEST = 20000  # of a message, in bytes: faults of a scene are listed

    def state(self):
        answer = self.service('/cable_solver/solve_equilibrium', SolveEquilibrium)()
        self.assertSuccess(answer.status)
        return [xyz(each.position) for each in answer.shapes[0].section]

    def setUp(self):
        self.assertSuccess(self.service('/cable_solver/load_scene', LoadScene)(DATA + 'attachments.yaml').status)
        self.nodes = {node: self.pid(node) for node in ('/cable_solver', '/moving_geometry_node')}
        self.before = self.state()

    def tearDown(self):
        self.assertTrue(self.service('/cable_solver/reset_design', Trigger)().success)
        self.assertSuccess(self.service('/cable_solver/load_scene', LoadScene)(DATA + 'attachments.yaml').status)
        self.assertEqual(self.state(), self.before)
        self.assertEqual({node: self.pid(node) for node in self.nodes}, self.nodes)

    def attack(self, service, kind, fields):
        proxy = self.service(service, kind)
        refused = []  # (seconds, label)
        for label, request in requests(kind, fields):
            start = time.time()
            answer = proxy(request)  # a node that dies or throws makes this fail
            seconds = time.time() - start
            status = getattr(answer, 'status', None)
            if status is None:
                continue
            if status.code != Status.SUCCESS:
                refused.append((seconds, label))
            self.assertNotEqual(status.code, Status.INTERNAL_ERROR, '%s: %s' % (label, status.message))
            self.assertLess(len(status.message), self.LONGEST, label)
            self.assertEqual(status.message == '', status.code == Status.SUCCESS, label)
            status.message.encode()  # it is UTF-8, which Python would have replaced
            self.assertNotIn('\N{REPLACEMENT CHARACTER}', status.message, label)
            self.assertFalse([each for each in status.message if each < ' ' and each != '\n'], label)
        refused.sort()
        if refused:
            print('%s: %d refused, half of them within %.1f ms; longest: %s' % (
                service, len(refused), 1e3 * refused[len(refused) // 2][0],
                ', '.join('%.0f ms for %s' % (1e3 * seconds, label) for seconds, label in refused[-3:])))


    def test_a_million_names(self):
        for name in ('solve_equilibrium', 'analyze_stability', 'set_design', 'generate_envelope', 'simulate_variation'):
            kind, fields = SOLVER[name]
            fields = dict(fields, variables=['b_z'] * MILLION)
            if 'values' in fields:
                fields['values'] = [0.001] * MILLION
            status = self.service('/cable_solver/' + name, kind)(**fields).status
            self.assertRefused(status, Status.INVALID_ARGUMENT, "'b_z'")

    def attack_by_bytes(self, service, kind, fields, count=40):
        """They are refused by the status, or by ROS, which cannot read them. What changes at random how much is to be
        computed is left out."""
        fields = {name: value for name, value in fields.items() if name not in AMOUNTS}
        proxy = self.service(service, kind)
        for request in damaged(kind, fields, count):
            try:
                status = getattr(proxy(request), 'status', None)
            except rospy.ServiceException:
                continue
            if status is not None:
                self.assertNotEqual(status.code, Status.INTERNAL_ERROR, '%r: %s' % (request.raw, status.message))


def attacks(name, kind, fields):
    def test(self):
        if name == 'check_forbidden_region':
            self.assertSuccess(self.service('/cable_solver/generate_envelope', GenerateEnvelope)(
                variables=['b_z'], verification_shapes=1, mesh_excess=5e-3, name='hostile').status)
        self.attack('/cable_solver/' + name, kind, fields)
        if name not in LONG:
            self.attack_by_bytes('/cable_solver/' + name, kind, fields)
    return test


for each, (each_kind, each_fields) in SOLVER.items():
    setattr(HostileRequestsTest, 'test_' + each, attacks(each, each_kind, each_fields))


def seek(self):
    self.attack('/moving_geometry_node/seek', Seek, dict(time=0.1))
    self.attack_by_bytes('/moving_geometry_node/seek', Seek, dict(time=0.1))
    self.service('/cable_solver/get_scene', GetScene)()


HostileRequestsTest.test_seek = seek


if __name__ == '__main__':
    rospy.init_node('hostile_requests_test')
    rostest.rosrun('cable_variation', 'hostile_requests', HostileRequestsTest, sys.argv)
