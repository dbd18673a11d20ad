/* Motions with a closed form, as scenes: oscillators, falls, pendulums, circles, chains, Kepler's ellipse. */
#ifndef TEST_CLOSED_FORM_MOTIONS_H
#define TEST_CLOSED_FORM_MOTIONS_H

#include <glib.h>

#define MOST_BODIES 8

/* Where each body is (x, y) and how fast it goes (vx, vy). */
typedef struct {
    double q[2 * MOST_BODIES], v[2 * MOST_BODIES];
} Motion;

typedef struct {
    const char *name;
    int bodies;
    double rate;     /* rad/s: of the fastest motion in it */
    double duration; /* s */
    void (*truth)(double t, Motion *motion);
    const char *blocks; /* of the scene; NULL for one that is written by closed_form_blocks */
    int anchors;
    double anchor[2][2]; /* m: the supports that something hangs on */
} ClosedForm;

/* Ended by one without a name. */
extern const ClosedForm closed_forms[];

/* The scene's blocks. (transfer full) */
char *closed_form_blocks(const ClosedForm *form);

#endif
