/* The peers: solvers that others wrote, and the motions as the equations of first order that those take.
 *
 * A peer is handed exactly what it needs, with the right side written by hand; it knows of no blocks, keeps no energy
 * books and watches nothing. Where its library is missing it is left out. */
#ifndef BENCHMARK_PEERS_H
#define BENCHMARK_PEERS_H

#include <glib.h>

#define PEER_MOST_RATES 100

/* dy/dt = rates(t, y), from `start` at t = 0. */
typedef struct {
    const char *scene; /* "S1" */
    const char *form;  /* of the equations: "Cartesian", or "angles" where coordinates were chosen by hand */
    int size;
    double duration; /* s */
    double start[PEER_MOST_RATES];
    void (*rates)(double t, const double *y, double *f);
    int half_band;                              /* of the Jacobian of a stiff problem; 0: the problem is not stiff */
    double (*error)(double t, const double *y); /* against the truth: */
    gboolean everywhere;                        /* that is known at any t; else at the end alone */
} PeerProblem;

/* Ended by one without a scene. */
const PeerProblem *peer_problems(void);
const PeerProblem *peer_problem_find(const char *scene, const char *form);

/* Called after every step. */
typedef void (*PeerLook)(double t, const double *y, void *data);

typedef struct Peer {
    const char *maker, *method;
    gboolean takes_stiff, takes_smooth; /* whether it is tried on problems that are stiff, and on others */
    const void *kind;                   /* what `solve` makes of it */
    /* From the start to the duration, all preparing included; the end into y. `look` may be NULL. FALSE: it gave up. */
    gboolean (*solve)(const struct Peer *peer, const PeerProblem *problem, double tolerance, double *y, PeerLook look,
                      void *data);
} Peer;

/* Lists ended by one without a maker; empty where the library was not found. */
const Peer *peer_gsl(void);
const Peer *peer_sundials(void);

/* A row of what SciPy's solvers did, in a process of its own that takes its own times. */
typedef struct {
    char *method;
    const PeerProblem *problem;
    double tolerance, median, least, error;
} PeerScipyRow;

/* All rows of a scene; empty where there is no Python with SciPy. Element: PeerScipyRow. (transfer full) */
GArray *peer_scipy(const char *scene);

#endif
