"""Closed solids: plates with holes, boxes, bodies of revolution, sweeps, pressed sheets, bolts."""

import numpy as np

from .mesh import Mesh, join, strips, unit, weld
from .polygon import area, circle, inset, rectangle, regular, triangulate


def _bevelled(outline, z0, z1, bevel, segments):
    """Rings up the wall of an extrusion, with its two edges rounded."""
    if bevel <= 0:
        return [np.column_stack([outline, np.full(len(outline), z)]) for z in (z0, z1)]
    rings = []
    angles = np.linspace(0, np.pi / 2, segments + 1)
    for z, sign, order in ((z0 + bevel, -1, angles[::-1]), (z1 - bevel, 1, angles)):
        for a in order:
            flat = inset(outline, bevel * (1 - np.cos(a)))
            rings.append(np.column_stack([flat, np.full(len(flat), z + sign * bevel * np.sin(a))]))
    return rings


def plate(outline, z0, z1, holes=(), bevel=0.0, segments=2):
    """An outline with holes, extruded from z0 to z1 [m], edges rounded by `bevel`."""
    outline = outline if area(outline) > 0 else outline[::-1]
    holes = [hole if area(hole) < 0 else hole[::-1] for hole in holes]
    walls = [_bevelled(loop, z0, z1, bevel, segments) for loop in [outline, *holes]]
    pieces = [strips(wall) for wall in walls]
    faces = triangulate(walls[0][0][:, :2], [wall[0][:, :2] for wall in walls[1:]])
    bottom, top = (np.vstack([wall[end] for wall in walls]) for end in (0, -1))
    pieces += [(bottom, faces[:, ::-1]), (top, faces)]
    vertices = np.vstack([v for v, _ in pieces])
    offsets = np.cumsum([0] + [len(v) for v, _ in pieces[:-1]])
    return weld(vertices, np.vstack([t + o for (_, t), o in zip(pieces, offsets)])).check("plate")


def box(size, centre=(0.0, 0.0, 0.0), radius=0.003, segments=2, corner=None):
    """A box with rounded edges, thin ones less; `corner` rounds the four upright edges more than `radius`."""
    radius = min(radius, 0.2 * min(size))
    outline = rectangle(size[0], size[1], max(1.6 * radius, corner or 0.0), segments + 1 if corner else segments)
    return plate(outline, -size[2] / 2, size[2] / 2, bevel=radius, segments=segments).moved(centre)


def lathe(profile, count=32, closed=False):
    """The profile [(r, z), ...] turned about z. Upwards on the outside; ends on the axis unless closed."""
    profile = np.asarray(profile, float)
    rings = [np.column_stack([circle(r, count), np.full(count, z)]) for r, z in profile]
    return weld(*strips(rings, closed)).check("lathe")


def cylinder(radius, z0, z1, bevel=0.001, count=32, segments=2):
    return plate(circle(radius, count), z0, z1, bevel=bevel, segments=segments)


def tube(outer, inner, z0, z1, count=32, bevel=0.0005):
    b = bevel
    loop = [(inner + b, z0), (outer - b, z0), (outer, z0 + b), (outer, z1 - b)]
    loop += [(outer - b, z1), (inner + b, z1), (inner, z1 - b), (inner, z0 + b)]
    return lathe(loop, count, closed=True)


def torus(major, minor, count=40, around=14):
    angle = 2 * np.pi * np.arange(around) / around
    return lathe(np.column_stack([major + minor * np.cos(angle), minor * np.sin(angle)]), count, closed=True)


def frames(path, normal_hint):
    """Tangents, normals and binormals along a path, turning no more than they must."""
    path = np.asarray(path, float)
    tangent = np.gradient(path, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normal = np.empty_like(tangent)
    hint = np.asarray(normal_hint, float)
    if np.linalg.norm(np.cross(hint, tangent[0])) < 1e-3:
        hint = np.roll(hint, 1)
    for i, t in enumerate(tangent):
        previous = hint if i == 0 else normal[i - 1]
        normal[i] = unit(previous - t * t.dot(previous))
    return tangent, normal, np.cross(tangent, normal)


def sweep(section, path, normal=(0.0, 0.0, 1.0), scale=1.0):
    """A counter-clockwise section (normal, binormal) carried along a path; `scale` per path point."""
    section = section if area(section) > 0 else section[::-1]
    path = np.asarray(path, float)
    _, n, b = frames(path, normal)
    scale = np.broadcast_to(scale, len(path))
    rings = np.array([p + k * (section[:, :1] * u + section[:, 1:] * v) for p, k, u, v in zip(path, scale, n, b)])
    vertices, triangles = strips(rings)
    faces, last = triangulate(section), len(vertices) - len(section)
    return Mesh(vertices, np.vstack([triangles, faces[:, ::-1], faces + last])).check("sweep")


def pipe(path, radius, count=20):
    return sweep(circle(radius, count), path)


def sheet(surface, rows, columns, depth, plain_back=False):
    """surface(u, v) for u, v in [0, 1], a vector of arrays; thickened by the vector `depth`.

    Seen from the side away from `depth`, u runs to the right and v up. A back that nobody
    sees may be plain: a fan about its middle.
    """
    v, u = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    front = np.stack(np.broadcast_arrays(*surface(u, v)), axis=-1).reshape(-1, 3)
    index = np.arange(len(front)).reshape(rows + 1, columns + 1)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    face = np.vstack([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    rim = np.concatenate([index[0, :-1], index[:-1, -1], index[-1, :0:-1], index[:0:-1, 0]])
    after, n = np.roll(rim, -1), len(front)
    wall = np.vstack([np.column_stack([after, rim, rim + n]), np.column_stack([after, rim + n, after + n])])
    if plain_back:
        edge = front[rim] + np.asarray(depth, float)
        k, m = np.arange(len(rim)), len(rim)
        wall = np.vstack([np.column_stack([after, rim, k + n]), np.column_stack([after, k + n, (k + 1) % m + n])])
        fan = np.column_stack([(k + 1) % m + n, k + n, np.full(m, n + m)])
        return Mesh(np.vstack([front, edge, edge.mean(axis=0)]), np.vstack([face, fan, wall])).check("sheet")
    vertices = np.vstack([front, front + np.asarray(depth, float)])
    return Mesh(vertices, np.vstack([face, face[:, ::-1] + n, wall])).check("sheet")


def bolt(width=0.013, height=0.008, washer=1.7):
    """A hexagon flange bolt's head, standing on z = 0; `width` across flats."""
    flange = lathe([(0, 0), (washer * width / 2, 0), (washer * width / 2, 0.0012), (width * 0.55, 0.003), (0, 0.003)], 16)
    head = plate(regular(6, width), 0.002, height, bevel=0.0012, segments=1)
    return join(flange, head)


def bolts(places, axis=(0, 0, 1), **size):
    return join(*[bolt(**size).placed(place, axis) for place in places])
