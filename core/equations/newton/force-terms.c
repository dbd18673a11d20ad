/* Force elements and fields. */
#include <string.h>

#include "equations/newton/writer.h"
#include "law/build.h"

static const TinkerPointSymbols *point_at(const GArray *points, guint number)
{
    return &g_array_index(points, TinkerPointSymbols, number);
}

/* Force elements --------------------------------------------------------------------------------------------------- */

/* Minus the slope of a potential by the place of a body: by its x, its y or its angle. */
static TinkerExpression *force_along(TinkerEquationWriter *writer, const TinkerExpression *potential,
                                     const TinkerExpression *place)
{
    return place->kind == TINKER_EXPRESSION_SYMBOL ? tinker_writer_slope(writer, potential, place->name, -1)
                                                   : tinker_expression_number(0);
}

/* A component of a typed law, which is in plain numbers, as a definition of its own; `index` is NULL for the block's.
 */
static TinkerExpression *as_typed(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law,
                                  const char *index, const char *component, TinkerExpression *is)
{
    if (!law->typed || is == NULL || tinker_expression_is_number(is, 0)) return is;
    const char *name = index != NULL ? tinker_equations_free_name(writer->equations, block, "F", index, 0, component)
                                     : tinker_writer_name(writer, block, "F", 0, component);
    return tinker_writer_define(writer, name, block, tinker_force_dimension, "its force", is, TRUE);
}

gboolean tinker_writer_add_force(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    g_autoptr(GArray) points = tinker_writer_ends(writer, block);
    const gboolean connects =
        strcmp(tinker_scene_block_class(writer->scene, block)->type->category, TINKER_CONNECTOR) == 0;
    const TinkerTermKind kind = connects ? TINKER_TERM_CONNECTOR : TINKER_TERM_FORCE;
    TinkerLawUse use;
    tinker_law_use_init(&use, block, law);
    tinker_law_use_set_ends(writer, &use, points);
    const TinkerBodyEquation *body = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(point_at(points, 0)->block));
    if (law->typed && body != NULL) tinker_law_use_set(&use, "m", body->mass);
    g_autoptr(TinkerExpression) potential = NULL;
    gboolean known = TRUE;
    for (guint i = 0; i < points->len && known; i++) {
        const TinkerPointSymbols *point = point_at(points, i);
        g_autofree char *number = points->len == 1 ? g_strdup("") : g_strdup_printf("%u", i + 1);
        g_autofree char *along_x = g_strconcat("force_x", number, NULL),
                        *along_y = g_strconcat("force_y", number, NULL);
        TinkerExpression *x = tinker_law_use_equation(writer, &use, along_x);
        TinkerExpression *y = tinker_law_use_equation(writer, &use, along_y);
        g_autofree char *turn = g_strconcat("torque", number, NULL);
        TinkerExpression *torque = tinker_law_use_equation(writer, &use, turn);
        if (x == NULL && y == NULL && torque == NULL) {
            if (potential == NULL) {
                TinkerExpression *is = tinker_law_use_equation(writer, &use, "potential");
                known = is != NULL;
                if (!known) break;
                const TinkerDimension energy = {1, 2, -2, 0};
                const char *name = tinker_writer_name(writer, block, "V", 0, NULL);
                potential = tinker_writer_define(writer, name, block, energy, TINKER_STORED_ENERGY, is, law->typed);
            }
            x = force_along(writer, potential, point->x);
            y = force_along(writer, potential, point->y);
            torque = force_along(writer, potential, point->angle);
        }
        x = as_typed(writer, block, law, NULL, "x", x);
        y = as_typed(writer, block, law, NULL, "y", y);
        tinker_writer_add_term(writer, point, block, kind, x != NULL ? x : tinker_expression_number(0),
                               y != NULL ? y : tinker_expression_number(0), torque);
    }
    tinker_law_use_clear(&use);
    return known;
}

/* Fields ----------------------------------------------------------------------------------------------------------- */

/* Gives x, y, vx, vy, m their meaning for a body; with "2" behind them for another. */
static void set_body(TinkerEquationWriter *writer, TinkerLawUse *use, const TinkerBodyEquation *body,
                     const char *number)
{
    static const char *const names[] = {"x", "y", "vx", "vy"};
    const char *block = tinker_scene_block_name(writer->scene, body->block);
    for (int k = 0; k < 4; k++) {
        g_autofree char *of_state = g_strconcat(block, ".", names[k], NULL),
                        *of_law = g_strconcat(names[k], number, NULL);
        g_autoptr(TinkerExpression) symbol = tinker_expression_symbol(of_state);
        tinker_law_use_set(use, of_law, symbol);
    }
    g_autofree char *mass = g_strconcat("m", number, NULL);
    tinker_law_use_set(use, mass, body->mass);
}

static TinkerExpression *or_zero(TinkerExpression *expression)
{
    return expression != NULL ? expression : tinker_expression_number(0);
}

static void add_field_of_others(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law,
                                const TinkerBodyEquation *body)
{
    TinkerExpression *x = tinker_expression_number(0), *y = tinker_expression_number(0);
    for (guint i = 0; i < writer->equations->bodies->len; i++) {
        const TinkerBodyEquation *other = g_ptr_array_index(writer->equations->bodies, i);
        if (other == body) continue;
        g_autofree char *index = g_strdup_printf("%s,%s", tinker_writer_index(writer, body->block),
                                                 tinker_writer_index(writer, other->block));
        TinkerLawUse use;
        tinker_law_use_init(&use, block, law);
        use.index = index;
        set_body(writer, &use, body, "");
        set_body(writer, &use, other, "2");
        x = tinker_expression_plus(x, or_zero(tinker_law_use_equation(writer, &use, "pair_force_x")));
        y = tinker_expression_plus(y, or_zero(tinker_law_use_equation(writer, &use, "pair_force_y")));
        tinker_law_use_clear(&use);
    }
    const TinkerPointSymbols centre = {.block = body->block};
    tinker_writer_add_term(writer, &centre, block, TINKER_TERM_FIELD, x, y, NULL);
}

gboolean tinker_writer_add_field(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    const gboolean pairs = tinker_block_law_find(law, "pair_force_x") != NULL;
    const gboolean by_potential =
        tinker_block_law_find(law, "force_x") == NULL && tinker_block_law_find(law, "force_y") == NULL;
    if (!pairs && by_potential && tinker_block_law_find(law, "potential") == NULL) return FALSE;
    for (guint i = 0; i < writer->equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(writer->equations->bodies, i);
        if (pairs) {
            add_field_of_others(writer, block, law, body);
            continue;
        }
        TinkerLawUse use;
        tinker_law_use_init(&use, block, law);
        use.index = tinker_writer_index(writer, body->block);
        set_body(writer, &use, body, "");
        TinkerExpression *parts[2];
        static const char *const equations[] = {"force_x", "force_y"}, *const components[] = {"x", "y"};
        g_autoptr(TinkerExpression) potential =
            by_potential ? tinker_law_use_equation(writer, &use, "potential") : NULL;
        for (int axis = 0; axis < 2; axis++) {
            const TinkerExpression *place = g_hash_table_lookup(use.meanings, components[axis]);
            parts[axis] = by_potential ? force_along(writer, potential, place)
                                       : tinker_law_use_equation(writer, &use, equations[axis]);
            parts[axis] = as_typed(writer, block, law, use.index, components[axis], parts[axis]);
        }
        const TinkerPointSymbols centre = {.block = body->block};
        tinker_writer_add_term(writer, &centre, block, TINKER_TERM_FIELD, or_zero(parts[0]), or_zero(parts[1]), NULL);
        tinker_law_use_clear(&use);
    }
    return TRUE;
}
