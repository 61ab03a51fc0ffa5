/* Writes a .poly file, whose items are numbered from 0 or 1, in the form that the drivers of bench/ read. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The next number, comments passed over. */
static double number(FILE *file) {
    char word[64];
    while (fscanf(file, "%63s", word) == 1) {
        if (word[0] != '#') return strtod(word, NULL);
        while (!feof(file) && fgetc(file) != '\n') {
        }
    }
    fputs("the file is cut short\n", stderr);
    exit(2);
}

int main(int argc, char **argv) {
    FILE *file = argc == 3 ? fopen(argv[1], "r") : NULL, *out = argc == 3 ? fopen(argv[2], "wb") : NULL;
    if (!file || !out) return fputs("usage: drawing FILE.poly OUT\n", stderr), 2;
    uint64_t counts[3];
    counts[0] = (uint64_t)number(file);
    number(file);
    int attributes = (int)number(file), markers = (int)number(file), first = 0;
    double *xy = malloc(16 * counts[0] + 16), *seeds;
    for (uint64_t i = 0; i < counts[0]; i++) {
        int n = (int)number(file);
        if (i == 0) first = n;
        xy[2 * i] = number(file), xy[2 * i + 1] = number(file);
        for (int k = 0; k < attributes + markers; k++) number(file);
    }
    counts[1] = (uint64_t)number(file), markers = (int)number(file);
    uint32_t *ends = malloc(8 * counts[1] + 8);
    for (uint64_t i = 0; i < counts[1]; i++) {
        number(file);
        for (int k = 0; k < 2; k++) ends[2 * i + k] = (uint32_t)(number(file) - first);
        for (int k = 0; k < markers; k++) number(file);
    }
    counts[2] = (uint64_t)number(file);
    seeds = malloc(16 * counts[2] + 16);
    for (uint64_t i = 0; i < counts[2]; i++) number(file), seeds[2 * i] = number(file), seeds[2 * i + 1] = number(file);
    fwrite("DRAWING1", 8, 1, out), fwrite(counts, 8, 3, out);
    fwrite(xy, 16, counts[0], out), fwrite(ends, 8, counts[1], out), fwrite(seeds, 16, counts[2], out);
    free(xy), free(ends), free(seeds), fclose(file);
    return fclose(out);
}
