/* Which forces of contact a scene has: those of which it is known where they touch are written out, others, as impulses
 * have them, are numbers. */
#include <math.h>

#include "equations/newton/contact-terms.h"

/* Of 1 and of the support's height: a force that is not across the top is not one of its top. */
#define ACROSS 1e-9

/* A contact of which nothing but its forces is known. */
static void add_unlike(TinkerEquationWriter *writer, const TinkerActingForce *acting)
{
    static const char *const components[] = {"x", "y"};
    const gboolean is_normal = acting->kind == TINKER_ACTING_NORMAL;
    const double values[] = {acting->fx, acting->fy, tinker_model_state_moment(writer->state, acting)};
    TinkerExpression *parts[3];
    for (int k = 0; k < 3; k++) {
        const char *name = k < 2 ? tinker_writer_name(writer, acting->by, is_normal ? "N" : "f", 0, components[k])
                                 : tinker_writer_name(writer, acting->by, "M", 0, NULL);
        const TinkerDimension moment = TINKER_DIMENSION_ENERGY;
        tinker_writer_note_unwritten(writer, acting->by, name,
                                     "contact as impulses does not tell where two bodies touch");
        parts[k] = tinker_writer_symbol(writer, name, acting->by, values[k], k < 2 ? tinker_force_dimension : moment,
                                        NULL, "force of contact");
    }
    const TinkerPointSymbols centre = {.block = acting->on};
    tinker_writer_add_term(writer, &centre, acting->by, is_normal ? TINKER_TERM_NORMAL : TINKER_TERM_FRICTION, parts[0],
                           parts[1], parts[2]);
}

/* Whether a force is one of a support's top; then its normal. */
static gboolean is_of_top(const TinkerEquationWriter *writer, const TinkerActingForce *acting, double n[2])
{
    double angle, place[2];
    if (!tinker_block_class_stands(tinker_scene_block_class(writer->scene, acting->by))) return FALSE;
    tinker_frame_centre(writer->frame, acting->by, &place[0], &place[1], &angle);
    const double top = 0.5 * tinker_frame_meaning(writer->frame, acting->by, TINKER_MEANING_HEIGHT, 0, 0);
    n[0] = -sin(angle);
    n[1] = cos(angle);
    const double off = n[0] * (acting->x - place[0]) + n[1] * (acting->y - place[1]) - top;
    return fabs(off) <= 1e-6 * (1 + top) &&
           fabs(n[0] * acting->fy - n[1] * acting->fx) <= ACROSS * hypot(acting->fx, acting->fy);
}

static TinkerTouchShape shape_of(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    const TinkerBodyEquation *equation = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(contact->tip));
    const gboolean turns = equation != NULL && equation->inertia != NULL;
    if (!turns && tinker_contact_is_on_top(writer, contact)) return TINKER_TOUCHES_AS_MASS;
    if (contact->touch != NULL)
        return contact->touch->gap.tip_radius > 0 ? TINKER_TOUCHES_AS_DISC : TINKER_TOUCHES_AT_CORNER;
    const TinkerBody *role = tinker_scene_block_class(writer->scene, contact->tip)->physics->body;
    return role->shape == TINKER_SHAPE_DISC ? TINKER_TOUCHES_AS_DISC : TINKER_TOUCHES_AT_CORNER;
}

/* How many contacts a block has, and how many of them stand before number `before`, with this body alone where it is
 * one. */
static guint contacts_of(const TinkerEquationWriter *writer, TinkerBlockId block, TinkerBlockId body, guint before)
{
    const GArray *forces = writer->state->forces;
    guint count = 0;
    for (guint i = 0; i < MIN(forces->len, before); i++) {
        const TinkerActingForce *each = &g_array_index(forces, TinkerActingForce, i);
        count += each->kind == TINKER_ACTING_NORMAL && each->by == block && (body < 0 || each->on == body);
    }
    return count;
}

static void append_index(GString *index, const char *part)
{
    if (index->len > 0 && part[0] != '\0') g_string_append_c(index, ',');
    g_string_append(index, part);
}

/* "seat,tip,number": of a support that touches one body alone NULL, as its own index will do, and the body and the
 * number are left out where they tell nothing. (transfer full) */
static char *index_of(const TinkerEquationWriter *writer, const TinkerActingForce *acting, guint number)
{
    const guint all = contacts_of(writer, acting->by, -1, G_MAXUINT),
                own = contacts_of(writer, acting->by, acting->on, G_MAXUINT);
    const gboolean is_of_body = g_hash_table_contains(writer->body_of, GINT_TO_POINTER(acting->by));
    if (all == 1 && !is_of_body) return NULL;
    g_autoptr(GString) index = g_string_new(tinker_writer_index(writer, acting->by));
    g_autofree char *order = g_strdup_printf("%u", 1 + contacts_of(writer, acting->by, acting->on, number));
    if (own < all || is_of_body) append_index(index, tinker_writer_index(writer, acting->on));
    if (own > 1) append_index(index, order);
    return g_string_free(g_steal_pointer(&index), FALSE);
}

/* The friction that belongs to a normal force: behind it, at the same place. */
static const TinkerActingForce *friction_beside(const GArray *forces, guint number)
{
    const TinkerActingForce *normal = &g_array_index(forces, TinkerActingForce, number);
    for (guint i = number + 1; i < forces->len; i++) {
        const TinkerActingForce *each = &g_array_index(forces, TinkerActingForce, i);
        if (each->kind == TINKER_ACTING_NORMAL && each->on == normal->on) return NULL;
        if (each->kind == TINKER_ACTING_FRICTION && each->by == normal->by && each->on == normal->on) return each;
    }
    return NULL;
}

/* A normal force and the friction (NULL: none) beside it. */
static void add_contact(TinkerEquationWriter *writer, const TinkerActingForce *normal,
                        const TinkerActingForce *friction, const double n[2], const char *index)
{
    TinkerContactForce contact = {.tip = normal->on,
                                  .seat = normal->by,
                                  .normal = n[0] * normal->fx + n[1] * normal->fy,
                                  .friction = friction != NULL ? n[1] * friction->fx - n[0] * friction->fy : 0,
                                  .moment = friction != NULL ? friction->torque : 0,
                                  .at = {normal->x, normal->y},
                                  .index = index};
    if (normal->touch >= 0) contact.touch = &g_array_index(writer->state->touches, TinkerActingTouch, normal->touch);
    contact.shape = shape_of(writer, &contact);
    tinker_writer_add_contact(writer, &contact);
}

/* Whether a force is that on the tip of two shapes that touch, whose other forces follow from it. */
static gboolean is_on_tip(const TinkerEquationWriter *writer, const TinkerActingForce *normal)
{
    const TinkerActingTouch *touch = &g_array_index(writer->state->touches, TinkerActingTouch, normal->touch);
    return normal->on == touch->block[touch->gap.tip_of];
}

void tinker_writer_add_contacts(TinkerEquationWriter *writer)
{
    const GArray *forces = writer->state->forces;
    for (guint i = 0; i < forces->len; i++) {
        const TinkerActingForce *normal = &g_array_index(forces, TinkerActingForce, i);
        if (normal->kind != TINKER_ACTING_NORMAL) continue;
        const TinkerActingForce *friction = friction_beside(forces, i);
        const gboolean is_known = normal->touch >= 0;
        double n[2];
        if (is_known ? !is_on_tip(writer, normal)
                     : !g_hash_table_contains(writer->body_of, GINT_TO_POINTER(normal->on)))
            continue;
        if (!is_known && !is_of_top(writer, normal, n)) {
            add_unlike(writer, normal);
            if (friction != NULL) add_unlike(writer, friction);
            continue;
        }
        g_autofree char *index = index_of(writer, normal, i);
        add_contact(writer, normal, friction,
                    is_known ? g_array_index(writer->state->touches, TinkerActingTouch, normal->touch).normal : n,
                    index);
    }
}
