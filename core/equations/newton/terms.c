/* Terms of bodies, and the ends of blocks that they act at. */
#include <string.h>

#include "equations/newton/writer.h"
#include "law/build.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

/* The moment of a force about the body's centre: r x F. */
static TinkerExpression *moment_of(const TinkerPointSymbols *point, const TinkerExpression *x,
                                   const TinkerExpression *y)
{
    if (point->arm_x == NULL) return tinker_expression_number(0);
    return tinker_expression_minus(tinker_expression_times(copy(point->arm_x), copy(y)),
                                   tinker_expression_times(copy(point->arm_y), copy(x)));
}

void tinker_writer_add_term(TinkerEquationWriter *writer, const TinkerPointSymbols *at, TinkerBlockId by,
                            TinkerTermKind kind, TinkerExpression *x, TinkerExpression *y, TinkerExpression *torque)
{
    TinkerBodyEquation *equation = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(at->block));
    const gboolean turns = equation != NULL && equation->inertia != NULL;
    TinkerExpression *moment = moment_of(at, x, y);
    if (torque != NULL) moment = tinker_expression_plus(moment, torque);
    const gboolean nothing = tinker_expression_is_number(x, 0) && tinker_expression_is_number(y, 0) &&
                             (!turns || tinker_expression_is_number(moment, 0));
    TinkerTerm term = {by, kind, x, y, moment};
    if (!turns) g_clear_pointer(&term.torque, tinker_expression_unref);
    if (equation == NULL || nothing)
        tinker_term_clear(&term);
    else
        g_array_append_val(equation->terms, term);
}

void tinker_term_clear(void *data)
{
    TinkerTerm *term = data;
    tinker_expression_unref(term->x);
    tinker_expression_unref(term->y);
    g_clear_pointer(&term->torque, tinker_expression_unref);
}

/* What no law says: numbers of the run. */
typedef struct {
    TinkerBlockId block;
    const char *index; /* of the names; NULL: that of the block */
    const char *why;
} Unwritten;

static TinkerExpression *unwritten(TinkerEquationWriter *writer, const Unwritten *of, const char *stem,
                                   const char *component, double value, TinkerDimension dimension)
{
    const char *name = of->index == NULL
                           ? tinker_writer_name(writer, of->block, stem, 0, component)
                           : tinker_equations_free_name(writer->equations, of->block, stem, of->index, 0, component);
    tinker_writer_note_unwritten(writer, of->block, name, of->why);
    return tinker_writer_symbol(writer, name, of->block, value, dimension, NULL,
                                dimension.length == 1 ? "force" : "torque");
}

/* "block,body" of what acts on several bodies; NULL of what acts on one. (transfer full) */
static char *index_of_unwritten(const TinkerEquationWriter *writer, TinkerBlockId block, TinkerBlockId body)
{
    const char *own = tinker_writer_index(writer, block), *of_body = tinker_writer_index(writer, body);
    double force[3];
    guint acted_on = 0;
    for (guint i = 0; i < writer->equations->bodies->len; i++) {
        const TinkerBodyEquation *each = g_ptr_array_index(writer->equations->bodies, i);
        acted_on += tinker_model_state_force(writer->state, block, each->block, force);
    }
    return acted_on > 1 ? g_strconcat(own, own[0] != '\0' && of_body[0] != '\0' ? "," : "", of_body, NULL) : NULL;
}

void tinker_writer_add_unwritten(TinkerEquationWriter *writer, TinkerBlockId block, TinkerTermKind kind,
                                 const char *why)
{
    static const char *const components[] = {"x", "y"};
    for (guint i = 0; i < writer->equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(writer->equations->bodies, i);
        double force[3];
        if (!tinker_model_state_force(writer->state, block, body->block, force)) continue;
        const TinkerPointSymbols centre = {.block = body->block};
        g_autofree char *index = index_of_unwritten(writer, block, body->block);
        const Unwritten of = {block, index, why};
        TinkerExpression *parts[3] = {NULL, NULL, NULL};
        for (int axis = 0; axis < 2; axis++)
            parts[axis] = unwritten(writer, &of, "F", components[axis], force[axis], tinker_force_dimension);
        if (body->inertia != NULL) parts[2] = unwritten(writer, &of, "τ", NULL, force[2], tinker_torque_dimension);
        tinker_writer_add_term(writer, &centre, block, kind, parts[0], parts[1], parts[2]);
    }
}

/* Ends ------------------------------------------------------------------------------------------------------------- */

GArray *tinker_writer_ends(TinkerEquationWriter *writer, TinkerBlockId block)
{
    GArray *points = g_array_new(FALSE, TRUE, sizeof(TinkerPointSymbols));
    g_array_set_clear_func(points, (GDestroyNotify)tinker_point_symbols_clear);
    g_array_set_size(points, (guint)tinker_scene_end_count(writer->scene, block));
    for (guint i = 0; i < points->len; i++)
        tinker_writer_end(writer, block, (int32_t)i, &g_array_index(points, TinkerPointSymbols, i));
    return points;
}

/* What the law's symbol of an end stands for; NULL: it is none of these. (transfer full) */
static TinkerExpression *meaning_of_end(TinkerEquationWriter *writer, TinkerBlockId block, guint number,
                                        const TinkerPointSymbols *point, const char *quantity)
{
    const struct {
        const char *name;
        const TinkerExpression *is;
    } known[] = {{"x", point->x},   {"y", point->y},         {"vx", point->vx},
                 {"vy", point->vy}, {"theta", point->angle}, {"omega", point->rate}};
    for (gsize i = 0; i < G_N_ELEMENTS(known); i++)
        if (strcmp(known[i].name, quantity) == 0) return copy(known[i].is);
    const TinkerBodyEquation *body = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(point->block));
    if (strcmp(quantity, "turns") == 0) return tinker_expression_number(body == NULL || body->inertia != NULL ? 1 : 0);
    if (!g_str_has_suffix(quantity, "_start")) return NULL;
    return tinker_writer_start(writer, block, (int32_t)number, quantity[0]);
}

void tinker_law_use_set_ends(TinkerEquationWriter *writer, TinkerLawUse *use, const GArray *points)
{
    for (guint i = 0; i < use->law->symbols->len; i++) {
        const TinkerLawSymbol *symbol = &g_array_index(use->law->symbols, TinkerLawSymbol, i);
        if (symbol->end < 0 || (guint)symbol->end >= points->len || !tinker_block_law_names(use->law, symbol->name))
            continue;
        const TinkerPointSymbols *point = &g_array_index(points, TinkerPointSymbols, symbol->end);
        g_autoptr(TinkerExpression) is =
            meaning_of_end(writer, use->block, (guint)symbol->end, point, symbol->quantity);
        if (is != NULL) tinker_law_use_set(use, symbol->name, is);
    }
}

static TinkerExpression *distance_of(const TinkerPointSymbols *a, const TinkerPointSymbols *b)
{
    TinkerExpression *dx = tinker_expression_minus(copy(b->x), copy(a->x)),
                     *dy = tinker_expression_minus(copy(b->y), copy(a->y));
    return tinker_expression_call("sqrt",
                                  tinker_expression_plus(tinker_expression_squared(dx), tinker_expression_squared(dy)));
}

/* A part of a rope, from its end of this number to the next. Takes its length over. */
static TinkerExpression *define_span(TinkerEquationWriter *writer, TinkerBlockId block, int32_t number,
                                     TinkerExpression *length)
{
    const char *of_block = tinker_writer_index(writer, block);
    g_autofree char *index = g_strdup_printf("%s%s%d", of_block, of_block[0] != '\0' ? "," : "", number);
    g_autofree char *means = g_strdup_printf("distance from its end %d to its end %d", number, number + 1);
    const char *name = tinker_equations_free_name(writer->equations, block, "L", index, 0, NULL);
    const guint before = writer->equations->definitions->len;
    TinkerExpression *symbol = tinker_writer_define(writer, name, block, tinker_length_dimension, means, length, FALSE);
    ((TinkerEquationDefinition *)g_ptr_array_index(writer->equations->definitions, before))->span = number;
    return symbol;
}

TinkerExpression *tinker_writer_length(TinkerEquationWriter *writer, TinkerBlockId block,
                                       const TinkerPointSymbols *points, int32_t count)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (int32_t i = 1; i < count; i++) {
        TinkerExpression *distance = distance_of(&points[i - 1], &points[i]);
        sum = tinker_expression_plus(sum, count == 2 ? distance : define_span(writer, block, i, distance));
    }
    const char *name = tinker_writer_name(writer, block, "L", 0, NULL);
    return tinker_writer_define(writer, name, block, tinker_length_dimension,
                                count == 2 ? "distance between the ends" : "length along the ends", sum, FALSE);
}
