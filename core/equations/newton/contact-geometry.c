/* With n from the seat to the tip and t = (n_y, -n_x), d from the centre of the seat's block to the tip, r the radius
 * of a disc at the tip:
 *
 *     on an edge     gap n . d - h - r       h: from the centre to the edge; of a support half its height, and half
 *                    rolled t . d + r (theta_tip - theta_seat)                  that of a mass, which is a point
 *     on a round     gap |d| - s - r         d from the round, s its radius; n = d / |d|
 *                    rolled r theta_tip + s theta_seat - (r + s) atan2(d_y, d_x) */
#include "equations/newton/contact-geometry.h"

#include <float.h>
#include <math.h>

#include "law/build.h"

/* rad: an edge that looks along an axis of its body to within this does so. */
#define ALONG_AXIS 1e-12

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

static TinkerExpression *across(TinkerExpression *const direction[2], const TinkerExpression *x,
                                const TinkerExpression *y)
{
    return tinker_expression_plus(tinker_expression_times(copy(direction[0]), copy(x)),
                                  tinker_expression_times(copy(direction[1]), copy(y)));
}

/* The tip ---------------------------------------------------------------------------------------------------------- */

static void add_tip(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerContactSide *tip)
{
    const TinkerContactArmNames names = {contact->tip, "a", "r"};
    double own[2] = {0, 0};
    tinker_writer_centre(writer, contact->tip, &tip->point);
    if (contact->shape == TINKER_TOUCHES_AS_DISC)
        tip->radius = tinker_writer_meaning(writer, contact->tip, TINKER_MEANING_RADIUS, 0, "R");
    if (contact->shape == TINKER_TOUCHES_AT_CORNER)
        tinker_contact_in_block_axes(tip, contact->touch->angle[contact->touch->gap.tip_of], contact->touch->gap.tip,
                                     own);
    tinker_contact_add_arm(writer, contact, tip, &names, own);
}

/* The seat --------------------------------------------------------------------------------------------------------- */

static TinkerExpression *half(TinkerExpression *height)
{
    return tinker_expression_over(height, tinker_expression_number(2));
}

/* A number of an edge: the symbol that a contact before this one has for it, or a new one. */
static TinkerExpression *edge_symbol(TinkerEquationWriter *writer, TinkerBlockId block, const char *stem, double value,
                                     TinkerDimension dimension, const char *means, double rounding)
{
    const GPtrArray *symbols = writer->equations->symbols;
    g_autoptr(GString) index = g_string_new(tinker_writer_index(writer, block));
    int others = 0;
    for (guint i = 0; i < symbols->len; i++) {
        const TinkerEquationSymbol *each = g_ptr_array_index(symbols, i);
        if (each->block != block || g_strcmp0(each->quantity, means) != 0) continue;
        if (each->value == value) return tinker_expression_symbol(each->name);
        others++;
    }
    if (others > 0) g_string_append_printf(index, "%s%d", index->len > 0 ? "," : "", others + 1);
    const char *name = tinker_equations_free_name(writer->equations, block, stem, index->str, 0, NULL);
    tinker_equations_set_rounding(writer->equations, name, rounding);
    return tinker_writer_symbol(writer, name, block, value, dimension, NULL, means);
}

/* A unit vector that turns with a block, `direction` (rad) from its own x axis. */
static void turned(TinkerEquationWriter *writer, const TinkerContactForce *contact, const TinkerExpression *angle,
                   double direction, TinkerExpression *vector[2])
{
    const double quarter = round(direction / G_PI_2);
    const gboolean along_axis = fabs(direction - quarter * G_PI_2) <= ALONG_AXIS;
    if (along_axis && tinker_expression_is_number(angle, 0)) {
        vector[0] = tinker_expression_number(round(cos(direction)));
        vector[1] = tinker_expression_number(round(sin(direction)));
        return;
    }
    TinkerExpression *of = copy(angle);
    if (!along_axis) {
        of = tinker_expression_plus(of, edge_symbol(writer, contact->seat, "β", direction, tinker_angle_dimension,
                                                    "direction across its edge", DBL_EPSILON * G_PI));
    }
    TinkerExpression *c = tinker_expression_call("cos", copy(of)), *s = tinker_expression_call("sin", of);
    switch (along_axis ? (int)quarter & 3 : 0) {
    case 0:
        vector[0] = c;
        vector[1] = s;
        return;
    case 1:
        vector[0] = tinker_expression_negated(s);
        vector[1] = c;
        return;
    case 2:
        vector[0] = tinker_expression_negated(c);
        vector[1] = tinker_expression_negated(s);
        return;
    default:
        vector[0] = s;
        vector[1] = tinker_expression_negated(c);
    }
}

static void add_top(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerContactGeometry *geometry)
{
    turned(writer, contact, geometry->seat.point.angle, G_PI_2, geometry->normal);
    geometry->off = half(tinker_writer_meaning(writer, contact->seat, TINKER_MEANING_HEIGHT, 0, "H"));
    if (contact->shape == TINKER_TOUCHES_AS_MASS)
        geometry->off = tinker_expression_plus(
            geometry->off, half(tinker_writer_meaning(writer, contact->tip, TINKER_MEANING_HEIGHT, 0, "h")));
}

static void add_edge(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerContactGeometry *geometry)
{
    const TinkerGapFunction *gap = &contact->touch->gap;
    double n[2];
    tinker_contact_in_block_axes(&geometry->seat, contact->touch->angle[1 - gap->tip_of], gap->normal, n);
    turned(writer, contact, geometry->seat.point.angle, atan2(n[1], n[0]), geometry->normal);
    geometry->off =
        edge_symbol(writer, contact->seat, "h", gap->normal[0] * gap->seat[0] + gap->normal[1] * gap->seat[1],
                    tinker_length_dimension, "from its centre to its edge", tinker_contact_rounding(writer, contact));
}

static void add_round(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerContactGeometry *geometry)
{
    const TinkerContactArmNames names = {contact->seat, "b", "q"};
    const TinkerGapFunction *gap = &contact->touch->gap;
    TinkerContactSide *seat = &geometry->seat;
    double own[2];
    if (gap->seat_radius > 0)
        seat->radius = tinker_writer_meaning(writer, contact->seat, TINKER_MEANING_RADIUS, 0, "R");
    tinker_contact_in_block_axes(seat, contact->touch->angle[1 - gap->tip_of], gap->seat, own);
    tinker_contact_add_arm(writer, contact, seat, &names, own);
    if (seat->point.arm_x != NULL) {
        geometry->dx = tinker_expression_minus(geometry->dx, copy(seat->point.arm_x));
        geometry->dy = tinker_expression_minus(geometry->dy, copy(seat->point.arm_y));
    }
    TinkerExpression *square = tinker_expression_plus(tinker_expression_squared(copy(geometry->dx)),
                                                      tinker_expression_squared(copy(geometry->dy)));
    const char *name = tinker_contact_name(writer, contact, "d", NULL);
    geometry->distance =
        tinker_writer_define(writer, name, contact->seat, tinker_length_dimension, "distance of what touches",
                             tinker_expression_call("sqrt", square), FALSE);
    geometry->normal[0] = tinker_expression_over(copy(geometry->dx), copy(geometry->distance));
    geometry->normal[1] = tinker_expression_over(copy(geometry->dy), copy(geometry->distance));
}

/* Both ------------------------------------------------------------------------------------------------------------- */

gboolean tinker_contact_is_on_top(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    return tinker_block_class_stands(tinker_scene_block_class(writer->scene, contact->seat)) &&
           (contact->touch == NULL || !contact->touch->gap.round);
}

void tinker_contact_geometry_init(TinkerEquationWriter *writer, const TinkerContactForce *contact,
                                  TinkerContactGeometry *geometry)
{
    *geometry = (TinkerContactGeometry){0};
    tinker_writer_centre(writer, contact->seat, &geometry->seat.point);
    add_tip(writer, contact, &geometry->tip);
    const TinkerPointSymbols *tip = &geometry->tip.point, *seat = &geometry->seat.point;
    geometry->dx = tinker_expression_minus(copy(tip->x), copy(seat->x));
    geometry->dy = tinker_expression_minus(copy(tip->y), copy(seat->y));
    if (tip->arm_x != NULL) {
        geometry->dx = tinker_expression_plus(geometry->dx, copy(tip->arm_x));
        geometry->dy = tinker_expression_plus(geometry->dy, copy(tip->arm_y));
    }
    if (tinker_contact_is_on_top(writer, contact))
        add_top(writer, contact, geometry);
    else if (contact->touch->gap.round)
        add_round(writer, contact, geometry);
    else
        add_edge(writer, contact, geometry);
}

void tinker_contact_geometry_clear(TinkerContactGeometry *geometry)
{
    TinkerExpression **const parts[] = {&geometry->normal[0], &geometry->normal[1], &geometry->dx,
                                        &geometry->dy,        &geometry->off,       &geometry->distance};
    tinker_contact_side_clear(&geometry->tip);
    tinker_contact_side_clear(&geometry->seat);
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        g_clear_pointer(parts[i], tinker_expression_unref);
}

TinkerExpression *tinker_contact_gap(const TinkerContactGeometry *geometry)
{
    const TinkerContactSide *tip = &geometry->tip, *seat = &geometry->seat;
    TinkerExpression *gap, *radii = tinker_expression_number(0);
    if (geometry->distance != NULL) {
        gap = copy(geometry->distance);
        if (seat->radius != NULL) radii = tinker_expression_plus(radii, copy(seat->radius));
    } else {
        gap = across(geometry->normal, geometry->dx, geometry->dy);
        radii = tinker_expression_plus(radii, copy(geometry->off));
    }
    if (tip->radius != NULL) radii = tinker_expression_plus(radii, copy(tip->radius));
    return tinker_expression_minus(gap, radii);
}

TinkerExpression *tinker_contact_along(const TinkerContactGeometry *geometry)
{
    return tinker_expression_minus(tinker_expression_times(copy(geometry->normal[1]), copy(geometry->dx)),
                                   tinker_expression_times(copy(geometry->normal[0]), copy(geometry->dy)));
}

static TinkerExpression *turn_of(const TinkerContactSide *side, TinkerExpression *radius)
{
    return tinker_expression_times(radius, copy(side->point.angle));
}

TinkerExpression *tinker_contact_rolled(const TinkerContactGeometry *geometry)
{
    const TinkerContactSide *tip = &geometry->tip, *seat = &geometry->seat;
    if (geometry->distance == NULL) {
        TinkerExpression *along = tinker_contact_along(geometry);
        if (tip->radius == NULL) return along;
        TinkerExpression *angle = copy(tip->point.angle);
        if (!tinker_expression_is_number(seat->point.rate, 0))
            angle = tinker_expression_minus(angle, copy(seat->point.angle));
        return tinker_expression_plus(along, tinker_expression_times(copy(tip->radius), angle));
    }
    TinkerExpression *radii = tinker_expression_number(0), *rolled = tinker_expression_number(0);
    if (tip->radius == NULL && seat->radius == NULL) {
        tinker_expression_unref(radii);
        tinker_expression_unref(rolled);
        return NULL;
    }
    for (int k = 0; k < 2; k++) {
        const TinkerContactSide *of = k == 0 ? tip : seat;
        if (of->radius == NULL) continue;
        radii = tinker_expression_plus(radii, copy(of->radius));
        rolled = tinker_expression_plus(rolled, turn_of(of, copy(of->radius)));
    }
    TinkerExpression *const towards[2] = {copy(geometry->dy), copy(geometry->dx)};
    TinkerExpression *direction = tinker_expression_node(TINKER_EXPRESSION_FUNCTION, "atan2", towards, 2);
    return tinker_expression_minus(rolled, tinker_expression_times(radii, direction));
}
