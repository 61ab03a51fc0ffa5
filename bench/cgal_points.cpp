// Times CGAL's Delaunay_triangulation_2 on a point file: cgal_points FILE
//
// Prints wall seconds, processor seconds, vertices, triangles, peak bytes beyond those before the call.
// Timed: the range constructor on a vector of points in the caller's order. It sorts them itself, as CGAL's
// manual recommends.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

static std::vector<Kernel::Point_2> read_points(const char *path) {
    std::ifstream file(path, std::ios::binary);
    std::uint64_t n = 0;
    file.read(reinterpret_cast<char *>(&n), sizeof n);
    std::vector<Kernel::Point_2> points;
    points.reserve(n);
    double xy[2];
    while (points.size() < n && file.read(reinterpret_cast<char *>(xy), sizeof xy)) points.emplace_back(xy[0], xy[1]);
    return points;
}

static double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

static double cpu_seconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static long peak_bytes() {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1024 * usage.ru_maxrss;
}

int main(int argc, char **argv) {
    if (argc != 2) return std::fputs("usage: cgal_points FILE\n", stderr), 2;
    const auto points = read_points(argv[1]);
    const long peak = peak_bytes();
    const double wall = wall_seconds(), cpu = cpu_seconds();
    const Triangulation t(points.begin(), points.end());
    const double cpu_used = cpu_seconds() - cpu, wall_used = wall_seconds() - wall;
    std::printf("%.9f %.9f %zu %zu %ld\n", wall_used, cpu_used, std::size_t(t.number_of_vertices()),
                std::size_t(t.number_of_faces()), peak_bytes() - peak);
}
