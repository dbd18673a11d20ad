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
#include <math.h>

#include "equations/angles-private.h"

typedef struct {
    const TinkerEquations *equations;
    const TinkerAngleTree *tree;
    TinkerExpression *const *pivot; /* m/s^2 */
} Writer;

/* From a joint on, along e and n of its angle; owned. */
typedef struct {
    TinkerExpression *p, *q;
} Arm;

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

static void arm_clear(Arm *arm)
{
    tinker_expression_unref(arm->p);
    tinker_expression_unref(arm->q);
}

static gboolean is_beyond(const TinkerAngleTree *tree, int body, int number)
{
    for (int at = body; at >= 0; at = tinker_angle_at(tree, at)->before)
        if (at == number) return TRUE;
    return FALSE;
}

/* (x, y) . (a, b) / d */
static TinkerExpression *along(TinkerExpression *const v[2], TinkerExpression *a, TinkerExpression *b,
                               const TinkerExpression *d)
{
    TinkerExpression *sum = tinker_expression_plus(product(copy(v[0]), a), product(copy(v[1]), b));
    return tinker_expression_over(sum, copy(d));
}

/* The arm (v) in the axes of a body, of which the joint is at a: e points from there to the centre. */
static Arm arm_of_body(const Writer *writer, TinkerExpression *const a[2], TinkerExpression *const v[2],
                       gboolean to_centre)
{
    const gboolean level = tinker_expression_is_number(a[1], 0);
    if (level && tinker_expression_is_number(a[0], 0)) return (Arm){tinker_expression_negated(copy(v[1])), copy(v[0])};
    if (level) {
        const gboolean back = tinker_equations_value(writer->equations, a[0]) > 0;
        return (Arm){back ? tinker_expression_negated(copy(v[0])) : copy(v[0]),
                     back ? tinker_expression_negated(copy(v[1])) : copy(v[1])};
    }
    g_autoptr(TinkerExpression) d = tinker_expression_call(
        "sqrt", tinker_expression_plus(tinker_expression_squared(copy(a[0])), tinker_expression_squared(copy(a[1]))));
    if (to_centre) return (Arm){copy(d), tinker_expression_number(0)};
    return (Arm){along(v, tinker_expression_negated(copy(a[0])), tinker_expression_negated(copy(a[1])), d),
                 along(v, copy(a[1]), tinker_expression_negated(copy(a[0])), d)};
}

/* What angle k does to the centre of body i. */
static Arm arm_of(const Writer *writer, int k, int i)
{
    const TinkerRodAngle *angle = tinker_angle_at(writer->tree, k);
    if (!angle->turns) return (Arm){copy(angle->line->tension), tinker_expression_number(0)};
    const TinkerRodAngle *next = NULL;
    for (int at = i; at != k; at = next->before)
        next = tinker_angle_at(writer->tree, at);
    TinkerExpression *const *joint = angle->line->local[1 - angle->near];
    TinkerExpression *v[2];
    for (int axis = 0; axis < 2; axis++) {
        TinkerExpression *to = next != NULL ? copy(next->line->local[next->near][axis]) : tinker_expression_number(0);
        v[axis] = tinker_expression_minus(to, copy(joint[axis]));
    }
    const Arm arm = arm_of_body(writer, joint, v, next == NULL);
    tinker_expression_unref(v[0]);
    tinker_expression_unref(v[1]);
    return arm;
}

static gboolean same_arm(const Arm *a, const Arm *b)
{
    return tinker_expression_equal(a->p, b->p) && tinker_expression_equal(a->q, b->q);
}

static TinkerExpression *square_of(const TinkerExpression *a)
{
    return tinker_expression_squared(copy(a->kind == TINKER_EXPRESSION_NEGATIVE ? a->parts[0] : a));
}

/* m (P_j P_k + Q_j Q_k), and m (P_j Q_k - Q_j P_k). */
static TinkerExpression *even_part(const TinkerExpression *mass, const Arm *j, const Arm *k)
{
    return tinker_expression_plus(product(product(copy(mass), copy(j->p)), copy(k->p)),
                                  product(product(copy(mass), copy(j->q)), copy(k->q)));
}

static TinkerExpression *odd_part(const TinkerExpression *mass, const Arm *j, const Arm *k)
{
    return tinker_expression_minus(product(product(copy(mass), copy(j->p)), copy(k->q)),
                                   product(product(copy(mass), copy(j->q)), copy(k->p)));
}

/* What the turning of k does along j, to a mass whose arms these are. */
static TinkerExpression *turning_term(const Writer *writer, int j, int k, const TinkerExpression *mass, const Arm *own,
                                      const Arm *other)
{
    const TinkerRodAngle *a = tinker_angle_at(writer->tree, j), *b = tinker_angle_at(writer->tree, k);
    g_autoptr(TinkerExpression) even = even_part(mass, own, other), odd = odd_part(mass, own, other);
    g_autoptr(TinkerExpression) between = tinker_expression_minus(symbol(a->angle), symbol(b->angle));
    g_autoptr(TinkerExpression) cosine = tinker_expression_call("cos", copy(between)),
                                sine = tinker_expression_call("sin", copy(between));
    TinkerExpression *turning =
        tinker_expression_plus(product(copy(even), copy(cosine)), product(copy(odd), copy(sine)));
    TinkerExpression *spinning =
        tinker_expression_minus(product(copy(even), copy(sine)), product(copy(odd), copy(cosine)));
    return tinker_expression_plus(product(turning, symbol(b->acceleration)),
                                  product(spinning, tinker_expression_squared(symbol(b->rate))));
}

/* The mass of body i and of those behind it that have the same arms; 0 where it is one of those behind. */
static TinkerExpression *mass_alike(const Writer *writer, int j, int k, int i, const Arm *own, const Arm *other)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (int n = 0; n < (int)writer->tree->angles->len; n++) {
        if (!is_beyond(writer->tree, n, j) || !is_beyond(writer->tree, n, k)) continue;
        Arm first = arm_of(writer, j, n), second = arm_of(writer, k, n);
        const gboolean alike = same_arm(&first, own) && same_arm(&second, other);
        arm_clear(&first);
        arm_clear(&second);
        if (alike && n < i) return sum;
        const TinkerBodyEquation *body = tinker_angle_body(writer->equations, tinker_angle_at(writer->tree, n)->body);
        if (alike) sum = tinker_expression_plus(sum, copy(body->mass));
    }
    return sum;
}

/* All that the turning of k does along j. */
static TinkerExpression *inertia_terms(const Writer *writer, int j, int k)
{
    const TinkerRodAngle *angle = tinker_angle_at(writer->tree, j);
    TinkerExpression *sum = tinker_expression_number(0);
    const TinkerBodyEquation *body = tinker_angle_body(writer->equations, angle->body);
    for (int i = 0; i < (int)writer->tree->angles->len; i++) {
        if (!is_beyond(writer->tree, i, j) || !is_beyond(writer->tree, i, k)) continue;
        Arm own = arm_of(writer, j, i), other = arm_of(writer, k, i);
        g_autoptr(TinkerExpression) mass = mass_alike(writer, j, k, i, &own, &other);
        TinkerExpression *term;
        if (tinker_expression_is_number(mass, 0))
            term = tinker_expression_number(0);
        else if (j == k)
            term = tinker_expression_plus(product(copy(mass), square_of(own.p)), product(copy(mass), square_of(own.q)));
        else
            term = turning_term(writer, j, k, mass, &own, &other);
        sum = tinker_expression_plus(sum, term);
        arm_clear(&own);
        arm_clear(&other);
    }
    if (j != k) return sum;
    if (angle->turns) sum = tinker_expression_plus(sum, copy(body->inertia));
    return product(sum, symbol(angle->acceleration));
}

/* -F . (P n - Q e), term by term; and what the support's acceleration asks for. */
static TinkerExpression *load_terms(const Writer *writer, int j, int i)
{
    const TinkerRodAngle *angle = tinker_angle_at(writer->tree, j);
    const TinkerBodyEquation *body = tinker_angle_body(writer->equations, tinker_angle_at(writer->tree, i)->body);
    Arm arm = arm_of(writer, j, i);
    g_autoptr(TinkerExpression) c = tinker_expression_call("cos", symbol(angle->angle)),
                                s = tinker_expression_call("sin", symbol(angle->angle));
    TinkerExpression *sum = tinker_expression_number(0);
    for (int axis = 0; axis < 2; axis++) {
        g_autoptr(TinkerExpression) lever =
            axis == 0 ? tinker_expression_minus(product(copy(arm.p), copy(c)), product(copy(arm.q), copy(s)))
                      : tinker_expression_plus(product(copy(arm.p), copy(s)), product(copy(arm.q), copy(c)));
        sum = tinker_expression_plus(sum, product(product(copy(body->mass), copy(writer->pivot[axis])), copy(lever)));
        for (guint k = 0; k < body->terms->len; k++) {
            const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
            if (term->kind == TINKER_TERM_CONSTRAINT) continue;
            sum = tinker_expression_minus(sum, product(copy(axis == 0 ? term->x : term->y), copy(lever)));
        }
    }
    for (guint k = 0; i == j && angle->turns && k < body->terms->len; k++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
        if (term->kind != TINKER_TERM_CONSTRAINT) sum = tinker_expression_minus(sum, copy(term->torque));
    }
    arm_clear(&arm);
    return sum;
}

TinkerExpression *tinker_angle_equation(const TinkerEquations *equations, const TinkerAngleTree *tree, int j,
                                        TinkerExpression *const pivot[2])
{
    const Writer writer = {equations, tree, pivot};
    const int n = (int)tree->angles->len;
    TinkerExpression *sum = tinker_expression_number(0);
    for (int k = 0; k < n; k++)
        if (is_beyond(tree, k, j) || is_beyond(tree, j, k))
            sum = tinker_expression_plus(sum, inertia_terms(&writer, j, k));
    for (int i = 0; i < n; i++)
        if (is_beyond(tree, i, j)) sum = tinker_expression_plus(sum, load_terms(&writer, j, i));
    return sum;
}
