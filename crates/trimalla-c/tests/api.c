/* trimalla.h from outside: a mesh and its arrays, bad input, options, cancelling. Prints nothing where all is well. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <trimalla.h>

#include "check.h"

static const double XY[] = {0, 0, 4, 0, 4, 3, 0, 3, 1, 1, 2, 1, 2, 2, 1, 2};
static const uint32_t ENDS[] = {0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4};

static trimalla_drawing *plate(void) {
    trimalla_drawing *drawing = trimalla_drawing_new();
    const int32_t markers[] = {5, 6, 7, 8, 0, 0, 0, 0};
    trimalla_error error;
    CHECK(trimalla_add_points(drawing, XY, 8, NULL, &error) == TRIMALLA_OK && error.code == TRIMALLA_OK);
    CHECK(trimalla_add_segments(drawing, ENDS, 4, markers, NULL) == TRIMALLA_OK);
    CHECK(trimalla_add_segments(drawing, ENDS + 8, 4, NULL, NULL) == TRIMALLA_OK);
    CHECK(trimalla_add_hole(drawing, 1.5, 1.5, &error) == TRIMALLA_OK);
    CHECK(trimalla_add_region(drawing, 0.5, 0.5, 9.0, 0.05, &error) == TRIMALLA_OK);
    return drawing;
}

/* The sum of the areas of all triangles, each of which must be counter-clockwise and name points that are there. */
static double area(const trimalla_mesh *mesh) {
    const double *xy = trimalla_points(mesh);
    const uint32_t *corners = trimalla_triangles(mesh);
    double sum = 0;
    for (size_t t = 0; t < trimalla_triangle_count(mesh); t++, corners += 3) {
        for (int i = 0; i < 3; i++) CHECK(corners[i] < trimalla_point_count(mesh));
        const double *a = xy + 2 * corners[0], *b = xy + 2 * corners[1], *c = xy + 2 * corners[2];
        double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        CHECK(twice > 0);
        sum += twice / 2;
    }
    return sum;
}

static void a_mesh_has_arrays(void) {
    trimalla_drawing *drawing = plate();
    double attributes[8];
    trimalla_mesh *mesh;
    trimalla_report_data report;
    trimalla_error error;
    for (int i = 0; i < 8; i++) attributes[i] = 3 * XY[2 * i] - XY[2 * i + 1];
    CHECK(trimalla_set_attributes(drawing, attributes, 1, &error) == TRIMALLA_OK);
    CHECK(trimalla_mesh_drawing(drawing, NULL, NULL, &mesh, &error) == TRIMALLA_OK);
    CHECK(fabs(area(mesh) - 11) < 1e-12);
    CHECK(trimalla_input_point_count(mesh) == 8 && memcmp(trimalla_points(mesh), XY, sizeof XY) == 0);
    trimalla_report(mesh, &report);
    CHECK(report.complete && report.min_angle >= 30 && report.below_bound == 0);
    CHECK(report.points_added + 8 == trimalla_point_count(mesh));
    CHECK(trimalla_triangle_count(mesh) >= 220); /* the region's bound on areas */
    CHECK(trimalla_attributes_per_triangle(mesh) == 1 && trimalla_triangle_attributes(mesh)[0] == 9.0);
    CHECK(trimalla_attributes_per_point(mesh) == 1);
    for (size_t p = 0; p < trimalla_point_count(mesh); p++) {
        const double *at = trimalla_points(mesh) + 2 * p;
        CHECK(fabs(trimalla_point_attributes(mesh)[p] - (3 * at[0] - at[1])) < 1e-9);
    }
    /* Euler: one hole. Each edge inside has two triangles, each on the boundary one. */
    size_t boundary = 0;
    for (size_t i = 0; i < 3 * trimalla_triangle_count(mesh); i++) boundary += trimalla_neighbours(mesh)[i] < 0;
    CHECK(2 * trimalla_edge_count(mesh) == 3 * trimalla_triangle_count(mesh) + boundary);
    CHECK(trimalla_point_count(mesh) + trimalla_triangle_count(mesh) == trimalla_edge_count(mesh));
    CHECK(trimalla_segment_count(mesh) == boundary);
    for (size_t s = 0; s < trimalla_segment_count(mesh); s++) {
        const uint32_t *ends = trimalla_segments(mesh) + 2 * s;
        const double *a = trimalla_points(mesh) + 2 * ends[0], *b = trimalla_points(mesh) + 2 * ends[1];
        if (a[1] == 0 && b[1] == 0) CHECK(trimalla_segment_markers(mesh)[s] == 5);
    }
    trimalla_mesh_free(mesh);
    trimalla_drawing_free(drawing);
}

static void options_have_keys(void) {
    trimalla_drawing *drawing = plate();
    trimalla_options *options = trimalla_options_new();
    trimalla_mesh *mesh;
    trimalla_report_data report;
    trimalla_error error;
    CHECK(trimalla_set_number(options, "min-angle", 33, &error) == TRIMALLA_OK);
    CHECK(trimalla_set_option(options, "algorithm", "lepp-centroid", &error) == TRIMALLA_OK);
    CHECK(trimalla_set_option(options, "domain", "nesting", &error) == TRIMALLA_OK);
    CHECK(trimalla_mesh_drawing(drawing, options, NULL, &mesh, &error) == TRIMALLA_OK);
    trimalla_report(mesh, &report);
    CHECK(report.min_angle >= 33);
    trimalla_mesh_free(mesh);
    CHECK(trimalla_set_number(options, "min-angle", 61, &error) == TRIMALLA_BAD_OPTION);
    CHECK(trimalla_set_option(options, "algorithm", "magic", &error) == TRIMALLA_BAD_OPTION);
    CHECK(strstr(error.message, "off-center"));
    CHECK(trimalla_set_option(options, "no-such", "1", &error) == TRIMALLA_BAD_OPTION);
    CHECK(trimalla_triangulate(drawing, options, &mesh, &error) == TRIMALLA_OK);
    CHECK(trimalla_point_count(mesh) == 8 && trimalla_triangle_count(mesh) == 8);
    trimalla_mesh_free(mesh);
    trimalla_options_free(options);
    trimalla_drawing_free(drawing);
}

static void bad_input_returns(void) {
    trimalla_drawing *drawing = plate();
    const double more[] = {NAN, 1, 7, 7};
    const uint32_t crossing[] = {0, 2}, missing[] = {0, 99};
    trimalla_mesh *mesh = (trimalla_mesh *)1;
    trimalla_error error;
    CHECK(trimalla_add_segments(drawing, crossing, 1, NULL, &error) == TRIMALLA_OK);
    CHECK(trimalla_mesh_drawing(drawing, NULL, NULL, &mesh, &error) == TRIMALLA_BAD_DRAWING && mesh == NULL);
    CHECK(error.index >= 0 && error.x > 0 && error.y > 0 && strstr(error.message, "cross"));
    CHECK(trimalla_add_segments(drawing, missing, 1, NULL, &error) == TRIMALLA_OK);
    CHECK(trimalla_mesh_drawing(drawing, NULL, NULL, &mesh, &error) == TRIMALLA_BAD_DRAWING);
    CHECK(error.index == 9);
    CHECK(trimalla_add_points(drawing, more, 2, NULL, &error) == TRIMALLA_OK);
    CHECK(trimalla_mesh_drawing(drawing, NULL, NULL, &mesh, &error) == TRIMALLA_BAD_DRAWING);
    CHECK(error.index == 8 && isnan(error.x) && error.y == 1);
    CHECK(trimalla_add_points(drawing, NULL, 2, NULL, &error) == TRIMALLA_BAD_ARGUMENT);
    CHECK(trimalla_add_points(drawing, XY, SIZE_MAX, NULL, &error) == TRIMALLA_BAD_ARGUMENT);
    CHECK(trimalla_add_points(NULL, XY, 8, NULL, &error) == TRIMALLA_BAD_ARGUMENT);
    CHECK(trimalla_mesh_drawing(NULL, NULL, NULL, &mesh, &error) == TRIMALLA_BAD_ARGUMENT);
    CHECK(trimalla_mesh_drawing(drawing, NULL, NULL, NULL, &error) == TRIMALLA_BAD_ARGUMENT);
    CHECK(trimalla_set_option(NULL, "a", "b", NULL) == TRIMALLA_BAD_ARGUMENT);
    CHECK(trimalla_point_count(NULL) == 0 && trimalla_triangles(NULL) == NULL && trimalla_warning(NULL, 0) == NULL);
    trimalla_drawing_free(drawing);
    trimalla_mesh_free(NULL);
    drawing = trimalla_drawing_new();
    CHECK(trimalla_mesh_drawing(drawing, NULL, NULL, &mesh, &error) == TRIMALLA_BAD_DRAWING);
    trimalla_drawing_free(drawing);
}

static void *raise_soon(void *cancel) {
    struct timespec soon = {0, 30 * 1000 * 1000};
    nanosleep(&soon, NULL);
    trimalla_cancel_set(cancel, 1);
    return NULL;
}

static void a_flag_cancels(void) {
    trimalla_drawing *drawing = plate();
    trimalla_options *options = trimalla_options_new();
    trimalla_cancel *cancel = trimalla_cancel_new();
    trimalla_mesh *mesh;
    trimalla_error error;
    pthread_t thread;
    CHECK(trimalla_set_number(options, "max-area", 1e-7, &error) == TRIMALLA_OK); /* 10^8 triangles, if nobody cancels */
    CHECK(trimalla_set_number(options, "max-vertices", 1e9, &error) == TRIMALLA_OK);
    CHECK(trimalla_set_option(options, "fill", "none", &error) == TRIMALLA_OK);
    CHECK(pthread_create(&thread, NULL, raise_soon, cancel) == 0);
    CHECK(trimalla_mesh_drawing(drawing, options, cancel, &mesh, &error) == TRIMALLA_CANCELLED && mesh == NULL);
    pthread_join(thread, NULL);
    trimalla_cancel_free(cancel);
    trimalla_options_free(options);
    trimalla_drawing_free(drawing);
}

int main(void) {
    CHECK(strlen(trimalla_version()) > 0);
    a_mesh_has_arrays();
    options_have_keys();
    bad_input_returns();
    a_flag_cancels();
    return 0;
}
