/* Trees of rods and their equations.
 *
 * The place of body i is that of the support and l_k (sin theta_k, -cos theta_k) for each rod k on the way to it. The
 * virtual work of (m a - F) along a turn of rod j, d r_i / d theta_j = l_j (cos theta_j, sin theta_j), is 0; with
 * cos a cos b + sin a sin b = cos(a - b) it is
 *
 *   sum over k of (sum of m_i beyond both) l_j l_k (cos(theta_j - theta_k) theta_k'' + sin(theta_j - theta_k)
 * theta_k'^2)
 *     + sum over i beyond j of l_j ((m_i P_x'' - F_x) cos theta_j + (m_i P_y'' - F_y) sin theta_j) = 0,
 *
 * with the support's acceleration P'' and every force but those of the rods (H. Goldstein, Classical Mechanics, 1.4).
 */
#include "equations/angles.h"

#include <math.h>
#include <string.h>

#include "law/derivative.h"

typedef struct {
    TinkerEquations *equations;
    TinkerAngleForm *form;
    TinkerAngleTree *tree;
    TinkerExpression *pivot[2]; /* m/s^2: the support's acceleration; 0, or symbols */
} Writer;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static TinkerRodAngle *angle_at(const TinkerAngleTree *tree, int number)
{
    return &g_array_index(tree->angles, TinkerRodAngle, number);
}

static const TinkerBodyEquation *body_of(const TinkerEquations *equations, TinkerBlockId block)
{
    for (guint i = 0; i < equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(equations->bodies, i);
        if (body->block == block) return body;
    }
    return NULL;
}

/* Trees ------------------------------------------------------------------------------------------------------------ */

static int angle_of_body(const TinkerAngleTree *tree, TinkerBlockId body)
{
    for (guint i = 0; i < tree->angles->len; i++)
        if (angle_at(tree, (int)i)->body == body) return (int)i;
    return -1;
}

static gboolean has_rod(const TinkerAngleTree *tree, TinkerBlockId rod)
{
    for (guint i = 0; i < tree->angles->len; i++)
        if (angle_at(tree, (int)i)->rod == rod) return TRUE;
    return FALSE;
}

static void add_angle(TinkerAngleTree *tree, const TinkerLineEquation *rod, int near, int before)
{
    const TinkerRodAngle angle = {.rod = rod->block, .body = rod->ends[1 - near], .before = before, .line = rod};
    g_array_append_val(tree->angles, angle);
}

/* Every rod that hangs on the tree; FALSE where one closes a ring or holds on to a second support. */
static gboolean grow(TinkerAngleTree *tree, const TinkerEquations *equations)
{
    for (guint i = 0; i < tree->angles->len; i++) {
        const TinkerBlockId body = angle_at(tree, (int)i)->body;
        for (guint k = 0; k < equations->rods->len; k++) {
            const TinkerLineEquation *rod = g_ptr_array_index(equations->rods, k);
            const int near = rod->ends[0] == body ? 0 : rod->ends[1] == body ? 1 : -1;
            if (near < 0 || has_rod(tree, rod->block)) continue;
            if (rod->ends[1 - near] < 0 || angle_of_body(tree, rod->ends[1 - near]) >= 0) return FALSE;
            add_angle(tree, rod, near, (int)i);
        }
    }
    return TRUE;
}

/* Whether rods of the tree alone hold its bodies, and nothing touches them. */
static const char *held_otherwise(const TinkerAngleTree *tree, const TinkerEquations *equations)
{
    for (guint i = 0; i < tree->angles->len; i++) {
        const TinkerBodyEquation *body = body_of(equations, angle_at(tree, (int)i)->body);
        for (guint k = 0; k < body->terms->len; k++) {
            const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
            if (term->kind == TINKER_TERM_NORMAL) return "it lies on something";
            if (term->kind == TINKER_TERM_CONSTRAINT && !has_rod(tree, term->block))
                return "something else than rods holds it";
        }
    }
    return NULL;
}

/* Names and values ------------------------------------------------------------------------------------------------- */

static char *add_name(TinkerEquations *equations, const char *stem, const char *index, int dots)
{
    static const char *const behind[] = {"", "_d", "_dd"};
    char *name = g_strconcat("angle", behind[dots], index[0] != '\0' ? "_" : "", index, NULL);
    TinkerEquationLook *look = g_new(TinkerEquationLook, 1);
    *look = (TinkerEquationLook){g_strdup(stem), g_strdup(index), dots, NULL};
    g_hash_table_insert(equations->looks, g_strdup(name), look);
    return name;
}

static void name_angle(const Writer *writer, TinkerRodAngle *angle, guint number)
{
    TinkerEquations *equations = writer->equations;
    g_autofree char *index = equations->rods->len == 1 ? g_strdup("") : g_strdup_printf("%u", number);
    const TinkerLineEquation *line = angle->line;
    const int near = line->ends[0] == angle->body ? 1 : 0;
    double d[2], v[2];
    for (int axis = 0; axis < 2; axis++) {
        d[axis] = tinker_equations_value(equations, line->place[1 - near][axis]) -
                  tinker_equations_value(equations, line->place[near][axis]);
        v[axis] = tinker_equations_value(equations, line->velocity[1 - near][axis]) -
                  tinker_equations_value(equations, line->velocity[near][axis]);
    }
    angle->angle = add_name(equations, "θ", index, 0);
    angle->rate = add_name(equations, "θ", index, 1);
    angle->acceleration = add_name(equations, "θ", index, 2);
    angle->value = atan2(d[0], -d[1]);
    angle->rate_value = (d[0] * v[1] - d[1] * v[0]) / (d[0] * d[0] + d[1] * d[1]);
}

/* The support's acceleration ----------------------------------------------------------------------------------------
 */

static const TinkerEquationDefinition *definition_named(const TinkerEquations *equations, const char *name)
{
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        if (strcmp(definition->name, name) == 0) return definition;
    }
    return NULL;
}

/* By time, through definitions. */
static TinkerExpression *by_time(const char *symbol, void *data)
{
    if (strcmp(symbol, "t") == 0) return tinker_expression_number(1);
    const TinkerEquationDefinition *definition = definition_named(data, symbol);
    return definition != NULL ? tinker_expression_derivative(definition->is, by_time, data) : NULL;
}

static gboolean is_typed(const TinkerEquations *equations, const TinkerExpression *expression)
{
    for (int i = 0; i < expression->count; i++)
        if (is_typed(equations, expression->parts[i])) return TRUE;
    if (expression->kind != TINKER_EXPRESSION_SYMBOL) return FALSE;
    const TinkerEquationDefinition *definition = definition_named(equations, expression->name);
    return definition != NULL && (definition->typed || is_typed(equations, definition->is));
}

/* Once for each support; a symbol of the form's own definitions, or 0. */
static TinkerExpression *acceleration_of(Writer *writer, const TinkerLineEquation *rod, int near, int axis)
{
    static const char *const stems[] = {"X", "Y"};
    const TinkerExpression *place = rod->place[near][axis];
    g_autoptr(TinkerExpression) velocity = tinker_expression_derivative(place, by_time, writer->equations);
    TinkerExpression *is = tinker_expression_derivative(velocity, by_time, writer->equations);
    if (tinker_expression_is_number(is, 0)) return is;
    const TinkerBlockId support = tinker_scene_end(writer->equations->scene, rod->block, near).block;
    g_autofree char *name =
        g_strdup_printf("%s_dd %s", stems[axis], tinker_scene_block_name(writer->equations->scene, support));
    for (guint i = 0; i < writer->form->definitions->len; i++) {
        const TinkerEquationDefinition *known = g_ptr_array_index(writer->form->definitions, i);
        if (strcmp(known->name, name) != 0) continue;
        tinker_expression_unref(is);
        return tinker_expression_symbol(name);
    }
    TinkerEquationDefinition *definition = g_new0(TinkerEquationDefinition, 1);
    *definition = (TinkerEquationDefinition){.name = g_strdup(name),
                                             .block = support,
                                             .dimension = {0, 1, -2, 0},
                                             .means = g_strdup("its acceleration"),
                                             .is = is,
                                             .typed = is_typed(writer->equations, place)};
    definition->value = tinker_equations_value(writer->equations, is);
    g_ptr_array_add(writer->form->definitions, definition);
    TinkerEquationLook *look = g_new(TinkerEquationLook, 1);
    *look = (TinkerEquationLook){g_strdup(stems[axis]), g_strdup(""), 2, NULL};
    g_hash_table_insert(writer->equations->looks, g_strdup(name), look);
    return tinker_expression_symbol(name);
}

/* Equations -------------------------------------------------------------------------------------------------------- */

static gboolean is_beyond(const TinkerAngleTree *tree, int body, int rod)
{
    for (int at = body; at >= 0; at = angle_at(tree, at)->before)
        if (at == rod) return TRUE;
    return FALSE;
}

static TinkerExpression *symbol(const char *name)
{
    return tinker_expression_symbol(name);
}

static TinkerExpression *product(TinkerExpression *a, TinkerExpression *b)
{
    return tinker_expression_times(a, b);
}

/* The sum of the masses beyond two rods. */
static TinkerExpression *masses_beyond(const Writer *writer, int j, int k)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (guint i = 0; i < writer->tree->angles->len; i++) {
        if (!is_beyond(writer->tree, (int)i, j) || !is_beyond(writer->tree, (int)i, k)) continue;
        const TinkerBodyEquation *body = body_of(writer->equations, angle_at(writer->tree, (int)i)->body);
        sum = tinker_expression_plus(sum, copy(body->mass));
    }
    return sum;
}

/* What rod k's turning does along j. */
static TinkerExpression *inertia_term(const Writer *writer, int j, int k)
{
    const TinkerRodAngle *a = angle_at(writer->tree, j), *b = angle_at(writer->tree, k);
    TinkerExpression *mass = masses_beyond(writer, j, k);
    if (j == k) {
        TinkerExpression *square = tinker_expression_squared(copy(a->line->tension));
        return product(product(mass, square), symbol(a->acceleration));
    }
    TinkerExpression *factor = product(product(mass, copy(a->line->tension)), copy(b->line->tension));
    TinkerExpression *between = tinker_expression_minus(symbol(a->angle), symbol(b->angle));
    TinkerExpression *cosine = tinker_expression_call("cos", copy(between));
    TinkerExpression *sine = tinker_expression_call("sin", between);
    TinkerExpression *turning = product(product(copy(factor), cosine), symbol(b->acceleration));
    TinkerExpression *spinning = product(product(factor, sine), tinker_expression_squared(symbol(b->rate)));
    return tinker_expression_plus(turning, spinning);
}

/* -F l (cos theta, sin theta), term by term; and what the support's acceleration asks for. */
static TinkerExpression *load_terms(const Writer *writer, int j, int i)
{
    static const char *const functions[] = {"cos", "sin"};
    const TinkerRodAngle *rod = angle_at(writer->tree, j);
    const TinkerBodyEquation *body = body_of(writer->equations, angle_at(writer->tree, i)->body);
    TinkerExpression *sum = tinker_expression_number(0);
    for (int axis = 0; axis < 2; axis++) {
        g_autoptr(TinkerExpression) arm =
            product(copy(rod->line->tension), tinker_expression_call(functions[axis], symbol(rod->angle)));
        sum = tinker_expression_plus(sum, product(product(copy(body->mass), copy(writer->pivot[axis])), copy(arm)));
        for (guint k = 0; k < body->terms->len; k++) {
            const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
            if (term->kind == TINKER_TERM_CONSTRAINT) continue;
            const TinkerExpression *force = axis == 0 ? term->x : term->y;
            sum = tinker_expression_minus(sum, product(copy(force), copy(arm)));
        }
    }
    return sum;
}

static TinkerExpression *equation_of(const Writer *writer, int j)
{
    const int n = (int)writer->tree->angles->len;
    TinkerExpression *sum = tinker_expression_number(0);
    for (int k = 0; k < n; k++)
        if (is_beyond(writer->tree, k, j) || is_beyond(writer->tree, j, k))
            sum = tinker_expression_plus(sum, inertia_term(writer, j, k));
    for (int i = 0; i < n; i++)
        if (is_beyond(writer->tree, i, j)) sum = tinker_expression_plus(sum, load_terms(writer, j, i));
    return sum;
}

/* The form --------------------------------------------------------------------------------------------------------- */

static void angle_clear(void *data)
{
    TinkerRodAngle *angle = data;
    g_free(angle->angle);
    g_free(angle->rate);
    g_free(angle->acceleration);
}

static void tree_free(void *data)
{
    TinkerAngleTree *tree = data;
    g_array_unref(tree->angles);
    g_ptr_array_unref(tree->equations);
    g_free(tree);
}

static void definition_free(void *data)
{
    TinkerEquationDefinition *definition = data;
    g_free(definition->name);
    g_free(definition->means);
    tinker_expression_unref(definition->is);
    g_free(definition);
}

static void reason_free(void *data)
{
    g_free(((TinkerNotWritten *)data)->why);
    g_free(data);
}

static void add_reason(TinkerAngleForm *form, TinkerBlockId block, const char *why)
{
    TinkerNotWritten *reason = g_new(TinkerNotWritten, 1);
    *reason = (TinkerNotWritten){block, NULL, g_strdup(why)};
    g_ptr_array_add(form->why, reason);
}

/* The tree that hangs on a support by this rod. */
static void add_tree(TinkerAngleForm *form, TinkerEquations *equations, const TinkerLineEquation *rod, int near,
                     guint *number)
{
    TinkerAngleTree *tree = g_new(TinkerAngleTree, 1);
    *tree = (TinkerAngleTree){g_array_new(FALSE, TRUE, sizeof(TinkerRodAngle)),
                              g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref)};
    g_array_set_clear_func(tree->angles, angle_clear);
    add_angle(tree, rod, near, -1);
    const char *why = grow(tree, equations) ? held_otherwise(tree, equations) : "its rods are no tree on one support";
    if (why != NULL) {
        add_reason(form, angle_at(tree, 0)->body, why);
        tree_free(tree);
        return;
    }
    Writer writer = {equations, form, tree, {NULL, NULL}};
    for (int axis = 0; axis < 2; axis++)
        writer.pivot[axis] = acceleration_of(&writer, rod, near, axis);
    for (guint i = 0; i < tree->angles->len; i++)
        name_angle(&writer, angle_at(tree, (int)i), ++*number);
    for (guint i = 0; i < tree->angles->len; i++)
        g_ptr_array_add(tree->equations, equation_of(&writer, (int)i));
    for (int axis = 0; axis < 2; axis++)
        tinker_expression_unref(writer.pivot[axis]);
    g_ptr_array_add(form->trees, tree);
}

TinkerAngleForm *tinker_angle_form_new(TinkerEquations *equations)
{
    TinkerAngleForm *form = g_new(TinkerAngleForm, 1);
    *form =
        (TinkerAngleForm){g_ptr_array_new_with_free_func(tree_free), g_ptr_array_new_with_free_func(definition_free),
                          g_ptr_array_new_with_free_func(reason_free)};
    guint number = 0;
    for (guint i = 0; i < equations->rods->len; i++) {
        const TinkerLineEquation *rod = g_ptr_array_index(equations->rods, i);
        for (int near = 0; near < 2; near++)
            if (rod->ends[near] < 0 && rod->ends[1 - near] >= 0) add_tree(form, equations, rod, near, &number);
    }
    if (form->trees->len == 0 && form->why->len == 0 && equations->bodies->len > 0)
        add_reason(form, ((TinkerBodyEquation *)g_ptr_array_index(equations->bodies, 0))->block,
                   "it hangs on no rod from a support");
    return form;
}

void tinker_angle_form_free(TinkerAngleForm *form)
{
    g_ptr_array_unref(form->trees);
    g_ptr_array_unref(form->definitions);
    g_ptr_array_unref(form->why);
    g_free(form);
}
