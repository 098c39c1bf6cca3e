"""Triangle meshes made of closed shells, and the checks that keep them closed."""

import numpy as np

# Coordinates are written as multiples of this [m]: exact in single precision, and no length that a
# person would choose lies half-way between two multiples, so every machine writes the same bytes.
GRID = 2.0**-20


def unit(vector):
    vector = np.asarray(vector, float)
    return vector / np.linalg.norm(vector)


class Mesh:
    """Vertices (n, 3) [m] and counter-clockwise triangles (m, 3)."""

    def __init__(self, vertices, triangles):
        self.vertices = np.asarray(vertices, float).reshape(-1, 3)
        self.triangles = np.asarray(triangles, int).reshape(-1, 3)

    def moved(self, *offset):
        return Mesh(self.vertices + np.asarray(offset, float).ravel(), self.triangles)

    def scaled(self, x, y, z):
        flip = x * y * z < 0
        return Mesh(self.vertices * [x, y, z], self.triangles[:, ::-1] if flip else self.triangles)

    def mirrored(self):
        """Mirrored at the plane y = 0: the other side of the car."""
        return self.scaled(1, -1, 1)

    def rotated(self, axis, degrees):
        """Turned about a coordinate axis, 'x', 'y' or 'z', through the origin."""
        a = np.radians(degrees)
        c, s = np.cos(a), np.sin(a)
        i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
        turned = self.vertices.copy()
        turned[:, i] = c * self.vertices[:, i] - s * self.vertices[:, j]
        turned[:, j] = s * self.vertices[:, i] + c * self.vertices[:, j]
        return Mesh(turned, self.triangles)

    def placed(self, origin, z_axis, x_hint=(1.0, 0.0, 0.0)):
        """With the local z along `z_axis`, the local x as near `x_hint` as can be, at `origin`."""
        z = unit(z_axis)
        hint = np.asarray(x_hint, float)
        if np.linalg.norm(np.cross(z, hint)) < 1e-6:
            hint = np.array([0.0, 1.0, 0.0])
        x = unit(hint - z * hint.dot(z))
        rotation = np.column_stack([x, np.cross(z, x), z])
        return Mesh(self.vertices @ rotation.T + np.asarray(origin, float), self.triangles)

    def check(self, name):
        """Raises ValueError unless every shell is closed, turned outwards and free of slivers."""
        used = np.round(self.vertices / GRID) * GRID
        corners = used[self.triangles]
        edges = np.vstack([self.triangles[:, [0, 1]], self.triangles[:, [1, 2]], self.triangles[:, [2, 0]]])
        forward = edges[:, 0] * len(used) + edges[:, 1]
        backward = edges[:, 1] * len(used) + edges[:, 0]
        if len(np.unique(forward)) != len(forward) or not np.array_equal(np.sort(forward), np.sort(backward)):
            raise ValueError(f"{name}: not closed, or turned both ways")
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        longest = np.max(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2), axis=1)
        height = area / np.maximum(longest, GRID)
        if height.min() < 2e-5:
            raise ValueError(f"{name}: a triangle only {height.min():.2g} m high")
        if self.volume() <= 0:
            raise ValueError(f"{name}: inside out")
        return self

    def volume(self):
        a, b, c = np.moveaxis(self.vertices[self.triangles], 1, 0)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def join(*meshes):
    """One mesh of many; the shells stay separate and may overlap."""
    flat = []
    for mesh in meshes:
        flat.extend(mesh if isinstance(mesh, (list, tuple)) else [mesh])
    offsets = np.cumsum([0] + [len(m.vertices) for m in flat[:-1]])
    return Mesh(
        np.vstack([m.vertices for m in flat]), np.vstack([m.triangles + o for m, o in zip(flat, offsets)])
    )


def weld(vertices, triangles, tolerance=1e-7):
    """Merges coincident vertices and drops the triangles that this collapses."""
    keys = np.round(np.asarray(vertices) / tolerance).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    triangles = inverse.reshape(-1)[np.asarray(triangles, int)]
    keep = (
        (triangles[:, 0] != triangles[:, 1])
        & (triangles[:, 1] != triangles[:, 2])
        & (triangles[:, 2] != triangles[:, 0])
    )
    return Mesh(np.asarray(vertices)[first], triangles[keep])


def strips(rings, closed=False):
    """Vertices and triangles between successive rings (m, n, 3), each a closed loop of n points.

    Rings that run counter-clockwise seen from where they go to give outward triangles.
    """
    rings = np.asarray(rings, float)
    m, n, _ = rings.shape
    i = np.arange(m if closed else m - 1)[:, None]
    j = np.arange(n)[None, :]
    a, b = i * n + j, i * n + (j + 1) % n
    c, d = (i + 1) % m * n + (j + 1) % n, (i + 1) % m * n + j
    lower = np.stack(np.broadcast_arrays(a, b, c), axis=-1).reshape(-1, 3)
    upper = np.stack(np.broadcast_arrays(a, c, d), axis=-1).reshape(-1, 3)
    return rings.reshape(-1, 3), np.vstack([lower, upper])
