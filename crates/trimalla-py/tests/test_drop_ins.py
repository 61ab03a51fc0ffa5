"""The functions of other packages under their names, beside these packages where they are installed."""

import numpy as np
import pytest

import trimalla
import trimalla.meshpy
import trimalla.triangle as ours
from trimalla.scipy import Delaunay

KEYS = ["vertices", "vertex_markers", "vertex_attributes", "triangles", "triangle_attributes", "segments",
        "segment_markers", "edges", "edge_markers", "neighbors", "holes", "regions"]  # fmt: skip


def canonical(triangles):
    return sorted(tuple(np.roll(row, -row.argmin()).tolist()) for row in np.asarray(triangles)[:, :3])


def areas(mesh):
    a, b, c = (mesh["vertices"][mesh["triangles"][:, k]] for k in range(3))
    return 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


@pytest.fixture(scope="module")
def theirs():
    return pytest.importorskip("triangle", reason="the package triangle is not installed")


@pytest.mark.parametrize("name", ["box", "plate", "star"])
@pytest.mark.parametrize("switches", ["", "p", "pq", "pq30a0.1", "pA", "pq20e", "pn", "c", "pqD", "pq25a0.5en", "pqYY", "pqo2"])
def test_keys_shapes_and_kinds_are_those_of_triangle(theirs, name, switches):
    data = ours.get_data(name)
    made, expected = ours.triangulate(data, switches), theirs.triangulate(data, switches)
    assert set(made) == set(expected)
    for key in made:
        ours_is, theirs_is = made[key], expected[key]
        assert np.ndim(ours_is) == np.ndim(theirs_is) == 2, key
        assert np.shape(ours_is)[1] == np.shape(theirs_is)[1], key
        assert np.asarray(ours_is).dtype == np.asarray(theirs_is).dtype, key
    assert np.isclose(areas(made).sum(), areas(expected).sum())


def test_attributes_and_regions_as_in_triangle(theirs):
    data = dict(ours.get_data("plate"))
    data["holes"] = data["holes"][:1]
    data["regions"] = [[0.5, 0.5, 3, 0.2], [6, 2, 8, 0.05]]
    data["vertex_attributes"] = [[i, 2.0 * i] for i in range(len(data["vertices"]))]
    data["vertex_markers"] = np.arange(len(data["vertices"]))[:, None] + 2
    data["segment_markers"] = np.arange(len(data["segments"]))[:, None] + 2
    made, expected = ours.triangulate(data, "pqaAe"), theirs.triangulate(data, "pqaAe")
    assert set(made) == set(expected)
    for region in (3, 8):
        both = [areas(m)[m["triangle_attributes"][:, 0] == region] for m in (made, expected)]
        assert np.isclose(both[0].sum(), both[1].sum())
    n = len(data["vertices"])
    for key in ("vertices", "vertex_attributes", "vertex_markers"):
        assert (made[key][:n] == np.asarray(expected[key])[:n]).all()
    assert set(made["segment_markers"].ravel()) == set(np.asarray(expected["segment_markers"]).ravel())


def test_a_mesh_is_refined(theirs):
    coarse = ours.triangulate(ours.get_data("plate"), "pq")
    limits = np.full((len(coarse["triangles"]), 1), 0.1)
    fine = ours.triangulate({**coarse, "triangle_max_area": limits}, "prqa")
    assert areas(fine).max() <= 0.1 and (fine["vertices"][: len(coarse["vertices"])] == coarse["vertices"]).all()
    assert set(fine) == set(theirs.triangulate({**coarse, "triangle_max_area": limits}, "prqa"))


def test_small_functions_agree_with_triangle(theirs):
    points = np.random.default_rng(5).random((200, 2))
    assert canonical(ours.delaunay(points)) == canonical(theirs.delaunay(points))
    hull = [sorted(map(tuple, np.sort(f(points), axis=1).tolist())) for f in (ours.convex_hull, theirs.convex_hull)]
    assert hull[0] == hull[1]
    mine, other = ours.voronoi(points), theirs.voronoi(points)
    assert [np.shape(a) for a in mine] == [np.shape(a) for a in other]
    assert np.allclose(np.sort(mine[0], axis=0), np.sort(other[0], axis=0), rtol=1e-6)


def test_what_triangle_gets_wrong_is_refused():
    bad = [
        ({"vertices": [[0, 0], [1, 0], [2, 0]]}, ""),
        ({"vertices": [[0, 0], [1, 0], [0, np.nan]]}, ""),
        ({"vertices": [[0, 0], [1, 0], [0, 1]], "segments": [[0, 7]]}, "p"),
        ({"vertices": [[0, 0], [1, 0], [0, 1]]}, "w"),
    ]
    for data, switches in bad:
        with pytest.raises(trimalla.Error):
            ours.triangulate(data, switches)
    with pytest.raises(KeyError):
        ours.triangulate({"vertices": [[0, 0]], "points": 1})


def test_files(tmp_path):
    trimalla.Drawing([[0, 0], [1, 0], [0, 1]], [[0, 1], [1, 2], [2, 0]], segment_markers=[1, 2, 3]).write(tmp_path / "a.poly")
    data = ours.load(tmp_path, "a")
    assert data["vertices"].tolist() == [[0, 0], [1, 0], [0, 1]] and data["segment_markers"].ravel().tolist() == [1, 2, 3]
    again = ours.loads((tmp_path / "a.poly").read_text())
    assert all((again[key] == data[key]).all() for key in data)
    assert len(ours.triangulate(data, "p")["triangles"]) == 1


def test_plots():
    plt = pytest.importorskip("matplotlib.pyplot")
    plt.switch_backend("agg")
    data = ours.get_data("plate")
    ours.compare(plt, data, ours.triangulate(data, "pq30e"))
    mesh = trimalla.mesh(data["vertices"], data["segments"], data["holes"], size=0.5)
    assert mesh.plot() is mesh.plot(plt.gca()) and mesh.plot(values=mesh.areas) is not None
    plt.close("all")


def test_delaunay_beside_scipy():
    spatial = pytest.importorskip("scipy.spatial")
    rng = np.random.default_rng(11)
    points = rng.random((500, 2))
    mine, other = Delaunay(points), spatial.Delaunay(points)
    assert canonical(mine.simplices) == canonical(oriented(points, other.simplices))
    assert mine.simplices.dtype == other.simplices.dtype and mine.neighbors.dtype == other.neighbors.dtype
    for t, row in enumerate(mine.neighbors):
        for corner, beyond in enumerate(row):
            edge = set(np.delete(mine.simplices[t], corner).tolist())
            assert beyond == -1 or edge <= set(mine.simplices[beyond].tolist())
    places = rng.random((40, 50, 2)) * 1.4 - 0.2
    found, expected = mine.find_simplex(places), other.find_simplex(places)
    assert found.shape == expected.shape and ((found == -1) == (expected == -1)).all()
    inside = found >= 0
    assert (np.sort(mine.simplices[found[inside]]) == np.sort(other.simplices[expected[inside]])).all()
    transform = mine.transform[found[inside]]
    two = np.einsum("ijk,ik->ij", transform[:, :2], places[inside] - transform[:, 2])
    three = np.column_stack([two, 1 - two.sum(axis=1)])
    assert three.min() > -1e-9
    assert np.allclose((three[:, :, None] * points[mine.simplices[found[inside]]]).sum(axis=1), places[inside])
    assert {frozenset(e) for e in mine.convex_hull.tolist()} == {frozenset(e) for e in other.convex_hull.tolist()}
    for v in range(500):
        rows = [d.vertex_neighbor_vertices for d in (mine, other)]
        assert {*rows[0][1][rows[0][0][v] : rows[0][0][v + 1]]} == {*rows[1][1][rows[1][0][v] : rows[1][0][v + 1]]}
    assert (np.take_along_axis(mine.simplices, np.zeros((1, 1), int), 0) >= 0).all()
    assert all(v in mine.simplices[mine.vertex_to_simplex[v]] for v in range(500))
    assert Delaunay([[0, 0], [1, 0], [0, 1], [1, 0]]).coplanar.tolist() == [[3, 0, 1]]


def oriented(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] < 0
    return np.where(turn[:, None], triangles[:, ::-1], triangles)


def test_meshpy():
    info = trimalla.meshpy.MeshInfo()
    points, facets = trimalla.meshpy.subdivide_facets(2, [(0, 0), (4, 0), (4, 4), (0, 4)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    info.set_points(points)
    info.set_facets(facets, facet_markers=[1] * 8)
    info.regions.resize(1)
    info.regions[0] = [2, 2, 5, 0.5]
    mesh = trimalla.meshpy.build(info, attributes=True, volume_constraints=True, min_angle=30, generate_faces=True)
    assert (np.asarray(mesh.element_attributes) == 5).all() and len(mesh.faces) > 20

    def coarse(vertices, area):
        x = sum(v[0] for v in vertices) / 3
        return area > 0.01 + 0.05 * x

    fine = trimalla.meshpy.build(info, refinement_func=coarse)
    corners = np.asarray(fine.points)[np.asarray(fine.elements)]
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    sizes = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    assert (sizes <= 0.01 + 0.05 * corners[:, :, 0].mean(axis=1)).all() and np.isclose(sizes.sum(), 16)
    assert len(trimalla.meshpy.refine(fine, max_volume=0.005).elements) > len(fine.elements)


def test_section_properties_on_our_meshes(monkeypatch):
    pre = pytest.importorskip("sectionproperties.pre.pre", reason="the package sectionproperties is not installed")
    from sectionproperties.analysis import Section
    from sectionproperties.pre.library import i_section

    def torsion():
        section = i_section(d=203, b=133, t_f=7.8, t_w=5.8, r=8.9, n_r=8)
        section.create_mesh(mesh_sizes=[5])
        made = Section(section)
        made.calculate_geometric_properties()
        made.calculate_warping_properties()
        return made.get_area(), made.get_j()

    expected = torsion()
    monkeypatch.setattr(pre, "triangle", ours)
    assert torsion() == pytest.approx(expected, rel=1e-4)
