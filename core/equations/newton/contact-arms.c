#include "equations/newton/contact-arms.h"

#include <float.h>
#include <math.h>

#include "law/build.h"

static TinkerExpression *copy(const TinkerExpression *expression)
{
    return tinker_expression_ref(expression);
}

const char *tinker_contact_name(TinkerEquationWriter *writer, const TinkerContactForce *contact, const char *stem,
                                const char *component)
{
    if (contact->index == NULL) return tinker_writer_name(writer, contact->seat, stem, 0, component);
    return tinker_equations_free_name(writer->equations, contact->seat, stem, contact->index, 0, component);
}

void tinker_contact_side_clear(TinkerContactSide *side)
{
    tinker_point_symbols_clear(&side->point);
    g_clear_pointer(&side->radius, tinker_expression_unref);
}

double tinker_contact_rounding(const TinkerEquationWriter *writer, const TinkerContactForce *contact)
{
    return DBL_EPSILON * (hypot(contact->at[0], contact->at[1]) + writer->extent);
}

void tinker_contact_add_arm(TinkerEquationWriter *writer, const TinkerContactForce *contact, TinkerContactSide *side,
                            const TinkerContactArmNames *names, const double own[2])
{
    static const char *const components[] = {"x", "y"};
    const gboolean is_body = side->point.block >= 0;
    const TinkerBlockId owner = is_body ? contact->seat : names->of;
    const TinkerExpression *angle = side->point.angle;
    TinkerExpression *local[2], *arm[2];
    if (own[0] == 0 && own[1] == 0) return;
    for (int k = 0; k < 2; k++) {
        local[k] =
            tinker_writer_symbol(writer, tinker_contact_name(writer, contact, names->local, components[k]), owner,
                                 own[k], tinker_length_dimension, NULL,
                                 is_body ? "where it touches, in the body's axes" : "its corner, in its own axes");
        tinker_equations_set_rounding(writer->equations, local[k]->name, tinker_contact_rounding(writer, contact));
    }
    if (tinker_expression_is_number(angle, 0)) {
        side->point.arm_x = local[0];
        side->point.arm_y = local[1];
        return;
    }
    arm[0] =
        tinker_expression_minus(tinker_expression_times(copy(local[0]), tinker_expression_call("cos", copy(angle))),
                                tinker_expression_times(copy(local[1]), tinker_expression_call("sin", copy(angle))));
    arm[1] = tinker_expression_plus(tinker_expression_times(local[0], tinker_expression_call("sin", copy(angle))),
                                    tinker_expression_times(local[1], tinker_expression_call("cos", copy(angle))));
    for (int k = 0; k < 2; k++)
        arm[k] = tinker_writer_define(
            writer, tinker_contact_name(writer, contact, names->arm, components[k]), owner, tinker_length_dimension,
            is_body ? "arm from the centre of mass" : "from its centre to its corner", arm[k], FALSE);
    side->point.arm_x = arm[0];
    side->point.arm_y = arm[1];
}

void tinker_contact_in_block_axes(const TinkerContactSide *side, double angle, const double place[2], double own[2])
{
    const gboolean stays = tinker_expression_is_number(side->point.angle, 0);
    const double c = stays ? cos(angle) : 1, s = stays ? sin(angle) : 0;
    own[0] = c * place[0] - s * place[1];
    own[1] = s * place[0] + c * place[1];
}
