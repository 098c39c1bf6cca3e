"""What the command line clients of cable_solver's actions share."""
import math
import sys
import threading
import time

import actionlib
import rospy

from solver_client import INTERRUPTED

PATIENCE = 30.0  # for the solver to show up, and to say that it stopped [s]


class StatusLine:
    """One line on a terminal, written over again; nothing elsewhere."""

    def __init__(self, stream):
        self.stream = stream
        self.shown = stream.isatty()
        self.lock = threading.Lock()
        self.width = 0

    def clear(self):
        self.write('')
        self.shown = False

    def write(self, text):
        with self.lock:
            if self.shown:
                self.stream.write('\r' + text.ljust(self.width) + ('' if text else '\r'))
                self.width = len(text)
                self.stream.flush()


def bar(share, width):
    """Share done as [######..................]  25 %"""
    done = round(width * min(max(share, 0.0), 1.0))
    return '[%s%s] %3.0f %%' % ('#' * done, '.' * (width - done), 100 * share)


def duration(seconds):
    for name, size in (('s', 1), ('min', 60), ('h', 3600)):
        if seconds < 100 * size:
            break
    return '%.0f %s' % (math.ceil(seconds / size), name)


def time_left(seconds):
    """Of an estimate; empty: there is none yet."""
    return 'about %s left' % duration(seconds) if seconds >= 0 else ''


def count(value, what):
    return '%s %s%s' % (format(value, ','), what, '' if value == 1 else 's')


def act(node, action, kind, goal, line, draw):
    """Has an action of a node done while draw(feedback) writes `line`. Ctrl-C cancels it. Returns its result and
    how long it took to stop after Ctrl-C [s], None: it was not asked to. SystemExit: there is no answer."""
    name = rospy.resolve_name('%s/%s' % (node, action))
    client = actionlib.SimpleActionClient(name, kind)
    if not client.wait_for_server(rospy.Duration(PATIENCE)):
        sys.exit('%s: nobody there within %.0f s' % (name, PATIENCE))
    client.send_goal(goal, feedback_cb=draw)
    stopping = None
    try:
        while not client.wait_for_result(rospy.Duration(0.5)):
            # An answer quicker than send_goal() is not waited for.
            if client.get_result() is not None:
                break
            # A solver that died never answers.
            if client.action_client.pub_goal.get_num_connections() == 0:
                line.clear()
                sys.exit('%s: the solver is gone' % name)
    except KeyboardInterrupt:
        line.clear()
        asked = time.time()
        client.cancel_goal()
        if not client.wait_for_result(rospy.Duration(PATIENCE)):
            print('asked to stop, no answer', file=sys.stderr)
            sys.exit(INTERRUPTED)
        stopping = time.time() - asked
    line.clear()
    return client.get_result(), stopping
