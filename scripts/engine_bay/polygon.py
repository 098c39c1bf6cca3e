"""Plane outlines: shapes, rounding, offsetting and triangulation with holes."""

import numpy as np


def circle(radius, count=32, centre=(0.0, 0.0)):
    angle = 2 * np.pi * np.arange(count) / count
    return np.column_stack([np.cos(angle), np.sin(angle)]) * radius + centre


def slot(length, width, count=16, centre=(0.0, 0.0), angle=0.0):
    """A hole with parallel sides and round ends; `length` over all, along x before turning [rad]."""
    half = np.pi * (np.arange(count // 2 + 1) / (count // 2) - 0.5)
    end = np.column_stack([np.cos(half), np.sin(half)]) * width / 2
    points = np.vstack([end + [(length - width) / 2, 0], -end - [(length - width) / 2, 0]])
    c, s = np.cos(angle), np.sin(angle)
    return points @ np.array([[c, s], [-s, c]]) + centre


def rounded(points, radius, segments=4):
    """The closed polygon with every corner replaced by an arc of `radius` (one, or one per corner)."""
    points = np.asarray(points, float)
    radii = np.broadcast_to(radius, len(points))
    out = []
    for i, corner in enumerate(points):
        out.extend(fillet(points[i - 1], corner, points[(i + 1) % len(points)], radii[i], segments))
    return np.array(out)


def fillet(before, corner, after, radius, segments):
    """Points of the arc that replaces `corner` between its neighbours; works in the plane and in space."""
    u, v = before - corner, after - corner
    u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
    opening = np.arccos(np.clip(u @ v, -1, 1))
    if radius <= 0 or np.pi - opening < 1e-6:
        return [corner]
    bisector = (u + v) / np.linalg.norm(u + v)
    centre = corner + bisector * radius / np.sin(opening / 2)
    side = (u - v) / np.linalg.norm(u - v)
    sweep = (np.pi - opening) / 2
    angles = np.linspace(-sweep, sweep, segments + 1)
    return [centre + radius * (-np.cos(a) * bisector - np.sin(a) * side) for a in angles]


def rectangle(width, height, radius=0.0, segments=4, centre=(0.0, 0.0)):
    w, h = width / 2, height / 2
    corners = np.array([[-w, -h], [w, -h], [w, h], [-w, h]])
    return (rounded(corners, radius, segments) if radius > 0 else corners) + centre


def regular(count, across_flats, turn=0.0):
    return circle(across_flats / 2 / np.cos(np.pi / count), count) @ np.array(
        [[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]
    )


def area(outline):
    x, y = outline[:, 0], outline[:, 1]
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def inset(outline, distance):
    """Every side moved by `distance` to the left of its direction: inwards, if counter-clockwise."""
    before, after = outline - np.roll(outline, 1, axis=0), np.roll(outline, -1, axis=0) - outline
    n0 = np.column_stack([-before[:, 1], before[:, 0]])
    n1 = np.column_stack([-after[:, 1], after[:, 0]])
    n0 /= np.linalg.norm(n0, axis=1, keepdims=True)
    n1 /= np.linalg.norm(n1, axis=1, keepdims=True)
    both = n0 + n1
    return outline + distance * 2 * both / np.sum(both**2, axis=1, keepdims=True)


def _cross(a, b, c):
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])


def _bridge(points, ring, hole, others):
    """Splices `hole` into `ring` along the shortest cut that crosses no loop; all are lists of indices."""
    p, h = points[ring], points[hole]
    distance = np.linalg.norm(p[:, None] - h[None], axis=2)
    sides = [(loop, np.roll(loop, -1, axis=0)) for loop in (p, h, *(points[other] for other in others))]
    for flat in np.argsort(distance, axis=None, kind="stable"):
        i, j = divmod(int(flat), len(hole))
        a, b = p[i], h[j]
        crossed = any(
            np.any((_cross(a, b, s) * _cross(a, b, e) < 0) & (_cross(s, e, a) * _cross(s, e, b) < 0))
            for s, e in sides
        )
        if not crossed and _opens_to(points[ring[i - 1]], a, points[ring[(i + 1) % len(ring)]], b):
            return ring[: i + 1] + hole[j:] + hole[: j + 1] + ring[i:]
    raise ValueError("a hole cannot be reached from the outline")


def _opens_to(before, corner, after, target):
    """Whether `target` lies in the interior angle of a counter-clockwise ring's corner."""
    left_of_first, left_of_second = _cross(before, corner, target) > 0, _cross(corner, after, target) > 0
    if _cross(before, corner, after) >= 0:
        return left_of_first and left_of_second
    return left_of_first or left_of_second


def triangulate(outline, holes=()):
    """Counter-clockwise triangles of a counter-clockwise outline less its clockwise holes.

    Indices run through the outline, then through each hole.
    """
    points = np.vstack([outline, *holes])
    ring, start = list(range(len(outline))), len(outline)
    loops = []
    for hole in holes:
        loops.append(list(range(start, start + len(hole))))
        start += len(hole)
    loops.sort(key=lambda loop: -points[loop, 0].max())
    for number, loop in enumerate(loops):
        ring = _bridge(points, ring, loop, loops[number + 1 :])
    triangles = _clip_ears(points, ring)
    return _flip(points, triangles)


def _clip_ears(points, ring):
    ring, triangles, at = list(ring), [], 0
    while len(ring) > 3:
        for _ in range(len(ring)):
            i, j, k = ring[at - 1], ring[at], ring[(at + 1) % len(ring)]
            a, b, c = points[i], points[j], points[k]
            if _cross(a, b, c) > 1e-14:
                others = points[[v for v in ring if v not in (i, j, k)]]
                inside = (
                    (_cross(a, b, others) >= -1e-15) & (_cross(b, c, others) >= -1e-15) & (_cross(c, a, others) >= -1e-15)
                )
                if not inside.any():
                    break
            at = (at + 1) % len(ring)
        else:
            raise ValueError("an outline crosses itself")
        triangles.append((i, j, k))
        del ring[at]
        at %= len(ring)
    return np.array(triangles + [tuple(ring)])


def _flip(points, triangles):
    """Lawson's flips: the same region in better-shaped (constrained Delaunay) triangles."""
    triangles = [list(t) for t in triangles]
    edges = {(t[e], t[(e + 1) % 3]): n for n, t in enumerate(triangles) for e in range(3)}
    queue = sorted(edges)
    while queue:
        a, b = queue.pop()
        n, m = edges.get((a, b)), edges.get((b, a))
        if n is None or m is None:
            continue
        c = next(v for v in triangles[n] if v not in (a, b))
        d = next(v for v in triangles[m] if v not in (a, b))
        pa, pb, pc, pd = points[[a, b, c, d]]
        if _cross(pd, pb, pc) <= 1e-14 or _cross(pc, pa, pd) <= 1e-14:
            continue
        cosines = [(u @ v) / np.linalg.norm(u) / np.linalg.norm(v) for u, v in ((pa - pc, pb - pc), (pa - pd, pb - pd))]
        if np.arccos(np.clip(cosines, -1, 1)).sum() <= np.pi + 1e-6:
            continue
        for gone in ((a, b), (b, a)):
            del edges[gone]
        triangles[n], triangles[m] = [d, b, c], [c, a, d]
        for t, number in ((triangles[n], n), (triangles[m], m)):
            for e in range(3):
                edges[(t[e], t[(e + 1) % 3])] = number
        queue.extend([(d, b), (b, c), (c, a), (a, d)])
    return np.array(triangles)
