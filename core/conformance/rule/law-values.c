/* Symbols of a law get their values from a state; what rounding takes is seen by shaking the last digits of them. */
#include "conformance/rule/law-values.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "law/derivative.h"
#include "law/value.h"

#define SHAKES 3 /* of the last digits, to see what rounding does */
#define SHAKEN 4 /* last digits */

/* x, y, vx, vy of a point; places are in the world. */
static double of_point(const KitLawPlace *place, const TinkerPoint *point, const char *quantity)
{
    const KitState *state = place->state;
    const gboolean velocity = quantity[0] == 'v', along_x = quantity[velocity ? 1 : 0] == 'x';
    const int axis = along_x ? 0 : 1;
    if (velocity) return place->at_rest ? 0 : along_x ? point->vx : point->vy;
    /* the points of fields are in the world already */
    const double origin = place->law->role == TINKER_LAW_FIELD ? 0 : state->origin[axis];
    return (along_x ? point->x : point->y) + origin;
}

/* What the role has for an end. Of a block that asks for no angles ends are as on point masses. */
static double of_end(const KitLawPlace *place, const TinkerLawSymbol *symbol)
{
    const KitState *state = place->state;
    const int32_t end = state->offsets[place->instance] + symbol->end;
    const gboolean angles = tinker_block_class_speaks_of_angles(state->block_class);
    const char *quantity = symbol->quantity;
    if (strcmp(quantity, "theta") == 0) return angles ? state->poses[end].angle : 0;
    if (strcmp(quantity, "omega") == 0) return angles && !place->at_rest ? state->poses[end].rate : 0;
    if (strcmp(quantity, "turns") == 0) return angles ? state->has_angle[end] : 0;
    if (strcmp(quantity, "theta_start") == 0) return angles ? state->placed_poses[end].angle : 0;
    const gboolean start = angles && g_str_has_suffix(quantity, "_start");
    return of_point(place, start ? &state->placed[end] : &state->points[end], quantity);
}

static double length_of(const KitLawPlace *place)
{
    const KitState *state = place->state;
    double sum = 0;
    if (place->law->role == TINKER_LAW_LINE) return state->lengths[place->instance];
    for (int32_t e = state->offsets[place->instance] + 1; e < state->offsets[place->instance + 1]; e++)
        sum += hypot(state->points[e].x - state->points[e - 1].x, state->points[e].y - state->points[e - 1].y);
    return sum;
}

static double of_role(const KitLawPlace *place, const char *symbol)
{
    const KitState *state = place->state;
    if (strcmp(symbol, "t") == 0) return state->time;
    if (strcmp(symbol, "L") == 0) return length_of(place);
    if (strcmp(symbol, "rate") == 0) return place->at_rest ? 0 : state->rates[place->instance];
    if (symbol[0] == 'm') return state->masses[symbol[1] == '2' ? place->other : place->body];
    const char last = symbol[strlen(symbol) - 1];
    return of_point(place, &state->bodies[last == '2' ? place->other : place->body], symbol);
}

static double value_at(const char *symbol, void *data)
{
    const KitLawPlace *place = data;
    const TinkerLawSymbol *known = tinker_block_law_symbol(place->law, symbol);
    if (known == NULL) return tinker_expression_value(tinker_block_law_find(place->law, symbol), value_at, data);
    double **columns = known->at_start ? place->state->placed_columns : place->state->columns;
    const double value = known->absent          ? 0
                         : known->property >= 0 ? columns[known->column][place->instance]
                         : known->end >= 0      ? of_end(place, known)
                                                : of_role(place, symbol);
    return place->shake == NULL ? value
                                : value * (1 + g_rand_double_range(place->shake, -SHAKEN, SHAKEN) * DBL_EPSILON);
}

double kit_law_value(const KitLawPlace *place, const TinkerExpression *expression, double *lost)
{
    const double value = tinker_expression_value(expression, value_at, (void *)place);
    g_autoptr(GRand) random = g_rand_new_with_seed(1);
    KitLawPlace shaken = *place;
    shaken.shake = random;
    for (int i = 0; i < SHAKES; i++)
        *lost = fmax(*lost, fabs(tinker_expression_value(expression, value_at, &shaken) - value));
    *lost = fmax(*lost, DBL_EPSILON * fabs(value));
    return value;
}

gboolean kit_law_turns_support(const TinkerBlockLaw *law)
{
    return law->role == TINKER_LAW_MOTION && tinker_block_law_find(law, "rotation") != NULL;
}

char *kit_law_name(const TinkerBlockLaw *law, int32_t component, int32_t number, int32_t count)
{
    static const char *const forces[] = {"force_x", "force_y"}, *const moves[] = {"displacement_x", "displacement_y"};
    g_autofree char *digits = count > 1 ? g_strdup_printf("%d", number + 1) : g_strdup("");
    switch (law->role) {
    case TINKER_LAW_LINE:
        return g_strdup("tension");
    case TINKER_LAW_FORCE:
        return g_strconcat(forces[component], digits, NULL);
    case TINKER_LAW_FIELD:
        return g_strdup(forces[component]);
    case TINKER_LAW_CONSTRAINT:
        return g_strconcat("g", digits, NULL);
    default:
        return g_strdup(kit_law_turns_support(law) ? "rotation" : moves[component]);
    }
}

typedef struct {
    const TinkerBlockLaw *law;
    const char *by;
} Gradient;

static TinkerExpression *through_steps(const char *symbol, void *data)
{
    const Gradient *gradient = data;
    if (strcmp(symbol, gradient->by) == 0) return tinker_expression_number(1);
    const TinkerExpression *step = tinker_block_law_find(gradient->law, symbol);
    return step != NULL ? tinker_expression_derivative(step, through_steps, data) : NULL;
}

TinkerExpression *kit_law_slope(const TinkerBlockLaw *law, const char *by)
{
    const TinkerExpression *is = tinker_block_law_find(law, "potential");
    Gradient gradient = {law, by};
    return is != NULL ? tinker_expression_derivative(is, through_steps, &gradient) : NULL;
}

TinkerExpression *kit_law_stated(const TinkerBlockLaw *law, int32_t component, int32_t number, int32_t count)
{
    g_autofree char *name = kit_law_name(law, component, number, count);
    const TinkerExpression *is = tinker_block_law_find(law, name);
    if (is != NULL) return tinker_expression_ref(is);
    if (law->role != TINKER_LAW_FORCE) return NULL;
    g_autofree char *turn = count > 1 ? g_strdup_printf("torque%d", number + 1) : g_strdup("torque");
    if (tinker_block_law_find(law, turn) != NULL) return tinker_expression_number(0);
    g_autofree char *by = count > 1 ? g_strdup_printf("%c%d", component == 0 ? 'x' : 'y', number + 1)
                                    : g_strdup(component == 0 ? "x" : "y");
    TinkerExpression *slope = kit_law_slope(law, by);
    return slope != NULL ? tinker_expression_negated(slope) : NULL;
}
