/* One run of a random scene beside the truth: what it claims of its error, and what that is. */
#ifndef TEST_HONEST_RUN_H
#define TEST_HONEST_RUN_H

#include "random-scenes.h"
#include "scene/store/scene.h"

/* How a scene is run. */
typedef struct {
    const char *name, *method;
    double tolerance;       /* of adaptive methods */
    double steps_in_a_turn; /* of those of a fixed step: 1 / (step * rate of the scene) */
} HonestyMethod;

/* One sample: the largest error so far, in units of how far and how fast the motion has gone, and what is claimed. */
typedef struct {
    double claimed, error;
} HonestySample;

typedef struct {
    TinkerScene *scene;
    const RandomScene *text;
    GString *columns;
    gsize claims, times;     /* how many of each: claims are made at some of the times */
    double *at, *claimed_at; /* s, rising */
    double *truth, *other;   /* time by time: a row of columns each; of two methods */
    double *extent, *speed;  /* m, m/s: reached up to each time */
    double *doubt;           /* up to each time: how far the two are apart, as errors are measured */
} HonestyTruth;

/* The truth of a scene: order 8 at a tolerance near rounding, beside order 5. NULL where the scene has none: why is
 * then in *error. The text is borrowed. (transfer full) */
HonestyTruth *honesty_truth_new(TinkerCatalogue *catalogue, const RandomScene *text, guint32 seed, GError **error);
void honesty_truth_free(HonestyTruth *truth);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(HonestyTruth, honesty_truth_free)

/* Runs the scene with an estimate and adds the samples that can be judged (of HonestySample) to `samples`: those up to
 * which the record is to be believed and the motion predictable, and where the truth is known to a quarter of what is
 * claimed. *left_out counts the others. FALSE with `error` where the run stopped. */
gboolean honesty_judge(const HonestyTruth *truth, const HonestyMethod *method, GArray *samples, guint *left_out,
                       GError **error);

#endif
