/* Runs a crowd and looks at its record. */
#ifndef TEST_CROWD_RUN_H
#define TEST_CROWD_RUN_H

#include "physics/run/simulation.h"
#include "plugin/catalogue/catalogue.h"
#include "random-crowds.h"

/* x, y, angle, vx, vy, rate of each body */
#define CROWD_COLUMNS 6
#define CROWD_SAMPLES 1000 /* of a run, behind its start */

typedef struct {
    GArray *rows;           /* of double: CROWD_COLUMNS a body, sample by sample */
    GArray *claims;         /* of double: the error estimate, sample by sample; NAN without */
    guint samples;          /* at even times from 0 to the duration */
    double balance;         /* of the energy books: the largest, relative */
    double overlap;         /* m: the largest of two bodies, or of a body and a wall */
    double overlap_time;    /* s */
    double gain, gain_time; /* the largest growth of the energy, worked out from the record, relative; s */
    double seconds;         /* of processor time */
    gint64 changes;         /* of contacts */
    guint warnings;
} CrowdRun;

/* Runs it to its end at this tolerance. FALSE with `error` where it stopped, or took more than `patience` (s) of the
 * processor's time: what came before is in *run all the same. `claims`: it is to estimate its error. Free it with
 * crowd_run_clear. */
gboolean crowd_run(TinkerCatalogue *catalogue, const Crowd *crowd, double tolerance, double patience, gboolean claims,
                   CrowdRun *run, GError **error);
void crowd_run_clear(CrowdRun *run);

#endif
