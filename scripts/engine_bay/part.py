"""A named, coloured piece of a component: one STL file and one URDF link."""

from dataclasses import dataclass

from .mesh import Mesh

PAINT = ("body_paint", (0.62, 0.68, 0.72))
PRIMER = ("primer", (0.50, 0.54, 0.57))
ALUMINIUM = ("cast_aluminium", (0.74, 0.75, 0.75))
STEEL = ("zinc_plated", (0.66, 0.65, 0.58))
PLASTIC = ("black_plastic", (0.30, 0.31, 0.33))
GREY_PLASTIC = ("grey_plastic", (0.44, 0.45, 0.47))
RUBBER = ("rubber", (0.22, 0.22, 0.23))
NATURAL = ("natural_plastic", (0.86, 0.86, 0.80))
LEAD = ("lead", (0.55, 0.56, 0.60))
BLUE = ("blue_cap", (0.25, 0.42, 0.62))
YELLOW = ("yellow_cap", (0.80, 0.66, 0.22))
COVER = ("cover_paint", (0.36, 0.44, 0.50))


@dataclass
class Part:
    name: str
    mesh: Mesh
    material: tuple
    joint: str = "fixed"  # or "continuous": turns about `axis` at `origin`
    origin: tuple = (0.0, 0.0, 0.0)  # of the link in the component; the mesh is given about it
    axis: tuple = (0.0, 0.0, 1.0)
