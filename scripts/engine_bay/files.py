"""Binary STL and URDF."""

import struct

import numpy as np

from .mesh import GRID

PACKAGE = "package://cable_variation"
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
# Of a surface's area and volume; other diagonals change them by the rounding of corners to GRID alone.
SAME = 1e-5


def stl_bytes(mesh):
    corners = np.round(mesh.vertices[mesh.triangles] / GRID) * GRID
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    record = np.zeros(len(corners), dtype=RECORD)
    # Normals of few digits, so that they too are the same everywhere; readers take them from the corners anyway.
    record["normal"] = np.round(normal, 4) + 0.0
    record["corners"] = corners
    return b"cable_variation".ljust(80, b"\0") + struct.pack("<I", len(corners)) + record.tobytes()


def same_file(path, data):
    """Whether a file holds these bytes, or, an STL, the same surface with other diagonals in its flat faces.

    Of two equally short cuts from an outline to its holes the last digit decides, which differs from numpy to numpy.
    Same are: the corners, each as it is, the number of triangles, and area and volume but for a share of SAME.
    """
    if not path.is_file():
        return False
    stored = path.read_bytes()
    if stored == data:
        return True
    if path.suffix != ".stl" or len(stored) != len(data) or stored[:84] != data[:84]:
        return False
    (corners, area, volume), (others, other_area, other_volume) = map(_surface, (stored, data))
    return (
        np.array_equal(corners, others)
        and abs(area - other_area) <= SAME * area
        and abs(volume - other_volume) <= SAME * volume
    )


def _surface(stl):
    """The corners in order, each once; the area; the volume enclosed."""
    triangles = np.frombuffer(stl[84:], RECORD)["corners"].astype(float)
    a, b, c = np.moveaxis(triangles, 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    return np.unique(triangles.reshape(-1, 3), axis=0), area, np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def numbers(values):
    return " ".join(f"{value:.6g}" for value in values)


def urdf_text(name, parts, folder="", maker="make_engine_bay"):
    """Every part a link on the root link `name`; visual and collision geometry are the same mesh."""
    lines = ['<?xml version="1.0"?>', f"<!-- Made by scripts/{maker}. -->", f'<robot name="{name}">']
    materials = {material[0]: material[1] for material in (part.material for part in parts)}
    for material, colour in materials.items():
        lines += [f'  <material name="{material}">', f'    <color rgba="{numbers(colour)} 1"/>', "  </material>"]
    lines.append(f'  <link name="{name}"/>')
    for part in parts:
        geometry = f'      <geometry><mesh filename="{PACKAGE}/meshes/{folder}{part.name}.stl"/></geometry>'
        lines += [f'  <link name="{part.name}">', "    <visual>", geometry]
        lines += [f'      <material name="{part.material[0]}"/>', "    </visual>"]
        lines += ["    <collision>", geometry, "    </collision>", "  </link>"]
        lines += [f'  <joint name="{part.name}_joint" type="{part.joint}">']
        lines += [f'    <parent link="{name}"/>', f'    <child link="{part.name}"/>']
        lines += [f'    <origin xyz="{numbers(part.origin)}" rpy="0 0 0"/>']
        if part.joint != "fixed":
            lines += [f'    <axis xyz="{numbers(part.axis)}"/>']
        lines += ["  </joint>"]
    return "\n".join([*lines, "</robot>", ""])
