"""Opens meshes of trimalla with other people's programs, and solves on one.

    cargo build --release -p trimalla-cli
    python scripts/solver_formats.py target/release/trimalla

needs meshio, gmsh, scikit-fem, numpy and scipy (pip install meshio gmsh scikit-fem scipy), and says in one line what it
skips where one is missing. It meshes a drawing with two regions, five boundary markers and a hole, writes every format,
and checks with meshio and Gmsh that vertices, triangles, regions and boundaries are those of the `.ele` group. Then it
refines a square four times and solves Poisson's equation on the `.msh` files with scikit-fem: the error in the
L2 norm must fall with the second power of the edge length.
"""

import importlib
import pathlib
import subprocess
import sys
import tempfile

DRAWING = """9 2 0 0
1 0 0
2 2 0
3 4 0
4 4 3
5 2 3
6 0 3
7 0.5 1
8 1.5 1
9 1 2
10 1
1 1 2 10
2 2 3 10
3 3 4 20
4 4 5 30
5 5 6 30
6 6 1 40
7 2 5 50
8 7 8 60
9 8 9 60
10 9 7 60
1
1 1 1.2
2
1 0.1 0.1 5
2 3 1 7
"""

SQUARE = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"


def optional(name):
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def numbers(path):
    lines = (line.split("#")[0].split() for line in path.read_text().splitlines())
    return iter([list(map(float, line)) for line in lines if line])


def rows(source, count):
    return [next(source)[1:] for _ in range(int(count))]


class Expected:
    """The mesh as its .node, .ele and .poly files have it."""

    def __init__(self, stem):
        source = numbers(stem.with_suffix(".node"))
        self.points = rows(source, next(source)[0])
        source = numbers(stem.with_suffix(".ele"))
        triangles = rows(source, next(source)[0])
        self.triangles = len(triangles)
        self.regions = count(int(row[3]) for row in triangles)
        source = numbers(stem.with_suffix(".poly"))
        next(source)
        self.boundaries = count(int(row[2]) for row in rows(source, next(source)[0]))


def count(values):
    found = {}
    for value in getattr(values, "flat", values):
        found[value] = found.get(value, 0) + 1
    return found


def same(what, found, expected):
    assert found == expected, f"{what}: {found}, not {expected}"


def by_meshio(meshio, stem, expected):
    """Formats that meshio reads, and the names of regions and boundaries where meshio keeps them."""
    for ending in ["msh", "msh2", "inp", "mesh", "su2", "vtu", "vtk", "obj", "ply", "stl", "off"]:
        path = stem.with_suffix("." + ending)
        mesh = meshio.read(path, file_format="gmsh") if ending == "msh2" else meshio.read(path)
        triangles = sum(len(cells.data) for cells in mesh.cells if cells.type == "triangle")
        same(f"{ending}: triangles", triangles, expected.triangles)
        if ending == "stl":
            print(f"meshio {ending}: {triangles} triangles")
            continue
        same(f"{ending}: points", len(mesh.points), len(expected.points))
        for found, point in zip(mesh.points, expected.points):
            assert (found[0], found[1]) == tuple(point[:2]), f"{ending}: {found}, not {point}"
        said = ""
        if ending in ("msh", "msh2"):
            names = {name: tuple(map(int, data)) for name, data in mesh.field_data.items()}
            expect = {f"region_{r}": (r, 2) for r in expected.regions}
            expect |= {f"boundary_{m}": (m, 1) for m in expected.boundaries}
            same(f"{ending}: names", names, expect)
            for kind, wanted in [("triangle", expected.regions), ("line", expected.boundaries)]:
                same(f"{ending}: {kind}", count(map(int, mesh.get_cell_data("gmsh:physical", kind))), wanted)
            said = f", {len(names)} names"
        elif ending == "inp":
            sets = {name: sum(len(block) for block in blocks) for name, blocks in mesh.cell_sets.items()}
            same("inp: element sets", sets, {f"region_{r}": n for r, n in expected.regions.items()})
            same("inp: node sets", sorted(mesh.point_sets), sorted(f"boundary_{m}" for m in expected.boundaries))
            said = f", {len(sets)} element sets, {len(mesh.point_sets)} node sets"
        elif ending == "mesh":
            for kind, wanted in [("triangle", expected.regions), ("line", expected.boundaries)]:
                same(f"mesh: {kind}", count(map(int, mesh.get_cell_data("medit:ref", kind))), wanted)
            said = ", references"
        elif ending == "su2":
            tags = count(map(int, mesh.get_cell_data("su2:tag", "line")))
            wanted = sorted(n for m, n in expected.boundaries.items() if m != 50)
            same("su2: markers", sorted(tags.values()), wanted)
            names = [line.split("=")[1].strip() for line in path.read_text().splitlines() if line.startswith("MARKER_TAG")]
            same("su2: names", sorted(names), sorted(f"boundary_{m}" for m in expected.boundaries if m != 50))
            said = f", {len(tags)} markers"
        elif ending in ("vtu", "vtk"):
            same(f"{ending}: regions", count(mesh.get_cell_data("region", "triangle")), expected.regions)
            same(f"{ending}: markers", count(mesh.get_cell_data("marker", "line")), expected.boundaries)
            said = ", regions and markers"
        print(f"meshio {ending}: {len(mesh.points)} points, {triangles} triangles{said}")


def by_gmsh(gmsh, stem, expected):
    """Formats that Gmsh reads; physical names and their elements of .msh."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for ending in ["msh", "msh2", "inp", "mesh", "su2", "vtk", "ply", "stl", "off"]:
        path = stem.with_suffix("." + ending)
        gmsh.clear()
        try:
            gmsh.open(str(path)) if ending in ("msh", "msh2") else gmsh.merge(str(path))
        except Exception as error:
            print(f"gmsh {ending}: not read by this Gmsh ({error})")
            continue
        triangles = sum(
            len(tags)
            for kind, elements in [gmsh.model.mesh.getElements(2)[:2]]
            for k, tags in zip(kind, elements)
            if k == 2
        )
        same(f"gmsh {ending}: triangles", triangles, expected.triangles)
        groups = {}
        for dimension, tag in gmsh.model.getPhysicalGroups():
            name = gmsh.model.getPhysicalName(dimension, tag)
            entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
            elements = [gmsh.model.mesh.getElements(dimension, int(e))[1] for e in entities]
            groups[name] = sum(len(tags) for found in elements for tags in found)
        if ending in ("msh", "msh2"):
            wanted = {f"region_{r}": n for r, n in expected.regions.items()}
            wanted |= {f"boundary_{m}": n for m, n in expected.boundaries.items()}
            same(f"gmsh {ending}: groups", groups, wanted)
        print(f"gmsh {ending}: {triangles} triangles, {len(groups)} physical groups")
    gmsh.finalize()


def poisson(program, folder):
    """The L2 error of linear elements on meshes whose edges halve: its order must be about 2."""
    import numpy as np
    from skfem import Basis, BilinearForm, ElementTriP1, Functional, LinearForm, MeshTri, condense, solve
    from skfem.helpers import dot, grad

    @BilinearForm
    def laplace(u, v, _):
        return dot(grad(u), grad(v))

    @LinearForm
    def load(v, w):
        return 2 * np.pi**2 * np.sin(np.pi * w.x[0]) * np.sin(np.pi * w.x[1]) * v

    @Functional
    def error_sq(w):
        return (w["u"] - np.sin(np.pi * w.x[0]) * np.sin(np.pi * w.x[1])) ** 2

    (folder / "square.poly").write_text(SQUARE)
    errors = []
    for level in range(4):
        path = folder / f"square{level}.msh"
        area = 0.02 / 4**level
        subprocess.run([program, "mesh", folder / "square.poly", "-q", "--max-area", str(area), "-o", path], check=True)
        mesh = MeshTri.load(path)
        assert set(mesh.boundaries) == {"boundary_1", "boundary_2", "boundary_3", "boundary_4"}, mesh.boundaries
        basis = Basis(mesh, ElementTriP1(), intorder=4)
        sides = basis.get_dofs(set(mesh.boundaries))
        u = solve(*condense(laplace.assemble(basis), load.assemble(basis), D=sides))
        errors.append((mesh.nelements, float(np.sqrt(error_sq.assemble(basis, u=basis.interpolate(u))))))
    orders = [2 * np.log(e / f) / np.log(m / n) for (n, e), (m, f) in zip(errors, errors[1:])]
    for (triangles, error), order in zip(errors, [float("nan"), *orders]):
        print(f"scikit-fem: {triangles} triangles, L2 error {error:.3e}, order {order:.2f}")
    assert all(1.8 < order < 2.3 for order in orders), orders


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "plate.poly").write_text(DRAWING)
        endings = ["ele", "msh", "msh2", "inp", "mesh", "su2", "vtu", "vtk", "obj", "ply", "stl", "off"]
        outputs = [word for ending in endings for word in ("-o", folder / f"plate.1.{ending}")]
        subprocess.run([program, "mesh", folder / "plate.poly", "-q", "--max-area", "0.02", *outputs], check=True)
        stem = folder / "plate.1.ele"
        expected = Expected(stem)
        for name, check in [("meshio", by_meshio), ("gmsh", by_gmsh)]:
            module = optional(name)
            if module is None:
                print(f"skipped: {name} is not installed")
            else:
                check(module, stem, expected)
        if optional("skfem") is None or optional("meshio") is None:
            print("skipped: scikit-fem or meshio is not installed")
        else:
            poisson(program, folder)
    print("all as expected")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
