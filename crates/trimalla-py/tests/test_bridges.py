"""Shapely, geopandas, meshio, networkx, xarray, matplotlib, pyvista: each where it is installed."""

import numpy as np
import pytest

import trimalla

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]


def test_shapely_polygons_lines_and_points():
    shapely = pytest.importorskip("shapely")
    plate = shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2)
    assert np.isclose(trimalla.polygon(plate, max_area=0.3).areas.sum(), 15)
    both = shapely.MultiPolygon([plate, shapely.box(6, 0, 7, 1)])
    assert np.isclose(trimalla.polygon(both, max_area=0.3).areas.sum(), 16)
    line = shapely.LineString([(2.5, 2.5), (3.5, 3.5)])
    mesh = trimalla.mesh(trimalla.from_shapely([plate, line, shapely.Point(3, 0.5)]), max_area=0.3)
    assert np.isclose(mesh.areas.sum(), 15)
    ends = mesh.points[mesh.segments]
    on_line = (ends[..., 0] == ends[..., 1]).all(axis=1) & (ends[..., 0] >= 2.5).all(axis=1) & (ends[..., 0] <= 3.5).all(axis=1)
    assert np.isclose(np.linalg.norm(np.diff(ends[on_line], axis=1)[:, 0], axis=1).sum(), 2**0.5)
    assert (mesh.points == [3, 0.5]).all(axis=1).any()
    with pytest.raises(trimalla.Error):
        trimalla.polygon(line)


def test_polygons_that_share_edges_are_regions():
    shapely = pytest.importorskip("shapely")
    left, right = shapely.Polygon([(0, 0), (2, 0), (2, 1), (2, 4), (0, 4)]), shapely.box(2, 1, 4, 4)
    frame = shapely.box(-1, -1, 6, 6) - shapely.box(-0.5, -0.5, 5.5, 5.5)
    mesh = trimalla.mesh(trimalla.from_shapely([left, right, frame], max_areas=[0.1, 0.5, 0]))
    sums = [mesh.areas[mesh.regions == number].sum() for number in (0, 1, 2, 3)]
    assert np.allclose(sums, [0, 8, 6, frame.area])
    assert mesh.areas[mesh.regions == 1].max() <= 0.1


def test_geopandas():
    geopandas = pytest.importorskip("geopandas")
    shapely = pytest.importorskip("shapely")
    rows = {"soil": ["clay", "sand"], "limit": [0.2, 0.4]}
    frame = geopandas.GeoDataFrame(rows, geometry=[shapely.box(0, 0, 2, 2), shapely.box(2, 0, 5, 2)])
    mesh = trimalla.mesh(trimalla.from_geopandas(frame, max_area="limit"))
    soils = frame["soil"].to_numpy()[(mesh.regions - 1).astype(int)]
    assert np.isclose(mesh.areas[soils == "clay"].sum(), 4) and np.isclose(mesh.areas[soils == "sand"].sum(), 6)
    back = trimalla.to_geopandas(mesh)
    assert np.isclose(back.area.sum(), 10)


def test_meshio(tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = trimalla.polygon(SQUARE, size=1)
    mesh.to_meshio().write(tmp_path / "m.vtu")
    again = trimalla.Mesh.from_meshio(meshio.read(tmp_path / "m.vtu"))
    assert (again.points == mesh.points).all() and (again.triangles == mesh.triangles).all()
    assert (again.segments == mesh.segments).all()


def test_networkx():
    networkx = pytest.importorskip("networkx")
    mesh = trimalla.polygon(SQUARE, size=1)
    graph, dual = mesh.to_networkx(), mesh.to_networkx(dual=True)
    assert graph.number_of_edges() == len(mesh.edges) and networkx.is_connected(graph)
    assert dual.number_of_edges() == len(mesh.edges) - len(mesh.boundary) and networkx.is_connected(dual)
    assert networkx.shortest_path_length(graph, 0, 1, weight="length") == pytest.approx(4)


def test_xarray_as_sizes():
    xarray = pytest.importorskip("xarray")
    field = xarray.DataArray([[0.1, 0.6], [0.1, 0.6]], coords={"y": [4.0, 0.0], "x": [0.0, 4.0]}, dims=("y", "x"))
    mesh = trimalla.polygon(SQUARE, size=field)
    middle = mesh.points[mesh.triangles].mean(axis=1)
    allowed = 0.25 * 3**0.5 * (0.1 + 0.125 * middle[:, 0]) ** 2
    assert (mesh.areas <= allowed * 1.001).all() and len(mesh.triangles) > 200


def test_a_raster_with_gaps():
    values = np.full((5, 5), np.nan)
    values[2, 2] = 0.05
    mesh = trimalla.polygon(SQUARE, size=trimalla.Raster(values, x=np.arange(5), y=np.arange(5)))
    at = np.linalg.norm(mesh.points[mesh.triangles].mean(axis=1) - 2, axis=1)
    assert mesh.areas[at < 0.05].max() <= 0.25 * 3**0.5 * 0.05**2 * 1.001 and mesh.areas.max() > 0.1


def test_matplotlib():
    tri = pytest.importorskip("matplotlib.tri")
    mesh = trimalla.polygon(SQUARE, size=1)
    made = mesh.to_matplotlib()
    assert isinstance(made, tri.Triangulation) and len(made.edges) == len(mesh.edges)


def test_pyvista():
    pytest.importorskip("pyvista")
    mesh = trimalla.polygon(SQUARE, size=1)
    assert mesh.to_pyvista().area == pytest.approx(16)
