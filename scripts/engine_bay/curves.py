"""Paths in space for pipes, beams and bent strips."""

import numpy as np

from .polygon import fillet


def filleted(points, radius, segments=8):
    """Straight runs joined by arcs of `radius`, as a pipe or a strip is bent."""
    points = np.asarray(points, float)
    out = [points[0]]
    for i in range(1, len(points) - 1):
        out.extend(fillet(points[i - 1], points[i], points[i + 1], radius, segments))
    return np.array(out + [points[-1]])


def spline(points, count=40):
    """A centripetal Catmull-Rom curve through the points, in steps of equal length."""
    p = np.asarray(points, float)
    p = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    t = np.concatenate([[0], np.cumsum(np.sqrt(np.linalg.norm(np.diff(p, axis=0), axis=1)))])
    fine = []
    for i in range(1, len(p) - 2):
        x = np.linspace(t[i], t[i + 1], 40, endpoint=i == len(p) - 3)[:, None]

        def blend(a, b, ta, tb):
            return ((tb - x) * a + (x - ta) * b) / (tb - ta)

        a = [blend(p[i + k - 1], p[i + k], t[i + k - 1], t[i + k]) for k in range(3)]
        b = [blend(a[k], a[k + 1], t[i + k - 1], t[i + k + 1]) for k in range(2)]
        fine.append(blend(b[0], b[1], t[i], t[i + 1]))
    fine = np.vstack(fine)
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(fine, axis=0), axis=1))])
    at = np.linspace(0, length[-1], count)
    return np.column_stack([np.interp(at, length, fine[:, k]) for k in range(3)])


def smoothstep(x, low, high):
    x = np.clip((x - low) / (high - low), 0, 1)
    return x * x * (3 - 2 * x)


def bead(x, centre, width, ramp):
    """1 on a band of `width` about `centre`, falling to 0 over `ramp` on both sides."""
    return 1 - smoothstep(np.abs(x - centre), width / 2, width / 2 + ramp)
