/* A model: a scene compiled into what is integrated.
 *
 * Compiling keeps only what the scene's blocks ask for: bodies that can move become coordinates, supports become points
 * that are known functions of time, linear laws between the same two points are merged into one, constant forces are
 * added up once. A model is a snapshot: later edits of the scene do not reach it.
 */
#ifndef TINKER_CORE_MODEL_H
#define TINKER_CORE_MODEL_H

#include "physics/model/warning.h"
#include "scene/frame/frame.h"
#include "scene/store/scene.h"

typedef enum {
    TINKER_MODEL_ERROR_SCENE,         /* nothing that could run: a detached end, a rod that does not fit, ... */
    TINKER_MODEL_ERROR_CONTRADICTION, /* constraints that exclude each other */
    TINKER_MODEL_ERROR_METHOD,        /* no such method, or a step or tolerance that it cannot take */
    TINKER_MODEL_ERROR_PLUGIN,        /* a type that nobody provides, or a plugin that lacks what its role needs */
    TINKER_MODEL_ERROR_RUN,           /* the run failed: it diverged, a plugin returned a non-number */
    TINKER_MODEL_ERROR_ACCURACY,      /* the run is whole, but its error estimate is above the accuracy asked for */
    TINKER_MODEL_ERROR_STOPPED,       /* the caller stopped it */
    TINKER_MODEL_ERROR_MEMORY,        /* there is not enough for a model of this size */
} TinkerModelError;
#define TINKER_MODEL_ERROR (tinker_model_error_quark())
GQuark tinker_model_error_quark(void);

/* What the energy books tell apart. */
typedef enum {
    TINKER_BOOK_DAMPERS,
    TINKER_BOOK_FRICTION,
    TINKER_BOOK_CONTACTS,
    TINKER_BOOK_MOTORS,
    TINKER_BOOK_FIELDS,
    TINKER_BOOK_SUPPORT_MOTION,
    TINKER_BOOK_PROJECTION, /* what bringing the state back onto the constraints gave */
    TINKER_BOOK_COUNT,
} TinkerBook;

typedef struct _TinkerModel TinkerModel;

/* Sizes of what was compiled. */
typedef struct {
    int32_t bodies;             /* that can move */
    int32_t turning;            /* of them */
    int32_t coordinates;        /* two a body, and one more of each that turns, behind those of all */
    int32_t degrees_of_freedom; /* coordinates less independent constraint rows */
    int32_t constraint_rows;
    int32_t redundant_rows;
    int32_t merged_lines;    /* pairs of points whose linear laws are stepped as one */
    int32_t nonlinear_lines; /* connectors that are asked at every evaluation */
    int32_t moving_supports;
} TinkerModelSizes;
TinkerModelSizes tinker_model_sizes(const TinkerModel *model);

/* What the model says before a run: start velocities that were projected, bodies that nothing holds, ...; of
 * TinkerWarning *. (transfer none) */
const GPtrArray *tinker_model_warnings(const TinkerModel *model);

#endif
