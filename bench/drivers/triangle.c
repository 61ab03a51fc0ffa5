// Times Triangle 1.6, compiled as a library: triangle_driver PROGRAM TASK FILE ANGLE AREA SIZE
// The call's own copies into and out of its arrays count.
#include "drawing.h"

#define REAL double
#define VOID void
#define ANSI_DECLARATORS
#include "triangle.h"

int main(int argc, char **argv) {
    char switches[64];
    struct triangulateio in, out;
    drawing d;
    reading r;
    if (argc != 7) return fputs("usage: triangle_driver PROGRAM TASK FILE ANGLE AREA SIZE\n", stderr), 2;
    if (!strcmp(argv[2], "points")) strcpy(switches, "zQ");
    else if (!strcmp(argv[2], "constrained")) strcpy(switches, "pczQ");
    else if (!strcmp(argv[2], "polygon")) strcpy(switches, "pzQ");
    else {
        int n = snprintf(switches, sizeof switches, "pzQ");
        if (atof(argv[4]) > 0) n += snprintf(switches + n, sizeof switches - n, "q%s", argv[4]);
        if (atof(argv[5]) > 0) snprintf(switches + n, sizeof switches - n, "a%.12f", atof(argv[5]));
    }
    d = read_drawing(argv[3]);
    memset(&in, 0, sizeof in);
    memset(&out, 0, sizeof out);
    in.pointlist = d.xy;
    in.numberofpoints = (int)d.points;
    in.segmentlist = (int *)d.ends;
    in.numberofsegments = (int)d.segments;
    in.holelist = d.seeds;
    in.numberofholes = (int)d.holes;
    r = start();
    triangulate(switches, &in, &out, NULL);
    r = stop(r);
    print_reading(r, out.numberofpoints, out.numberoftriangles);
    return 0;
}
