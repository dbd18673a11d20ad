/* A model as integrators see it. */
#ifndef TINKER_CORE_SYSTEM_H
#define TINKER_CORE_SYSTEM_H

#include "physics/line/linear-form.h"
#include "physics/model/model.h"
#include "physics/system/jacobian.h"

/* Steps that ended before the impulses of contacts were solved for. */
typedef struct {
    gint64 steps;         /* how many */
    double first;         /* s: the end of the first of them */
    double most, most_at; /* m/s: what one more sweep along the contacts would have changed speeds by, at the most; s */
} TinkerUnsolved;

/* An evaluation at a state, all of it borrowed: accelerations, and the powers of the books. */
typedef struct {
    double t;
    const double *q, *v, *a, *power;
} TinkerEvaluated;

/* The system that integrators see, with the reach of the states that were kept so far. Its coordinates are those of the
 * linear form where that is straight, else those of the model. */
typedef struct {
    TinkerModel *model;
    TinkerLinearForm *form; /* NULL where the model is not linear */
    TinkerSystem system;
    int32_t book_of[TINKER_BOOK_COUNT];    /* books that are integrated, in order */
    double box[4];                         /* m: least x, least y, greatest x, greatest y */
    double reach;                          /* m: of constraints with one end */
    double speed;                          /* m/s */
    double projection_work;                /* J that projections after steps have given so far */
    double impact_work[TINKER_BOOK_COUNT]; /* J that impacts have given so far, by book */
    TinkerUnsolved unsolved;
    double position_error; /* largest |g| relative to its length after any projection */
    double *constrained;   /* accelerations, where only the power is asked for */
    gboolean holds_energy; /* `project` brings the state onto `energy` (J), too */
    double energy;
    TinkerJacobian *jacobian; /* NULL: not offered */
    /* what was evaluated last, by the model in the plane: the next evaluation, if it is at this state, takes it from
     * here. NULL as a rule */
    const TinkerEvaluated *known;
} TinkerModelSystem;

/* `form` is the model's own, or NULL; borrowed. */
void tinker_model_system_init(TinkerModelSystem *system, TinkerModel *model, TinkerLinearForm *form);
/* Puts the functions of straight motion in place of those of the plane. */
void tinker_straight_system_init(TinkerModelSystem *system);
void tinker_straight_system_offer_jacobian(TinkerModelSystem *system);
/* Notes the reach along the line. */
void tinker_straight_system_keep(TinkerModelSystem *system, const double *x, const double *u);
/* Whether a line is shorter in the state x than those that are watched, with supports where the model has them. */
gboolean tinker_straight_system_is_near(const TinkerModelSystem *system, const double *x);
/* The reach along the line as a box in the plane, and back. */
void tinker_straight_system_widen_box(TinkerModelSystem *system);
void tinker_straight_system_narrow_box(TinkerModelSystem *system);
/* From here on bodies may rest on plates: the system is that of the plane, and has constraints to a method that is
 * created then. What was reached and given so far stays. */
void tinker_model_system_enter_plane(TinkerModelSystem *system);
/* Out of the plane: from here on the system is again that of the form, with which it began. */
void tinker_model_system_leave_plane(TinkerModelSystem *system, TinkerLinearForm *form);
/* Gives the system its pattern and jacobian, for a method that asks for them: before its stepper is created. */
void tinker_model_system_offer_jacobian(TinkerModelSystem *system);
/* Notes how far and how fast an accepted state reaches: what errors are measured against from then on. */
void tinker_model_system_keep(TinkerModelSystem *system, const double *q, const double *v);
void tinker_model_system_clear(TinkerModelSystem *system);

#endif
