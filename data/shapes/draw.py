#!/usr/bin/env python3
"""Draws the shapes of this folder.

`python3 data/shapes/draw.py` writes every `.poly` file beside this script and prints a line for each.
The same bytes come out on every run: the one random drawing is seeded, and coordinates are rounded to
four decimals before anything is decided about them.

Each drawing is checked before it is written, on the rounded coordinates and with integers, so the
answers are exact: no point occurs twice, no two segments meet except in a common end, outer rings run
counter-clockwise and holes clockwise, and every hole seed lies inside its hole and off every segment.

Coordinates have y upwards. Only the standard library is needed.
"""

import math
import random
from pathlib import Path

DECIMALS = 4
SCALE = 10**DECIMALS


# Curves. Every function returns a list of (x, y) and includes both ends.


def arc(cx, cy, r, start_deg, end_deg, pieces, ry=None):
    """A circular arc (elliptic if `ry` is given) from one angle to another."""
    ry = r if ry is None else ry
    points = []
    for i in range(pieces + 1):
        a = math.radians(start_deg + (end_deg - start_deg) * i / pieces)
        points.append((cx + r * math.cos(a), cy + ry * math.sin(a)))
    return points


def circle(cx, cy, r, pieces, start_deg=0.0):
    """A closed circle, counter-clockwise, without the repeated end."""
    return arc(cx, cy, r, start_deg, start_deg + 360.0, pieces)[:-1]


def cubic(p0, p1, p2, p3, t):
    """The point of a cubic Bezier curve at parameter `t`."""
    u = 1.0 - t
    b = (u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t)
    return tuple(b[0] * p0[k] + b[1] * p1[k] + b[2] * p2[k] + b[3] * p3[k] for k in (0, 1))


def even(dense, spacing):
    """Takes points along a dense chain at equal steps of its length, close to `spacing`."""
    lengths = [0.0]
    for a, b in zip(dense, dense[1:]):
        lengths.append(lengths[-1] + math.dist(a, b))
    pieces = max(1, round(lengths[-1] / spacing))
    points, k = [], 0
    for i in range(pieces + 1):
        want = lengths[-1] * i / pieces
        while k < len(dense) - 2 and lengths[k + 1] < want:
            k += 1
        t = (want - lengths[k]) / (lengths[k + 1] - lengths[k])
        a, b = dense[k], dense[k + 1]
        points.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
    points[0], points[-1] = dense[0], dense[-1]
    return points


def curve(*knots, spacing):
    """A chain of cubic Bezier curves (ends shared: 4, 7, 10 ... knots), sampled at even steps."""
    dense = [knots[0]]
    for k in range(0, len(knots) - 3, 3):
        dense += [cubic(*knots[k : k + 4], i / 400) for i in range(1, 401)]
    return even(dense, spacing)


def slot(ax, ay, bx, by, r, cap_pieces):
    """A slot with round ends about the segment from a to b, counter-clockwise."""
    a = math.degrees(math.atan2(by - ay, bx - ax))
    return arc(bx, by, r, a - 90, a + 90, cap_pieces) + arc(ax, ay, r, a + 90, a + 270, cap_pieces)


def turned(points, deg, cx=0.0, cy=0.0):
    """The points turned about (cx, cy)."""
    c, s = math.cos(math.radians(deg)), math.sin(math.radians(deg))
    return [(cx + c * (x - cx) - s * (y - cy), cy + s * (x - cx) + c * (y - cy)) for x, y in points]


def mirrored(points):
    """The points reflected in the x axis."""
    return [(x, -y) for x, y in points]


# Exact tests, on integer coordinates.


def orient(a, b, c):
    """Twice the signed area of abc: positive if counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def on_segment(p, a, b):
    """Whether p lies on the closed segment ab."""
    return (
        orient(a, b, p) == 0
        and min(a[0], b[0]) <= p[0] <= max(a[0], b[0])
        and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])
    )


def sign(v):
    return (v > 0) - (v < 0)


def meet(a, b, c, d):
    """Whether the closed segments ab and cd have a point in common."""
    if sign(orient(a, b, c)) * sign(orient(a, b, d)) < 0 and sign(orient(c, d, a)) * sign(orient(c, d, b)) < 0:
        return True
    return on_segment(c, a, b) or on_segment(d, a, b) or on_segment(a, c, d) or on_segment(b, c, d)


def inside(p, ring):
    """Whether p is inside the ring, by parity of crossings."""
    odd = False
    for a, b in zip(ring, ring[1:] + ring[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]):
            if (orient(a, b, p) > 0) == (b[1] > a[1]):
                odd = not odd
    return odd


def doubled_area(ring):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))


class Drawing:
    """A planar straight-line graph in the making; points are integers in units of 10^-DECIMALS."""

    def __init__(self, name, *notes):
        self.name, self.notes = name, notes
        self.points, self.markers, self.index = [], [], {}
        self.segments, self.seeds, self.regions, self.rings = [], [], [], []

    def vertex(self, p, marker):
        """The index of the point; a place already used gives the point already there."""
        q = (round(p[0] * SCALE), round(p[1] * SCALE))
        if q not in self.index:
            self.index[q] = len(self.points)
            self.points.append(q)
            self.markers.append(marker)
        return self.index[q]

    def chain(self, points, marker):
        """An open chain of segments. Ends, and only ends, may be points drawn earlier."""
        ids = [self.vertex(p, marker) for p in points]
        self.segments += [(a, b, marker) for a, b in zip(ids, ids[1:])]
        return ids

    def loop(self, points, marker):
        """A closed chain that bounds no hole."""
        before = len(self.points)
        ids = self.chain(points, marker)
        self.segments.append((ids[-1], ids[0], marker))
        assert len(self.points) - before == len(points), f"{self.name}: a ring repeats a point"
        return [self.points[i] for i in ids]

    def outer(self, points, marker):
        """An outer ring, given counter-clockwise."""
        self.rings.append((self.loop(points, marker), None))

    def bounded_by(self, points):
        """Declares the outer ring, counter-clockwise, where chains have drawn it piece by piece."""
        self.rings.append(([self.points[self.index[round(x * SCALE), round(y * SCALE)]] for x, y in points], None))

    def hole(self, points, marker, seed):
        """A hole, given counter-clockwise and stored clockwise, with a seed in it."""
        q = (round(seed[0] * SCALE), round(seed[1] * SCALE))
        self.seeds.append(q)
        self.rings.append((self.loop(points[::-1], marker), q))

    def region(self, seed, attribute, max_area):
        self.regions.append((round(seed[0] * SCALE), round(seed[1] * SCALE), attribute, max_area))

    def check(self):
        """Raises AssertionError with the place of the first fault."""
        at = self.points
        for i, (a, b, _) in enumerate(self.segments):
            for c, d, _ in self.segments[i + 1 :]:
                shared = {a, b} & {c, d}
                assert len(shared) < 2, f"{self.name}: segment {a} {b} drawn twice"
                if shared:
                    (s,) = shared
                    p, q = (a + b - s, c + d - s)
                    crossed = on_segment(at[p], at[c], at[d]) or on_segment(at[q], at[a], at[b])
                elif max(at[a][0], at[b][0]) < min(at[c][0], at[d][0]) or max(at[c][0], at[d][0]) < min(at[a][0], at[b][0]):
                    crossed = False
                else:
                    crossed = meet(at[a], at[b], at[c], at[d])
                assert not crossed, f"{self.name}: segments {a} {b} and {c} {d} meet at {at[a]}"
        used = {v for a, b, _ in self.segments for v in (a, b)}
        for p in range(len(at)):
            assert p in used or not any(on_segment(at[p], at[a], at[b]) for a, b, _ in self.segments), (
                f"{self.name}: point {p} lies inside a segment"
            )
        for ring, seed in self.rings:
            assert (doubled_area(ring) < 0) == (seed is not None), f"{self.name}: a ring runs the wrong way"
            around = sum(inside(ring[0], other) for other, _ in self.rings if other is not ring)
            assert around % 2 == (seed is not None), f"{self.name}: a ring is nested wrongly"
            if seed is not None:
                assert inside(seed, ring), f"{self.name}: seed {seed} is outside its hole"
        for seed in self.seeds + [r[:2] for r in self.regions]:
            assert not any(on_segment(seed, at[a], at[b]) for a, b, _ in self.segments), f"{self.name}: seed on a segment"

    def text(self):
        """The file: points, segments, holes and, where there are any, regions."""
        lines = [f"# {note}" for note in self.notes]
        lines.append("# Drawn for trimalla by draw.py, in the same folder.")
        lines += ["#", "# points: id x y marker", f"{len(self.points)} 2 0 1"]
        lines += [f"{i} {number(x)} {number(y)} {m}" for i, ((x, y), m) in enumerate(zip(self.points, self.markers))]
        lines += ["# segments: id end end marker", f"{len(self.segments)} 1"]
        lines += [f"{i} {a} {b} {m}" for i, (a, b, m) in enumerate(self.segments)]
        lines += ["# holes: id x y", f"{len(self.seeds)}"]
        lines += [f"{i} {number(x)} {number(y)}" for i, (x, y) in enumerate(self.seeds)]
        if self.regions:
            lines += ["# regions: id x y attribute max-area", f"{len(self.regions)}"]
            lines += [f"{i} {number(x)} {number(y)} {a} {m}" for i, (x, y, a, m) in enumerate(self.regions)]
        return "\n".join(lines) + "\n"


def number(v):
    """An integer count of 10^-DECIMALS as a decimal without superfluous zeros."""
    whole, rest = divmod(abs(v), SCALE)
    digits = f"{rest:0{DECIMALS}d}".rstrip("0")
    return ("-" if v < 0 else "") + str(whole) + ("." + digits if digits else "")


# The shapes.


def guitar():
    """A classical guitar seen from the front, in millimetres; 650 mm between nut and saddle."""
    d = Drawing(
        "guitar",
        "A classical guitar from the front, in millimetres: head, neck and frets to the right.",
        "Markers: 1 outline, 2 sound hole, 3 saddle slot, 4 head slots,",
        "5 rosette, 6 bridge, 7 edge of the fingerboard, 8 nut and frets.",
    )
    nut, joint, scale = 815.0, 490.0, 650.0

    def half(x):
        return 26.0 + (nut - x) * 5.0 / (nut - joint)

    fret_x = [nut - scale * (1.0 - 2.0 ** (-k / 12)) for k in range(19)]
    fret_x[12] = joint
    hole_x, hole_r = 332.0, 42.0

    # The upper half of the outline, from the tail to the tip of the head.
    body = curve(
        (0, 0), (0, 64), (14, 118), (44, 149),
        (68, 174), (98, 185), (134, 185),
        (202, 185), (240, 121), (306, 121),
        (340, 121), (362, 141), (402, 141),
        (452, 141), (486, 108), (joint, half(joint)),
        spacing=9.0,
    )  # fmt: skip
    neck = [(x, half(x)) for x in reversed(fret_x[1:12])] + [(nut, half(nut))]
    flare = curve((nut, 26), (824, 26), (824, 34.5), (842, 34.5), spacing=4.5)

    def side(x):
        return 34.5 + (x - 842) * 3.0 / 146

    head = list(flare[1:])
    for x in (870, 907, 944):
        y = side(x) + 15.5
        rx, ry = 8.5, 6.5
        foot = math.degrees(math.asin(2.4 / rx))
        knob = arc(x, y, rx, 270 - foot, -90 + foot, 13, ry)
        head += [(x - 2.4, side(x - 2.4)), *knob, (x + 2.4, side(x + 2.4))]
    shoulder = curve((988, 37.5), (996, 37.5), (1003, 33), (1003, 23), spacing=4.5)
    crest = curve((1003, 23), (1013, 21), (1017, 11), (1017, 0), spacing=4.5)
    upper = body + neck + head + shoulder + crest[1:]
    d.outer(mirrored(upper) + upper[-2:0:-1], 1)

    d.hole(circle(hole_x, 0, hole_r, 36), 2, (hole_x, 0))
    saddle = nut - scale
    d.hole(slot(saddle, -39, saddle, 39, 2.2, 4), 3, (saddle, 0))
    for s in (-1, 1):
        d.hole(slot(862, s * 17.5, 952, s * 17.5, 6.5, 8), 4, (907, s * 17.5))

    # The fingerboard lies on the body up to an arc about the sound hole.
    end_r = hole_r + 13.0
    lo, hi = hole_x, joint
    for _ in range(60):
        mid = (lo + hi) / 2
        lo, hi = (mid, hi) if math.hypot(mid - hole_x, half(mid)) < end_r else (lo, mid)
    corner = math.degrees(math.atan2(half(lo), lo - hole_x))
    rim = arc(hole_x, 0, end_r, -corner, corner, 8)
    edge = [(x, half(x)) for x in fret_x[12:]]
    d.chain(mirrored(edge) + rim + edge[::-1], 7)
    for x in fret_x:
        d.chain([(x, -half(x)), (x, half(x))], 8)

    # The rosette ends where the last fret meets the edge of the fingerboard.
    x = fret_x[18]
    rose_r, a = math.hypot(x - hole_x, half(x)), math.degrees(math.atan2(half(x), x - hole_x))
    rosette = arc(hole_x, 0, rose_r, a, 360 - a, 40)
    d.chain([(x, half(x)), *rosette[1:-1], (x, -half(x))], 5)

    wing = curve((177, 44), (177, 56), (173, 56), (173, 62), spacing=4.5) + curve(
        (173, 62), (173, 96), (173, 99), (164, 99), (155, 99), (155, 96), (155, 62), spacing=5
    )[1:]
    foot = curve((155, 62), (155, 56), (150, 56), (150, 44), spacing=4.5)[1:]
    half_bridge = wing + foot
    d.loop(half_bridge + mirrored(half_bridge)[::-1], 6)
    return d


def gear():
    """A spur gear with true involute flanks."""
    d = Drawing(
        "gear",
        "A spur gear, in millimetres: 24 involute teeth of module 4, pressure angle 20 degrees.",
        "Markers: 1 teeth, 2 bore with keyway, 3 kidney-shaped windows, 4 bolt holes.",
    )
    teeth, module, pressure = 24, 4.0, math.radians(20)
    pitch = teeth * module / 2
    base, tip, root = pitch * math.cos(pressure), pitch + module, pitch - 1.25 * module

    def half_tooth(r):
        """Half the angle that the tooth takes at radius r, in degrees."""
        a = math.acos(min(1.0, base / r))
        return math.degrees(math.pi / (2 * teeth) + math.tan(pressure) - pressure - math.tan(a) + a)

    radii = [base + (tip - base) * t for t in (0.0, 0.18, 0.4, 0.6, 0.8, 1.0)]
    right = [(r, -half_tooth(r)) for r in radii]
    fillet_r = (base - root) * 0.55
    right = [(root + fillet_r * 0.12, right[0][1] - 0.45), (root + fillet_r, right[0][1])] + right
    tooth = right + [(tip, 0.0)] + [(r, -a) for r, a in reversed(right)]
    outline = []
    for k in range(teeth):
        for r, a in [(root, -180 / teeth), *tooth]:
            t = math.radians(360.0 * k / teeth + a)
            outline.append((r * math.cos(t), r * math.sin(t)))
    d.outer(outline, 1)

    bore, key_half, key_top = 10.0, 2.6, 13.0
    a = math.degrees(math.asin(key_half / bore))
    d.hole(arc(0, 0, bore, 90 + a, 450 - a, 32) + [(key_half, key_top), (-key_half, key_top)], 2, (0, 0))

    mid, r, half = 27.5, 7.0, 14.0
    for k in range(5):
        kidney = (
            arc(0, 0, mid + r, -half, half, 9)
            + turned(arc(mid, 0, r, 0, 180, 9), half)[1:-1]
            + arc(0, 0, mid - r, half, -half, 5)
            + turned(arc(mid, 0, r, 180, 360, 9), -half)[1:-1]
        )
        turn = 90 + 72 * k
        d.hole(turned(kidney, turn), 3, turned([(mid, 0)], turn)[0])
    for k in range(5):
        cx, cy = turned([(36.2, 0)], 126 + 72 * k)[0]
        d.hole(circle(cx, cy, 2.6, 14), 4, (cx, cy))
    return d


def key():
    """An old door key."""
    d = Drawing(
        "key",
        "An old door key, in millimetres: trefoil bow on the left, collar, shank, bit with ward notches.",
        "Markers: 1 outline, 2 hole of the bow, 3 ward hole in the bit.",
    )

    def trefoil(r, lobe, start_deg, end_deg):
        """Three round lobes about the origin; one points along -x. Sampled finely."""
        points = []
        for i in range(1201):
            a = math.radians(start_deg + (end_deg - start_deg) * i / 1200)
            rho = r * (1 - lobe * math.cos(3 * a))
            points.append((rho * math.cos(a), rho * math.sin(a)))
        return points

    shank = 3.4
    bow = even(trefoil(17.5, 0.2, 27, 333), 1.9)
    x, y = bow[-1]
    neck = curve((x, y), (x - 0.5, y + 2.6), (x + 1.2, -shank), (20.5, -shank), spacing=1.3)[1:]

    def bead(x, r):
        """A bead turned on the shank, left to right on its lower side."""
        return arc(x, -shank, r, 180, 360, 8, ry=1.3 * r)

    lower = neck + bead(25.4, 1.6) + bead(30.6, 2.8) + bead(35.8, 1.6)
    top, bottom = -shank, -24.0
    bit = [
        (80, top), (80, -9), (84, -9), (84, -12), (80, -12), (80, bottom),
        (84.5, bottom), (84.5, -19), (87, -19), (87, bottom),
        (92.5, bottom), (92.5, -16), (95, -16), (95, bottom),
        (101, bottom), (101, -20), (97.5, -20), (97.5, -17.5), (101, -17.5), (101, top),
    ]  # fmt: skip
    tip = arc(108, 0, shank, -90, 90, 8)
    upper = [(x, -y) for x, y in reversed(lower)]
    d.outer(bow + lower + bit + tip + upper, 1)

    d.hole(even(trefoil(10.6, 0.2, 0, 360), 1.5)[:-1], 2, (0, 0))
    cx, cy, w, l = 90.5, -10.0, 0.9, 2.9
    cross = [(w, -l), (w, -w), (l, -w), (l, w), (w, w), (w, l), (-w, l), (-w, w), (-l, w), (-l, -w), (-w, -w), (-w, -l)]
    d.hole([(cx + x, cy + y) for x, y in cross], 3, (cx, cy))
    return d


class Coast:
    """Rings grown by midpoint displacement; a displacement that would cut or crowd a ring is made smaller."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.rings = []

    def free(self, ring, i, m):
        """Whether the segment after point i may go by m instead."""
        a, b = ring[i], ring[(i + 1) % len(ring)]
        before, after = ring[i - 1], ring[(i + 2) % len(ring)]
        if min(angle(before, a, m), angle(m, b, after), angle(a, m, b)) < 42.0:
            return False
        room = 0.42 * min(math.dist(a, m), math.dist(m, b))
        for other in self.rings:
            for j, c in enumerate(other):
                e = other[(j + 1) % len(other)]
                if other is ring and j == i:
                    continue
                if meet(a, m, c, e) and a not in (c, e) or meet(m, b, c, e) and b not in (c, e):
                    return False
                if distance(m, c, e) < room:
                    return False
        return True

    def grow(self, ring, roughness, shortest):
        """Halves the longest segment, again and again, until none is longer than `shortest`."""
        self.rings.append(ring)
        while True:
            lengths = [math.dist(ring[i], ring[(i + 1) % len(ring)]) for i in range(len(ring))]
            i = max(range(len(ring)), key=lambda k: (lengths[k], -k))
            if lengths[i] <= shortest:
                return ring
            a, b = ring[i], ring[(i + 1) % len(ring)]
            t = 0.5 + 0.16 * (self.random.random() - 0.5)
            h = roughness * (self.random.random() + self.random.random() - 1.0)
            while True:
                m = (
                    round(a[0] + t * (b[0] - a[0]) - h * (b[1] - a[1])),
                    round(a[1] + t * (b[1] - a[1]) + h * (b[0] - a[0])),
                )
                if abs(h) < 1e-3 or self.free(ring, i, m):
                    break
                h *= -0.6
            ring.insert(i + 1, m)


def angle(a, b, c):
    """The angle at b, in degrees, between 0 and 180."""
    u, v = (a[0] - b[0], a[1] - b[1]), (c[0] - b[0], c[1] - b[1])
    return math.degrees(math.atan2(abs(u[0] * v[1] - u[1] * v[0]), u[0] * v[0] + u[1] * v[1]))


def distance(p, a, b):
    """The distance from p to the segment ab."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = max(0.0, min(1.0, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def coast():
    """An island that never was."""
    d = Drawing(
        "coast",
        "An island that never was, in kilometres: fractal coast, four lakes, and an islet in the largest lake.",
        "Markers: 1 sea coast, 2 to 5 lake shores, 6 shore of the islet (land again, inside the hole of lake 2).",
    )
    grower = Coast(2009)

    def ring(points, roughness, shortest):
        whole = [(round(x * SCALE), round(y * SCALE)) for x, y in points]
        return [(x / SCALE, y / SCALE) for x, y in grower.grow(whole, roughness, round(shortest * SCALE))]

    lakes = [
        [(30, 34), (41, 29), (55, 31), (60, 41), (52, 50), (38, 49), (29, 43)],
        [(71, 52), (80, 48), (86, 55), (79, 62), (71, 60)],
        [(84, 24), (94, 21), (100, 28), (93, 35), (85, 32)],
        [(46, 66), (53, 63), (58, 67), (54, 72), (47, 72)],
    ]
    islet = ring([(41, 37), (48, 36), (50, 42), (44, 44)], 0.5, 1.9)
    shores = [ring(p, 0.6, 2.3) for p in lakes]
    sea = ring(
        [(8, 22), (22, 14), (40, 13), (50, 4), (66, 6), (72, 15), (88, 6), (108, 10), (122, 24), (112, 36),
         (120, 50), (108, 66), (90, 70), (78, 84), (60, 92), (52, 82), (36, 86), (24, 74), (28, 60), (12, 54), (16, 38)],
        0.62, 2.15,
    )  # fmt: skip
    d.outer(sea, 1)
    seeds = [(35, 40), (78, 55), (92, 28), (52, 68)]
    for k, (shore, seed) in enumerate(zip(shores, seeds)):
        d.hole(shore, 2 + k, seed)
    d.outer(islet, 6)
    return d


def plate():
    """A test plate: everything a drawing may hold besides rings."""
    d = Drawing(
        "plate",
        "A rectangular plate of two materials, in millimetres, with segments that end in its interior.",
        "Markers: 1 bottom, 2 right, 3 top, 4 left side, 5 seam between the materials, 6 bolt holes,",
        "7 slit, 8 crack from the top side, 9 ribs (some touch nothing, some hang from a vertex), 10 lone points.",
    )
    w, h = 120.0, 80.0
    seam = curve((46, 0), (46, 30), (74, 44), (74, h), spacing=6)
    crack = [(24, h), (25.5, 70), (23.2, 63), (26, 55.5)]
    d.chain([(0, 0), (46, 0), (w, 0)], 1)
    d.chain([(w, 0), (w, h)], 2)
    d.chain([(w, h), (74, h), (24, h), (0, h)], 3)
    d.chain([(0, h), (0, 0)], 4)
    d.bounded_by([(0, 0), (w, 0), (w, h), (0, h)])
    d.chain(seam, 5)
    d.chain(crack, 8)
    d.chain([(23.2, 63), (17, 57.5)], 8)

    for x, y in ((9, 9), (111, 9), (111, 71), (9, 71)):
        d.hole(circle(x, y, 3, 16), 6, (x, y))
    d.hole(arc(91, 41.5, 12, 180, 360, 12, ry=1.4) + arc(91, 41.5, 12, 0, 180, 12, ry=1.4)[1:-1], 7, (91, 41.5))

    d.chain([(14, 30), (36, 30)], 9)
    d.chain([(36, 30), (36, 14)], 9)
    d.chain([(36, 30), (44, 38)], 9)
    d.chain([(64, 16), (100, 26)], 9)
    d.chain([(103, 41.5), (112, 50)], 9)
    d.chain([(82, 58), (90, 64), (98, 58), (90, 52), (82, 58)], 9)
    for p in ((20, 20), (90, 58), (52, 66)):
        d.vertex(p, 10)
    d.region((30, 40), 1, 12)
    d.region((85, 30), 2, 30)
    return d


def star():
    """Small input angles, outside and inside."""
    d = Drawing(
        "star",
        "A star with tips from 6 to 40 degrees, and a fan of segments that meet under 4 to 30 degrees.",
        "No mesh can do away with these angles: they are in the input.",
        "Markers: 1 outline, 2 fan, 3 hole.",
    )
    tips = [(6, 64), (40, 38), (10, 60), (26, 42), (14, 62), (33, 36), (8, 66), (22, 40), (16, 58), (18, 44), (12, 64), (29, 37)]

    def half_width(tip, reach, waist):
        """Half the angle, seen from the centre, that a tip takes on the circle of radius `waist`."""
        slope = math.radians(tip / 2)
        return math.degrees(math.asin(reach * math.sin(slope) / waist)) - tip / 2

    # The waist for which the tips fill the circle without gaps.
    lo, hi = 13.2, 36.0
    for _ in range(60):
        waist = (lo + hi) / 2
        wide = sum(2 * half_width(t, r, waist) for t, r in tips) > 360
        lo, hi = (waist, hi) if wide else (lo, waist)
    outline, turn = [], 90 - half_width(*tips[0], waist)
    for tip, reach in tips:
        half = half_width(tip, reach, waist)
        for r, a in ((waist, turn), (reach, turn + half)):
            outline.append((r * math.cos(math.radians(a)), r * math.sin(math.radians(a))))
        turn += 2 * half
    d.outer(outline, 1)
    a = 100.0
    for step in (0, 4, 7, 11, 16, 22, 30):
        a += step
        d.chain([(0, 3), (11 * math.cos(math.radians(a)), 3 + 11 * math.sin(math.radians(a)))], 2)
    d.hole(circle(2, -7, 3.5, 5, 90), 3, (2, -7))
    return d


def mesh_b(name="mesh-b", *notes):
    """A cam with four holes: as many points and holes as mesh B of the MeshSuite tables, but a drawing of our own."""
    d = Drawing(
        name,
        "A cam with four holes, in millimetres: 72 points, as many as mesh B of the published tables has.",
        *notes,
        "Markers: 1 outline, 2 round hole, 3 oval hole, 4 star-shaped hole, 5 slot with chamfers.",
    )
    dense = []
    for i in range(4001):
        a = 2 * math.pi * i / 4000
        r = 50 + 7 * math.cos(3 * a + 0.4) + 4 * math.sin(5 * a)
        dense.append((r * math.cos(a), r * math.sin(a)))
    around = sum(math.dist(p, q) for p, q in zip(dense, dense[1:]))
    d.outer(even(dense, around / 40)[:-1], 1)
    d.hole(circle(24, 14, 9, 8, 10), 2, (24, 14))
    d.hole(turned(arc(-22, 20, 11, 0, 360, 8, ry=6)[:-1], 25, -22, 20), 3, (-22, 20))
    star = [(9.5 if k % 2 == 0 else 5.2, 20 + 45 * k) for k in range(8)]
    d.hole([(-16 + r * math.cos(math.radians(a)), -20 + r * math.sin(math.radians(a))) for r, a in star], 4, (-16, -20))
    slot = [(-8, -4), (8, -4), (10, -2), (10, 2), (8, 4), (-8, 4), (-10, 2), (-10, -2)]
    d.hole(turned([(20 + x, -22 + y) for x, y in slot], 38, 20, -22), 5, (20, -22))
    return d


def mesh_b_points():
    """The same with points scattered inside."""
    d = mesh_b("mesh-b-points", "With 50 points scattered inside, marker 6.")
    scatter, at, room = random.Random(50), list(d.points), 1.25 * SCALE
    while len(d.points) < 72 + 50:
        p = (round(scatter.uniform(-60, 60) * SCALE), round(scatter.uniform(-60, 60) * SCALE))
        apart = all(math.dist(p, q) > room for q in d.points[72:])
        clear = all(distance(p, at[a], at[b]) > room for a, b, _ in d.segments)
        if apart and clear and sum(inside(p, ring) for ring, _ in d.rings) % 2 == 1:
            d.vertex((p[0] / SCALE, p[1] / SCALE), 6)
    return d


def main():
    folder = Path(__file__).resolve().parent
    for draw in (key, gear, guitar, coast, plate, star, mesh_b, mesh_b_points):
        d = draw()
        d.check()
        with open(folder / f"{d.name}.poly", "w", encoding="ascii", newline="\n") as out:
            out.write(d.text())
        print(f"{d.name}.poly: {len(d.points)} points, {len(d.segments)} segments, {len(d.seeds)} holes")


if __name__ == "__main__":
    main()
