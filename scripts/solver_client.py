"""What the command line clients of cable_solver share."""
import argparse
import math
import os
import sys

import rosgraph
import rospy
from cable_variation.msg import Status

UNITS = {'deg': math.pi / 180, 'mm': 1e-3, 'rad': 1.0, 'm': 1.0, '': 1.0}


def parse_variable(text):
    """NAME=VALUE, in SI units, mm or deg, as (name, SI value)."""
    name, equals, value = text.partition('=')
    number = value.rstrip('abcdefghijklmnopqrstuvwxyz ')
    unit = value[len(number):].strip()
    if not equals or unit not in UNITS:
        raise argparse.ArgumentTypeError("'%s': expected NAME=VALUE, in SI units, mm or deg" % text)
    try:
        return name, float(number) * UNITS[unit]
    except ValueError:
        raise argparse.ArgumentTypeError("'%s': '%s' is not a number" % (text, number))


def start(name):
    """Becomes a node; SystemExit without a ROS master."""
    if not rosgraph.is_master_online():
        sys.exit('no ROS master at %s' % rosgraph.get_master_uri())
    rospy.init_node(name, anonymous=True)


def call(node, service, kind, **request):
    """The answer of a service; SystemExit with its message unless it succeeded."""
    name = rospy.resolve_name('%s/%s' % (node, service))
    try:
        rospy.wait_for_service(name, timeout=30)
        answer = rospy.ServiceProxy(name, kind)(**request)
    except (rospy.ROSException, rospy.ServiceException) as error:
        sys.exit('%s: %s' % (name, error))
    if answer.status.code != Status.SUCCESS:
        sys.exit('%s: status %d: %s' % (name, answer.status.code, answer.status.message))
    return answer


def run(main):
    """Runs main(); a reader that has read enough, as head(1) does, is no error."""
    try:
        main()
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


WIDTH = 100  # of what is printed, in characters


def shortened(text, width):
    return text if len(text) <= width else text[:width - 2] + '..'


def table(header, rows, left=1):
    """Prints columns as wide as they need to be, the first `left` of them flush left. Where they are wider
    than WIDTH together, the first one is shortened."""
    widths = [max(len(row[i]) for row in [header] + rows) for i in range(len(header))]
    widths[0] -= max(0, sum(widths) + 2 * len(widths) - WIDTH)
    for row in [header] + rows:
        row = [shortened(row[0], widths[0])] + row[1:]
        cells = [cell.ljust(width) if i < left else cell.rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        print(('  ' + '  '.join(cells)).rstrip())
