// Times CGAL: cgal_driver PROGRAM TASK FILE ANGLE AREA SIZE
//
// points: the range insertion, which sorts the points itself as the manual recommends; constrained: the insertion of points
// and index pairs; polygon: the same, then the faces that the outside does not reach; refine: Delaunay_mesher_2 with the
// bound sin(ANGLE)^2 on shape and SIZE on edges (0: none).
#include "drawing.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::No_constraint_intersection_tag>;
using MeshStructure =
    CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>, CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Mesh = CGAL::Constrained_Delaunay_triangulation_2<Kernel, MeshStructure>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Mesh>;
using Ends = std::vector<std::pair<std::size_t, std::size_t>>;

// Marks what the outside reaches without crossing a constraint, and counts the other triangles.
static long mark_inside(Mesh &t) {
    long inside = 0;
    for (auto f : t.all_face_handles()) f->set_in_domain(true);
    std::vector<Mesh::Face_handle> next{t.infinite_face()};
    t.infinite_face()->set_in_domain(false);
    while (!next.empty()) {
        auto f = next.back();
        next.pop_back();
        for (int i = 0; i < 3; ++i) {
            auto g = f->neighbor(i);
            if (!g->is_in_domain() || t.is_constrained({f, i})) continue;
            g->set_in_domain(false);
            next.push_back(g);
        }
    }
    for (auto f : t.finite_face_handles()) inside += f->is_in_domain();
    return inside;
}

int main(int argc, char **argv) {
    if (argc != 7) return std::fputs("usage: cgal_driver PROGRAM TASK FILE ANGLE AREA SIZE\n", stderr), 2;
    const std::string task = argv[2];
    drawing d = read_drawing(argv[3]);
    std::vector<Point> points;
    points.reserve(d.points);
    for (std::uint64_t i = 0; i < d.points; ++i) points.emplace_back(d.xy[2 * i], d.xy[2 * i + 1]);
    Ends ends;
    for (std::uint64_t i = 0; i < d.segments; ++i) ends.emplace_back(d.ends[2 * i], d.ends[2 * i + 1]);
    std::vector<Point> seeds;
    for (std::uint64_t i = 0; i < d.holes; ++i) seeds.emplace_back(d.seeds[2 * i], d.seeds[2 * i + 1]);
    std::free(d.xy);

    reading r = start();
    if (task == "points") {
        Delaunay t;
        t.insert(points.begin(), points.end());
        print_reading(stop(r), t.number_of_vertices(), t.number_of_faces());
    } else if (task == "constrained") {
        Constrained t;
        t.insert_constraints(points.begin(), points.end(), ends.begin(), ends.end());
        print_reading(stop(r), t.number_of_vertices(), t.number_of_faces());
    } else if (task == "polygon") {
        Mesh t;
        t.insert_constraints(points.begin(), points.end(), ends.begin(), ends.end());
        const long inside = mark_inside(t);
        print_reading(stop(r), t.number_of_vertices(), inside);
    } else {
        const double sine = std::sin(std::atof(argv[4]) * 3.14159265358979323846 / 180);
        Mesh t;
        t.insert_constraints(points.begin(), points.end(), ends.begin(), ends.end());
        CGAL::Delaunay_mesher_2<Mesh, Criteria> mesher(t, Criteria(sine * sine, std::atof(argv[6])));
        mesher.set_seeds(seeds.begin(), seeds.end(), false);
        mesher.refine_mesh();
        r = stop(r);
        long inside = 0;
        for (auto f : t.finite_face_handles()) inside += f->is_in_domain();
        print_reading(r, t.number_of_vertices(), inside);
    }
}
