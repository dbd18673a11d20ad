/* Bodies on fixed axes: one coordinate for what turns together. What a gear or a weld says of two angles,
 * s_a theta_a + s_b theta_b = constant, makes each of them a multiple of the first one's, theta = ratio q + constant,
 * and its torque acts on that one as the ratio times itself (the work is the same). The plan knows as shafts what has
 * such rows over angles alone, none of which gainsays another. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "equations/matrix/matrix-entries.h"
#include "law/build.h"
#include "law/derivative.h"

typedef struct {
    const TinkerBodyEquation *equation;
    int leader;                 /* which of them it turns with: itself, or one before it */
    TinkerExpression *ratio;    /* how far it turns while that turns by 1 */
    TinkerExpression *state[2]; /* its angle and its rate */
    TinkerExpression *constant; /* rad: its angle where q is 0 */
} Shaft;

static void shaft_clear(void *data)
{
    Shaft *shaft = data;
    tinker_expression_unref(shaft->ratio);
    tinker_expression_unref(shaft->state[0]);
    tinker_expression_unref(shaft->state[1]);
    g_clear_pointer(&shaft->constant, tinker_expression_unref);
}

static Shaft *shaft_at(const GArray *shafts, guint number)
{
    return &g_array_index(shafts, Shaft, number);
}

/* Of each body of the island that turns, by itself as yet. (transfer full) */
static GArray *shafts_of(const TinkerMatrixBuilder *builder)
{
    GArray *shafts = g_array_new(FALSE, TRUE, sizeof(Shaft));
    g_array_set_clear_func(shafts, shaft_clear);
    for (guint i = 0; i < builder->island->blocks->len; i++) {
        const TinkerBlockId block = g_array_index(builder->island->blocks, TinkerBlockId, i);
        const TinkerBodyEquation *equation = tinker_matrix_equation_of(builder, block);
        if (equation == NULL || equation->inertia == NULL) continue;
        const Shaft shaft = {.equation = equation,
                             .leader = (int)shafts->len,
                             .ratio = tinker_expression_number(1),
                             .state = {tinker_matrix_state_symbol(builder, block, "angle"),
                                       tinker_matrix_state_symbol(builder, block, "rate")}};
        g_array_append_val(shafts, shaft);
    }
    return shafts;
}

/* Angles -----------------------------------------------------------------------------------------------------------
 */

/* What turns with shaft b turns with what shaft a turns with, from now on. */
static void follow(GArray *shafts, const Shaft *a, const TinkerExpression *slope_a, const Shaft *b,
                   const TinkerExpression *slope_b)
{
    const int from = b->leader, to = a->leader;
    g_autoptr(TinkerExpression) ratio = tinker_expression_negated(tinker_expression_over(
        tinker_expression_times(tinker_expression_ref((TinkerExpression *)slope_a), tinker_expression_ref(a->ratio)),
        tinker_expression_times(tinker_expression_ref((TinkerExpression *)slope_b), tinker_expression_ref(b->ratio))));
    for (guint i = 0; i < shafts->len; i++) {
        Shaft *shaft = shaft_at(shafts, i);
        if (shaft->leader != from) continue;
        shaft->leader = to;
        shaft->ratio = tinker_expression_times(shaft->ratio, tinker_expression_ref(ratio));
    }
}

/* What one constraint says of the angles. */
static void take_constraint(TinkerMatrixBuilder *builder, GArray *shafts, const TinkerConstraintEquation *constraint)
{
    g_autoptr(TinkerExpression) g = tinker_matrix_written_out(builder, constraint->g);
    const Shaft *tied[2] = {NULL, NULL};
    int count = 0;
    for (guint i = 0; i < shafts->len; i++)
        if (tinker_expression_uses(g, shaft_at(shafts, i)->state[0]->name) && count++ < 2)
            tied[count - 1] = shaft_at(shafts, i);
    if (count == 1 || count > 2) builder->why = "a constraint holds it";
    if (count != 2 || tied[0]->leader == tied[1]->leader) return; /* or it says once more what is known */
    g_autoptr(TinkerExpression) first = tinker_expression_derivative_by(g, tied[0]->state[0]->name);
    g_autoptr(TinkerExpression) second = tinker_expression_derivative_by(g, tied[1]->state[0]->name);
    if (tied[0]->leader < tied[1]->leader)
        follow(shafts, tied[0], first, tied[1], second);
    else
        follow(shafts, tied[1], second, tied[0], first);
}

/* Of what turns with another the angle at q = 0 is what that leaves of its angle now. */
static void find_constants(const TinkerMatrixBuilder *builder, GArray *shafts)
{
    for (guint i = 0; i < shafts->len; i++) {
        Shaft *shaft = shaft_at(shafts, i);
        const double angle = tinker_equations_value(builder->equations, shaft->state[0]);
        const double turned =
            tinker_equations_value(builder->equations, shaft->ratio) *
            tinker_equations_value(builder->equations, shaft_at(shafts, (guint)shaft->leader)->state[0]);
        const double rounding = 8 * DBL_EPSILON * (fabs(angle) + fabs(turned));
        shaft->constant = tinker_expression_number(fabs(angle - turned) <= rounding ? 0 : angle - turned);
    }
}

/* Entries ----------------------------------------------------------------------------------------------------------
 */

/* A shaft's angle and rate where all coordinates are 0. */
static TinkerExpression *at_zero(const char *symbol, void *data)
{
    const GArray *shafts = data;
    for (guint i = 0; i < shafts->len; i++) {
        const Shaft *shaft = shaft_at(shafts, i);
        if (strcmp(symbol, shaft->state[0]->name) == 0) return tinker_expression_ref(shaft->constant);
        if (strcmp(symbol, shaft->state[1]->name) == 0) return tinker_expression_number(0);
    }
    return NULL;
}

static guint coordinate_of(const TinkerMatrixBuilder *builder, const GArray *shafts, const Shaft *shaft)
{
    return (guint)tinker_matrix_coordinate_of(builder, shaft_at(shafts, (guint)shaft->leader)->equation->block);
}

static void add_torque(TinkerMatrixBuilder *builder, const GArray *shafts, const Shaft *own,
                       const TinkerExpression *torque)
{
    static const TinkerMatrixKind kinds[] = {TINKER_MATRIX_STIFFNESS, TINKER_MATRIX_DAMPING};
    const guint row = coordinate_of(builder, shafts, own);
    g_autoptr(TinkerExpression) written = tinker_matrix_written_out(builder, torque);
    for (guint i = 0; i < shafts->len; i++) {
        const Shaft *shaft = shaft_at(shafts, i);
        for (int order = 0; order < 2; order++) {
            if (!tinker_expression_uses(written, shaft->state[order]->name)) continue;
            g_autoptr(TinkerExpression) slope = tinker_expression_derivative_by(written, shaft->state[order]->name);
            if (tinker_matrix_uses_state(builder, slope)) builder->why = "a torque on it is not linear";
            TinkerExpression *entry = tinker_expression_times(
                tinker_expression_times(tinker_expression_ref(own->ratio), tinker_expression_ref(slope)),
                tinker_expression_ref(shaft->ratio));
            tinker_matrix_add(builder, kinds[order], row, coordinate_of(builder, shafts, shaft),
                              tinker_expression_negated(entry));
        }
    }
    tinker_matrix_add_load(builder, row,
                           tinker_expression_times(tinker_expression_ref(own->ratio),
                                                   tinker_expression_replace(written, at_zero, (void *)shafts)));
}

static void add_shaft(TinkerMatrixBuilder *builder, const GArray *shafts, const Shaft *shaft)
{
    const guint row = coordinate_of(builder, shafts, shaft);
    TinkerExpression *inertia = tinker_expression_ref(shaft->equation->inertia);
    if (!tinker_expression_is_number(shaft->ratio, 1))
        inertia = tinker_expression_times(tinker_expression_squared(tinker_expression_ref(shaft->ratio)), inertia);
    tinker_matrix_add(builder, TINKER_MATRIX_MASS, row, row, inertia);
    for (guint k = 0; k < shaft->equation->terms->len; k++) {
        const TinkerTerm *term = &g_array_index(shaft->equation->terms, TinkerTerm, k);
        if (term->kind == TINKER_TERM_NORMAL) builder->why = "it lies on something";
        if (term->kind != TINKER_TERM_CONSTRAINT && term->torque != NULL)
            add_torque(builder, shafts, shaft, term->torque);
    }
}

GArray *tinker_matrix_shafts(TinkerMatrixBuilder *builder)
{
    GArray *shafts = shafts_of(builder);
    for (guint i = 0; i < builder->equations->constraints->len; i++)
        take_constraint(builder, shafts, g_ptr_array_index(builder->equations->constraints, i));
    for (guint i = 0; i < shafts->len; i++)
        if (shaft_at(shafts, i)->leader == (int)i)
            tinker_matrix_add_angle(builder, shaft_at(shafts, i)->equation->block);
    find_constants(builder, shafts);
    return shafts;
}

void tinker_matrix_add_shafts(TinkerMatrixBuilder *builder, const GArray *shafts)
{
    for (guint i = 0; i < shafts->len; i++)
        add_shaft(builder, shafts, shaft_at(shafts, i));
}
