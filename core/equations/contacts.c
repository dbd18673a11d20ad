/* Contacts: the normal force as the multiplier of the gap, friction as another one where it sticks, as a share of the
 * normal force where it slides. */
#include <math.h>

#include "equations/writer-private.h"
#include "law/build.h"

/* Slower than this share of the body's speed and 1 m/s together, a contact whose friction is not the dynamic one
 * sticks. */
#define STICKING 1e-9

typedef struct {
    TinkerBlockId support, body;
    double normal, friction; /* N: across the top, along it */
} Contact;

/* A top as a body sees it; expressions are owned. */
typedef struct {
    TinkerPointSymbols centre;
    TinkerExpression *normal[2]; /* unit vector; the top runs along (normal[1], -normal[0]) */
    TinkerExpression *dx, *dy;   /* from the centre to the body's */
    TinkerExpression *vx, *vy;   /* likewise the velocity */
} Top;

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static TinkerExpression *state_of(const TinkerEquationWriter *writer, TinkerBlockId body, const char *quantity)
{
    g_autofree char *name = g_strconcat(tinker_scene_block_name(writer->scene, body), ".", quantity, NULL);
    return tinker_expression_symbol(name);
}

static void top_init(TinkerEquationWriter *writer, const Contact *contact, Top *top)
{
    g_autoptr(TinkerExpression) angle =
        tinker_writer_meaning(writer, contact->support, TINKER_MEANING_ORIENTATION, 0, "φ");
    tinker_writer_centre(writer, contact->support, &top->centre);
    top->normal[0] = tinker_expression_negated(tinker_expression_call("sin", copy(angle)));
    top->normal[1] = tinker_expression_call("cos", copy(angle));
    top->dx = tinker_expression_minus(state_of(writer, contact->body, "x"), copy(top->centre.x));
    top->dy = tinker_expression_minus(state_of(writer, contact->body, "y"), copy(top->centre.y));
    top->vx = tinker_expression_minus(state_of(writer, contact->body, "vx"), copy(top->centre.vx));
    top->vy = tinker_expression_minus(state_of(writer, contact->body, "vy"), copy(top->centre.vy));
}

static void top_clear(Top *top)
{
    TinkerExpression *const parts[] = {top->normal[0], top->normal[1], top->dx, top->dy, top->vx, top->vy};
    tinker_point_symbols_clear(&top->centre);
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        tinker_expression_unref(parts[i]);
}

/* a along the top. */
static TinkerExpression *along(const Top *top, const TinkerExpression *x, const TinkerExpression *y)
{
    return tinker_expression_minus(tinker_expression_times(copy(top->normal[1]), copy(x)),
                                   tinker_expression_times(copy(top->normal[0]), copy(y)));
}

static TinkerExpression *across(const Top *top, const TinkerExpression *x, const TinkerExpression *y)
{
    return tinker_expression_plus(tinker_expression_times(copy(top->normal[0]), copy(x)),
                                  tinker_expression_times(copy(top->normal[1]), copy(y)));
}

static TinkerExpression *half(TinkerExpression *height)
{
    return tinker_expression_over(height, tinker_expression_number(2));
}

/* What the row that was added last does to the body. */
static void note_slope(TinkerEquationWriter *writer, TinkerBlockId body, const TinkerExpression *x,
                       const TinkerExpression *y)
{
    const double slope[] = {tinker_equations_value(writer->equations, x), tinker_equations_value(writer->equations, y),
                            0};
    tinker_writer_note_slope(writer, body, slope);
}

static TinkerExpression *add_normal(TinkerEquationWriter *writer, const Contact *contact, const Top *top)
{
    const TinkerBlockId support = contact->support, body = contact->body;
    TinkerExpression *heights =
        tinker_expression_plus(half(tinker_writer_meaning(writer, support, TINKER_MEANING_HEIGHT, 0, "H")),
                               half(tinker_writer_meaning(writer, body, TINKER_MEANING_HEIGHT, 0, "h")));
    const char *name = tinker_writer_name(writer, support, "N", 0, NULL);
    TinkerExpression *normal =
        tinker_writer_symbol(writer, name, support, contact->normal, tinker_force_dimension, NULL, "normal force");
    tinker_writer_add_row(writer, support, tinker_expression_minus(across(top, top->dx, top->dy), heights),
                          tinker_length_dimension, name, TRUE);
    note_slope(writer, body, top->normal[0], top->normal[1]);
    const TinkerPointSymbols centre = {.block = body};
    tinker_writer_add_term(writer, &centre, support, TINKER_TERM_NORMAL,
                           tinker_expression_times(copy(normal), copy(top->normal[0])),
                           tinker_expression_times(copy(normal), copy(top->normal[1])), NULL);
    return normal;
}

static void add_friction_term(TinkerEquationWriter *writer, const Contact *contact, const Top *top,
                              TinkerExpression *force)
{
    TinkerExpression *x = tinker_expression_times(copy(force), copy(top->normal[1]));
    TinkerExpression *y = tinker_expression_negated(tinker_expression_times(force, copy(top->normal[0])));
    const TinkerPointSymbols centre = {.block = contact->body};
    tinker_writer_add_term(writer, &centre, contact->support, TINKER_TERM_FRICTION, x, y, NULL);
}

static void add_sticking(TinkerEquationWriter *writer, const Contact *contact, const Top *top)
{
    const TinkerBlockId support = contact->support;
    TinkerExpression *place = along(top, top->dx, top->dy);
    const double value = tinker_equations_value(writer->equations, place);
    const char *start = tinker_writer_name(writer, support, "s0", 0, NULL);
    TinkerExpression *from =
        tinker_writer_symbol(writer, start, support, value, tinker_length_dimension, NULL, "place along the top");
    const char *name = tinker_writer_name(writer, support, "f", 0, NULL);
    TinkerExpression *friction =
        tinker_writer_symbol(writer, name, support, contact->friction, tinker_force_dimension, NULL, "friction force");
    tinker_writer_add_row(writer, support, tinker_expression_minus(place, from), tinker_length_dimension, name, TRUE);
    g_autoptr(TinkerExpression) back = tinker_expression_negated(copy(top->normal[0]));
    note_slope(writer, contact->body, top->normal[1], back);
    add_friction_term(writer, contact, top, friction);
}

static void add_sliding(TinkerEquationWriter *writer, const Contact *contact, const Top *top,
                        const TinkerExpression *normal, double direction)
{
    const TinkerBlockId support = contact->support;
    TinkerExpression *share = tinker_writer_meaning(writer, support, TINKER_MEANING_DYNAMIC_FRICTION, 0, "µd");
    if (tinker_expression_is_number(share, 0)) {
        tinker_expression_unref(share);
        return;
    }
    const char *name = tinker_writer_name(writer, support, "σ", 0, NULL);
    TinkerExpression *sign =
        tinker_writer_symbol(writer, name, support, direction, tinker_pure_dimension, NULL, "direction of sliding");
    TinkerExpression *force = tinker_expression_times(tinker_expression_times(sign, share), copy(normal));
    add_friction_term(writer, contact, top, tinker_expression_negated(force));
}

static void add_contact(TinkerEquationWriter *writer, const Contact *contact)
{
    Top top;
    top_init(writer, contact, &top);
    g_autoptr(TinkerExpression) normal = add_normal(writer, contact, &top);
    g_autoptr(TinkerExpression) slip = along(&top, top.vx, top.vy);
    const TinkerBodySample *at = tinker_model_state_body(writer->state, contact->body);
    const double speed = tinker_equations_value(writer->equations, slip);
    const double share = tinker_frame_meaning(writer->frame, contact->support, TINKER_MEANING_DYNAMIC_FRICTION, 0, 0.0);
    const double dynamic = share * contact->normal;
    const gboolean moves = fabs(speed) > STICKING * (1 + hypot(at->vx, at->vy));
    const gboolean as_sliding = fabs(fabs(contact->friction) - dynamic) <= STICKING * dynamic;
    if (moves || as_sliding)
        add_sliding(writer, contact, &top, normal, moves ? copysign(1, speed) : -copysign(1, contact->friction));
    else
        add_sticking(writer, contact, &top);
    top_clear(&top);
}

void tinker_writer_add_contacts(TinkerEquationWriter *writer)
{
    const GArray *forces = writer->state->forces;
    for (guint i = 0; i < forces->len; i++) {
        const TinkerActingForce *normal = &g_array_index(forces, TinkerActingForce, i);
        if (normal->kind != TINKER_ACTING_NORMAL ||
            !g_hash_table_contains(writer->body_of, GINT_TO_POINTER(normal->on)))
            continue;
        double orientation, place[2], friction[3];
        tinker_frame_centre(writer->frame, normal->by, &place[0], &place[1], &orientation);
        const double n[] = {-sin(orientation), cos(orientation)};
        (void)tinker_model_state_force(writer->state, normal->by, normal->on, TINKER_ACTING_FRICTION, friction);
        const Contact contact = {normal->by, normal->on, n[0] * normal->fx + n[1] * normal->fy,
                                 n[1] * friction[0] - n[0] * friction[1]};
        add_contact(writer, &contact);
    }
}
