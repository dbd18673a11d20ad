/* Random crowds: bodies of every shape, thrown about in a box of four supports, drawn from a seed. */
#ifndef TEST_RANDOM_CROWDS_H
#define TEST_RANDOM_CROWDS_H

#include <glib.h>

#define CROWD_MOST_BODIES  12
#define CROWD_MOST_CORNERS 8
#define CROWD_MOST_PARTS   2

/* A convex part of a body, in the body's own axes. */
typedef struct {
    int corners; /* counter-clockwise; 0: a disc about the centre of mass */
    double at[CROWD_MOST_CORNERS][2];
} CrowdPart;

/* What the scene says of a body, which its energy and its outline are worked out from. */
typedef struct {
    double mass, inertia, radius; /* kg, kg m^2, m */
    int part_count;
    CrowdPart parts[CROWD_MOST_PARTS];
} CrowdBody;

/* Bodies b0, b1, ... in a box from (0, 0) to `inside`. */
typedef struct {
    char *text; /* the scene file */
    int count;
    CrowdBody bodies[CROWD_MOST_BODIES];
    double inside[2], duration, gravity, friction, restitution;
} Crowd;

/* The same for the same seed. `most` bodies at most. (transfer full) */
Crowd *crowd_new(guint32 seed, int most);
void crowd_free(Crowd *crowd);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(Crowd, crowd_free)

#endif
