/* A plate with a hole: points, segments and a hole in, a mesh with no angle below 30 degrees out. */
#include <stdio.h>
#include <stdlib.h>
#include <trimalla.h>

static int failed(const trimalla_error *error) {
    fprintf(stderr, "error %d: %s\n", error->code, error->message);
    return EXIT_FAILURE;
}

int main(void) {
    const double xy[] = {0, 0, 4, 0, 4, 3, 0, 3, 1, 1, 2, 1, 2, 2, 1, 2};
    const uint32_t ends[] = {0, 1, 1, 2, 2, 3, 3, 0, 4, 5, 5, 6, 6, 7, 7, 4};
    trimalla_error error;
    trimalla_mesh *mesh = NULL;
    trimalla_drawing *plate = trimalla_drawing_new();
    trimalla_options *options = trimalla_options_new();
    int status = EXIT_SUCCESS;
    if (trimalla_add_points(plate, xy, 8, NULL, &error) || trimalla_add_segments(plate, ends, 8, NULL, &error) ||
        trimalla_add_hole(plate, 1.5, 1.5, &error) || trimalla_set_number(options, "max-area", 0.1, &error) ||
        trimalla_mesh_drawing(plate, options, NULL, &mesh, &error)) {
        status = failed(&error);
    } else {
        trimalla_report_data report;
        trimalla_report(mesh, &report);
        printf("%zu points, %zu triangles, no angle below %.2f degrees\n", trimalla_point_count(mesh),
               trimalla_triangle_count(mesh), report.min_angle);
    }
    trimalla_mesh_free(mesh);
    trimalla_options_free(options);
    trimalla_drawing_free(plate);
    return status;
}
