/* What start conditions and advice share: which blocks hang together, writing places, the rest state. */
#ifndef TINKER_CORE_ANALYSIS_START_PRIVATE_H
#define TINKER_CORE_ANALYSIS_START_PRIVATE_H

#include "analysis/modes/equilibrium.h"
#include "analysis/start/start-conditions.h"
#include "scene/frame/tops.h"
#include "scene/history/history.h"

/* Classes ---------------------------------------------------------------------------------------------------------- */

/* A body with degrees of freedom and a start velocity that can be given. */
gboolean start_can_move(const TinkerScene *scene, TinkerBlockId block);
/* A connector of two ends with a length: a law with a rest length; a constraint that keeps it. */
gboolean start_has_rest_length(const TinkerBlockClass *block_class);
gboolean start_keeps_length(const TinkerBlockClass *block_class);
/* A constraint that holds in both directions. */
gboolean start_is_rigid(const TinkerBlockClass *block_class);
/* One whose two ends lie at one place. */
gboolean start_is_joint(const TinkerBlockClass *block_class);

/* Sets the property with a meaning. */
gboolean start_set_meaning(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t meaning,
                           const double *values, GError **error);

/* A value for people, with four digits and the unit of the scene's system. (transfer full) */
char *start_quantity_text(TinkerScene *scene, double si, TinkerDimension dimension);

/* Links ------------------------------------------------------------------------------------------------------------ */

/* A connector of two ends, both attached, one of them to the block that was asked about. */
typedef struct {
    TinkerBlockId connector;
    TinkerSceneEnd own, far;
} StartLink;

/* All links of a block, in scene order. Element: StartLink. (transfer full) */
GArray *start_links_new(const TinkerScene *scene, TinkerBlockId block);

typedef enum {
    START_TIED_BY_ANYTHING,
    START_TIED_BY_CONSTRAINTS,
    START_TIED_RIGIDLY, /* by constraints that hold in both directions */
} StartTies;

/* The sets that ties make of the bodies that can move: by block id, the least id of its set. `without` (or
 * TINKER_NO_BLOCK) ties nothing. (transfer full) */
int32_t *start_sets_new(TinkerScene *scene, StartTies ties, TinkerBlockId without);

/* By block id: the bodies that are tied to `body`, itself among them. `anchored`: whether a support is tied to them
 * too; may be NULL. (transfer full) */
gboolean *start_group_new(TinkerScene *scene, TinkerBlockId body, StartTies ties, TinkerBlockId without,
                          gboolean *anchored);

/* Places ----------------------------------------------------------------------------------------------------------- */

/* Where a body is to start. What is NAN stays. */
typedef struct {
    TinkerBlockId body;
    double place[2], orientation, velocity[2], rate;
    gboolean lies; /* on the top of the plate, so far along (m), in place of a place and an orientation */
    TinkerBlockId plate;
    double along;
} StartPlace;

#define START_PLACE_AS_IT_IS(body_) ((StartPlace){body_, {NAN, NAN}, NAN, {NAN, NAN}, NAN, FALSE, TINKER_NO_BLOCK, 0})

/* A start position may miss a length by this much of it, as a run has it. */
#define START_FITS 1e-6

/* The distance of a link's ends. */
double start_distance(const TinkerFrame *frame, TinkerSceneEnd a, TinkerSceneEnd b);

/* The start velocity that a body was given. */
void start_velocity_of(const TinkerFrame *frame, TinkerBlockId body, double velocity[2]);

/* Puts bodies there, as one step. See tinker_start_apply for what is kept and what is refused. */
gboolean start_places_write(TinkerHistory *history, TinkerScene *scene, const char *title, const GArray *places,
                            GError **error);

/* Turning ---------------------------------------------------------------------------------------------------------- */

/* A body that turns; one that has a length, too, so that it can be level. */
gboolean start_turns(const TinkerScene *scene, TinkerBlockId body);
gboolean start_is_long(const TinkerScene *scene, TinkerBlockId body);

/* Whether a start is about how a body is turned or turns; and making it so, as one step. */
gboolean start_turn_is(TinkerStartKind kind);
gboolean start_turn_apply(TinkerHistory *history, TinkerScene *scene, const TinkerStartOption *option, double value,
                          const char *title, GError **error);

/* Rest ------------------------------------------------------------------------------------------------------------- */

/* The rest state of all that hangs together with a body; friction, which could hold it elsewhere, is left out. */
typedef struct {
    GArray *bodies; /* of StartPlace: at rest */
    guint own;      /* which of them is the body asked about */
    gboolean lands; /* something lies on a plate there that it does not touch at the start */
} StartRest;

/* NULL with an error where there is none. (transfer full) */
StartRest *start_rest_new(TinkerScene *scene, TinkerBlockId body, GError **error);
void start_rest_free(StartRest *rest);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(StartRest, start_rest_free)

/* The direction in which a body is displaced from rest: along its first connector with a rest length, away from the far
 * end; down where there is none; along the top of a plate that it touches. */
void start_direction_at(TinkerScene *scene, const TinkerFrame *frame, TinkerBlockId body, const StartRest *rest,
                        double direction[2]);

#endif
