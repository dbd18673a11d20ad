/* A line law with a kink. */
#include "planted.h"

/* rub: Hertz's contact, F (e / D)^1.5 with e = D - L where that is positive, and dry friction that is rounded off, R
 * tanh(rate / s): right, with a kink in the slope and a bend within centimetres. */

enum { HARDNESS, DIAMETER, FRICTION, ROUNDING };

static double depth_of(const TinkerBatch *batch, int32_t i, double length)
{
    return fmax(0, 1 - length / tinker_column(batch, DIAMETER)[i]);
}

static TinkerStatus rub_tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    for (int32_t i = 0; i < batch->count; i++)
        result[i] = tinker_column(batch, FRICTION)[i] * tanh(rate[i] / tinker_column(batch, ROUNDING)[i]) -
                    tinker_column(batch, HARDNESS)[i] * pow(depth_of(batch, i, length[i]), 1.5);
    return TINKER_OK;
}

static TinkerStatus rub_derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                    double *by_rate)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const double s = tinker_column(batch, ROUNDING)[i], slowing = 1 / cosh(fmin(fabs(rate[i] / s), 300));
        by_rate[i] = tinker_column(batch, FRICTION)[i] / s * slowing * slowing;
        by_length[i] = 1.5 * tinker_column(batch, HARDNESS)[i] / tinker_column(batch, DIAMETER)[i] *
                       sqrt(depth_of(batch, i, length[i]));
    }
    return TINKER_OK;
}

static TinkerStatus rub_energy(TinkerBatch *batch, const double *length, double *stored)
{
    for (int32_t i = 0; i < batch->count; i++)
        stored[i] = 0.4 * tinker_column(batch, HARDNESS)[i] * tinker_column(batch, DIAMETER)[i] *
                    pow(depth_of(batch, i, length[i]), 2.5);
    return TINKER_OK;
}

const TinkerPropertyType planted_rub_properties[] = {
    {TINKER_REAL_PROPERTY("hardness", "Hardness", "Rub", TINKER_DIMENSION_FORCE), TINKER_NOT_NEGATIVE(0, 20),
     .default_value = {5}, .description = "Force at length 0"},
    {TINKER_REAL_PROPERTY("diameter", "Diameter", "Rub", TINKER_DIMENSION_LENGTH), TINKER_POSITIVE(0, 0.5, 4),
     .default_value = {1}, .description = "Length at which it touches"},
    {TINKER_REAL_PROPERTY("friction", "Friction", "Rub", TINKER_DIMENSION_FORCE), TINKER_NOT_NEGATIVE(0, 5),
     .default_value = {1}, .description = "Force against motion"},
    {TINKER_REAL_PROPERTY("rounding", "Rounding", "Rub", TINKER_DIMENSION_VELOCITY), TINKER_POSITIVE(0, 0.02, 0.2),
     .default_value = {0.05}, .description = "Speed below which the friction is less"},
};

static const TinkerLineLaw rub_law = {
    .struct_size = sizeof(TinkerLineLaw), .tension = rub_tension, .derivatives = rub_derivatives, .energy = rub_energy};

static const TinkerPhysics rub = {.struct_size = sizeof(TinkerPhysics), .line_law = &rub_law};

const TinkerInterface planted_rub_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &rub}};
