/* What is taken of a run: its samples and its summary, as the bytes that are hashed. */
#ifndef NET_TAKE_H
#define NET_TAKE_H

#include "physics/record/columns.h"
#include "physics/run/accurate-run.h"

typedef struct {
    GByteArray *record;   /* a heading, "time [s]\tm0.x [m]\n", and rows of little-endian doubles under it */
    GByteArray *estimate; /* in the same form: time, the error estimate, and how far each column may be off */
    guint record_heading, estimate_heading; /* bytes */
    guint columns;                          /* without time */
    gint64 samples;
} NetTake;

NetTake *net_take_new(const GArray *columns);
void net_take_free(NetTake *take);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(NetTake, net_take_free)

/* What takes the samples of a run. Borrows the take. */
TinkerSampleTaker net_take_samples(NetTake *take);

/* A run's summary as text, without what the clock says and what stands in the table itself. (transfer full) */
char *net_summary_text(const TinkerSummary *summary);

#endif
