"""Calls that must end in an exception or a result, and never in a crash, a hang or a leak."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import trimalla
import trimalla.triangle
from trimalla import _native
from trimalla.scipy import Delaunay

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
RING = [[0, 1], [1, 2], [2, 3], [3, 0]]


def anything(rng):
    """A value that hardly any argument expects."""
    n = int(rng.integers(0, 6))
    return [
        None, 0, -1, 1.5, np.nan, np.inf, 1e308, 1e-320, True, "x", b"x", [], [[]], [[1]], [[1, 2, 3]], {}, object(), 2**70,
        [[2**40, 0]], np.zeros((n, 2)), np.full((n, 2), np.nan), rng.random((n, 2)) * 10.0 ** rng.integers(-300, 300),
        rng.integers(-3, 6, (n, 2)), rng.integers(-3, 6, (n, 3)), np.zeros((2, 2, 2)), np.zeros((0, 5)), rng.random(n),
        np.zeros((3, 2), dtype=complex), np.zeros((3, 2), dtype=bool), np.array([["a", "b"]]), np.zeros((3, 4)),
        np.array([[1, None]], dtype=object), np.broadcast_to(np.float64(1), (3, 2)), np.arange(8.0)[::-1].reshape(4, 2),
        np.array([[1, 2]], dtype=">i4"), np.datetime64("2020-01-01"), np.ma.array([[1, 2], [3, 4]], mask=[[0, 1], [0, 0]]),
        lambda *a: None, range(4), iter([1]), memoryview(b"ab"), SQUARE, RING, np.float16(3), [SQUARE], "30", "pqa0.1",
    ][int(rng.integers(0, 47))]  # fmt: skip


def test_arguments_of_every_kind():
    rng = np.random.default_rng(int(os.environ.get("TRIMALLA_SEED", "3")))
    mesh = trimalla.mesh(SQUARE, RING)
    dynamic = trimalla.Triangulation(SQUARE)
    calls = [
        lambda a, b, c, d: trimalla.mesh(a, b, c, d, max_vertices=500),
        lambda a, b, c, d: trimalla.mesh(SQUARE, RING, a, b, max_vertices=500),
        lambda a, b, c, d: trimalla.mesh(SQUARE, RING, size=a, max_vertices=500),
        lambda a, b, c, d: trimalla.mesh(SQUARE, RING, min_angle=a, max_area=b, max_vertices=500),
        lambda a, b, c, d: trimalla.mesh(SQUARE, RING, sources=a, gradation=b, max_vertices=500),
        lambda a, b, c, d: trimalla.mesh(SQUARE, RING, point_markers=a, segment_markers=b, point_attributes=c),
        lambda a, b, c, d: trimalla.polygon(a, max_vertices=500),
        lambda a, b, c, d: trimalla.triangulate(a, b, c, method=d if isinstance(d, str) else "incremental"),
        lambda a, b, c, d: trimalla.delaunay(a),
        lambda a, b, c, d: trimalla.refine(mesh, areas=a, min_angle=b, max_vertices=500),
        lambda a, b, c, d: trimalla.Mesh(a, b, c),
        lambda a, b, c, d: trimalla.Mesh(a, b).check(),
        lambda a, b, c, d: trimalla.Mesh(a, b).refine(max_vertices=500),
        lambda a, b, c, d: trimalla.Mesh(a, b).edges,
        lambda a, b, c, d: trimalla.Mesh(a, b).locate(c),
        lambda a, b, c, d: mesh.interpolate(a, b),
        lambda a, b, c, d: trimalla.Triangulation(a, b),
        lambda a, b, c, d: dynamic.insert(a),
        lambda a, b, c, d: dynamic.remove(a),
        lambda a, b, c, d: dynamic.move(a, b),
        lambda a, b, c, d: dynamic.insert_segment(a, b),
        lambda a, b, c, d: dynamic.nearest(a),
        lambda a, b, c, d: trimalla.Refinement(a, b, c, d, max_vertices=200).run(),
        lambda a, b, c, d: trimalla.faults(trimalla.Drawing(a, b, c, d)),
        lambda a, b, c, d: trimalla.clean(trimalla.Drawing(a, b), tolerance=c),
        lambda a, b, c, d: trimalla.triangle.triangulate({"vertices": a, "segments": b, "holes": c}, "pq20"),
        lambda a, b, c, d: trimalla.triangle.triangulate({"vertices": a, "triangles": b}, "rq20"),
        lambda a, b, c, d: trimalla.triangle.triangulate({"vertices": SQUARE}, a if isinstance(a, str) else "q"),
        lambda a, b, c, d: Delaunay(a).find_simplex(b),
        lambda a, b, c, d: _native.mesh(a, b, c, d),
        lambda a, b, c, d: _native.mesh({"points": a, "segments": b, "regions": c}, {}, {}),
        lambda a, b, c, d: _native.edges({"points": a, "triangles": b}),
        lambda a, b, c, d: _native.refine({"points": a}, None, b, {}, {}, None),
        lambda a, b, c, d: trimalla.Raster(a, b, c),
    ]
    refused = done = 0
    for i in range(int(os.environ.get("TRIMALLA_CALLS", "6000"))):
        call = calls[i % len(calls)]
        given = [anything(rng) for _ in range(4)]
        try:
            call(*given)
            done += 1
        except (trimalla.Error, TypeError, KeyError, ValueError, OverflowError, AttributeError, IndexError):
            refused += 1
        if len(dynamic.points) > 300:
            dynamic = trimalla.Triangulation(SQUARE)
    assert refused > done > 100
    assert dynamic.check() == []


MANY = np.random.default_rng(1).random((3_000_000, 2))


class Stop(Exception):
    pass


def slow(**options):
    """A mesh that takes seconds."""
    return trimalla.mesh(SQUARE, RING, max_area=2e-5, max_vertices=20_000_000, **options)


def test_a_callback_that_raises_ends_the_call():
    def raises(vertices, waiting):
        raise Stop

    start = time.monotonic()
    with pytest.raises(Stop):
        slow(progress=raises)
    assert time.monotonic() - start < 0.5


def test_a_callback_that_returns_false_gives_the_mesh_so_far():
    seen = []

    def stops(vertices, waiting):
        seen.append(vertices)
        return len(seen) < 3

    mesh = slow(progress=stops)
    assert mesh.report.stop == "cancelled" and not mesh.report.complete and len(seen) == 3
    assert mesh.check() == []


def test_a_callback_that_calls_back_in():
    inner = []

    def meshes(vertices, waiting):
        inner.append(len(trimalla.mesh(SQUARE, RING, size=0.5).triangles))
        return len(inner) < 2

    slow(progress=meshes)
    assert len(set(inner)) == 1
    size = lambda x, y: np.full_like(x, 0.2 + 1e-4 * len(trimalla.delaunay(np.column_stack([x, y]))))  # noqa: E731
    assert trimalla.mesh(SQUARE, RING, size=size).report.complete


def test_a_size_that_raises():
    def raises(x, y):
        raise Stop

    with pytest.raises(Stop):
        trimalla.mesh(SQUARE, RING, size=raises)


def interrupted_after(call):
    """How long after a signal a call ends."""
    sent = []

    def send():
        time.sleep(0.3)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        call()
        time.sleep(5)
    ended = time.monotonic()
    thread.join()
    return ended - sent[0]


@pytest.mark.parametrize(
    "call",
    [
        slow,
        lambda: trimalla.triangle.triangulate({"vertices": SQUARE, "segments": RING}, "pq30a0.00002"),
        lambda: trimalla.Refinement(SQUARE, RING, max_area=2e-5, max_vertices=20_000_000, history_bytes=0).run(),
        lambda: trimalla.delaunay(MANY),
    ],
)
def test_an_interrupt_ends_a_call_at_once(call):
    assert interrupted_after(call) < 0.1
    assert trimalla.mesh(SQUARE, RING).report.complete


def test_threads_work_side_by_side_and_the_interpreter_is_free():
    expected = trimalla.mesh(SQUARE, RING, size=0.05)
    made, ticks = [], [0]
    threads = [threading.Thread(target=lambda: made.append(trimalla.mesh(SQUARE, RING, size=0.05))) for _ in range(8)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        ticks[0] += 1
        time.sleep(0)
    assert len(made) == 8 and all(mesh == expected for mesh in made) and ticks[0] > 10


def test_threads_that_share_a_triangulation():
    t = trimalla.Triangulation(SQUARE)
    problems = []

    def work(seed):
        rng = np.random.default_rng(seed)
        for _ in range(200):
            try:
                t.insert(rng.random(2) * 4)
                t.nearest(rng.random((3, 2)))
                t.undo()
            except RuntimeError:
                pass  # Another thread works with it.
            except Exception as error:  # noqa: BLE001
                problems.append(error)

    threads = [threading.Thread(target=work, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert problems == [] and t.check() == []


LEAK = """
import resource, sys
import numpy as np, trimalla
square, ring = [[0, 0], [4, 0], [4, 4], [0, 4]], [[0, 1], [1, 2], [2, 3], [3, 0]]

def once():
    trimalla.mesh(square, ring, size=0.8)
    trimalla.delaunay(np.zeros((50, 2)))
    trimalla.Triangulation(square).insert([1, 1])
    try:
        trimalla.mesh(square, [[0, 2], [1, 3]])
    except trimalla.Error:
        pass

for _ in range(500):
    once()
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
for _ in range(int(sys.argv[1])):
    once()
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""


def test_no_leak():
    calls = os.environ.get("TRIMALLA_LEAK_CALLS", "2000")
    done = subprocess.run([sys.executable, "-c", LEAK, calls], capture_output=True, text=True, check=True)
    assert int(done.stdout) < 2_000  # kB
