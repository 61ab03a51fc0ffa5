/* trimalla for C and C++: a drawing in, a good mesh out. MIT or Apache-2.0.
 *
 *     trimalla_drawing *drawing = trimalla_drawing_new();
 *     trimalla_add_points(drawing, xy, 4, NULL, &error);
 *     trimalla_add_segments(drawing, ends, 4, NULL, &error);
 *     trimalla_mesh *mesh;
 *     if (trimalla_mesh_drawing(drawing, NULL, NULL, &mesh, &error)) puts(error.message);
 *     else use(trimalla_triangles(mesh), trimalla_triangle_count(mesh));
 *     trimalla_mesh_free(mesh);
 *     trimalla_drawing_free(drawing);
 *
 * Functions that can fail return a code, TRIMALLA_OK or another, and fill the error they are given (which may be NULL).
 * No call ends the process, prints, or lets a panic out. A call reads the caller's arrays and keeps none of them.
 * Points, segments and triangles are counted from 0. Angles are in degrees, areas in squared units of the drawing.
 * Different threads may use different handles at the same time; a flag to cancel may be raised from any thread. */
#ifndef TRIMALLA_H
#define TRIMALLA_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    TRIMALLA_OK = 0,
    TRIMALLA_BAD_ARGUMENT = 1, /* a null pointer, a count that does not fit */
    TRIMALLA_BAD_DRAWING = 2,  /* the message says what and where */
    TRIMALLA_BAD_OPTION = 3,   /* an unknown key, a value out of range */
    TRIMALLA_CANCELLED = 4,
    TRIMALLA_INTERNAL = 5 /* a fault of the library: please report it */
};

typedef struct trimalla_error {
    int code;
    char message[512]; /* UTF-8, shortened where it is longer */
    int64_t index;     /* the point, segment or seed at fault; -1 where there is none */
    double x, y;       /* where it lies; NaN where that is not known */
} trimalla_error;

typedef struct trimalla_drawing trimalla_drawing;
typedef struct trimalla_options trimalla_options;
typedef struct trimalla_cancel trimalla_cancel;
typedef struct trimalla_mesh trimalla_mesh;

const char *trimalla_version(void);

/* --- a drawing: points, segments between them, holes, regions --- */

trimalla_drawing *trimalla_drawing_new(void);
void trimalla_drawing_free(trimalla_drawing *);

/* xy: x and y in turn, 2 * count numbers. markers: count numbers, or NULL for zeros. */
int trimalla_add_points(trimalla_drawing *, const double *xy, size_t count, const int32_t *markers, trimalla_error *);
/* per_point numbers for each point there is; interpolated at new points. */
int trimalla_set_attributes(trimalla_drawing *, const double *values, size_t per_point, trimalla_error *);
/* ends: 2 * count indices of points. */
int trimalla_add_segments(trimalla_drawing *, const uint32_t *ends, size_t count, const int32_t *markers,
                          trimalla_error *);
/* What can be reached from (x, y) without crossing a segment is removed. */
int trimalla_add_hole(trimalla_drawing *, double x, double y, trimalla_error *);
/* max_area 0 or less: none. */
int trimalla_add_region(trimalla_drawing *, double x, double y, double attribute, double max_area, trimalla_error *);

/* --- options by key: those of docs/options.md ("min-angle", "max-area", "algorithm", "max-vertices", "protect", …),
 *     "domain" (seeds, nesting, hull) and "crossings" (refuse, split) --- */

trimalla_options *trimalla_options_new(void);
void trimalla_options_free(trimalla_options *);
int trimalla_set_option(trimalla_options *, const char *key, const char *value, trimalla_error *);
int trimalla_set_number(trimalla_options *, const char *key, double value, trimalla_error *);

/* --- a flag that cancels a call in another thread, which then returns TRIMALLA_CANCELLED --- */

trimalla_cancel *trimalla_cancel_new(void);
void trimalla_cancel_set(const trimalla_cancel *, int raised);
void trimalla_cancel_free(trimalla_cancel *);

/* --- meshing; options and cancel may be NULL. *mesh is NULL where the call fails --- */

int trimalla_mesh_drawing(trimalla_drawing *, const trimalla_options *, const trimalla_cancel *, trimalla_mesh **mesh,
                          trimalla_error *);
/* The constrained Delaunay triangulation: no point is added, but where segments cross and "crossings" is "split". */
int trimalla_triangulate(trimalla_drawing *, const trimalla_options *, trimalla_mesh **mesh, trimalla_error *);
void trimalla_mesh_free(trimalla_mesh *);

/* --- a mesh; arrays live as long as it does, and are NULL where they are empty --- */

size_t trimalla_point_count(const trimalla_mesh *);
size_t trimalla_input_point_count(const trimalla_mesh *); /* these come first, in order, bit for bit */
const double *trimalla_points(const trimalla_mesh *);     /* x and y in turn */
const int32_t *trimalla_point_markers(const trimalla_mesh *);
size_t trimalla_attributes_per_point(const trimalla_mesh *);
const double *trimalla_point_attributes(const trimalla_mesh *);

size_t trimalla_triangle_count(const trimalla_mesh *);
const uint32_t *trimalla_triangles(const trimalla_mesh *); /* 3 corners each, counter-clockwise */
size_t trimalla_attributes_per_triangle(const trimalla_mesh *);
const double *trimalla_triangle_attributes(const trimalla_mesh *);
const int32_t *trimalla_neighbours(const trimalla_mesh *); /* 3 each, opposite the corners; -1 for none */

size_t trimalla_segment_count(const trimalla_mesh *);
const uint32_t *trimalla_segments(const trimalla_mesh *); /* 2 ends each */
const int32_t *trimalla_segment_markers(const trimalla_mesh *);
size_t trimalla_edge_count(const trimalla_mesh *);
const uint32_t *trimalla_edges(const trimalla_mesh *); /* 2 ends each, the lower first */

typedef struct trimalla_report_data {
    double min_angle, max_angle;
    uint64_t points_added;
    uint64_t below_bound; /* triangles that miss a bound */
    int complete;         /* 1 where the drawing itself forces all of these */
} trimalla_report_data;

void trimalla_report(const trimalla_mesh *, trimalla_report_data *);
size_t trimalla_warning_count(const trimalla_mesh *);
const char *trimalla_warning(const trimalla_mesh *, size_t index);

#ifdef __cplusplus
}
#endif
#endif
