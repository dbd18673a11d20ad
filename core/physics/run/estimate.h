/* The estimate of a run's global error: from a companion run at half the step or a tenth of the tolerance
 * (companion.h).
 *
 * For a method of order p the companion at half the step is off by 2^-p of the error, so their distance is (1 -
 * 2^-p) of it; for an adaptive method about nine tenths. Twice what follows from that is claimed. A method that
 * steps exactly needs no companion as long as nothing lets rounding grow: its error is that of rounding, which grows
 * with the time and with the frequencies that move. In a run of some length the companion is stepped on a thread of
 * its own, a little behind; what is claimed is the same to the last bit. Source: E. Hairer, S. P. Norsett, G.
 * Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.4 (extrapolation), Springer 1993. */
#ifndef TINKER_CORE_ESTIMATE_H
#define TINKER_CORE_ESTIMATE_H

#include "physics/run/island-runs.h"

typedef struct _TinkerEstimate TinkerEstimate;

/* The estimate of these runs, which it follows from now on, with a companion where one is needed; NULL where none
 * can be made, which their warnings then say (transfer full). The runs outlive it. */
TinkerEstimate *tinker_estimate_new(TinkerIslandRuns *runs, const GArray *columns);
void tinker_estimate_free(TinkerEstimate *estimate);

/* The simulation's sample is at t: the companion is to come there, and to be compared. FALSE only where the user
 * stopped it. */
gboolean tinker_estimate_look(TinkerEstimate *estimate, double t, GError **error);

/* At the end of the run: waits for the companion, and warns where the motion was not predictable to its end. FALSE
 * only where the user stopped the companion before. */
gboolean tinker_estimate_close(TinkerEstimate *estimate, GError **error);

/* The largest error so far, relative to the scales of the islands; where it passed a tenth; and by column, NULL for
 * the whole run or for none of it. From where the companion stops on the first and the last are NAN. All wait for
 * the companion. */
double tinker_estimate_error(TinkerEstimate *estimate);
double tinker_estimate_predictable_until(TinkerEstimate *estimate);
const double *tinker_estimate_bands(TinkerEstimate *estimate);

#endif
