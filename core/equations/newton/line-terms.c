/* Connectors along a line: a tension over length and rate. */
#include "equations/newton/writer.h"
#include "law/build.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static const TinkerPointSymbols *point_at(const GArray *points, guint number)
{
    return &g_array_index(points, TinkerPointSymbols, number);
}

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

void tinker_writer_keep_line(GPtrArray *list, TinkerBlockId block, const GArray *points, const TinkerExpression *length,
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
            const TinkerExpression *local = axis == 0 ? point->local_x : point->local_y;
            line->local[end][axis] = local != NULL ? copy(local) : tinker_expression_number(0);
        }
    }
    g_ptr_array_add(list, line);
}

gboolean tinker_writer_add_line(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    const gboolean by_potential = tinker_block_law_find(law, "tension") == NULL;
    if (by_potential && tinker_block_law_find(law, "potential") == NULL) return FALSE;
    g_autoptr(GArray) points = tinker_writer_ends(writer, block);
    const TinkerPointSymbols *a = point_at(points, 0), *b = point_at(points, 1);
    const gboolean nothing = tinker_expression_equal(a->x, b->x) && tinker_expression_equal(a->y, b->y);
    if (nothing || (a->block < 0 && b->block < 0)) return TRUE;
    const guint definitions = writer->equations->definitions->len;
    g_autoptr(TinkerExpression) length =
        tinker_writer_length(writer, block, (TinkerPointSymbols *)(void *)points->data, 2);
    g_autoptr(TinkerExpression) rate =
        tinker_block_law_names(law, "rate") ? rate_of(writer, block, a, b, length) : NULL;
    TinkerLawUse use;
    tinker_law_use_init(&use, block, law);
    tinker_law_use_set(&use, "L", length);
    if (rate != NULL) tinker_law_use_set(&use, "rate", rate);
    g_autoptr(TinkerExpression) stated = tinker_law_use_equation(writer, &use, by_potential ? "potential" : "tension");
    g_autoptr(TinkerExpression) is = by_potential ? tinker_writer_slope(writer, stated, length->name, 1) : copy(stated);
    tinker_law_use_clear(&use);
    if (tinker_expression_is_number(is, 0)) {
        tinker_writer_drop_definitions(writer, definitions);
        return TRUE;
    }
    tinker_writer_keep_line(writer->equations->lines, block, points, length, rate, is);
    const char *name = tinker_writer_name(writer, block, "T", 0, NULL);
    g_autoptr(TinkerExpression) tension =
        tinker_writer_define(writer, name, block, tinker_force_dimension, "tension", copy(is), law->typed);
    tinker_writer_add_term(writer, a, block, TINKER_TERM_CONNECTOR, pull(tension, b->x, a->x, length),
                           pull(tension, b->y, a->y, length), NULL);
    tinker_writer_add_term(writer, b, block, TINKER_TERM_CONNECTOR, pull(tension, a->x, b->x, length),
                           pull(tension, a->y, b->y, length), NULL);
    return TRUE;
}
