/* The equations of a tree in its angles.
 *
 * With e = (sin theta, -cos theta) and n = de/dtheta = (cos theta, sin theta), the centre of body i is the support's
 * place and, for each angle k on the way to it, P_ki e_k + Q_ki n_k: from the joint of k to the next one on the way, or
 * to the centre. Of a rod of length l that is P = l, Q = 0. The virtual work of (m a - F) and (I alpha - M) along a
 * turn of j is 0, where dr_i/dtheta_j = P n_j - Q e_j:
 *
 *   sum over k, and i beyond j and k, of
 *     m_i ((C cos d + S sin d) theta_k'' + (C sin d - S cos d) theta_k'^2)    with d = theta_j - theta_k,
 *                                                       C = P_j P_k + Q_j Q_k, S = P_j Q_k - Q_j P_k
 *     + I_j theta_j'' - M_j + sum over i beyond j of (m_i P'' - F_i) . (P_j n_j - Q_j e_j) = 0
 *
 * with the support's acceleration P'' and all forces and moments but those of rods and pins (H. Goldstein, Classical
 * Mechanics, 1.4). */
#include "equations/angles/angles-private.h"
#include "law/collect.h"

typedef struct {
    TinkerEquations *equations;
    TinkerAngleForm *form;
    const TinkerAngleTree *tree;
    TinkerExpression *const *pivot; /* m/s^2 */
} Writer;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static TinkerExpression *product(TinkerExpression *a, TinkerExpression *b)
{
    return tinker_expression_times(a, b);
}

static TinkerExpression *symbol(const char *name)
{
    return tinker_expression_symbol(name);
}

static gboolean is_beyond(const TinkerAngleTree *tree, int body, int number)
{
    for (int at = body; at >= 0; at = tinker_angle_at(tree, at)->before)
        if (at == number) return TRUE;
    return FALSE;
}

static const TinkerBodyEquation *body_of(const Writer *writer, int number)
{
    return tinker_angle_body(writer->equations, tinker_angle_at(writer->tree, number)->body);
}

static TinkerAngleArm arm_of(const Writer *writer, int k, int i)
{
    return tinker_angle_arm(writer->equations, writer->form, writer->tree, k, i);
}

#define FACTORS 5

/* Adds a product, with a sign before it; its factors are borrowed, and end at NULL. */
static void add(TinkerExpression **sum, gboolean negative, const TinkerExpression *const factors[FACTORS])
{
    TinkerExpression *term = tinker_expression_number(1);
    for (int i = 0; i < FACTORS && factors[i] != NULL; i++)
        term = product(term, copy(factors[i]));
    *sum = tinker_expression_plus(*sum, negative ? tinker_expression_negated(term) : term);
}

/* C cos d + S sin d and C sin d - S cos d, each times what turns: of both angles, the nearer to the support first, so
 * that the equations of both have the same products. With the angles changed over, d and S have the other sign. */
static void add_turning(TinkerExpression **sum, const Writer *writer, int j, int k, int i)
{
    const int near = j < k ? j : k, far = j < k ? k : j;
    const TinkerRodAngle *turning = tinker_angle_at(writer->tree, k);
    const TinkerExpression *m = body_of(writer, i)->mass;
    TinkerAngleArm a = arm_of(writer, near, i), b = arm_of(writer, far, i);
    g_autoptr(TinkerExpression) d = tinker_expression_minus(symbol(tinker_angle_at(writer->tree, near)->angle),
                                                            symbol(tinker_angle_at(writer->tree, far)->angle));
    g_autoptr(TinkerExpression) c = tinker_expression_call("cos", copy(d)), s = tinker_expression_call("sin", copy(d));
    g_autoptr(TinkerExpression) acceleration = symbol(turning->acceleration);
    g_autoptr(TinkerExpression) square = tinker_expression_squared(symbol(turning->rate));
    const TinkerExpression *const even[][2] = {{a.p, b.p}, {a.q, b.q}}, *const odd[][2] = {{a.p, b.q}, {a.q, b.p}};
    for (int n = 0; n < 2; n++) {
        const gboolean back = n == 1, changed = j > k;
        add(sum, FALSE, (const TinkerExpression *[]){m, even[n][0], even[n][1], c, acceleration});
        add(sum, back, (const TinkerExpression *[]){m, odd[n][0], odd[n][1], s, acceleration});
        add(sum, changed, (const TinkerExpression *[]){m, even[n][0], even[n][1], s, square});
        add(sum, back == changed, (const TinkerExpression *[]){m, odd[n][0], odd[n][1], c, square});
    }
    tinker_angle_arm_clear(&a);
    tinker_angle_arm_clear(&b);
}

/* What the turning of j itself takes, of a body beyond it. */
static void add_own_turning(TinkerExpression **sum, const Writer *writer, int j, int i)
{
    g_autoptr(TinkerExpression) acceleration = symbol(tinker_angle_at(writer->tree, j)->acceleration);
    TinkerAngleArm arm = arm_of(writer, j, i);
    const TinkerExpression *const parts[] = {arm.p, arm.q};
    for (int n = 0; n < 2; n++)
        add(sum, FALSE, (const TinkerExpression *[]){body_of(writer, i)->mass, parts[n], parts[n], acceleration, NULL});
    tinker_angle_arm_clear(&arm);
}

/* -F . (P n - Q e) of one force along an axis, or with the other sign m P''. */
static void add_load(TinkerExpression **sum, const Writer *writer, int j, const TinkerAngleArm *arm, int axis,
                     gboolean force, const TinkerExpression *const load[2])
{
    g_autoptr(TinkerExpression) angle = symbol(tinker_angle_at(writer->tree, j)->angle);
    g_autoptr(TinkerExpression) c = tinker_expression_call("cos", copy(angle)),
                                s = tinker_expression_call("sin", copy(angle));
    add(sum, force, (const TinkerExpression *[]){load[0], load[1], arm->p, axis == 0 ? c : s, NULL});
    add(sum, force != (axis == 0), (const TinkerExpression *[]){load[0], load[1], arm->q, axis == 0 ? s : c, NULL});
}

/* What acts on a body beyond j, term by term, and what the support's acceleration asks for. */
static void add_loads(TinkerExpression **sum, const Writer *writer, int j, int i)
{
    const TinkerBodyEquation *body = body_of(writer, i);
    g_autoptr(TinkerExpression) one = tinker_expression_number(1);
    TinkerAngleArm arm = arm_of(writer, j, i);
    for (int axis = 0; axis < 2; axis++) {
        for (guint k = 0; k < body->terms->len; k++) {
            const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
            const TinkerExpression *const load[] = {axis == 0 ? term->x : term->y, one};
            if (term->kind != TINKER_TERM_CONSTRAINT) add_load(sum, writer, j, &arm, axis, TRUE, load);
        }
        add_load(sum, writer, j, &arm, axis, FALSE, (const TinkerExpression *[]){body->mass, writer->pivot[axis]});
    }
    for (guint k = 0; i == j && body->inertia != NULL && k < body->terms->len; k++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
        if (term->kind != TINKER_TERM_CONSTRAINT) *sum = tinker_expression_minus(*sum, copy(term->torque));
    }
    tinker_angle_arm_clear(&arm);
}

/* What says how the tree moves. */
static gboolean moves(const TinkerExpression *factor, void *data)
{
    const TinkerAngleTree *tree = data;
    for (int i = 0; i < (int)tree->angles->len; i++) {
        const TinkerRodAngle *angle = tinker_angle_at(tree, i);
        if (tinker_expression_uses(factor, angle->angle) || tinker_expression_uses(factor, angle->rate) ||
            tinker_expression_uses(factor, angle->acceleration))
            return TRUE;
    }
    return FALSE;
}

TinkerExpression *tinker_angle_equation(TinkerEquations *equations, TinkerAngleForm *form, const TinkerAngleTree *tree,
                                        int j, TinkerExpression *const pivot[2])
{
    const Writer writer = {equations, form, tree, pivot};
    const int n = (int)tree->angles->len;
    const TinkerRodAngle *angle = tinker_angle_at(tree, j);
    TinkerExpression *sum = tinker_expression_number(0);
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < n; i++) {
            if (!is_beyond(tree, i, j) || !is_beyond(tree, i, k)) continue;
            if (k == j)
                add_own_turning(&sum, &writer, j, i);
            else
                add_turning(&sum, &writer, j, k, i);
        }
        if (k == j && angle->turns)
            sum = tinker_expression_plus(sum, product(copy(body_of(&writer, j)->inertia), symbol(angle->acceleration)));
    }
    for (int i = 0; i < n; i++)
        if (is_beyond(tree, i, j)) add_loads(&sum, &writer, j, i);
    g_autoptr(TinkerExpression) terms = sum;
    return tinker_expression_collected(terms, moves, (void *)tree);
}
