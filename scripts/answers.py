"""Answers of the nodes as plain data, and where two of them differ."""
import re
import struct

# Fields that differ from run to run, and why; of every message that has them.
DURATION = 'how long the calculation took'
LEFT_OUT = {
    'linear_time': DURATION, 'resolve_time': DURATION, 'solve_time': DURATION, 'verify_time': DURATION,
    'clearance_time': DURATION, 'surface_time': DURATION, 'simulation_time': DURATION, 'report_time': DURATION,
    'samples_per_second': DURATION,
    'stamp': 'time of day',
    'seq': 'counts what was published',
}
# In reports.
TIME_OF_DAY = re.compile(r'\d{4}-\d\d-\d\d[ T]\d\d:\d\d(:\d\d)?')
NO_ANSWER = 'no answer'  # the only field of what stands for an answer that there is not


def plain(value, folder):
    """A message, or the value of a field, as dictionaries, lists and numbers, without the fields LEFT_OUT. Paths in
    `folder`, where the package's sources are, and times of day are the same wherever and whenever it was asked."""
    if hasattr(value, '_slot_types'):
        return {field: plain(getattr(value, field), folder) for field in value.__slots__ if field not in LEFT_OUT}
    if isinstance(value, (list, tuple)):
        return [plain(each, folder) for each in value]
    if isinstance(value, str):
        return TIME_OF_DAY.sub('TIME', value.replace(folder, 'PACKAGE'))
    if hasattr(value, 'to_nsec'):
        return value.to_nsec()
    return value


def same(old, new):
    """Bit for bit, so 0 and -0 are two; what is not a number is the same whatever its bits."""
    if isinstance(old, float) and isinstance(new, float):
        return struct.pack('<d', old) == struct.pack('<d', new) or (old != old and new != new)
    return old == new


def differences(old, new, path=''):
    """(path, old value, new value) of everything that differs in what both have; lists of different lengths are
    compared as far as the shorter one goes."""
    if isinstance(old, dict) and isinstance(new, dict) and (NO_ANSWER in old) == (NO_ANSWER in new):
        for field in old:
            if field in new:
                yield from differences(old[field], new[field], path + '.' + field if path else field)
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield 'length of ' + path, len(old), len(new)
        for i, (a, b) in enumerate(zip(old, new)):
            yield from differences(a, b, '%s[%d]' % (path, i))
    elif not same(old, new):
        yield path, old, new


def definitions(*modules):
    """Fields and constants with their types of each message and service of generated modules:
    {message: {field: type}}."""
    found = {}
    for module in modules:
        for kind in vars(module).values():
            if hasattr(kind, '_slot_types'):
                fields = dict(zip(kind.__slots__, kind._slot_types))
                constants = {name: 'constant' for name in vars(kind)
                             if name.isupper() and not name.startswith('_') and name not in fields}
                found[kind._type.split('/')[-1]] = {**constants, **fields}
    return found


def definition_differences(old, new):
    """Lines that tell which messages and fields are in one of two definitions only, or have another type."""
    for message in sorted(old.keys() | new.keys()):
        if message not in old or message not in new:
            yield '%s: only in %s' % (message, 'OLD' if message in old else 'NEW')
            continue
        a, b = old[message], new[message]
        for field in sorted(a.keys() | b.keys()):
            if field not in a or field not in b:
                yield '%s.%s: only in %s' % (message, field, 'OLD' if field in a else 'NEW')
            elif a[field] != b[field]:
                yield '%s.%s: %s in OLD, %s in NEW' % (message, field, a[field], b[field])
