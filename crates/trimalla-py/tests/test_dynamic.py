"""Triangulations that change, and refinements step by step."""

import numpy as np
import pytest

import trimalla


def canonical(triangles):
    first = triangles.argmin(axis=1)
    turned = [np.roll(row, -shift) for row, shift in zip(triangles, first)]
    return sorted(map(tuple, np.array(turned).tolist()))


def test_changes_and_undo():
    rng = np.random.default_rng(7)
    points = rng.random((60, 2))
    t = trimalla.Triangulation(points[:40])
    before = canonical(t.triangles)
    assert t.insert(points[40:]).tolist() == list(range(40, 60))
    assert canonical(t.triangles) == canonical(trimalla.delaunay(points))
    t.remove(41)
    t.move(3, [0.5, 0.501])
    assert t.check() == [] and t.changes == 3
    a, b = 0, 1
    number = t.insert_segment(a, b, crossings="split")
    assert t.check() == [] and t.remove_segment(number)
    while t.undo():
        assert t.check() == []
    assert canonical(t.triangles) == before and t.changes == 0


def test_places_and_values():
    rng = np.random.default_rng(8)
    points = rng.random((300, 2))
    t = trimalla.Triangulation(points)
    places = rng.random((500, 2)) * 1.2 - 0.1
    nearest = ((places[:, np.newaxis] - points) ** 2).sum(axis=2)
    found = t.nearest(places)
    assert (nearest[np.arange(500), found] == nearest.min(axis=1)).all()
    values = points @ [2.0, -1.0] + 5
    inside = t.locate(places)[:, 0] >= 0
    for method in ("linear", "natural-neighbour", "laplace"):
        at = t.interpolate(values, places, method=method)
        assert np.isnan(at[~inside]).all() and np.allclose(at[inside], places[inside] @ [2.0, -1.0] + 5)
    with pytest.raises(trimalla.OptionError):
        t.interpolate(values, places, method="magic")
    with pytest.raises(trimalla.MeshError):
        t.interpolate(values[:3], places)


def test_what_cannot_be_changed_changes_nothing():
    t = trimalla.Triangulation([[0, 0], [4, 0], [4, 4], [0, 4]], [[0, 2]])
    before = canonical(t.triangles)
    for call in (
        lambda: t.insert([np.nan, 0]),
        lambda: t.insert([[1, 1.5], [np.inf, 0]]),
        lambda: t.remove(0),
        lambda: t.remove(99),
        lambda: t.remove(-1),
        lambda: t.insert_segment(1, 3),
        lambda: t.insert_segment(1, 99),
        lambda: t.move(1, [np.nan, 1]),
        lambda: t.neighbours(99),
    ):
        with pytest.raises(trimalla.Error):
            call()
        assert canonical(t.triangles) == before and t.check() == [] and t.changes == 0
    assert t.remove_segment(99) is False


def test_few_points():
    t = trimalla.Triangulation()
    assert t.nearest([[1, 1]]).tolist() == [-1] and t.locate([[1, 1]]).tolist() == [[-1] * 3]
    t.insert([0, 0])
    assert t.insert([0, 0]) == 0
    t.insert([[1, 0], [2, 0]])
    assert len(t.triangles) == 0 and t.nearest([[1.2, 3]]).tolist() == [1]
    t.insert([1, 1])
    assert len(t.triangles) == 2 and t.check() == []


def test_a_refinement_step_by_step_is_the_mesh_at_once():
    points, ring = [[0, 0], [9, 0], [9, 1], [0, 4]], [[0, 1], [1, 2], [2, 3], [3, 0]]
    at_once = trimalla.mesh(points, ring, min_angle=30, max_area=0.5)
    r = trimalla.Refinement(points, ring, min_angle=30, max_area=0.5)
    start = r.mesh()
    assert r.run(5) == 5 and r.steps == 5
    middle = r.mesh()
    while r.step() != "Finished":
        pass
    assert r.finish() == at_once and r.report.complete and r.min_angle >= 30 - 1e-9
    while r.steps > 5:
        assert r.back()
    assert r.mesh() == middle
    while r.back():
        pass
    assert r.mesh() == start
    r.run()
    assert r.finish() == at_once
