"""What the command line clients of cable_solver share."""
import argparse
import difflib
import math
import os
import sys

import rosgraph
import rospy
from cable_variation.msg import Status
from cable_variation.srv import GetScene

UNITS = {'deg': math.pi / 180, 'mm': 1e-3, 'rad': 1.0, 'm': 1.0, '': 1.0}

PATIENCE = 30  # for a service to show up [s]

# What people use: name and size in SI.
PEOPLE = {'m': ('mm', 1e-3), 'rad': ('deg', math.pi / 180), 'Pa': ('MPa', 1e6), '1': ('%', 1e-2)}


def people(unit):
    return PEOPLE.get(unit, (unit, 1.0))


def number(value, unit, digits=4, sign=False):
    """A value in SI as a number in the unit that people use, without the unit; a dash: it is not defined."""
    if math.isnan(value):
        return '-'
    return ('%+.*g' if sign else '%.*g') % (digits, value / people(unit)[1])


def deviations(variables, values):
    """Deviations from nominal in units that people use, the largest shares of their tolerances first and those
    that hardly matter left out; empty: none is left."""
    shares = []
    for variable, deviation in zip(variables, values):
        limit = variable.upper if deviation > 0 else -variable.lower
        if limit > 0 and abs(deviation) > 0.02 * limit:
            shares.append((abs(deviation) / limit, '%s %s\N{NO-BREAK SPACE}%s' % (
                variable.name, number(deviation, variable.unit, 3, sign=True), people(variable.unit)[0])))
    return ', '.join(text for _, text in sorted(shares, key=lambda share: -share[0]))


def parse_value(text):
    """A number in SI units, mm or deg, as an SI value."""
    digits = text.rstrip('abcdefghijklmnopqrstuvwxyz ')
    unit = text[len(digits):].strip()
    try:
        return float(digits) * UNITS[unit]
    except (ValueError, KeyError):
        raise argparse.ArgumentTypeError("'%s': expected a number, in SI units, mm or deg" % text)


def parse_length(text):
    """A number in m or mm as metres."""
    if text.rstrip().endswith(('deg', 'rad')):
        raise argparse.ArgumentTypeError("'%s': is an angle; expected a length, in m or mm" % text)
    return parse_value(text)


def parse_share(text):
    """0.02 or 2%, as 0.02."""
    try:
        return float(text[:-1]) / 100 if text.endswith('%') else float(text)
    except ValueError:
        raise argparse.ArgumentTypeError("'%s': expected a share, such as 0.02 or 2%%" % text)


def parse_count(text):
    """A whole number from 1: an option that is left out stands for the default, 0 for nothing."""
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError("'%s': expected a whole number from 1, or the option left out" % text)
    return int(text)


def parse_variable(text):
    """NAME=VALUE, in SI units, mm or deg, as (name, SI value)."""
    name, equals, value = text.partition('=')
    if not equals:
        raise argparse.ArgumentTypeError("'%s': expected NAME=VALUE, in SI units, mm or deg" % text)
    return name, parse_value(value)


def start(name):
    """Becomes a node; SystemExit without a ROS master. Ctrl-C stays what it is in Python, see run()."""
    if not rosgraph.is_master_online():
        sys.exit('no ROS master at %s' % rosgraph.get_master_uri())
    # What goes wrong the client says itself, in one line.
    rospy.init_node(name, anonymous=True, disable_signals=True, log_level=rospy.FATAL)


def nearest_service(name):
    """What somebody may have meant by the name of a service that is not there: '; did you mean ...?', or nothing."""
    services = [each for each, _ in rosgraph.Master(rospy.get_name()).getSystemState()[2]]
    close = difflib.get_close_matches(name, services, 1)
    return "; did you mean '%s'?" % close[0] if close else ''


def call(node, service, kind, accepted=(Status.SUCCESS,), **request):
    """The answer of a service; SystemExit with its message unless its status is one that is accepted."""
    name = rospy.resolve_name('%s/%s' % (node, service))
    try:
        rospy.wait_for_service(name, timeout=PATIENCE)
    except rospy.ROSException:
        sys.exit('%s: nobody there within %d s%s' % (name, PATIENCE, nearest_service(name)))
    try:
        answer = rospy.ServiceProxy(name, kind)(**request)
    except (rospy.ROSException, rospy.ServiceException) as error:
        sys.exit('%s: %s' % (name, error))
    if answer.status.code not in accepted:
        for warning in getattr(answer, 'warnings', []):
            print('warning: ' + warning, file=sys.stderr)
        sys.exit('%s: status %d: %s' % (name, answer.status.code, answer.status.message))
    return answer


def scene_of(node):
    """The scene in force; implausible values in its file are printed as warnings."""
    scene = call(node, 'get_scene', GetScene)
    for warning in scene.warnings:
        print('warning: ' + warning, file=sys.stderr)
    return scene


INTERRUPTED = 130  # exit code, as a shell says that SIGINT ended a program


def run(main):
    """Runs main(); a reader that has read enough, as head(1) does, is no error, and Ctrl-C ends it with a line."""
    try:
        main()
        sys.stdout.flush()
    except KeyboardInterrupt:
        print('%s: interrupted' % os.path.basename(sys.argv[0]), file=sys.stderr)
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


WIDTH = 100  # of what is printed, in characters


def shortened(text, width):
    return text if len(text) <= width else text[:width - 2] + '..'


def table(header, rows, left=1):
    """Prints columns as wide as they need to be, the first `left` of them flush left. Where they are wider
    than WIDTH together, they move closer; then the first one is shortened, as far as that makes sense."""
    widths = [max(len(row[i]) for row in [header] + rows) for i in range(len(header))]
    gap = 2 if sum(widths) + 2 * len(widths) <= WIDTH else 1
    widths[0] = max(min(widths[0], 10), widths[0] - max(0, sum(widths) + 1 + gap * len(widths) - WIDTH))
    for row in [header] + rows:
        row = [shortened(row[0], widths[0])] + row[1:]
        cells = [cell.ljust(width) if i < left else cell.rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        print(('  ' + (gap * ' ').join(cells)).rstrip())


def print_wrapped(text):
    """Lines of at most WIDTH characters, broken at spaces but those that do not break (U+00A0)."""
    line = ' '
    for word in filter(None, text.replace('\n', ' ').split(' ')):
        if len(line) + 1 + len(word) > WIDTH and line.strip():
            print(line)
            line = '   '
        line += ' ' + word.replace('\N{NO-BREAK SPACE}', ' ')
    print(line)
