/* Constraints: rows g = 0, each with a multiplier, which acts on the ends along the row's gradient. The gradient is by
 * the places of the ends, and by the angles as far as the law names them: what a force at an end does to its body by
 * its arm is that force's moment. */
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"
#include "law/build.h"

/* Numbers, symbols and signs of a slope that is given a name. */
#define LONG_SLOPE 30

/* Slopes of one row at one end. */
enum { BY_X, BY_Y, BY_ANGLE, SLOPES };

typedef struct {
    TinkerBlockId block;
    const GArray *points;
    GPtrArray *slopes; /* of TinkerExpression: row by row, SLOPES an end */
    int32_t rows;
} Rows;

static const TinkerPointSymbols *point_at(const GArray *points, guint number)
{
    return &g_array_index(points, TinkerPointSymbols, number);
}

static TinkerExpression *slope_at(const Rows *rows, int32_t row, guint end, int which)
{
    return g_ptr_array_index(rows->slopes, ((guint)row * rows->points->len + end) * SLOPES + (guint)which);
}

/* The first end at the same place of the same body, of which the slopes are those of both; of the same body, for its
 * angle. */
static guint first_alike(const GArray *points, guint number, int which)
{
    const TinkerPointSymbols *point = point_at(points, number);
    for (guint i = 0; i < number; i++) {
        const TinkerPointSymbols *other = point_at(points, i);
        const gboolean same =
            tinker_expression_equal(other->x, point->x) && tinker_expression_equal(other->y, point->y);
        if (other->block == point->block && (same || which == BY_ANGLE)) return i;
    }
    return number;
}

static int size_of(const TinkerExpression *expression)
{
    int size = 1;
    for (int i = 0; i < expression->count; i++)
        size += size_of(expression->parts[i]);
    return size;
}

/* The slope itself, or a name for it where it is long: it stands beside others in the equation of a body. Takes it
 * over. */
static TinkerExpression *named_slope(TinkerEquationWriter *writer, const Rows *rows, guint end, int which,
                                     TinkerExpression *slope)
{
    static const char *const components[SLOPES] = {"x", "y", NULL};
    const char *of_block = tinker_writer_index(writer, rows->block);
    if (size_of(slope) <= LONG_SLOPE || which == BY_ANGLE) return slope;
    g_autofree char *index = g_strdup_printf("%s%s%u", of_block, of_block[0] != '\0' ? "," : "", end + 1);
    const char *name = tinker_equations_free_name(writer->equations, rows->block, "e", index, 0, components[which]);
    return tinker_writer_define(writer, name, rows->block, tinker_pure_dimension, "direction at that end", slope,
                                FALSE);
}

/* Adds SLOPES expressions an end: 0 where it is on no body, or like one before it. */
static void add_slopes(TinkerEquationWriter *writer, Rows *rows, const TinkerExpression *g)
{
    for (guint i = 0; i < rows->points->len; i++) {
        const TinkerPointSymbols *point = point_at(rows->points, i);
        const TinkerExpression *const by[] = {point->x, point->y, point->angle};
        for (int k = 0; k < SLOPES; k++) {
            const gboolean none =
                point->block < 0 || by[k]->kind != TINKER_EXPRESSION_SYMBOL || first_alike(rows->points, i, k) != i;
            g_ptr_array_add(rows->slopes,
                            none ? tinker_expression_number(0)
                                 : named_slope(writer, rows, i, k, tinker_writer_derivative(writer, g, by[k]->name)));
        }
    }
}

/* The multipliers that fit the forces which the run has at the ends, by least squares; of several fits the smallest.
 * (transfer full) */
static double *fitted(const TinkerEquationWriter *writer, const Rows *rows)
{
    const lapack_int count = (lapack_int)rows->points->len * SLOPES, n = rows->rows, most = MAX(count, n);
    g_autofree double *matrix = g_new0(double, count *n), *values = g_new0(double, n);
    double *forces = g_new0(double, most);
    lapack_int rank = 0;
    for (lapack_int i = 0; i < count; i++)
        for (int32_t r = 0; r < n; r++)
            matrix[i * n + r] =
                tinker_equations_value(writer->equations, slope_at(rows, r, (guint)(i / SLOPES), (int)(i % SLOPES)));
    for (guint i = 0; i < rows->points->len; i++) {
        const TinkerPointSymbols *point = point_at(rows->points, i);
        const double place[] = {tinker_equations_value(writer->equations, point->x),
                                tinker_equations_value(writer->equations, point->y)};
        double force[3];
        if (point->block < 0 || !tinker_model_state_end_force(writer->state, rows->block, (int32_t)i, place, force))
            continue;
        for (int k = 0; k < SLOPES; k++)
            forces[first_alike(rows->points, i, k) * SLOPES + (guint)k] += force[k];
    }
    if (LAPACKE_dgelsd(LAPACK_ROW_MAJOR, count, n, 1, matrix, n, forces, 1, values, 1e-12, &rank) != 0)
        memset(forces, 0, sizeof *forces * (gsize)most);
    return forces;
}

static gboolean acts(const TinkerEquationWriter *writer, const Rows *rows)
{
    for (guint i = 0; i < rows->points->len; i++) {
        double force[3];
        if (tinker_model_state_end_force(writer->state, rows->block, (int32_t)i, NULL, force) &&
            (force[0] != 0 || force[1] != 0 || force[2] != 0))
            return TRUE;
    }
    return FALSE;
}

static gboolean holds_a_body(const GArray *points)
{
    for (guint i = 0; i < points->len; i++)
        if (point_at(points, i)->block >= 0) return TRUE;
    return FALSE;
}

/* Multiplier times slope, of all rows. (transfer full) */
static TinkerExpression *pull_of(const Rows *rows, TinkerExpression *const *multipliers, guint end, int which)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (int32_t r = 0; r < rows->rows; r++) {
        TinkerExpression *part = tinker_expression_times(tinker_expression_ref(multipliers[r]),
                                                         tinker_expression_ref(slope_at(rows, r, end, which)));
        sum = tinker_expression_plus(sum, part);
    }
    return sum;
}

static void add_terms(TinkerEquationWriter *writer, const Rows *rows, TinkerExpression *const *multipliers)
{
    for (guint i = 0; i < rows->points->len; i++)
        tinker_writer_add_term(writer, point_at(rows->points, i), rows->block, TINKER_TERM_CONSTRAINT,
                               pull_of(rows, multipliers, i, BY_X), pull_of(rows, multipliers, i, BY_Y),
                               pull_of(rows, multipliers, i, BY_ANGLE));
}

/* The torques of its friction: their values, of which no law is written. */
static void add_friction(TinkerEquationWriter *writer, const Rows *rows)
{
    for (guint i = 0; i < rows->points->len; i++) {
        double force[3];
        if (point_at(rows->points, i)->block < 0 ||
            !tinker_model_state_end_force(writer->state, rows->block, (int32_t)i, NULL, force) || force[2] == 0)
            continue;
        const TinkerDimension dimension = TINKER_DIMENSION_ENERGY;
        const TinkerPointSymbols centre = {.block = point_at(rows->points, i)->block};
        g_autofree char *stem = g_strdup_printf("M%u", i + 1);
        const char *name = tinker_writer_name(writer, rows->block, stem, 0, NULL);
        tinker_writer_note_unwritten(writer, rows->block, name, "the torque of its friction is a number here");
        TinkerExpression *torque =
            tinker_writer_symbol(writer, name, rows->block, force[2], dimension, NULL, "torque of friction");
        tinker_writer_add_term(writer, &centre, rows->block, TINKER_TERM_FRICTION, tinker_expression_number(0),
                               tinker_expression_number(0), torque);
    }
}

/* What the row does to each coordinate, for finding rows that depend on others. */
static void note_slopes(TinkerEquationWriter *writer, const Rows *rows, int32_t row)
{
    const TinkerEquations *equations = writer->equations;
    for (guint i = 0; i < rows->points->len; i++) {
        const TinkerPointSymbols *point = point_at(rows->points, i);
        double slope[SLOPES];
        for (int k = 0; k < SLOPES; k++)
            slope[k] = tinker_equations_value(equations, slope_at(rows, row, i, k));
        if (point->arm_x != NULL)
            slope[BY_ANGLE] += tinker_equations_value(equations, point->arm_x) * slope[BY_Y] -
                               tinker_equations_value(equations, point->arm_y) * slope[BY_X];
        tinker_writer_note_slope(writer, point->block, slope);
    }
}

/* g = L - l of two ends, for good: a rod. */
static void keep_rod(TinkerEquationWriter *writer, const Rows *rows, const TinkerExpression *g)
{
    const gboolean unilateral =
        tinker_scene_block_class(writer->scene, rows->block)->physics->constraint->unilateral != 0;
    if (rows->points->len != 2 || unilateral || g->kind != TINKER_EXPRESSION_SUM || g->count != 2) return;
    const TinkerExpression *length = g->parts[0], *kept = g->parts[1];
    if (length->kind != TINKER_EXPRESSION_SYMBOL || kept->kind != TINKER_EXPRESSION_NEGATIVE) return;
    const TinkerEquationDefinition *distance = g_hash_table_lookup(writer->by_name, length->name);
    if (distance == NULL || distance->block != rows->block || kept->parts[0]->kind != TINKER_EXPRESSION_SYMBOL) return;
    tinker_writer_keep_line(writer->equations->rods, rows->block, rows->points, length, NULL, kept->parts[0]);
}

/* x2 - x1 = 0 and y2 - y1 = 0: a pin. */
static void keep_pin(TinkerEquationWriter *writer, const Rows *rows, const GPtrArray *g)
{
    if (rows->points->len != 2 || g->len != 2) return;
    const TinkerPointSymbols *a = point_at(rows->points, 0), *b = point_at(rows->points, 1);
    g_autoptr(TinkerExpression) x = tinker_expression_minus(tinker_expression_ref(b->x), tinker_expression_ref(a->x)),
                                y = tinker_expression_minus(tinker_expression_ref(b->y), tinker_expression_ref(a->y)),
                                none = tinker_expression_number(0);
    if (tinker_expression_equal(x, g_ptr_array_index(g, 0)) && tinker_expression_equal(y, g_ptr_array_index(g, 1)))
        tinker_writer_keep_line(writer->equations->pins, rows->block, rows->points, none, NULL, none);
}

/* Of a length that is kept, by its block's own word for it: λ pushes the ends apart. */
static gboolean is_tension(const TinkerEquationWriter *writer, TinkerBlockId block, const Rows *rows)
{
    return rows->rows == 1 &&
           tinker_block_class_quantity(tinker_scene_block_class(writer->scene, block), "tension") >= 0;
}

/* What the law says of each row; those that are 0 for these ends are left out. FALSE where it does not say. */
static gboolean rows_of(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law,
                        const GArray *points, GPtrArray *g, GArray *dimensions)
{
    const int32_t count = tinker_scene_block_class(writer->scene, block)->physics->constraint->rows;
    TinkerLawUse use;
    tinker_law_use_init(&use, block, law);
    tinker_law_use_set_ends(writer, &use, points);
    if (tinker_block_law_names(law, "L")) {
        g_autoptr(TinkerExpression) length =
            tinker_writer_length(writer, block, (TinkerPointSymbols *)(void *)points->data, (int32_t)points->len);
        tinker_law_use_set(&use, "L", length);
    }
    gboolean known = TRUE;
    for (int32_t r = 0; r < count && known; r++) {
        g_autofree char *name = count == 1 ? g_strdup("g") : g_strdup_printf("g%d", r + 1);
        TinkerExpression *is = tinker_law_use_equation(writer, &use, name);
        const TinkerLawDefinition *stated = tinker_block_law_definition(law, name);
        known = is != NULL;
        if (is == NULL) break;
        if (is->kind == TINKER_EXPRESSION_NUMBER) {
            tinker_expression_unref(is);
            continue;
        }
        g_ptr_array_add(g, is);
        g_array_append_val(dimensions, stated->dimension);
    }
    tinker_law_use_clear(&use);
    return known;
}

gboolean tinker_writer_add_constraint(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law)
{
    const gboolean unilateral = tinker_scene_block_class(writer->scene, block)->physics->constraint->unilateral != 0;
    g_autoptr(GArray) points = tinker_writer_ends(writer, block);
    if (!holds_a_body(points)) return TRUE;
    g_autoptr(GPtrArray) g = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    g_autoptr(GPtrArray) slopes = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    g_autoptr(GArray) dimensions = g_array_new(FALSE, FALSE, sizeof(TinkerDimension));
    if (!rows_of(writer, block, law, points, g, dimensions)) return FALSE;
    Rows rows = {block, points, slopes, (int32_t)g->len};
    for (guint r = 0; r < g->len; r++)
        add_slopes(writer, &rows, g_ptr_array_index(g, r));
    if (g->len == 1) keep_rod(writer, &rows, g_ptr_array_index(g, 0));
    keep_pin(writer, &rows, g);
    g_autofree double *values = fitted(writer, &rows);
    const gboolean active = !unilateral || acts(writer, &rows);
    const char *means = is_tension(writer, block, &rows) ? "minus its tension" : "multiplier";
    g_autoptr(GPtrArray) multipliers = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    for (guint r = 0; r < g->len; r++) {
        const TinkerDimension dimension = g_array_index(dimensions, TinkerDimension, r);
        const TinkerDimension of_multiplier = {1, (int8_t)(2 - dimension.length), -2, 0};
        static const char *const components[] = {"x", "y", "θ"};
        const guint named = dimension.angle == 1 ? 2 : r;
        const char *name = tinker_writer_name(
            writer, block, "λ", 0, g->len > 1 && named < G_N_ELEMENTS(components) ? components[named] : NULL);
        g_ptr_array_add(multipliers, tinker_writer_symbol(writer, name, block, values[r], of_multiplier, NULL, means));
        tinker_writer_add_row(writer, block, tinker_expression_ref(g_ptr_array_index(g, r)), dimension, name, active);
        note_slopes(writer, &rows, (int32_t)r);
    }
    add_terms(writer, &rows, (TinkerExpression *const *)multipliers->pdata);
    if (tinker_scene_block_class(writer->scene, block)->physics->constraint->friction != NULL)
        add_friction(writer, &rows);
    return TRUE;
}

void tinker_writer_add_row(TinkerEquationWriter *writer, TinkerBlockId block, TinkerExpression *g,
                           TinkerDimension dimension, const char *multiplier, gboolean active)
{
    TinkerConstraintEquation *row = g_new(TinkerConstraintEquation, 1);
    *row = (TinkerConstraintEquation){block, g, g_strdup(multiplier), NULL, dimension, active, FALSE};
    g_ptr_array_add(writer->equations->constraints, row);
}

void tinker_writer_limit_row(TinkerEquationWriter *writer, TinkerExpression *limit)
{
    const GPtrArray *rows = writer->equations->constraints;
    ((TinkerConstraintEquation *)g_ptr_array_index(rows, rows->len - 1))->limit = limit;
}
