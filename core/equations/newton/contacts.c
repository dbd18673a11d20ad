/* Which forces of contact a scene has, and what touches in each. */
#include <math.h>

#include "equations/newton/contact-terms.h"

/* From what a normal force is of to what it is on. */
static void normal_of(const TinkerEquationWriter *writer, const TinkerActingForce *acting, double n[2])
{
    const double size = hypot(acting->fx, acting->fy);
    if (acting->touch >= 0) {
        const TinkerActingTouch *touch = &g_array_index(writer->state->touches, TinkerActingTouch, acting->touch);
        n[0] = touch->normal[0];
        n[1] = touch->normal[1];
    } else if (acting->is_mean && size > 0) {
        n[0] = acting->fx / size;
        n[1] = acting->fy / size;
    } else { /* it is a top */
        double angle, place[2];
        tinker_frame_centre(writer->frame, acting->by, &place[0], &place[1], &angle);
        n[0] = -sin(angle);
        n[1] = cos(angle);
    }
}

/* Where no gap function is known it is a mass on a top. */
static TinkerTouchShape shape_of(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    const TinkerBodyEquation *equation = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(contact->tip));
    const gboolean turns = equation != NULL && equation->inertia != NULL;
    if (contact->touch == NULL || (!turns && tinker_contact_is_on_top(writer, contact))) return TINKER_TOUCHES_AS_MASS;
    return contact->touch->gap.tip_radius > 0 ? TINKER_TOUCHES_AS_DISC : TINKER_TOUCHES_AT_CORNER;
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

/* Of the four forces of a contact. */
static void add_contact(TinkerEquationWriter *writer, const TinkerActingForce *forces, const char *index)
{
    const TinkerActingForce *normal = &forces[0], *friction = &forces[2];
    double n[2];
    normal_of(writer, normal, n);
    TinkerContactForce contact = {.tip = normal->on,
                                  .seat = normal->by,
                                  .normal = n[0] * normal->fx + n[1] * normal->fy,
                                  .friction = n[1] * friction->fx - n[0] * friction->fy,
                                  .moment = friction->torque,
                                  .at = {normal->x, normal->y},
                                  .index = index,
                                  .is_mean = normal->is_mean,
                                  .direction = {n[0], n[1]},
                                  .at_seat = {forces[1].x, forces[1].y}};
    if (normal->touch >= 0) contact.touch = &g_array_index(writer->state->touches, TinkerActingTouch, normal->touch);
    contact.shape = shape_of(writer, &contact);
    tinker_writer_add_contact(writer, &contact);
}

void tinker_writer_add_contacts(TinkerEquationWriter *writer)
{
    const GArray *forces = writer->state->forces;
    for (guint i = 0; i < forces->len; i++) {
        const TinkerActingForce *first = &g_array_index(forces, TinkerActingForce, i);
        if (first->kind != TINKER_ACTING_NORMAL || first->is_answer) continue;
        g_autofree char *index = index_of(writer, first, i);
        add_contact(writer, first, index);
    }
}
