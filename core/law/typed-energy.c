/* What typed laws do to energy. */
#include <string.h>

#include "law/build.h"
#include "law/derivative.h"
#include "law/integral.h"
#include "law/simplify.h"
#include "law/typed-law.h"

static const char *const velocities[] = {"rate", "vx", "vy", NULL};

static TinkerExpression *at_rest(const char *symbol, G_GNUC_UNUSED void *data)
{
    return g_strv_contains(velocities, symbol) ? tinker_expression_number(0) : NULL;
}

typedef struct {
    int32_t property;
    TinkerTypedLaw *law;
    TinkerExpression *still; /* the law at rest; a number where nothing is typed */
} Typed;

static Typed find(const TinkerBlockClass *block_class, TinkerTypedLaw **laws, const char *id,
                  TinkerTypedLawTextFunc text_of, void *data)
{
    Typed typed = {-1, NULL, NULL};
    for (int32_t p = 0; p < block_class->property_count && typed.law == NULL; p++) {
        const TinkerPropertyType *type = &block_class->properties[p];
        if ((type->flags & TINKER_TEXT_LAW) == 0) continue;
        if (*laws != NULL && strcmp(type->id, id) == 0) typed = (Typed){p, *laws, NULL};
        laws++;
    }
    g_autoptr(TinkerExpression) is =
        typed.law != NULL ? tinker_typed_folded(block_class, typed.property, text_of, data, NULL) : NULL;
    typed.still = is != NULL ? tinker_expression_folded(is, at_rest, NULL) : tinker_expression_number(0);
    return typed;
}

/* Takes the energy over. */
static void keep(const TinkerBlockClass *block_class, const Typed *typed, TinkerExpression *stored)
{
    const TinkerPropertyType *type = &block_class->properties[typed->property];
    typed->law->stored = tinker_compiled_new(stored, type->choices, type->choice_count);
    tinker_expression_unref(stored);
}

/* V of force_x = -dV/dx and force_y = -dV/dy; NULL: none is found. (transfer full) */
static TinkerExpression *potential_of(const TinkerExpression *x, const TinkerExpression *y)
{
    g_autoptr(TinkerExpression) along_x = tinker_expression_integral(x, "x");
    if (along_x == NULL) return NULL;
    /* what force_y has beside that is to depend on y alone */
    g_autoptr(TinkerExpression) rest =
        tinker_expression_minus(tinker_expression_ref(y), tinker_expression_derivative_by(along_x, "y"));
    g_autoptr(TinkerExpression) left = tinker_expression_simplified(rest);
    g_autoptr(TinkerExpression) along_y =
        tinker_expression_uses(left, "x") ? NULL : tinker_expression_integral(left, "y");
    if (along_y == NULL) return NULL;
    return tinker_expression_negated(tinker_expression_plus(g_steal_pointer(&along_x), g_steal_pointer(&along_y)));
}

static void find_of_forces(const TinkerBlockClass *block_class, TinkerTypedLaw **laws, TinkerTypedLawTextFunc text_of,
                           void *data)
{
    Typed x = find(block_class, laws, "force_x", text_of, data), y = find(block_class, laws, "force_y", text_of, data);
    const gboolean timed = tinker_expression_uses(x.still, "t") || tinker_expression_uses(y.still, "t");
    TinkerExpression *stored = timed || (x.law == NULL && y.law == NULL) ? NULL : potential_of(x.still, y.still);
    if (stored != NULL) keep(block_class, x.law != NULL ? &x : &y, stored);
    tinker_expression_unref(x.still);
    tinker_expression_unref(y.still);
}

void tinker_typed_find_energy(const TinkerBlockClass *block_class, TinkerTypedLaw **laws,
                              TinkerTypedLawTextFunc text_of, void *data)
{
    Typed potential = find(block_class, laws, "potential", text_of, data);
    if (potential.law != NULL) keep(block_class, &potential, tinker_expression_ref(potential.still));
    tinker_expression_unref(potential.still);
    Typed tension = find(block_class, laws, "tension", text_of, data);
    TinkerExpression *stored = tension.law == NULL || tinker_expression_uses(tension.still, "t")
                                   ? NULL
                                   : tinker_expression_integral(tension.still, "L");
    if (stored != NULL) keep(block_class, &tension, stored);
    tinker_expression_unref(tension.still);
    find_of_forces(block_class, laws, text_of, data);
}
