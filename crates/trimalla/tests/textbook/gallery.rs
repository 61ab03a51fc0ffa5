//! Visibility against brute force in rationals; colours and guards.

use std::collections::BTreeSet;

use dashu_ratio::RBig;
use trimalla::Point;
use trimalla::geometry::{Containment, Ring};
use trimalla::polygon::{Gallery, SeenCorner, Visibility, art_gallery, visible};
use trimalla::trace::{Act, NoTrace, Shape, Step};
use trimalla_testkit::generators::SplitMix64;

use crate::random_rings::{GENERATORS, Rings, touching};
use crate::seidel::faulty;

type Exact = [RBig; 2];

fn exact(p: Point) -> Exact {
    [p.x, p.y].map(|v| RBig::try_from(v).expect("finite"))
}

fn minus(p: &Exact, q: &Exact) -> Exact {
    [&p[0] - &q[0], &p[1] - &q[1]]
}

fn cross(u: &Exact, v: &Exact) -> RBig {
    &u[0] * &v[1] - &u[1] * &v[0]
}

fn dot(u: &Exact, v: &Exact) -> RBig {
    &u[0] * &v[0] + &u[1] * &v[1]
}

fn along(p: &Exact, direction: &Exact, t: &RBig) -> Exact {
    [&p[0] + &direction[0] * t, &p[1] + &direction[1] * t]
}

/// The sides of all rings.
fn sides(rings: &Rings) -> Vec<[Exact; 2]> {
    let polygon = rings.polygon();
    let of_ring = |ring| Ring::sides(polygon.ring(ring)).map(|(a, b)| [exact(a), exact(b)]).collect::<Vec<_>>();
    polygon.rings().flat_map(of_ring).filter(|[a, b]| a != b).collect()
}

/// Whether a point is inside an odd number of rings, or on one: for rings that do not cross that is the polygon.
fn place(sides: &[[Exact; 2]], p: &Exact) -> Containment {
    let mut is_inside = false;
    for [a, b] in sides {
        let (low, high) = if a[1] <= b[1] { (a, b) } else { (b, a) };
        let turn = cross(&minus(high, low), &minus(p, low));
        let is_between = dot(&minus(a, p), &minus(b, p)) <= RBig::ZERO;
        if turn == RBig::ZERO && is_between {
            return Containment::On;
        }
        is_inside ^= low[1] <= p[1] && p[1] < high[1] && turn > RBig::ZERO;
    }
    if is_inside { Containment::Inside } else { Containment::Outside }
}

/// Where the ray from `p` meets sides, as multiples of its direction; sides along the ray give their ends.
fn meetings(sides: &[[Exact; 2]], p: &Exact, direction: &Exact) -> Vec<RBig> {
    let mut found = Vec::new();
    for [a, b] in sides {
        let (from, side) = (minus(a, p), minus(b, a));
        let det = cross(direction, &side);
        if det == RBig::ZERO {
            if cross(direction, &from) == RBig::ZERO {
                found.extend([a, b].map(|q| dot(&minus(q, p), direction) / dot(direction, direction)));
            }
        } else {
            let s = cross(&from, direction) / &det;
            if s >= RBig::ZERO && s <= RBig::ONE {
                found.push(cross(&from, &side) / det);
            }
        }
    }
    found.sort();
    found
}

/// Whether no point of a segment is outside: every point at which something may change, and one between each two.
fn sees(sides: &[[Exact; 2]], x: &Exact, y: &Exact) -> bool {
    let direction = minus(y, x);
    let mut cuts: Vec<RBig> = vec![RBig::ZERO];
    if x != y {
        cuts.extend(meetings(sides, x, &direction).into_iter().filter(|t| *t > RBig::ZERO && *t < RBig::ONE));
        cuts.push(RBig::ONE);
    }
    let half = RBig::from_parts(1.into(), 2_u8.into());
    let middles: Vec<RBig> = cuts.windows(2).map(|w| (&w[0] + &w[1]) * &half).collect();
    cuts.iter().chain(&middles).all(|t| place(sides, &along(x, &direction, t)) != Containment::Outside)
}

fn any_polygon(round: usize, size: usize, rng: &mut SplitMix64) -> Rings {
    match round % 14 {
        k @ 0..9 => GENERATORS[k].1(3 + rng.below(size), rng),
        _ => touching(rng),
    }
}

/// A point that is likely to be in a polygon: at a vertex, on a side, inside a triangle, anywhere.
fn some_point(rings: &Rings, rng: &mut SplitMix64) -> Point {
    let n = rings.points.len();
    let [a, b, c] = [(); 3].map(|()| rings.points[rng.below(n)]);
    let next = rng.below(n - 1);
    match rng.below(4) {
        0 => a,
        1 => Point::midpoint(rings.points[next], rings.points[next + 1]),
        2 => Point::midpoint(a, b),
        _ => Point::midpoint(Point::midpoint(a, b), c),
    }
}

#[test]
fn points_see_each_other_as_in_rationals() {
    let mut rng = SplitMix64::new(41);
    let mut seen = 0;
    for round in 0..280 {
        let rings = any_polygon(round, 25, &mut rng);
        let sides = sides(&rings);
        for _ in 0..25 {
            let (x, y) = (some_point(&rings, &mut rng), some_point(&rings, &mut rng));
            let expected = sees(&sides, &exact(x), &exact(y));
            assert_eq!(visible(rings.polygon(), x, y), expected, "{x} {y} in {rings:?}");
            assert_eq!(visible(rings.polygon(), y, x), expected, "{y} {x} in {rings:?}");
            seen += usize::from(expected);
        }
    }
    assert!(seen > 1000, "{seen}");
}

#[test]
fn touching_the_boundary_does_not_interrupt() {
    let at = Point::new;
    let notched = Rings::of([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)]);
    let sees = |x, y| visible(notched.polygon(), x, y);
    assert!(sees(at(0.0, 1.0), at(4.0, 1.0)), "past a vertex");
    assert!(sees(at(0.0, 0.0), at(4.0, 0.0)), "along a side");
    assert!(sees(at(2.0, 1.0), at(2.0, 1.0)), "itself");
    assert!(!sees(at(2.0, 2.0), at(2.0, 2.0)), "a point outside");
    assert!(!sees(at(0.0, 2.0), at(4.0, 2.0)));
    assert!(!sees(at(f64::NAN, 2.0), at(4.0, 2.0)));
    let mut pinched = Rings::of([(0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0)]);
    pinched.add([(4.0, 0.0), (5.0, 4.0), (4.0, 4.0)]);
    pinched.add([(4.0, 4.0), (4.0, 8.0), (3.0, 5.0)]);
    let sees = |x, y| visible(pinched.polygon(), x, y);
    assert!(sees(at(2.0, 2.0), at(6.0, 6.0)), "through a vertex in which two holes touch");
    assert!(!sees(at(2.0, 2.1), at(6.0, 6.0)));
    assert!(sees(at(4.0, 0.0), at(4.0, 8.0)), "along the sides of two holes");
    let arms = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (5.0, 6.0), (3.0, 4.0), (5.0, 3.0), (5.0, 1.0)];
    let arms = Rings::of(arms.into_iter().chain([(1.0, 1.0), (1.0, 3.0), (4.0, 5.0), (0.0, 6.0)]));
    assert!(visible(arms.polygon(), at(5.0, 5.0), at(3.0, 5.0)), "across a side, where a vertex touches it");
    assert!(!visible(arms.polygon(), at(5.0, 4.9), at(3.0, 4.9)), "beside the vertex");
    let outside = Rings::default();
    assert!(!visible(outside.polygon(), at(0.0, 0.0), at(0.0, 0.0)));
}

/// Twice the area that is seen: for each two successive directions of vertices, the triangle up to the nearest side.
fn doubled_area_seen(rings: &Rings, x: Point) -> RBig {
    let (sides, x) = (sides(rings), exact(x));
    let mut directions: Vec<Exact> = rings.points.iter().map(|&p| minus(&exact(p), &x)).collect();
    directions.retain(|d| *d != [RBig::ZERO, RBig::ZERO]);
    directions.extend([[1, 0], [0, 1], [-1, 0], [0, -1]].map(|d: [i32; 2]| d.map(RBig::from)));
    let half = |d: &Exact| d[1] < RBig::ZERO || (d[1] == RBig::ZERO && d[0] < RBig::ZERO);
    directions.sort_by(|u, v| half(u).cmp(&half(v)).then_with(|| RBig::ZERO.cmp(&cross(u, v))));
    let mut sum = RBig::ZERO;
    for k in 0..directions.len() {
        let (u, v) = (&directions[k], &directions[(k + 1) % directions.len()]);
        if cross(u, v) == RBig::ZERO {
            continue;
        }
        let middle = [&u[0] + &v[0], &u[1] + &v[1]];
        let Some(nearest) = meetings(&sides, &x, &middle).into_iter().find(|t| *t > RBig::ZERO) else { continue };
        let half = RBig::from_parts(1.into(), 2_u8.into());
        if place(&sides, &along(&x, &middle, &(&nearest * half))) == Containment::Outside {
            continue;
        }
        // The side that is met there crosses the whole wedge.
        let hit = along(&x, &middle, &nearest);
        let side = sides.iter().find(|[a, b]| {
            cross(&minus(b, a), &minus(&hit, a)) == RBig::ZERO && dot(&minus(a, &hit), &minus(b, &hit)) <= RBig::ZERO
        });
        let [a, b] = side.expect("the side that is met");
        let reach = |d: &Exact| along(&x, d, &(cross(&minus(a, &x), &minus(b, a)) / cross(d, &minus(b, a))));
        sum += cross(&minus(&reach(u), &x), &minus(&reach(v), &x));
    }
    sum
}

/// Twice the area of a visibility polygon, its corners computed in rationals.
fn doubled_area_of(corners: &[SeenCorner], rings: &Rings, x: Point) -> RBig {
    let from = exact(x);
    let corner = |c: &SeenCorner| match *c {
        SeenCorner::OnSide { side, past, .. } => {
            let [a, b] = side.map(|v| exact(rings.points[v as usize]));
            let direction = minus(&exact(rings.points[past as usize]), &from);
            let t = cross(&minus(&a, &from), &minus(&b, &a)) / cross(&direction, &minus(&b, &a));
            assert!(t > RBig::ONE, "a corner before the vertex past which it is seen");
            let corner = along(&from, &direction, &t);
            assert!(dot(&minus(&a, &corner), &minus(&b, &corner)) < RBig::ZERO, "a corner not inside its side");
            corner
        }
        SeenCorner::Vertex { vertex, at } => {
            assert_eq!(at, rings.points[vertex as usize]);
            exact(at)
        }
        SeenCorner::Viewpoint(at) => {
            assert_eq!(at, x);
            exact(at)
        }
    };
    let corners: Vec<Exact> = corners.iter().map(corner).collect();
    let n = corners.len();
    let mut sum = RBig::ZERO;
    for k in 0..n {
        let (u, v) = (minus(&corners[k], &from), minus(&corners[(k + 1) % n], &from));
        assert!(cross(&u, &v) >= RBig::ZERO, "clockwise: {x} in {rings:?}");
        sum += cross(&u, &v);
    }
    sum
}

#[test]
fn visibility_polygons_have_the_area_of_brute_force() {
    let mut rng = SplitMix64::new(43);
    let mut shadows = 0;
    for round in 0..280 {
        let rings = any_polygon(round, 20, &mut rng);
        let visibility = Visibility::new(rings.polygon(), &mut NoTrace).expect("a valid polygon");
        for _ in 0..6 {
            let x = some_point(&rings, &mut rng);
            let corners = visibility.seen_from(x, &mut NoTrace).expect("nobody cancels");
            if place(&sides(&rings), &exact(x)) == Containment::Outside {
                assert_eq!(corners, []);
                continue;
            }
            assert_eq!(doubled_area_of(&corners, &rings, x), doubled_area_seen(&rings, x), "{x} in {rings:?}");
            for corner in corners {
                let vertex = match corner {
                    SeenCorner::OnSide { past, .. } => rings.points[past as usize],
                    other => other.at(),
                };
                assert!(visible(rings.polygon(), x, vertex), "{x} {corner:?} in {rings:?}");
                shadows += usize::from(matches!(corner, SeenCorner::OnSide { .. }));
            }
        }
    }
    assert!(shadows > 500, "{shadows}");
}

#[test]
fn coordinates_of_any_size_do_not_change_what_is_seen() {
    let mut rng = SplitMix64::new(47);
    for _ in 0..20 {
        let rings = GENERATORS[8].1(30, &mut rng);
        let x = Point::midpoint(rings.points[0], rings.points[4]);
        let corners = |rings: &Rings, x| {
            let visibility = Visibility::new(rings.polygon(), &mut NoTrace).expect("a valid polygon");
            visibility.seen_from(x, &mut NoTrace).expect("nobody cancels")
        };
        let plain = corners(&rings, x);
        for factor in [2.0_f64.powi(1000), 2.0_f64.powi(-900)] {
            let scaled = |p: Point| Point::new(p.x * factor, p.y * factor);
            let found = corners(&rings.mapped(scaled), scaled(x));
            assert_eq!(found.len(), plain.len());
            for (one, other) in found.iter().zip(&plain) {
                assert!(one.at().is_finite());
                assert_eq!(one.at(), scaled(other.at()));
            }
        }
    }
}

fn check(gallery: &Gallery, rings: &Rings) {
    assert_eq!(gallery.unwatched(), None, "{rings:?}");
    assert_eq!(gallery.colours.len(), gallery.triangles.len());
    assert!(gallery.guards.len() <= gallery.limit, "{rings:?}");
    assert!(gallery.guards.is_sorted_by(|a, b| a < b));
    let bridges: BTreeSet<[u32; 2]> = gallery.bridges.iter().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
    let mut colours_of = std::collections::BTreeMap::new();
    for (t, colours) in gallery.triangles.iter().zip(&gallery.colours) {
        let mut all = *colours;
        all.sort_unstable();
        assert_eq!(all, [0, 1, 2]);
        for k in 0..3 {
            let next = (k + 1) % 3;
            colours_of.insert([t[k], t[next]], [colours[k], colours[next]]);
        }
    }
    for ([a, b], [one, two]) in &colours_of {
        if let Some(behind) = colours_of.get(&[*b, *a]).filter(|_| !bridges.contains(&[*a, *b])) {
            assert_eq!(behind, &[*two, *one], "{rings:?}");
        }
    }
}

#[test]
fn guards_see_all_and_are_few() {
    let mut rng = SplitMix64::new(53);
    for round in 0..400 {
        let rings = any_polygon(round, 60, &mut rng);
        let gallery = art_gallery(rings.polygon(), &mut NoTrace).expect("a valid polygon");
        check(&gallery, &rings);
        if round % 14 < 9 {
            let (n, holes) = (rings.points.len(), rings.ends.len() - 1);
            assert_eq!(gallery.limit, (n + 2 * holes) / 3);
            assert_eq!(gallery.bridges.len(), holes);
        }
        // Some point of each triangle is seen by a guard, by the test of visibility.
        for t in gallery.triangles.iter().take(20) {
            let [a, b, c] = t.map(|v| rings.points[v as usize]);
            let inside = Point::midpoint(Point::midpoint(a, b), c);
            if place(&sides(&rings), &exact(inside)) == Containment::Inside {
                let is_seen = |&guard: &u32| visible(rings.polygon(), rings.points[guard as usize], inside);
                assert!(gallery.guards.iter().any(is_seen), "{inside} in {rings:?}");
            }
        }
    }
}

#[test]
fn a_comb_needs_a_third_of_its_corners() {
    // Each tooth of Chvátal's comb has a tip that no guard of another tooth sees.
    for teeth in 1..20 {
        let mut ring = vec![];
        for i in 0..teeth {
            let x = 3.0 * f64::from(i);
            ring.extend([(x, 0.0), (x + 1.0, -9.0), (x + 2.0, 0.0)]);
        }
        let (first, last) = (ring.remove(0), ring.pop().expect("a corner"));
        ring.insert(0, (first.0, 1.0));
        ring.push((last.0, 1.0));
        let rings = Rings::of(ring);
        let gallery = art_gallery(rings.polygon(), &mut NoTrace).expect("a valid polygon");
        check(&gallery, &rings);
        assert!(gallery.guards.len() <= teeth as usize);
    }
}

#[test]
fn faulty_polygons_have_no_guards_and_steps_are_told() {
    for rings in faulty() {
        assert!(art_gallery(rings.polygon(), &mut NoTrace).is_err());
        assert!(Visibility::new(rings.polygon(), &mut NoTrace).is_err());
    }
    let square = Rings::of([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let mut steps: Vec<Step> = Vec::new();
    let gallery = art_gallery(square.polygon(), &mut steps).expect("a valid polygon");
    assert_eq!(gallery.guards.len(), 1);
    let guard = Step { act: Act::Add, shape: Shape::Vertex(gallery.guards[0]), note: "a guard" };
    assert_eq!(steps.last(), Some(&guard));
    let empty = art_gallery(Rings::default().polygon(), &mut NoTrace);
    assert_eq!(empty, Ok(Gallery::default()));
    let odd = Gallery::of_triangles(vec![[0, 1, 2], [0, 1, 2], [1, 0, 0]], &mut NoTrace).expect("nobody cancels");
    assert_eq!(odd.unwatched(), None);
}

#[test]
fn rings_that_touch_themselves_anyhow_are_looked_at_and_guarded() {
    let mut rng = SplitMix64::new(59);
    let mut valid = 0;
    for _ in 0..6000 {
        let (size, grid) = (5 + rng.below(6), 3 + rng.below(3));
        let rings = Rings::of((0..size).map(|_| (rng.below(grid) as f64, rng.below(grid) as f64)));
        let Ok(visibility) = Visibility::new(rings.polygon(), &mut NoTrace) else { continue };
        valid += 1;
        check(&art_gallery(rings.polygon(), &mut NoTrace).expect("a valid polygon"), &rings);
        let sides = sides(&rings);
        let (x, y) = (some_point(&rings, &mut rng), some_point(&rings, &mut rng));
        assert_eq!(visible(rings.polygon(), x, y), sees(&sides, &exact(x), &exact(y)), "{x} {y} in {rings:?}");
        if place(&sides, &exact(x)) != Containment::Outside {
            let corners = visibility.seen_from(x, &mut NoTrace).expect("nobody cancels");
            assert_eq!(doubled_area_of(&corners, &rings, x), doubled_area_seen(&rings, x), "{x} in {rings:?}");
        }
    }
    assert!(valid > 300, "{valid}");
}
