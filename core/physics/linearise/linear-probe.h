/* What drives a held model and what is read off it, made linear: the two ends of a frequency response. */
#ifndef TINKER_CORE_LINEAR_PROBE_H
#define TINKER_CORE_LINEAR_PROBE_H

#include "physics/linearise/linearise.h"
#include "physics/model/model.h"
#include "physics/record/columns.h"

/* A waveform that a force is proportional to, or the displacement of a support. Which one and along which direction,
 * the block's own linear form says; of a force without one, as a torque, what it does at the places that the model was
 * made linear about. */
typedef struct {
    TinkerBlockId block;
    gboolean is_motion;
    const char *unit; /* of the waveform: "N", "m" */
    double *force;    /* on every coordinate (TinkerLinearisation.coordinates), per unit */
    double *place;    /* displacement of every coordinate of supports, per unit */
} TinkerLinearInput;

/* The input of this block. TINKER_SCENE_ERROR_NAME where there is no such block, or it drives nothing; the message
 * lists the blocks that do. */
gboolean tinker_linear_input_find(TinkerModel *model, const char *name, TinkerLinearInput *input, GError **error);
void tinker_linear_input_clear(TinkerLinearInput *input);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerLinearInput, tinker_linear_input_clear)

/* A quantity by the state and by the input itself: its derivatives, as differences of order 6 of what the block
 * reports. They are exact for quantities that are linear in them. */
typedef struct {
    double *by_place, *by_speed; /* `size` entries each */
    double by_input[3];          /* by the input's value, its first and its second derivative */
} TinkerLinearOutput;

/* Of the column of a record, at the places q. Errors: TINKER_MODEL_ERROR_RUN where the quantity cannot be worked out.
 */
gboolean tinker_linear_output_find(TinkerModel *model, const double *q, const TinkerColumn *column,
                                   const TinkerLinearInput *input, TinkerLinearOutput *output, GError **error);
void tinker_linear_output_clear(TinkerLinearOutput *output);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerLinearOutput, tinker_linear_output_clear)

#endif
