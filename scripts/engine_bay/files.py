"""Binary STL and URDF."""

import struct

import numpy as np

from .mesh import GRID

PACKAGE = "package://cable_variation"


def stl_bytes(mesh):
    corners = np.round(mesh.vertices[mesh.triangles] / GRID) * GRID
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    record = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    # Normals of few digits, so that they too are the same everywhere; readers take them from the corners anyway.
    record["normal"] = np.round(normal, 4) + 0.0
    record["corners"] = corners
    return b"cable_variation".ljust(80, b"\0") + struct.pack("<I", len(corners)) + record.tobytes()


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
