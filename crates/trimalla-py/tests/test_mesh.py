"""Meshes: arrays in and out, options, sizes, errors with places, pickles, files."""

import pickle

import numpy as np
import pytest

import trimalla

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
RING = [[0, 1], [1, 2], [2, 3], [3, 0]]


def least_angle(mesh):
    return mesh.angles.min()


def test_a_square_becomes_a_good_mesh():
    mesh = trimalla.mesh(SQUARE, RING, min_angle=30, size=0.5)
    assert mesh.report.complete and mesh.report.stop == "finished"
    assert mesh.points.dtype == np.float64 and mesh.triangles.dtype == np.int32
    assert (mesh.points[:4] == np.array(SQUARE)).all() and mesh.input_points == 4
    assert least_angle(mesh) >= 30 - 1e-9 and mesh.areas.min() > 0
    assert np.isclose(mesh.areas.sum(), 16) and mesh.areas.max() <= 0.25 * 3**0.5 * 0.25 * (1 + 1e-12)
    assert mesh.check(delaunay=True) == []
    # Euler's formula.
    assert len(mesh.points) - len(mesh.edges) + len(mesh.triangles) == 1
    assert (mesh.neighbours == -1).sum() == len(mesh.boundary)


@pytest.mark.parametrize(
    "convert",
    [
        lambda a, t: a,
        lambda a, t: [tuple(row) for row in a],
        lambda a, t: np.array(a, dtype=t),
        lambda a, t: np.asfortranarray(np.array(a, dtype=t)),
        lambda a, t: np.array([[x, y, 0] for x, y in a], dtype=t)[:, :2],
        lambda a, t: np.array(a[::-1], dtype=t)[::-1],
    ],
)
@pytest.mark.parametrize("kinds", [(np.float32, np.int32), (np.float64, np.uint64), (np.int16, np.int64)])
def test_every_kind_of_array_gives_the_same_mesh(convert, kinds):
    expected = trimalla.mesh(np.array(SQUARE, dtype=float), np.array(RING), size=0.7)
    assert trimalla.mesh(convert(SQUARE, kinds[0]), convert(RING, kinds[1]), size=0.7) == expected


def test_the_arrays_of_the_caller_stay_as_they_are_and_ours_are_read_only():
    points = np.array(SQUARE, dtype=float)
    mesh = trimalla.mesh(points, RING)
    own = trimalla.Mesh(points, [[0, 1, 2]])
    points[0] = 7
    assert (mesh.points[0] == 0).all() and (own.points[0] == 0).all()
    for array in (mesh.points, mesh.triangles, mesh.edges, mesh.regions, own.points):
        with pytest.raises(ValueError):
            array[0] = 1


def test_holes_regions_and_markers():
    inner = [[1, 1], [3, 1], [3, 3], [1, 3]]
    points, segments = SQUARE + inner, RING + [[a + 4, b + 4] for a, b in RING]
    with_hole = trimalla.mesh(points, segments, holes=[[2, 2]], max_area=0.2)
    assert np.isclose(with_hole.areas.sum(), 12) and (with_hole.holes == [[2, 2]]).all()
    regions = [[0.5, 0.5, 7], [2, 2, 9]]
    markers = [1, 1, 1, 1, 5, 5, 5, 5]
    mesh = trimalla.mesh(points, segments, regions=[r + [0.01 * r[2] - 0.05] for r in regions], segment_markers=markers)
    assert np.isclose(mesh.areas[mesh.regions == 7].sum(), 12) and np.isclose(mesh.areas[mesh.regions == 9].sum(), 4)
    assert mesh.areas[mesh.regions == 7].max() <= 0.02 and mesh.areas[mesh.regions == 9].max() <= 0.04
    ends = mesh.points[mesh.segments[mesh.segment_markers == 5]]
    assert np.isclose(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum(), 8)


def test_rings_of_polygons():
    hole = [(1, 1), (3, 1), (3, 3), (1, 3), (1, 1)]
    island = [(1.5, 1.5), (2.5, 1.5), (2.5, 2.5), (1.5, 2.5)]
    assert np.isclose(trimalla.polygon([SQUARE, hole, island]).areas.sum(), 13)
    assert np.isclose(trimalla.polygon(np.array(SQUARE)).areas.sum(), 16)
    assert np.isclose(trimalla.polygon(SQUARE).areas.sum(), 16)

    class Shape:
        __geo_interface__ = {"type": "Polygon", "coordinates": (SQUARE, hole)}

    assert np.isclose(trimalla.polygon(Shape()).areas.sum(), 12)


def test_points_alone_are_meshed_in_their_hull():
    mesh = trimalla.mesh(SQUARE, max_area=1)
    assert np.isclose(mesh.areas.sum(), 16) and len(mesh.boundary) >= 4


def test_sizes():
    number = trimalla.mesh(SQUARE, RING, size=0.5)
    function = trimalla.mesh(SQUARE, RING, size=lambda x, y: np.full_like(x, 0.5))
    assert number.areas.max() <= 0.0625 * 3**0.5 and function.areas.max() <= 0.0625 * 3**0.5 * (1 + 1e-9)
    graded = trimalla.mesh(SQUARE, RING, size=lambda x, y: 0.05 + 0.3 * x)
    middle = graded.points[graded.triangles].mean(axis=1)
    allowed = 0.25 * 3**0.5 * (0.05 + 0.3 * middle[:, 0]) ** 2
    assert graded.report.complete and (graded.areas <= allowed * 1.0001).all()
    assert graded.areas[middle[:, 0] > 3].mean() > 30 * graded.areas[middle[:, 0] < 0.2].mean()
    at_points = trimalla.mesh(SQUARE, RING, size=[0.05, np.inf, np.inf, 1.0], gradation=0.3)
    near = np.flatnonzero((at_points.triangles == 0).any(axis=1))
    assert at_points.areas[near].max() <= 0.25 * 3**0.5 * (0.05 + 0.3 * 0.2) ** 2
    assert abs(len(trimalla.mesh(SQUARE, RING, triangles=3000).triangles) - 3000) < 300
    raster = trimalla.Raster([[0.1, 1.0], [0.1, 1.0]], x=[0, 4], y=[4, 0])
    assert len(trimalla.mesh(SQUARE, RING, size=raster).triangles) > 200


def test_a_small_feature_of_a_size_function_is_found():
    def narrow(x, y):
        return np.minimum(1.0, 0.01 + np.hypot(x - 2.71, y - 1.41))

    mesh = trimalla.mesh(SQUARE, RING, size=narrow)
    middle = mesh.points[mesh.triangles].mean(axis=1)
    at = np.hypot(middle[:, 0] - 2.71, middle[:, 1] - 1.41)
    assert mesh.areas[at.argmin()] <= 0.25 * 3**0.5 * (0.02) ** 2
    assert (mesh.areas <= 0.25 * 3**0.5 * (narrow(*middle.T) * 1.1 + 0.005) ** 2).all()


def test_refine_keeps_vertices_and_takes_areas():
    coarse = trimalla.polygon(SQUARE, max_area=2)
    areas = np.where(coarse.points[coarse.triangles].mean(axis=1)[:, 0] < 2, 0.05, np.nan)
    fine = coarse.refine(areas=areas)
    assert (fine.points[: len(coarse.points)] == coarse.points).all()
    middle = fine.points[fine.triangles].mean(axis=1)
    assert fine.areas[middle[:, 0] < 1].max() <= 0.05 < fine.areas.max()
    with pytest.raises(trimalla.MeshError) as caught:
        coarse.refine(areas=[-1.0] * len(coarse.triangles))
    assert caught.value.kind == "area-bound" and caught.value.indices == [0]


@pytest.mark.parametrize(
    ("call", "kind", "indices"),
    [
        (lambda: trimalla.mesh([[0, 0], [1, 0], [0, np.nan]]), "not-finite", [2]),
        (lambda: trimalla.mesh([[0, 0], [1, 0], [0, np.inf]]), "not-finite", [2]),
        (lambda: trimalla.mesh(SQUARE, [[0, 2], [1, 3]]), "crossing", [0, 1]),
        (lambda: trimalla.mesh(SQUARE, RING + [[0, 9]]), "no-such-vertex", [4]),
        (lambda: trimalla.mesh(SQUARE, RING + [[0, -1]]), "no-such-vertex", [4]),
        (lambda: trimalla.mesh([[0, 0], [1, 0], [2, 0]]), "flat", []),
        (lambda: trimalla.mesh(SQUARE, RING[:3]), "open-outline", [0]),
        (lambda: trimalla.mesh(SQUARE, RING, holes=[[2, 2]]), "seed-takes-all", [0]),
        (lambda: trimalla.mesh(SQUARE, RING, holes=[[2, 0]]), "seed-on-segment", [0]),
        (lambda: trimalla.mesh([[0, 0, 0]]), "shape", []),
        (lambda: trimalla.mesh([[0, 0], [1]]), "shape", []),
        (lambda: trimalla.mesh("abc"), "shape", []),
        (lambda: trimalla.mesh(SQUARE, [[0.5, 1]]), "shape", []),
        (lambda: trimalla.mesh(SQUARE, RING, segment_markers=[1]), "shape", []),
        (lambda: trimalla.Mesh(SQUARE, [[0, 1, 4]]), "no-such-vertex", [0]),
    ],
)
def test_errors_name_what_is_wrong_and_where(call, kind, indices):
    with pytest.raises(trimalla.Error) as caught:
        call()
    assert (caught.value.kind, list(caught.value.indices)) == (kind, indices)
    assert isinstance(caught.value, ValueError) and str(caught.value)


def test_errors_have_coordinates():
    with pytest.raises(trimalla.DrawingError) as caught:
        trimalla.mesh(SQUARE, [[0, 2], [1, 3]])
    assert caught.value.points == [(2.0, 2.0)]


@pytest.mark.parametrize(
    "options",
    [
        {"min_angle": 90},
        {"min_angle": "x"},
        {"max_area": -1},
        {"no_such_option": 1},
        {"preset": "nothing"},
        {"domain": "x"},
        {"size": -1},
        {"size": [1, 2]},
        {"size": lambda x, y: -x - 1},
        {"size": lambda x, y: np.array([1.0])},
        {"growth": 0.5},
        {"sources": [[1, 2]]},
    ],
)
def test_options_out_of_range(options):
    with pytest.raises(trimalla.OptionError):
        trimalla.mesh(SQUARE, RING, **options)


def test_presets_and_recipes(tmp_path):
    by_name = trimalla.mesh(SQUARE, RING, preset="lepp-centroid", max_area=0.3)
    path = tmp_path / "mine.toml"
    trimalla.recipe(path, preset="lepp-centroid", max_area=0.3)
    assert trimalla.mesh(SQUARE, RING, recipe=path) == by_name != trimalla.mesh(SQUARE, RING, max_area=0.3)


def test_pickles_and_equality():
    mesh = trimalla.mesh(SQUARE, RING, size=0.5)
    again = pickle.loads(pickle.dumps(mesh))
    assert again == mesh and again.report.triangles == mesh.report.triangles and (again.edges == mesh.edges).all()
    assert mesh != trimalla.mesh(SQUARE, RING) and mesh != 3


@pytest.mark.parametrize("ending", [".vtu", ".msh", ".ele", ".off", ".ply"])
def test_files_keep_points_and_triangles(tmp_path, ending):
    mesh = trimalla.mesh(SQUARE, RING, size=1)
    mesh.write(tmp_path / f"m{ending}")
    again = trimalla.Mesh.read(tmp_path / f"m{ending}")
    assert (again.points == mesh.points).all() and (again.triangles == mesh.triangles).all()


def test_drawings_in_files(tmp_path):
    drawing = trimalla.Drawing(SQUARE, RING, segment_markers=[1, 2, 3, 4])
    drawing.write(tmp_path / "d.poly")
    again = trimalla.read(tmp_path / "d.poly")
    assert trimalla.mesh(again) == trimalla.mesh(drawing)
    with pytest.raises(trimalla.FileError):
        trimalla.read(tmp_path / "nothing.poly")
    with pytest.raises(trimalla.FileError):
        trimalla.mesh(drawing).write(tmp_path / "x.unknown")


def test_pictures():
    mesh = trimalla.mesh(SQUARE, RING, size=1)
    assert mesh._repr_svg_().startswith("<svg") or "<svg" in mesh._repr_svg_()[:200]
    assert mesh.png()[:4] == b"\x89PNG" and mesh._repr_png_() is None
    large = trimalla.mesh(SQUARE, RING, triangles=25000)
    assert large._repr_svg_() is None and large._repr_png_()[:4] == b"\x89PNG"


def test_clean_and_compare():
    bow_tie = trimalla.Drawing([[0, 0], [2, 2], [2, 0], [0, 2]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    assert [fault.kind for fault in trimalla.faults(bow_tie)] == ["crossing"]
    mended = trimalla.clean(bow_tie)
    assert mended.left == [] and mended.changes > 0 and np.isclose(trimalla.mesh(mended.drawing).areas.sum(), 2)
    table = trimalla.compare({"square": trimalla.Drawing(SQUARE, RING)}, angles=[20, 30], jobs=2)
    assert "off-center" in str(table) and len(table.data["inputs"][0]["recipes"]) == 3
    assert "min_angle" in trimalla.options()


def test_locate_and_interpolate():
    mesh = trimalla.polygon([SQUARE, [(1, 1), (3, 1), (3, 3), (1, 3)]], size=0.4)
    rng = np.random.default_rng(1)
    places = rng.uniform(-1, 5, (2000, 2))
    found = mesh.locate(places)
    in_hole = ((places > 1) & (places < 3)).all(axis=1)
    outside = ((places < 0) | (places > 4)).any(axis=1)
    assert ((found == -1) == (in_hole | outside)).all()
    values = 3 * mesh.points[:, 0] - 2 * mesh.points[:, 1]
    at = mesh.interpolate(values, places)
    assert np.isnan(at[found == -1]).all()
    assert np.allclose(at[found >= 0], (3 * places[:, 0] - 2 * places[:, 1])[found >= 0])
    assert mesh.locate([[np.nan, 0]]).tolist() == [-1]
