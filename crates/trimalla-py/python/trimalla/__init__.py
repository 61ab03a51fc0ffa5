"""Triangle meshes of planar drawings, and Delaunay triangulations.

| you want | call |
|---|---|
| a mesh of points, segments, holes and regions | `mesh` |
| a mesh of polygons | `polygon`, `from_shapely`, `from_geopandas` |
| a triangulation without new points | `triangulate`, `delaunay` |
| a finer mesh | `refine`, `Mesh.refine` |
| points inserted, removed, moved, and all of it undone | `Triangulation` |
| a refinement step by step, and back | `Refinement` |
| faults of a drawing found and mended | `faults`, `clean` |
| strategies compared | `compare` |
| files | `read`, `Mesh.read`, `Mesh.write`, `Drawing.write` |
| the `triangle` package, `scipy.spatial.Delaunay`, MeshPy | `trimalla.triangle`, `trimalla.scipy`, `trimalla.meshpy` |

The interpreter is free while the library works, Ctrl-C ends every call, and what is at fault in the input raises an
`Error` with `kind`, `indices` and `points`.
"""

from ._drawing import Drawing, read
from ._dynamic import Refinement, Triangulation
from ._make import delaunay, mesh, polygon, refine, triangulate
from ._mesh import Mesh, Report
from ._native import DrawingError, Error, FileError, MeshError, OptionError
from ._size import Raster
from ._tools import Cleaned, Comparison, Fault, clean, compare, faults, options, recipe
from .bridges import from_geopandas, from_shapely, to_geopandas

__version__ = "0.1.0"

# Faults that name no place have empty lists.
Error.kind, Error.indices, Error.points = "error", [], []

__all__ = [
    "Cleaned", "Comparison", "Drawing", "DrawingError", "Error", "Fault", "FileError", "Mesh", "MeshError",
    "OptionError", "Raster", "Refinement", "Report", "Triangulation", "clean", "compare", "delaunay", "faults",
    "from_geopandas", "from_shapely", "mesh", "options", "polygon", "read", "recipe", "refine", "to_geopandas",
    "triangulate",
]  # fmt: skip
