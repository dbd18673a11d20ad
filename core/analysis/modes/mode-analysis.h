/* The modes of a scene from beginning to end: compiled, held, brought to rest, made linear, analysed. */
#ifndef TINKER_CORE_MODE_ANALYSIS_H
#define TINKER_CORE_MODE_ANALYSIS_H

#include "analysis/modes/equilibrium.h"
#include "analysis/modes/frequency-response.h"
#include "analysis/modes/modes.h"
#include "physics/linearise/left-out.h"

typedef struct {
    TinkerModel *model;            /* held */
    TinkerStillContacts *contacts; /* NULL: nothing can touch anything; they tell what was assumed */
    double *q;                     /* places that the modes are about, by coordinate, relative to the model's origin */
    gboolean about_rest;
    TinkerEquilibrium rest; /* where it was looked for */
    TinkerLinearisation *linear;
    TinkerModalBasis *basis;
    GPtrArray *modes; /* of TinkerMode * */
    GArray *left_out; /* of TinkerLeftOut: what is there and does not count */
} TinkerModeAnalysis;

/* About the rest state that the start leads to, or about the start itself. Where no rest is found the analysis is about
 * the start, with about_rest FALSE and rest.why saying why. The scene is borrowed. (transfer full) */
TinkerModeAnalysis *tinker_mode_analysis_new(TinkerScene *scene, gboolean rest, GError **error);
void tinker_mode_analysis_free(TinkerModeAnalysis *analysis);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerModeAnalysis, tinker_mode_analysis_free)

#endif
