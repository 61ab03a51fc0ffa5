// What the C and C++ drivers share: the drawing file, the clocks, the memory, the line they print.
#ifndef TRIMALLA_BENCH_DRAWING_H
#define TRIMALLA_BENCH_DRAWING_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    uint64_t points, segments, holes;
    double *xy;       // two a point
    uint32_t *ends;   // two a segment
    double *seeds;    // two a hole
} drawing;

// "DRAWING1", three counts, then points, segments and hole seeds, little endian.
static drawing read_drawing(const char *path) {
    drawing d;
    char magic[8];
    uint64_t count[3];
    FILE *file = fopen(path, "rb");
    if (!file || fread(magic, 1, 8, file) != 8 || memcmp(magic, "DRAWING1", 8) || fread(count, 8, 3, file) != 3) {
        fprintf(stderr, "%s is no drawing\n", path);
        exit(2);
    }
    d.points = count[0], d.segments = count[1], d.holes = count[2];
    d.xy = (double *)malloc(16 * d.points + 16);
    d.ends = (uint32_t *)malloc(8 * d.segments + 8);
    d.seeds = (double *)malloc(16 * d.holes + 16);
    if (fread(d.xy, 16, d.points, file) != d.points || fread(d.ends, 8, d.segments, file) != d.segments ||
        fread(d.seeds, 16, d.holes, file) != d.holes) {
        fprintf(stderr, "%s is cut short\n", path);
        exit(2);
    }
    fclose(file);
    return d;
}

static double seconds(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static long peak_bytes(void) {
    char line[256];
    long kilobytes = 0;
    FILE *file = fopen("/proc/self/status", "r");
    while (file && fgets(line, sizeof line, file)) sscanf(line, "VmHWM: %ld", &kilobytes);
    if (file) fclose(file);
    return 1024 * kilobytes;
}

typedef struct {
    double wall, cpu;
    long bytes;
} reading;

static reading start(void) {
    reading r;
    r.bytes = peak_bytes();
    r.wall = seconds(CLOCK_MONOTONIC);
    r.cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
    return r;
}

static reading stop(reading r) {
    r.cpu = seconds(CLOCK_PROCESS_CPUTIME_ID) - r.cpu;
    r.wall = seconds(CLOCK_MONOTONIC) - r.wall;
    r.bytes = peak_bytes() - r.bytes;
    return r;
}

static void print_reading(reading r, long vertices, long triangles) {
    printf("%.9f %.9f %ld %ld %ld\n", r.wall, r.cpu, vertices, triangles, r.bytes);
}

#endif
