"""Binary STL and URDF, and the programs that make a package's files of them."""

import argparse
import pathlib
import struct
import sys

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


def material_lines(materials):
    lines = []
    for material, colour in materials:
        lines += [f'  <material name="{material}">', f'    <color rgba="{numbers(colour)} 1"/>', "  </material>"]
    return lines


def link_lines(name, part, folder=""):
    """A link whose visual and collision geometry are a part's mesh; `folder` below meshes/, with its slash."""
    geometry = f'      <geometry><mesh filename="{PACKAGE}/meshes/{folder}{part.name}.stl"/></geometry>'
    lines = [f'  <link name="{name}">', "    <visual>", geometry]
    lines += [f'      <material name="{part.material[0]}"/>', "    </visual>"]
    return [*lines, "    <collision>", geometry, "    </collision>", "  </link>"]


def urdf_text(name, parts, folder="", maker="make_engine_bay"):
    """Every part a link on the root link `name`; visual and collision geometry are the same mesh."""
    lines = ['<?xml version="1.0"?>', f"<!-- Made by scripts/{maker}. -->", f'<robot name="{name}">']
    materials = {material[0]: material[1] for material in (part.material for part in parts)}
    lines += material_lines(materials.items())
    lines.append(f'  <link name="{name}"/>')
    for part in parts:
        lines += link_lines(part.name, part, folder)
        lines += [f'  <joint name="{part.name}_joint" type="{part.joint}">']
        lines += [f'    <parent link="{name}"/>', f'    <child link="{part.name}"/>']
        lines += [f'    <origin xyz="{numbers(part.origin)}" rpy="0 0 0"/>']
        if part.joint != "fixed":
            lines += [f'    <axis xyz="{numbers(part.axis)}"/>']
        lines += ["  </joint>"]
    return "\n".join([*lines, "</robot>", ""])


def main(script, description, outputs, stored=None):
    """A program that makes files: writes those that differ, or, with --check, names them. Its exit code.

    script: its file, in scripts/ of the package. outputs(): contents by path in the package, and the number of triangles
    by mesh. stored(package): paths of the files that are there; those that `outputs` has not are wrong, and are removed.
    """
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare with the package's files, write nothing")
    arguments = parser.parse_args()
    script = pathlib.Path(script).resolve()
    package = script.parent.parent
    contents, triangles = outputs()
    superfluous = sorted(set(stored(package)) - set(contents)) if stored else []
    changed = [path for path, data in contents.items() if not same_file(package / path, data)]
    if arguments.check:
        for path in changed + superfluous:
            print(f"{path} is not what scripts/{script.name} makes", file=sys.stderr)
        return 1 if changed + superfluous else 0
    for path in changed:
        (package / path).parent.mkdir(exist_ok=True)
        (package / path).write_bytes(contents[path])
    for path in superfluous:
        (package / path).unlink()
    for name, count in triangles.items():
        print(f"{name:20} {count:7} triangles")
    print(f"{'in all':20} {sum(triangles.values()):7} triangles, {sum(map(len, contents.values())) / 1e6:.2f} MB")
    return 0
