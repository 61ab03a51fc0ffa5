/* A program written for Triangle's library: a mesh made, made finer, and its Voronoi diagram; every result checked.
 * Compiled with "triangle.h", which is Triangle's own header where that is there, else triangle_compat.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define REAL double
#define VOID void
#define ANSI_DECLARATORS
#include "triangle.h"
#include "check.h"

const char *triangulate_error(void);

static double XY[] = {0, 0, 4, 0, 4, 3, 0, 3, 1, 1, 2, 1, 2, 2, 1, 2};
static double ATTRIBUTES[] = {0, 4, 7, 3, 2, 3, 4, 3}; /* x + y */
static int ENDS[] = {1, 2, 2, 3, 3, 4, 4, 1, 5, 6, 6, 7, 7, 8, 8, 5};
static int MARKERS[] = {5, 0, 0, 0, 0, 0, 0, 0};
static double HOLE[] = {1.5, 1.5};
static double REGION[] = {0.5, 0.5, 7.0, 0.1};

static struct triangulateio plate(void) {
    struct triangulateio in;
    memset(&in, 0, sizeof in);
    in.pointlist = XY, in.numberofpoints = 8;
    in.pointattributelist = ATTRIBUTES, in.numberofpointattributes = 1;
    in.segmentlist = ENDS, in.segmentmarkerlist = MARKERS, in.numberofsegments = 8;
    in.holelist = HOLE, in.numberofholes = 1;
    in.regionlist = REGION, in.numberofregions = 1;
    return in;
}

/* Checks triangles, edges and neighbours; the areas must sum to that of the plate without its hole. */
static void check(const struct triangulateio *mesh, int first, double min_angle, double max_area) {
    double sum = 0;
    int boundary = 0;
    for (int t = 0; t < mesh->numberoftriangles; t++) {
        const int *nodes = mesh->trianglelist + t * mesh->numberofcorners;
        const double *p[3];
        for (int i = 0; i < mesh->numberofcorners; i++)
            CHECK(nodes[i] >= first && nodes[i] < mesh->numberofpoints + first);
        for (int i = 0; i < 3; i++) p[i] = mesh->pointlist + 2 * (nodes[i] - first);
        double twice = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
        CHECK(twice > 0 && twice / 2 <= max_area);
        sum += twice / 2;
        for (int i = 0; i < 3; i++) {
            const double *a = p[i], *b = p[(i + 1) % 3], *c = p[(i + 2) % 3];
            double angle = atan2(twice, (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]));
            CHECK(angle * 180 / acos(-1) > min_angle - 1e-9);
            int beyond = mesh->neighborlist[3 * t + i];
            CHECK(beyond == -1 || (beyond >= first && beyond < mesh->numberoftriangles + first));
            boundary += beyond == -1;
            if (mesh->numberofcorners == 6) {
                const double *middle = mesh->pointlist + 2 * (nodes[3 + i] - first);
                CHECK(fabs(middle[0] - (b[0] + c[0]) / 2) < 1e-12 && fabs(middle[1] - (b[1] + c[1]) / 2) < 1e-12);
            }
        }
    }
    CHECK(fabs(sum - 11) < 1e-9);
    CHECK(2 * mesh->numberofedges == 3 * mesh->numberoftriangles + boundary);
    CHECK(mesh->numberofsegments == boundary);
    for (int v = 0; v < mesh->numberofpoints; v++) {
        const double *at = mesh->pointlist + 2 * v;
        CHECK(fabs(mesh->pointattributelist[v] - (at[0] + at[1])) < 1e-9);
        if (at[1] == 0 && at[0] > 0 && at[0] < 4) CHECK(mesh->pointmarkerlist[v] == 5);
    }
    for (int e = 0; e < mesh->numberofedges; e++) CHECK(mesh->edgemarkerlist[e] >= 0);
}

static void release(struct triangulateio *io) {
    free(io->pointlist), free(io->pointattributelist), free(io->pointmarkerlist);
    free(io->trianglelist), free(io->triangleattributelist), free(io->trianglearealist), free(io->neighborlist);
    free(io->segmentlist), free(io->segmentmarkerlist);
    free(io->edgelist), free(io->edgemarkerlist), trifree(io->normlist);
}

static void a_mesh_is_made_and_made_finer(void) {
    struct triangulateio in = plate(), made, finer;
    memset(&made, 0, sizeof made), memset(&finer, 0, sizeof finer);
    triangulate("pq30aAenQ", &in, &made, NULL);
    CHECK(triangulate_error() == NULL && made.numberofcorners == 3 && made.numberofholes == 1);
    check(&made, 1, 30, 0.1);
    CHECK(memcmp(made.pointlist, XY, sizeof XY) == 0 && made.numberoftriangleattributes == 1);
    for (int t = 0; t < made.numberoftriangles; t++) CHECK(made.triangleattributelist[t] == 7.0);
    made.trianglearealist = malloc(made.numberoftriangles * sizeof *made.trianglearealist);
    for (int t = 0; t < made.numberoftriangles; t++) made.trianglearealist[t] = t % 2 ? -1 : 0.03;
    triangulate("prq30a0.05aenQo2", &made, &finer, NULL);
    CHECK(triangulate_error() == NULL && finer.numberofcorners == 6);
    check(&finer, 1, 30, 0.05);
    CHECK(finer.numberoftriangles > made.numberoftriangles);
    CHECK(memcmp(finer.pointlist, made.pointlist, 2 * made.numberofpoints * sizeof(double)) == 0);
    release(&made), release(&finer);
}

static void points_have_a_voronoi_diagram(void) {
    struct triangulateio in, out, voronoi;
    memset(&in, 0, sizeof in), memset(&out, 0, sizeof out), memset(&voronoi, 0, sizeof voronoi);
    in.pointlist = XY, in.numberofpoints = 8;
    triangulate("zevQ", &in, &out, &voronoi);
    CHECK(out.numberofpoints == 8 && out.numberofsegments == 0 && out.segmentlist == NULL);
    CHECK(voronoi.numberofpoints == out.numberoftriangles && voronoi.numberofedges == out.numberofedges);
    int rays = 0;
    for (int e = 0; e < voronoi.numberofedges; e++) {
        const int *ends = voronoi.edgelist + 2 * e;
        CHECK(ends[0] >= 0 && ends[0] < voronoi.numberofpoints && ends[1] < voronoi.numberofpoints);
        const double *direction = voronoi.normlist + 2 * e;
        CHECK((ends[1] == -1) == (direction[0] != 0 || direction[1] != 0));
        rays += ends[1] == -1;
    }
    CHECK(rays == 4);
    release(&out), release(&voronoi);
}

static void bad_input_returns(void) {
    struct triangulateio in = plate(), out;
    int ends[sizeof ENDS / sizeof *ENDS];
    double xy[sizeof XY / sizeof *XY];
    char *refused[] = {"pu", "pW", "q99", "ra", "v", "pa0"};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        memset(&out, 0, sizeof out);
        triangulate(refused[i], &in, &out, NULL);
        CHECK(triangulate_error() && out.numberofpoints == 0 && out.pointlist == NULL);
    }
    memcpy(ends, ENDS, sizeof ENDS), memcpy(xy, XY, sizeof XY);
    in.segmentlist = ends, in.pointlist = xy;
    ends[3] = 9;
    triangulate("pQ", &in, &out, NULL);
    CHECK(strstr(triangulate_error(), "segment 2 names point 9, not between 1 and 8"));
    ends[3] = 3, xy[5] = NAN;
    triangulate("pQ", &in, &out, NULL);
    CHECK(strstr(triangulate_error(), "not finite") && out.numberoftriangles == 0);
    xy[5] = 3, in.numberofpoints = -8;
    triangulate("pQ", &in, &out, NULL);
    CHECK(triangulate_error());
    in.numberofpoints = 8, in.numberofsegments = 3; /* an open outline */
    triangulate("pQ", &in, &out, NULL);
    CHECK(triangulate_error());
    triangulate("pQ", NULL, &out, NULL);
    CHECK(triangulate_error());
    in = plate();
    triangulate("pQ", &in, &out, NULL);
    CHECK(triangulate_error() == NULL && out.numberoftriangles == 16 - 8);
    release(&out);
}

int main(void) {
    a_mesh_is_made_and_made_finer();
    points_have_a_voronoi_diagram();
    bad_input_returns();
    return 0;
}
