/* How far the angles of a tree move what hangs on them, and the lengths that this takes, each with a name: those of
 * rods have one, those on bodies are made from where their joints are. */
#include "equations/angles/angles-private.h"
#include "equations/newton/writer.h"

typedef struct {
    TinkerEquations *equations;
    TinkerAngleForm *form;
    const TinkerAngleTree *tree;
    int angle;
} Writer;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static gboolean is_zero(const Writer *writer, const TinkerExpression *length)
{
    return tinker_equations_shown_value(writer->equations, length) == 0;
}

/* The length by its name, which it gets with the number of the angle; minus it where it is negative. Uses it up. */
static TinkerExpression *named(const Writer *writer, const char *stem, const char *means, TinkerExpression *is)
{
    TinkerEquations *equations = writer->equations;
    GPtrArray *lengths = writer->form->lengths;
    const TinkerRodAngle *angle = tinker_angle_at(writer->tree, writer->angle);
    if (is_zero(writer, is)) {
        tinker_expression_unref(is);
        return tinker_expression_number(0);
    }
    if (tinker_equations_value(equations, is) < 0)
        return tinker_expression_negated(named(writer, stem, means, tinker_expression_negated(is)));
    for (guint i = 0; i < lengths->len; i++) {
        const TinkerEquationDefinition *known = g_ptr_array_index(lengths, i);
        if (known->block != angle->body || !tinker_expression_equal(known->is, is)) continue;
        tinker_expression_unref(is);
        return tinker_expression_symbol(known->name);
    }
    const TinkerEquationLook *look = g_hash_table_lookup(equations->looks, angle->angle);
    const char *name = tinker_equations_free_name(equations, angle->body, stem, look->index, 0, NULL);
    TinkerEquationDefinition *definition = g_new0(TinkerEquationDefinition, 1);
    *definition = (TinkerEquationDefinition){.name = g_strdup(name),
                                             .block = angle->body,
                                             .dimension = tinker_length_dimension,
                                             .means = g_strdup(means),
                                             .is = is,
                                             .value = tinker_equations_value(equations, is)};
    g_ptr_array_add(lengths, definition);
    tinker_equations_set_value(equations, name, definition->value);
    tinker_equations_set_rounding(equations, name, tinker_equations_rounding(equations, is));
    return tinker_expression_symbol(name);
}

/* (x, y) . (a, b) / d; takes a and b over */
static TinkerExpression *along(TinkerExpression *const v[2], TinkerExpression *a, TinkerExpression *b,
                               const TinkerExpression *d)
{
    TinkerExpression *sum =
        tinker_expression_plus(tinker_expression_times(copy(v[0]), a), tinker_expression_times(copy(v[1]), b));
    return tinker_expression_over(sum, copy(d));
}

static TinkerAngleArm joint_to_joint(const Writer *writer, TinkerExpression *p, TinkerExpression *q)
{
    return (TinkerAngleArm){named(writer, "l", "from joint to joint", p),
                            named(writer, "b", "from joint to joint, across the way to its centre of mass", q)};
}

/* Minus the expression where `minus`, else itself. (transfer full) */
static TinkerExpression *with_sign(const TinkerExpression *expression, gboolean minus)
{
    return minus ? tinker_expression_negated(copy(expression)) : copy(expression);
}

/* e and n are axes of the body: e is minus `axis` where `back`, n is e turned by a right angle. */
static TinkerAngleArm arm_along_axis(const Writer *writer, TinkerExpression *const a[2], TinkerExpression *const *v,
                                     int axis, gboolean back)
{
    if (v == NULL)
        return (TinkerAngleArm){named(writer, "a", "from its joint to its centre of mass", with_sign(a[axis], !back)),
                                tinker_expression_number(0)};
    return joint_to_joint(writer, with_sign(v[axis], back), with_sign(v[1 - axis], back == (axis == 0)));
}

/* e points from the joint at a to the centre, to -y where they coincide; v is the way to the next joint, in the axes of
 * the body, NULL: none. */
static TinkerAngleArm arm_of_body(const Writer *writer, TinkerExpression *const a[2], TinkerExpression *const *v)
{
    const gboolean level = is_zero(writer, a[1]), upright = is_zero(writer, a[0]);
    if (level && upright && v == NULL)
        return (TinkerAngleArm){tinker_expression_number(0), tinker_expression_number(0)};
    if (upright) return arm_along_axis(writer, a, v, 1, level || tinker_equations_value(writer->equations, a[1]) > 0);
    if (level) return arm_along_axis(writer, a, v, 0, tinker_equations_value(writer->equations, a[0]) > 0);
    g_autoptr(TinkerExpression) d =
        named(writer, "a", "from its joint to its centre of mass",
              tinker_expression_call("sqrt", tinker_expression_plus(tinker_expression_squared(copy(a[0])),
                                                                    tinker_expression_squared(copy(a[1])))));
    if (v == NULL) return (TinkerAngleArm){copy(d), tinker_expression_number(0)};
    return joint_to_joint(writer,
                          along(v, tinker_expression_negated(copy(a[0])), tinker_expression_negated(copy(a[1])), d),
                          along(v, copy(a[1]), tinker_expression_negated(copy(a[0])), d));
}

TinkerAngleArm tinker_angle_arm(TinkerEquations *equations, TinkerAngleForm *form, const TinkerAngleTree *tree, int k,
                                int i)
{
    const Writer writer = {equations, form, tree, k};
    const TinkerRodAngle *angle = tinker_angle_at(tree, k), *next = NULL;
    if (!angle->turns) return (TinkerAngleArm){copy(angle->line->tension), tinker_expression_number(0)};
    TinkerExpression *const *joint = angle->line->local[1 - angle->near];
    if (i == k) return arm_of_body(&writer, joint, NULL);
    for (int at = i; at != k; at = next->before)
        next = tinker_angle_at(tree, at);
    TinkerExpression *v[2];
    for (int axis = 0; axis < 2; axis++)
        v[axis] = tinker_expression_minus(copy(next->line->local[next->near][axis]), copy(joint[axis]));
    const TinkerAngleArm arm = arm_of_body(&writer, joint, v);
    tinker_expression_unref(v[0]);
    tinker_expression_unref(v[1]);
    return arm;
}

void tinker_angle_arm_clear(TinkerAngleArm *arm)
{
    tinker_expression_unref(arm->p);
    tinker_expression_unref(arm->q);
}
