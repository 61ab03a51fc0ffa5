/* Triangle's in/out structure and call, answered by trimalla: link with -ltrimalla_c instead of Triangle.
 *
 * The structure has the fields of Triangle 1.6 as it is compiled for doubles, in the same order, so that a program
 * compiled with Triangle's own header needs no more than linking again. Fields, switches and results are those of
 * Triangle; `trimalla triangle -h` and docs/triangle.md list the switches.
 *
 * Memory is as there. An array of `out` or `vorout` that is NULL before the call is allocated, by malloc, so that
 * free() and trifree() take it; one that is not NULL must have room. `holelist` and `regionlist` of `out` are those of
 * `in`: free them once. Set all pointers of `out` and `vorout` to NULL, as in
 *
 *     struct triangulateio in, out;
 *     memset(&in, 0, sizeof in), memset(&out, 0, sizeof out);
 *
 * Other than there, no call ends the process. Where one fails, all counts of `out` are 0, nothing stays allocated, one
 * line is printed on standard error, and triangulate_error() returns the reason. */
#ifndef TRIANGLE_COMPAT_H
#define TRIANGLE_COMPAT_H

#ifndef REAL
#define REAL double
#endif
#ifndef VOID
#define VOID void
#endif

#ifdef __cplusplus
extern "C" {
#endif

struct triangulateio {
    REAL *pointlist;             /* in, out: x and y in turn */
    REAL *pointattributelist;    /* in, out: numberofpointattributes each */
    int *pointmarkerlist;        /* in (or NULL), out (not under -B) */
    int numberofpoints;
    int numberofpointattributes;

    int *trianglelist;           /* in under -r, out: numberofcorners each, counter-clockwise */
    REAL *triangleattributelist; /* in under -r, out: numberoftriangleattributes each */
    REAL *trianglearealist;      /* in under -ra: the largest area of each; 0 or less for none */
    int *neighborlist;           /* out under -n: 3 each, opposite the corners; -1 for none */
    int numberoftriangles;
    int numberofcorners;         /* 3, or 6 under -o2 */
    int numberoftriangleattributes;

    int *segmentlist;            /* in under -p, out under -p and -c: 2 ends each */
    int *segmentmarkerlist;      /* in (or NULL), out (not under -B) */
    int numberofsegments;

    REAL *holelist;              /* in under -p: x and y in turn */
    int numberofholes;
    REAL *regionlist;            /* in under -pA and -pa: x, y, attribute, largest area */
    int numberofregions;

    int *edgelist;               /* out under -e; vorout: -1 as the second end of a ray */
    int *edgemarkerlist;         /* out under -e (not under -B) */
    REAL *normlist;              /* vorout: the direction of each ray, 0 and 0 elsewhere */
    int numberofedges;
};

void triangulate(char *switches, struct triangulateio *in, struct triangulateio *out, struct triangulateio *vorout);
void trifree(VOID *memory);

/* Not in Triangle: why the last call in this thread failed, NULL if it did not. */
const char *triangulate_error(void);

#ifdef __cplusplus
}
#endif
#endif
