//! Vertices of no triangle left out.

use trimalla::IndexedMesh;

/// The mesh without the vertices that no triangle has, in the order of those that stay.
pub(crate) fn jettisoned(mut mesh: IndexedMesh) -> IndexedMesh {
    const UNUSED: u32 = u32::MAX;
    let mut number = vec![UNUSED; mesh.points.len()];
    mesh.triangles.iter().flatten().for_each(|&v| number[v as usize] = 0);
    let used = number.iter_mut().filter(|slot| **slot != UNUSED);
    (0..).zip(used).for_each(|(next, slot)| *slot = next);
    let is_kept = |v: usize| number[v] != UNUSED;
    let kept = |column: &mut Vec<i32>| {
        let mut vertex = 0..;
        column.retain(|_| vertex.next().is_some_and(is_kept));
    };
    kept(&mut mesh.point_markers);
    if mesh.attributes_per_point > 0 {
        let rows = mesh.point_attributes.chunks(mesh.attributes_per_point).enumerate();
        mesh.point_attributes = rows.filter(|&(v, _)| is_kept(v)).flat_map(|(_, row)| row.iter().copied()).collect();
    }
    mesh.input_points = (0..mesh.input_points.min(mesh.points.len())).filter(|&v| is_kept(v)).count();
    let mut vertex = 0..;
    mesh.points.retain(|_| vertex.next().is_some_and(is_kept));
    mesh.triangles.iter_mut().flatten().for_each(|v| *v = number[*v as usize]);
    let has_ends: Vec<bool> = mesh.segments.iter().map(|ends| ends.iter().all(|&v| is_kept(v as usize))).collect();
    let mut segment = has_ends.iter();
    mesh.segment_markers.retain(|_| segment.next().is_some_and(|&has_ends| has_ends));
    let mut segment = has_ends.iter();
    mesh.segments.retain(|_| segment.next().is_some_and(|&has_ends| has_ends));
    mesh.segments.iter_mut().flatten().for_each(|v| *v = number[*v as usize]);
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use trimalla::geometry::Point;

    #[test]
    fn what_stays_keeps_its_order_and_columns() {
        let mesh = IndexedMesh {
            points: [[9.0, 9.0], [0.0, 0.0], [1.0, 0.0], [8.0, 8.0], [0.0, 1.0]].map(Point::from).to_vec(),
            triangles: vec![[1, 2, 4]],
            point_markers: vec![1, 2, 3, 4, 5],
            attributes_per_point: 2,
            point_attributes: (0..10).map(f64::from).collect(),
            segments: vec![[0, 1], [1, 2]],
            segment_markers: vec![6, 7],
            input_points: 4,
            ..IndexedMesh::default()
        };
        let left = jettisoned(mesh);
        assert_eq!(left.points, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from));
        assert_eq!((left.triangles, left.point_markers), (vec![[0, 1, 2]], vec![2, 3, 5]));
        assert_eq!(left.point_attributes, [2.0, 3.0, 4.0, 5.0, 8.0, 9.0]);
        assert_eq!((left.segments, left.segment_markers, left.input_points), (vec![[0, 1]], vec![7], 2));
    }
}
