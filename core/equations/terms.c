/* What blocks of each role do, as terms of bodies. */
#include <math.h>
#include <string.h>

#include "equations/writer-private.h"
#include "law/build.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

void tinker_writer_add_term(TinkerEquationWriter *writer, TinkerBlockId body, TinkerBlockId by, TinkerTermKind kind,
                            TinkerExpression *x, TinkerExpression *y)
{
    TinkerBodyEquation *equation = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(body));
    const gboolean nothing = tinker_expression_is_number(x, 0) && tinker_expression_is_number(y, 0);
    if (equation == NULL || nothing) {
        tinker_expression_unref(x);
        tinker_expression_unref(y);
        return;
    }
    const TinkerTerm term = {by, kind, x, y};
    g_array_append_val(equation->terms, term);
}

void tinker_writer_add_unwritten(TinkerEquationWriter *writer, TinkerBlockId block, TinkerTermKind kind,
                                 const char *why)
{
    static const char *const components[] = {"x", "y"};
    for (guint i = 0; i < writer->equations->bodies->len; i++) {
        const TinkerBlockId body = ((TinkerBodyEquation *)g_ptr_array_index(writer->equations->bodies, i))->block;
        double force[2];
        if (!tinker_model_state_force(writer->state, block, body, -1, force)) continue;
        TinkerExpression *parts[2];
        for (int axis = 0; axis < 2; axis++) {
            const char *name = tinker_writer_name(writer, block, "F", 0, components[axis]);
            tinker_writer_note_unwritten(writer, block, name, why);
            parts[axis] = tinker_writer_symbol(writer, name, block, force[axis], tinker_force_dimension, NULL, "force");
        }
        tinker_writer_add_term(writer, body, block, kind, parts[0], parts[1]);
    }
}

/* Ends ------------------------------------------------------------------------------------------------------------- */

static GArray *ends_of(TinkerEquationWriter *writer, TinkerBlockId block)
{
    GArray *points = g_array_new(FALSE, TRUE, sizeof(TinkerPointSymbols));
    g_array_set_clear_func(points, (GDestroyNotify)tinker_point_symbols_clear);
    g_array_set_size(points, (guint)tinker_scene_end_count(writer->scene, block));
    for (guint i = 0; i < points->len; i++)
        tinker_writer_end(writer, block, (int32_t)i, &g_array_index(points, TinkerPointSymbols, i));
    return points;
}

static const TinkerPointSymbols *point_at(const GArray *points, guint number)
{
    return &g_array_index(points, TinkerPointSymbols, number);
}

/* Gives x1, y1, vx1, vy1, ... their meaning; without numbers where there is one end. */
static void set_ends(TinkerLawUse *use, const GArray *points, gboolean velocities)
{
    for (guint i = 0; i < points->len; i++) {
        const TinkerPointSymbols *point = point_at(points, i);
        const TinkerExpression *const parts[] = {point->x, point->y, point->vx, point->vy};
        static const char *const names[] = {"x", "y", "vx", "vy"};
        for (int k = 0; k < (velocities ? 4 : 2); k++) {
            g_autofree char *name = points->len == 1 ? g_strdup(names[k]) : g_strdup_printf("%s%u", names[k], i + 1);
            tinker_law_use_set(use, name, parts[k]);
        }
    }
}

TinkerExpression *tinker_writer_length(TinkerEquationWriter *writer, TinkerBlockId block,
                                       const TinkerPointSymbols *points, int32_t count)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (int32_t i = 1; i < count; i++) {
        const TinkerPointSymbols *a = &points[i - 1], *b = &points[i];
        TinkerExpression *dx = tinker_expression_minus(copy(b->x), copy(a->x)),
                         *dy = tinker_expression_minus(copy(b->y), copy(a->y));
        sum = tinker_expression_plus(
            sum, tinker_expression_call(
                     "sqrt", tinker_expression_plus(tinker_expression_squared(dx), tinker_expression_squared(dy))));
    }
    const char *name = tinker_writer_name(writer, block, "L", 0, NULL);
    return tinker_writer_define(writer, name, block, tinker_length_dimension,
                                count == 2 ? "distance between the ends" : "length along the ends", sum, FALSE);
}

/* Line laws -------------------------------------------------------------------------------------------------------- */

/* dL/dt = d . (v_b - v_a) / L */
static TinkerExpression *rate_of(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerPointSymbols *a,
                                 const TinkerPointSymbols *b, const TinkerExpression *length)
{
    TinkerExpression *x = tinker_expression_times(tinker_expression_minus(copy(b->x), copy(a->x)),
                                                  tinker_expression_minus(copy(b->vx), copy(a->vx)));
    TinkerExpression *y = tinker_expression_times(tinker_expression_minus(copy(b->y), copy(a->y)),
                                                  tinker_expression_minus(copy(b->vy), copy(a->vy)));
    const char *name = tinker_writer_name(writer, block, "L", 1, NULL);
    return tinker_writer_define(writer, name, block, tinker_velocity_dimension, "rate at which that grows",
                                tinker_expression_over(tinker_expression_plus(x, y), copy(length)), FALSE);
}

/* T (x_other - x_own) / L */
static TinkerExpression *pull(const TinkerExpression *tension, const TinkerExpression *other,
                              const TinkerExpression *own, const TinkerExpression *length)
{
    return tinker_expression_times(
        copy(tension), tinker_expression_over(tinker_expression_minus(copy(other), copy(own)), copy(length)));
}

static gboolean law_names(const TinkerBlockLaw *law, const char *symbol)
{
    for (guint i = 0; i < law->definitions->len; i++)
        if (tinker_expression_uses(g_array_index(law->definitions, TinkerLawDefinition, i).is, symbol)) return TRUE;
    return FALSE;
}

/* For who writes equations of another form. */
static void keep_line(GPtrArray *list, TinkerBlockId block, const GArray *points, const TinkerExpression *length,
                      const TinkerExpression *rate, const TinkerExpression *tension)
{
    TinkerLineEquation *line = g_new0(TinkerLineEquation, 1);
    line->block = block;
    line->length = copy(length);
    line->rate = rate != NULL ? copy(rate) : NULL;
    line->tension = copy(tension);
    for (guint end = 0; end < 2; end++) {
        const TinkerPointSymbols *point = point_at(points, end);
        const TinkerExpression *const parts[] = {point->x, point->y, point->vx, point->vy};
        line->ends[end] = point->block;
        for (int axis = 0; axis < 2; axis++) {
            line->place[end][axis] = copy(parts[axis]);
            line->velocity[end][axis] = copy(parts[2 + axis]);
        }
    }
    g_ptr_array_add(list, line);
}

gboolean tinker_writer_add_line(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    if (tinker_block_law_find(law, "tension") == NULL) return FALSE;
    g_autoptr(GArray) points = ends_of(writer, block);
    const TinkerPointSymbols *a = point_at(points, 0), *b = point_at(points, 1);
    if ((a->block < 0 && b->block < 0) || a->block == b->block) return TRUE;
    const guint definitions = writer->equations->definitions->len;
    g_autoptr(TinkerExpression) length =
        tinker_writer_length(writer, block, (TinkerPointSymbols *)(void *)points->data, 2);
    g_autoptr(TinkerExpression) rate = law_names(law, "rate") ? rate_of(writer, block, a, b, length) : NULL;
    TinkerLawUse use;
    tinker_law_use_init(&use, block, law);
    tinker_law_use_set(&use, "L", length);
    if (rate != NULL) tinker_law_use_set(&use, "rate", rate);
    g_autoptr(TinkerExpression) is = tinker_law_use_equation(writer, &use, "tension");
    tinker_law_use_clear(&use);
    if (tinker_expression_is_number(is, 0)) {
        tinker_writer_drop_definitions(writer, definitions);
        return TRUE;
    }
    keep_line(writer->equations->lines, block, points, length, rate, is);
    const char *name = tinker_writer_name(writer, block, "T", 0, NULL);
    g_autoptr(TinkerExpression) tension =
        tinker_writer_define(writer, name, block, tinker_force_dimension, "tension", copy(is), FALSE);
    tinker_writer_add_term(writer, a->block, block, TINKER_TERM_CONNECTOR, pull(tension, b->x, a->x, length),
                           pull(tension, b->y, a->y, length));
    tinker_writer_add_term(writer, b->block, block, TINKER_TERM_CONNECTOR, pull(tension, a->x, b->x, length),
                           pull(tension, a->y, b->y, length));
    return TRUE;
}

/* Force elements --------------------------------------------------------------------------------------------------- */

/* The derivative of an expression by the place of a body; by its x or its y. */
static TinkerExpression *by_place(TinkerEquationWriter *writer, const TinkerExpression *expression,
                                  const TinkerExpression *place)
{
    return place->kind == TINKER_EXPRESSION_SYMBOL ? tinker_writer_derivative(writer, expression, place->name)
                                                   : tinker_expression_number(0);
}

gboolean tinker_writer_add_force(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    g_autoptr(GArray) points = ends_of(writer, block);
    const gboolean connects =
        strcmp(tinker_scene_block_class(writer->scene, block)->type->category, TINKER_CONNECTOR) == 0;
    const TinkerTermKind kind = connects ? TINKER_TERM_CONNECTOR : TINKER_TERM_FORCE;
    TinkerLawUse use;
    tinker_law_use_init(&use, block, law);
    set_ends(&use, points, TRUE);
    g_autoptr(TinkerExpression) potential = NULL;
    gboolean known = TRUE;
    for (guint i = 0; i < points->len && known; i++) {
        const TinkerPointSymbols *point = point_at(points, i);
        g_autofree char *number = points->len == 1 ? g_strdup("") : g_strdup_printf("%u", i + 1);
        g_autofree char *along_x = g_strconcat("force_x", number, NULL),
                        *along_y = g_strconcat("force_y", number, NULL);
        TinkerExpression *x = tinker_law_use_equation(writer, &use, along_x);
        TinkerExpression *y = tinker_law_use_equation(writer, &use, along_y);
        if (x == NULL && y == NULL) {
            if (potential == NULL) {
                TinkerExpression *is = tinker_law_use_equation(writer, &use, "potential");
                known = is != NULL;
                if (!known) break;
                const TinkerDimension energy = {1, 2, -2, 0};
                const char *name = tinker_writer_name(writer, block, "V", 0, NULL);
                potential = tinker_writer_define(writer, name, block, energy, "stored energy", is, FALSE);
            }
            x = tinker_expression_negated(by_place(writer, potential, point->x));
            y = tinker_expression_negated(by_place(writer, potential, point->y));
        }
        tinker_writer_add_term(writer, point->block, block, kind, x != NULL ? x : tinker_expression_number(0),
                               y != NULL ? y : tinker_expression_number(0));
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
    tinker_writer_add_term(writer, body->block, block, TINKER_TERM_FIELD, x, y);
}

gboolean tinker_writer_add_field(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    const gboolean pairs = tinker_block_law_find(law, "pair_force_x") != NULL;
    if (!pairs && tinker_block_law_find(law, "force_x") == NULL && tinker_block_law_find(law, "force_y") == NULL)
        return FALSE;
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
        TinkerExpression *x = tinker_law_use_equation(writer, &use, "force_x");
        TinkerExpression *y = tinker_law_use_equation(writer, &use, "force_y");
        tinker_writer_add_term(writer, body->block, block, TINKER_TERM_FIELD, or_zero(x), or_zero(y));
        tinker_law_use_clear(&use);
    }
    return TRUE;
}

/* Constraints ------------------------------------------------------------------------------------------------------ */

/* lambda that fits the forces which the run has on the bodies, by least squares over them; `gradient` has two
 * expressions an end. */
static double fitted(const TinkerEquationWriter *writer, TinkerBlockId block, const GPtrArray *gradient,
                     const GArray *points)
{
    double along = 0, square = 0;
    for (guint i = 0; i < points->len; i++) {
        const TinkerBlockId body = point_at(points, i)->block;
        double force[2];
        if (body < 0 || !tinker_model_state_force(writer->state, block, body, -1, force)) continue;
        for (guint axis = 0; axis < 2; axis++) {
            const double slope = tinker_equations_value(writer->equations, g_ptr_array_index(gradient, 2 * i + axis));
            along += slope * force[axis];
            square += slope * slope;
        }
    }
    return square > 0 ? along / square : 0;
}

static gboolean acts(const TinkerEquationWriter *writer, TinkerBlockId block)
{
    double force[2];
    gboolean any = FALSE;
    for (guint i = 0; i < writer->equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(writer->equations->bodies, i);
        if (tinker_model_state_force(writer->state, block, body->block, -1, force))
            any = any || force[0] != 0 || force[1] != 0;
    }
    return any;
}

/* dg/dx and dg/dy of each end; 0 where it is none of a body, or of one that has been seen before. (transfer full) */
static GPtrArray *gradient_of(TinkerEquationWriter *writer, const TinkerExpression *g, const GArray *points)
{
    GPtrArray *gradient = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    for (guint i = 0; i < points->len; i++) {
        const TinkerPointSymbols *point = point_at(points, i);
        gboolean none = point->block < 0;
        for (guint k = 0; k < i; k++)
            none = none || point_at(points, k)->block == point->block;
        g_ptr_array_add(gradient, none ? tinker_expression_number(0) : by_place(writer, g, point->x));
        g_ptr_array_add(gradient, none ? tinker_expression_number(0) : by_place(writer, g, point->y));
    }
    return gradient;
}

static gboolean holds_a_body(const GArray *points)
{
    for (guint i = 0; i < points->len; i++)
        if (point_at(points, i)->block >= 0) return TRUE;
    return FALSE;
}

/* Uses g up. */
static void add_row(TinkerEquationWriter *writer, TinkerBlockId block, TinkerExpression *g, TinkerDimension dimension,
                    const GArray *points)
{
    g_autoptr(GPtrArray) gradient = gradient_of(writer, g, points);
    const gboolean unilateral = tinker_scene_block_class(writer->scene, block)->physics->constraint->unilateral != 0;
    const char *name = tinker_writer_name(writer, block, "λ", 0, NULL);
    const TinkerDimension of_multiplier = {1, (int8_t)(2 - dimension.length), -2, 0};
    g_autoptr(TinkerExpression) multiplier = tinker_writer_symbol(
        writer, name, block, fitted(writer, block, gradient, points), of_multiplier, NULL, "multiplier");
    tinker_writer_add_row(writer, block, g, dimension, name, !unilateral || acts(writer, block));
    for (guint i = 0; i < points->len; i++)
        tinker_writer_add_term(writer, point_at(points, i)->block, block, TINKER_TERM_CONSTRAINT,
                               tinker_expression_times(copy(multiplier), copy(g_ptr_array_index(gradient, 2 * i))),
                               tinker_expression_times(copy(multiplier), copy(g_ptr_array_index(gradient, 2 * i + 1))));
}

void tinker_writer_add_row(TinkerEquationWriter *writer, TinkerBlockId block, TinkerExpression *g,
                           TinkerDimension dimension, const char *multiplier, gboolean active)
{
    TinkerConstraintEquation *row = g_new(TinkerConstraintEquation, 1);
    *row = (TinkerConstraintEquation){block, g, g_strdup(multiplier), dimension, active};
    g_ptr_array_add(writer->equations->constraints, row);
}

/* g = L - l of two ends, for good: a rod. */
static void keep_rod(TinkerEquationWriter *writer, TinkerBlockId block, const GArray *points, const TinkerExpression *g)
{
    const gboolean unilateral = tinker_scene_block_class(writer->scene, block)->physics->constraint->unilateral != 0;
    if (points->len != 2 || unilateral || g->kind != TINKER_EXPRESSION_SUM || g->count != 2) return;
    const TinkerExpression *length = g->parts[0], *kept = g->parts[1];
    if (length->kind != TINKER_EXPRESSION_SYMBOL || kept->kind != TINKER_EXPRESSION_NEGATIVE) return;
    const TinkerEquationDefinition *distance = g_hash_table_lookup(writer->by_name, length->name);
    if (distance == NULL || distance->block != block || kept->parts[0]->kind != TINKER_EXPRESSION_SYMBOL) return;
    keep_line(writer->equations->rods, block, points, length, NULL, kept->parts[0]);
}

gboolean tinker_writer_add_constraint(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    const int32_t rows = tinker_scene_block_class(writer->scene, block)->physics->constraint->rows;
    if (rows != 1 || tinker_block_law_find(law, "g") == NULL) return FALSE;
    g_autoptr(GArray) points = ends_of(writer, block);
    if (!holds_a_body(points)) return TRUE;
    TinkerLawUse use;
    tinker_law_use_init(&use, block, law);
    set_ends(&use, points, FALSE);
    if (law_names(law, "L")) {
        g_autoptr(TinkerExpression) length =
            tinker_writer_length(writer, block, (TinkerPointSymbols *)(void *)points->data, (int32_t)points->len);
        tinker_law_use_set(&use, "L", length);
    }
    TinkerExpression *g = tinker_law_use_equation(writer, &use, "g");
    tinker_law_use_clear(&use);
    keep_rod(writer, block, points, g);
    add_row(writer, block, g, tinker_length_dimension, points);
    return TRUE;
}
