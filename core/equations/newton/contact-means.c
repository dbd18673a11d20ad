#include "equations/newton/contact-means.h"

#include <float.h>
#include <math.h>

#include "law/build.h"

/* A place in the axes of a body, from its centre. */
static void in_axes_of(const TinkerEquationWriter *writer, const TinkerPointSymbols *centre, const double place[2],
                       double own[2])
{
    const TinkerBodySample *at = tinker_model_state_body(writer->state, centre->block);
    const double angle = tinker_equations_value(writer->equations, centre->angle), c = cos(angle), s = sin(angle);
    const double rx = place[0] - at->x, ry = place[1] - at->y;
    own[0] = c * rx + s * ry;
    own[1] = c * ry - s * rx;
}

/* A body that does not turn, and a support, need no arm. */
static void add_side(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerBlockId block,
                     const TinkerContactArmNames *names, TinkerContactSide *side)
{
    const TinkerBodyEquation *equation = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(block));
    double own[2];
    tinker_writer_centre(writer, block, &side->point);
    if (equation == NULL || equation->inertia == NULL) return;
    in_axes_of(writer, &side->point, block == contact->seat ? contact->at_seat : contact->at, own);
    tinker_contact_add_arm(writer, contact, side, names, own);
}

void tinker_contact_mean_geometry(TinkerEquationWriter *writer, const TinkerContactForce *contact,
                                  TinkerContactGeometry *geometry)
{
    static const char *const components[] = {"x", "y"};
    const TinkerContactArmNames of_tip = {contact->tip, "a", "r"}, of_seat = {contact->seat, "b", "q"};
    *geometry = (TinkerContactGeometry){0};
    add_side(writer, contact, contact->tip, &of_tip, &geometry->tip);
    add_side(writer, contact, contact->seat, &of_seat, &geometry->seat);
    for (int k = 0; k < 2; k++) {
        const gboolean across = fabs(contact->direction[k]) <= DBL_EPSILON; /* but for rounding */
        const double n = across ? 0 : contact->direction[k];
        geometry->normal[k] =
            n == 0 || fabs(n) == 1
                ? tinker_expression_number(n)
                : tinker_writer_symbol(writer, tinker_contact_name(writer, contact, "n", components[k]), contact->seat,
                                       n, tinker_pure_dimension, NULL, "direction of the normal force");
    }
}

void tinker_contact_note_mean(TinkerEquationWriter *writer, const TinkerContactForce *contact, const char *symbol)
{
    tinker_writer_note_unwritten(writer, contact->seat, symbol,
                                 "contact as impulses: its forces are the means of the last step");
}
