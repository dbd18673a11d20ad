/* The form in angles: names and values of the angles, and what moves their supports. */
#include "equations/angles/angles.h"

#include <math.h>
#include <string.h>

#include "equations/angles/angles-private.h"
#include "law/derivative.h"

typedef struct {
    TinkerEquations *equations;
    TinkerAngleForm *form;
} Writer;

/* Names and values ------------------------------------------------------------------------------------------------- */

/* Of a body that turns: its own angle, turned so that it is that of the way from its joint to its centre. */
static void value_of_body(const TinkerEquations *equations, TinkerRodAngle *angle)
{
    const char *name = tinker_scene_block_name(equations->scene, angle->body);
    g_autofree char *own = g_strconcat(name, ".angle", NULL), *rate = g_strconcat(name, ".rate", NULL);
    g_autoptr(TinkerExpression) turned = tinker_expression_symbol(own), turning = tinker_expression_symbol(rate);
    double joint[2];
    for (int axis = 0; axis < 2; axis++)
        joint[axis] = tinker_equations_shown_value(equations, angle->line->local[1 - angle->near][axis]);
    const gboolean centred = joint[0] == 0 && joint[1] == 0;
    const double from_own = centred ? 0 : remainder(atan2(-joint[1], -joint[0]) + G_PI_2, 2 * G_PI);
    angle->value = tinker_equations_value(equations, turned) + from_own;
    angle->rate_value = tinker_equations_value(equations, turning);
}

static void value_of_rod(const TinkerEquations *equations, TinkerRodAngle *angle)
{
    const TinkerLineEquation *line = angle->line;
    double d[2], v[2];
    for (int axis = 0; axis < 2; axis++) {
        d[axis] = tinker_equations_value(equations, line->place[1 - angle->near][axis]) -
                  tinker_equations_value(equations, line->place[angle->near][axis]);
        v[axis] = tinker_equations_value(equations, line->velocity[1 - angle->near][axis]) -
                  tinker_equations_value(equations, line->velocity[angle->near][axis]);
    }
    angle->value = atan2(d[0], -d[1]);
    angle->rate_value = (d[0] * v[1] - d[1] * v[0]) / (d[0] * d[0] + d[1] * d[1]);
}

static void show_angle(TinkerEquations *equations, const TinkerRodAngle *angle, const char *index)
{
    const char *const names[] = {angle->angle, angle->rate, angle->acceleration};
    for (int dots = 0; dots < 3; dots++)
        tinker_equations_add_look(equations, names[dots], "θ", index, dots, NULL);
}

/* With the number of its body, as its mass. */
static void name_angle(const Writer *writer, TinkerRodAngle *angle)
{
    TinkerEquations *equations = writer->equations;
    g_autofree char *place = g_strconcat(tinker_scene_block_name(equations->scene, angle->body), ".x", NULL);
    const char *index = ((const TinkerEquationLook *)g_hash_table_lookup(equations->looks, place))->index;
    angle->angle = tinker_equations_name("angle", index, 0, NULL);
    angle->rate = tinker_equations_name("angle", index, 1, NULL);
    angle->acceleration = tinker_equations_name("angle", index, 2, NULL);
    show_angle(equations, angle, index);
    if (angle->turns)
        value_of_body(equations, angle);
    else
        value_of_rod(equations, angle);
}

/* The support's acceleration --------------------------------------------------------------------------------------- */

/* By time, through definitions. */
static TinkerExpression *by_time(const char *symbol, void *data)
{
    if (strcmp(symbol, "t") == 0) return tinker_expression_number(1);
    const TinkerEquationDefinition *definition = tinker_equations_definition(data, symbol);
    return definition != NULL ? tinker_expression_derivative(definition->is, by_time, data) : NULL;
}

/* Whether numbers alone are known of a place: its acceleration would be taken for 0. */
static gboolean is_known_by_numbers(const TinkerEquations *equations, const TinkerExpression *place)
{
    for (int i = 0; i < place->count; i++)
        if (is_known_by_numbers(equations, place->parts[i])) return TRUE;
    if (place->kind != TINKER_EXPRESSION_SYMBOL) return FALSE;
    const TinkerEquationDefinition *definition = tinker_equations_definition(equations, place->name);
    return definition != NULL ? is_known_by_numbers(equations, definition->is)
                              : tinker_equations_is_not_written(equations, place->name);
}

static gboolean is_typed(const TinkerEquations *equations, const TinkerExpression *expression)
{
    for (int i = 0; i < expression->count; i++)
        if (is_typed(equations, expression->parts[i])) return TRUE;
    if (expression->kind != TINKER_EXPRESSION_SYMBOL) return FALSE;
    const TinkerEquationDefinition *definition = tinker_equations_definition(equations, expression->name);
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
    g_autofree char *index = tinker_equations_free_index(writer->equations, support, stems[axis], "", 2, NULL);
    tinker_equations_add_look(writer->equations, name, stems[axis], index, 2, NULL);
    return tinker_expression_symbol(name);
}

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

/* The tree that hangs on a support by this rod or pin. */
static void add_tree(TinkerAngleForm *form, TinkerEquations *equations, const TinkerLineEquation *line, int near)
{
    TinkerAngleTree *tree = g_new(TinkerAngleTree, 1);
    *tree = (TinkerAngleTree){g_array_new(FALSE, TRUE, sizeof(TinkerRodAngle)),
                              g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref)};
    g_array_set_clear_func(tree->angles, angle_clear);
    const char *why = tinker_angle_tree_fill(tree, equations, line, near);
    for (int axis = 0; axis < 2 && why == NULL; axis++)
        if (is_known_by_numbers(equations, line->place[near][axis])) why = "what moves its support is not written";
    if (why != NULL) {
        add_reason(form, line->ends[1 - near], why);
        tree_free(tree);
        return;
    }
    Writer writer = {equations, form};
    TinkerExpression *pivot[2];
    for (int axis = 0; axis < 2; axis++)
        pivot[axis] = acceleration_of(&writer, line, near, axis);
    for (guint i = 0; i < tree->angles->len; i++)
        name_angle(&writer, tinker_angle_at(tree, (int)i));
    for (guint i = 0; i < tree->angles->len; i++)
        g_ptr_array_add(tree->equations, tinker_angle_equation(equations, form, tree, (int)i, pivot));
    for (int axis = 0; axis < 2; axis++)
        tinker_expression_unref(pivot[axis]);
    g_ptr_array_add(form->trees, tree);
}

static void add_trees(TinkerAngleForm *form, TinkerEquations *equations, const GPtrArray *links)
{
    for (guint i = 0; i < links->len; i++) {
        const TinkerLineEquation *line = g_ptr_array_index(links, i);
        for (int near = 0; near < 2; near++)
            if (line->ends[near] < 0 && line->ends[1 - near] >= 0) add_tree(form, equations, line, near);
    }
}

void tinker_angle_form_mark(const TinkerAngleForm *form, const TinkerEquations *equations, GHashTable *needed)
{
    for (guint i = 0; i < form->trees->len; i++) {
        const TinkerAngleTree *tree = g_ptr_array_index(form->trees, i);
        for (guint k = 0; k < tree->equations->len; k++)
            tinker_equations_mark(equations, g_ptr_array_index(tree->equations, k), needed);
    }
    for (guint i = 0; i < form->definitions->len; i++)
        tinker_equations_mark(equations, ((TinkerEquationDefinition *)g_ptr_array_index(form->definitions, i))->is,
                              needed);
}

/* What acts on a body somewhere is written with the body's own angle, which has another value than that of the way from
 * its joint to its centre: where both are needed, the latter gets the body's name in place of its number. */
static void tell_angles_apart(TinkerEquations *equations, const TinkerAngleForm *form)
{
    g_autoptr(GHashTable) needed = g_hash_table_new(g_str_hash, g_str_equal);
    tinker_angle_form_mark(form, equations, needed);
    tinker_equations_mark_definitions(equations, needed);
    for (guint i = 0; i < form->trees->len; i++) {
        const TinkerAngleTree *tree = g_ptr_array_index(form->trees, i);
        for (guint k = 0; k < tree->angles->len; k++) {
            const TinkerRodAngle *angle = tinker_angle_at(tree, (int)k);
            const char *body = tinker_scene_block_name(equations->scene, angle->body);
            g_autofree char *own = g_strconcat(body, ".angle", NULL);
            if (g_hash_table_contains(needed, own)) show_angle(equations, angle, body);
        }
    }
}

TinkerAngleForm *tinker_angle_form_new(TinkerEquations *equations)
{
    TinkerAngleForm *form = g_new(TinkerAngleForm, 1);
    *form = (TinkerAngleForm){
        g_ptr_array_new_with_free_func(tree_free), g_ptr_array_new_with_free_func(tinker_equation_definition_free),
        g_ptr_array_new_with_free_func(tinker_equation_definition_free), g_ptr_array_new_with_free_func(reason_free)};
    add_trees(form, equations, equations->rods);
    add_trees(form, equations, equations->pins);
    tell_angles_apart(equations, form);
    if (form->trees->len == 0 && form->why->len == 0 && equations->bodies->len > 0)
        add_reason(form, ((TinkerBodyEquation *)g_ptr_array_index(equations->bodies, 0))->block,
                   "it hangs on no rod from a support");
    return form;
}

void tinker_angle_form_free(TinkerAngleForm *form)
{
    g_ptr_array_unref(form->trees);
    g_ptr_array_unref(form->definitions);
    g_ptr_array_unref(form->lengths);
    g_ptr_array_unref(form->why);
    g_free(form);
}
