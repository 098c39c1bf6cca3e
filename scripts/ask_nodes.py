#!/usr/bin/python3
"""Starts a ROS master and the nodes of one build with a scene, asks all fixed requests and writes a pickle: the
definitions of the messages, and all answers by request. compare_answers runs it in the environment of the build."""
import argparse
import hashlib
import os
import pickle
import subprocess
import sys
import threading
import time

import actionlib
import cable_variation.msg
import cable_variation.srv
import genpy
import rosgraph
import rospkg
import rospy
import std_srvs.srv

from answers import NO_ANSWER, definitions, plain
from fixed_requests import MOVING, SOLVER, STATIC, fixed_requests

START = 120.0  # for a node to start [s]; generous, the machine may be busy
TOPIC = 60.0  # for a latched topic to tell what it has [s]


class Node:
    """A program that writes to a file of its own."""

    def __init__(self, command, folder):
        self.name = os.path.basename(command[0])
        self.log = os.path.join(folder, self.name + '.log')
        with open(self.log, 'w') as log:
            self.process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT)

    def ended(self):
        """How it ended; empty: it did not."""
        code = self.process.poll()
        return '' if code is None else '%s ended with code %d' % (self.name, code)

    def wait(self, ready):
        """Until ready(); SystemExit with the end of what it wrote if it does not get there."""
        end = time.time() + START
        while not ready():
            if self.ended() or time.time() > end:
                with open(self.log, errors='replace') as log:
                    sys.exit('%s:\n%s' % (self.ended() or '%s did not start within %.0f s' % (self.name, START),
                                          ''.join(log.readlines()[-10:]).rstrip()))
            time.sleep(0.05)

    def stop(self):
        self.process.terminate()
        try:
            self.process.wait(10.0)
        except subprocess.TimeoutExpired:
            self.process.kill()


def offered(name):
    """Whether a topic is published or a service offered."""
    publishers, _, services = rosgraph.Master('/compare_answers').getSystemState()
    return any(name == each for each, _ in publishers + services)


def filled(message, fields):
    """The message with fields by name; those that it does not have are left out."""
    genpy.message.fill_message_args(message, [{field: value for field, value in fields.items()
                                               if field in message.__slots__}])
    return message


def service_kind(name):
    return getattr(cable_variation.srv, name, None) or getattr(std_srvs.srv, name)


def ask_service(request):
    kind = service_kind(request['kind'])
    return rospy.ServiceProxy(request['name'], kind)(filled(kind._request_class(), request['fields']))


def ask_action(request):
    kind = getattr(cable_variation.msg, request['kind'] + 'Action')
    client = actionlib.SimpleActionClient(request['name'], kind)
    if not client.wait_for_server(rospy.Duration(START)):
        raise rospy.ROSException('nobody there')
    client.send_goal(filled(kind().action_goal.goal, request['fields']))
    # An answer quicker than send_goal() is not waited for.
    while not client.wait_for_result(rospy.Duration(0.5)) and client.get_result() is None:
        pass
    return client.get_result()


def ask_topic(request):
    kinds = dict(rosgraph.Master('/compare_answers').getTopicTypes())
    if request['name'] not in kinds:
        raise rospy.ROSException('no such topic')
    return rospy.wait_for_message(request['name'], genpy.message.get_message_class(kinds[request['name']]), TOPIC)


ASK = {'service': ask_service, 'action': ask_action, 'topic': ask_topic}


def answer(request, nodes, patience):
    """The message that answers a request, or a dictionary that says why there is none."""
    found = []

    def ask():
        try:
            found.append(ASK[request['how']](request))
        except Exception as error:  # of whatever kind, there is no answer
            found.append({NO_ANSWER: '%s: %s' % (type(error).__name__, error)})
    thread = threading.Thread(target=ask, daemon=True)  # a client waits for ever for a node that hangs or died
    thread.start()
    end = time.time() + patience
    while thread.is_alive() and time.time() < end and not any(node.ended() for node in nodes):
        thread.join(0.2)
    for node in nodes:
        if node.ended():
            return {NO_ANSWER: node.ended()}
    return found[0] if found else {NO_ANSWER: 'not within %.0f s' % patience}


def content(path, folder):
    """A file as lines, or what is left of one that is no text."""
    with open(path, 'rb') as file:
        data = file.read()
    try:
        return plain(data.decode().splitlines(), folder)
    except UnicodeDecodeError:
        return '%d bytes, md5 %s' % (len(data), hashlib.md5(data).hexdigest())


def title(request):
    return ' '.join(part for part in (request['how'] if request['how'] != 'service' else '', request['name'],
                                      request['label']) if part)


def record(scene, build, work, patience):
    """All answers by request, and the files that were written."""
    package = rospkg.RosPack().get_path('cable_variation')
    output = os.path.join(work, 'output')
    programs = os.path.join(build, 'devel', 'lib', 'cable_variation')
    port = rosgraph.get_master_uri().rsplit(':', 1)[1].strip('/')
    master = Node(['rosmaster', '--core', '-p', port], work)
    nodes = [master]
    try:
        master.wait(rosgraph.is_master_online)
        for name in ('cable_solver', 'moving_geometry_node', 'static_geometry_node'):
            nodes.append(Node([os.path.join(programs, name), '__name:=' + name, '_scene:=' + scene,
                               '_output_directory:=' + output], work))
        for node, name in zip(nodes[1:], (SOLVER + '/get_scene', MOVING + '/seek', STATIC + '/components')):
            node.wait(lambda name=name: offered(name))
        rospy.init_node('compare_answers', anonymous=True, log_level=rospy.FATAL)
        loaded = rospy.ServiceProxy(SOLVER + '/get_scene', cable_variation.srv.GetScene)()
        answers = {}
        for request in fixed_requests(loaded, scene):
            key = title(request)
            assert key not in answers, key
            print(key, file=sys.stderr, flush=True)
            answers[key] = plain(answer(request, nodes, patience), package)
        for file in sorted(os.listdir(output)) if os.path.isdir(output) else []:
            answers['file ' + file] = {'line': content(os.path.join(output, file), package)}
        return answers
    finally:
        for node in reversed(nodes):
            node.stop()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('build')
    parser.add_argument('scene')
    parser.add_argument('work', help='folder for files')
    parser.add_argument('answers', help='file to write')
    parser.add_argument('--patience', type=float, default=600.0, help='for one answer [s]')
    arguments = parser.parse_args()
    answers = record(arguments.scene, arguments.build, arguments.work, arguments.patience)
    with open(arguments.answers, 'wb') as file:
        pickle.dump((definitions(cable_variation.msg, cable_variation.srv), answers), file)
    sys.stdout.flush()
    os._exit(0)  # threads of requests that nobody answered would keep it


if __name__ == '__main__':
    main()
