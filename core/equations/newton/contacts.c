/* Which forces of contact a scene has: those of tops are written out, others are numbers. */
#include <math.h>

#include "equations/newton/contact-terms.h"

/* Of 1 and of the support's height: a force that is not across the top is not one of its top. */
#define ACROSS 1e-9

/* A contact with something else than a top: its forces are numbers. */
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
        tinker_writer_note_unwritten(writer, acting->by, name, "it touches something else than a support's top");
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

static TinkerTouchShape shape_of(const TinkerEquationWriter *writer, TinkerBlockId body)
{
    const TinkerBodyEquation *equation = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(body));
    if (equation->inertia == NULL) return TINKER_TOUCHES_AS_MASS;
    const TinkerBody *role = tinker_scene_block_class(writer->scene, body)->physics->body;
    return role->shape == TINKER_SHAPE_DISC ? TINKER_TOUCHES_AS_DISC : TINKER_TOUCHES_AT_CORNER;
}

/* How many contacts a support has, and how many of them stand before number `before`, with this body alone where it is
 * one. */
static guint contacts_of(const TinkerEquationWriter *writer, TinkerBlockId support, TinkerBlockId body, guint before)
{
    const GArray *forces = writer->state->forces;
    guint count = 0;
    for (guint i = 0; i < MIN(forces->len, before); i++) {
        const TinkerActingForce *each = &g_array_index(forces, TinkerActingForce, i);
        count += each->kind == TINKER_ACTING_NORMAL && each->by == support && (body < 0 || each->on == body);
    }
    return count;
}

/* "support,body,number", of which each is left out where it tells nothing; NULL: that of the support. (transfer full)
 */
static char *index_of(const TinkerEquationWriter *writer, const TinkerActingForce *acting, guint number)
{
    const guint all = contacts_of(writer, acting->by, -1, G_MAXUINT),
                own = contacts_of(writer, acting->by, acting->on, G_MAXUINT);
    const char *of_support = tinker_writer_index(writer, acting->by);
    g_autoptr(GString) index = g_string_new(of_support);
    if (all == 1) return NULL;
    if (own < all)
        g_string_append_printf(index, "%s%s", index->len > 0 ? "," : "", tinker_writer_index(writer, acting->on));
    if (own > 1)
        g_string_append_printf(index, "%s%u", index->len > 0 ? "," : "",
                               1 + contacts_of(writer, acting->by, acting->on, number));
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

void tinker_writer_add_contacts(TinkerEquationWriter *writer)
{
    const GArray *forces = writer->state->forces;
    for (guint i = 0; i < forces->len; i++) {
        const TinkerActingForce *normal = &g_array_index(forces, TinkerActingForce, i);
        if (normal->kind != TINKER_ACTING_NORMAL ||
            !g_hash_table_contains(writer->body_of, GINT_TO_POINTER(normal->on)))
            continue;
        const TinkerActingForce *friction = friction_beside(forces, i);
        double n[2];
        if (!is_of_top(writer, normal, n)) {
            add_unlike(writer, normal);
            if (friction != NULL) add_unlike(writer, friction);
            continue;
        }
        g_autofree char *index = index_of(writer, normal, i);
        const TinkerTopContact contact = {normal->by,
                                          normal->on,
                                          n[0] * normal->fx + n[1] * normal->fy,
                                          friction != NULL ? n[1] * friction->fx - n[0] * friction->fy : 0,
                                          friction != NULL ? friction->torque : 0,
                                          {normal->x, normal->y},
                                          shape_of(writer, normal->on),
                                          index};
        tinker_writer_add_top_contact(writer, &contact);
    }
}
