/* The modes of a scene: how it moves of itself, a little, about a state.
 *
 * x = Re(shape exp(s t)) with (s^2 M + s C + K) shape = 0 on what the constraints allow. Source: Meirovitch,
 * "Fundamentals of Vibrations" (2001), chapters 7 and 8; Tisseur, Meerbergen, "The quadratic eigenvalue problem", SIAM
 * Review 43 (2001). */
#ifndef TINKER_CORE_MODES_H
#define TINKER_CORE_MODES_H

#include "analysis/modes/modal-basis.h"

typedef enum {
    TINKER_MODE_RIGID,       /* nothing brings it back: s = 0 */
    TINKER_MODE_OSCILLATION, /* s = -decay +- i frequency */
    TINKER_MODE_DECAY,       /* s = -decay: damped beyond swinging */
    TINKER_MODE_GROWTH,      /* s = -decay > 0, without swinging: the state is unstable */
} TinkerModeKind;

typedef struct {
    TinkerModeKind kind;
    double natural;       /* rad/s: |s|, the undamped frequency; of a pair of decays that one oscillator makes, its own;
                             NAN for other decays and for growth */
    double frequency;     /* rad/s: |Im s| */
    double damping_ratio; /* -Re s / |s|, of such a pair its own; negative where an oscillation grows; NAN as above */
    double decay;         /* 1/s: -Re s, negative for growth */
    guint number; /* of what swings or would but for its damping, from 1, as the matrix form numbers its frequencies:
                     of a pair of decays that one oscillator makes the same; 0: of what nothing brings back, and of
                     decays that dampers couple */
    double *real, *imaginary; /* the shape, `size` entries each; the largest component is 1 */
} TinkerMode;

/* All modes, by |s|; element: TinkerMode *. NULL with an error where the eigenvalues do not converge. (transfer full)
 */
GPtrArray *tinker_modes_of(const TinkerModalBasis *basis, GError **error);

/* Whether the components of a shape are in step or in counterstep: it can be drawn as one displacement. */
gboolean tinker_mode_is_standing(const TinkerMode *mode, int32_t size);

/* The greatest rate (1/s) at which a mode grows; 0 where none does. */
double tinker_modes_growth(const GPtrArray *modes);

/* "oscillation", "rigid", "decay", "growth". */
const char *tinker_mode_kind_name(TinkerModeKind kind);

#endif
