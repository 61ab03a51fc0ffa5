/* CHECK(what) ends the program with status 1, and says where, if what does not hold. */
#include <stdio.h>
#include <stdlib.h>

#define CHECK(what)                                                         \
    do {                                                                    \
        if (!(what)) {                                                      \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #what); \
            exit(1);                                                        \
        }                                                                   \
    } while (0)
