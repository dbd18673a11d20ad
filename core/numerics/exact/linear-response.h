/* What a set of coupled oscillators does within a time h, to rounding: the matrix of
 *
 *     eta'' + C eta' + diag(omega^2) eta = drive r(t),    r' = N r
 *
 * and the integrals that energy books need. The state is z = (scale eta, eta', r); with scale = omega it cannot grow
 * where C is positive, so that doubling the time never overflows nor amplifies rounding.
 */
#ifndef TINKER_NUMERICS_LINEAR_RESPONSE_H
#define TINKER_NUMERICS_LINEAR_RESPONSE_H

#include <glib.h>

/* The scale of a mode: omega, or 1 where that is 0. */
static inline double tinker_linear_scale(double omega)
{
    return omega > 0.0 ? omega : 1.0;
}

/* F = exp(A h) - I of one damped oscillator eta'' + c eta' + omega^2 eta = 0, as {F00, F01, F10, F11} on (scale
 * eta, eta'). Closed form: under-, over- and critically damped, slow roots to rounding of their own size. */
void tinker_linear_oscillator(double omega, double c, double h, double propagator[4]);

/* What a force of 1 that stays adds to (scale eta, eta') of the same oscillator within h, given its propagator. */
void tinker_linear_push(double omega, double c, double h, const double propagator[4], double push[2]);

/* Inputs that belong together: 1 (a constant), 4 (t^k / k! and its derivatives) or 2 (sine and cosine of rate t). The
 * first of them is the input's value. */
typedef struct {
    int32_t first, count;
    double rate; /* rad/s, of 2 */
} TinkerLinearInput;

/* An integral of (direction . eta') times what the input was; one row per entry of the input. */
typedef struct {
    int32_t input;           /* index of TinkerLinearInput */
    const double *direction; /* size */
} TinkerLinearMoment;

typedef struct {
    int32_t size, input_count, entries; /* entries: of r */
    const double *omega;
    const double *damping; /* size x size */
    const double *drive;   /* size x entries */
    const TinkerLinearInput *inputs;
    int32_t form_count, moment_count;
    const double *forms[2];            /* size x size, symmetric: integrals of eta'^T form eta' */
    const TinkerLinearMoment *moments; /* moment_count */
} TinkerLinearOscillators;

/* Rows of all moments together. */
int32_t tinker_linear_moment_rows(const TinkerLinearOscillators *oscillators);

/* Doubles of work memory that one calculation needs. */
gsize tinker_linear_response_work(const TinkerLinearOscillators *oscillators);

/* An upper bound on the rate (1/s) of anything in the system: |A| and the inputs' rates. */
double tinker_linear_rate(const TinkerLinearOscillators *oscillators);

/* With D = 2 size + entries: `propagator` (D x D) = exp - I over h; form_count matrices (D x D) such that z^T form
 * z with z at the start is the integral; the moments (rows x D), rows in the order of moments and of their inputs'
 * entries, to be multiplied with z at the start and summed with the inputs at the start. `rate` as above. FALSE
 * where h is so long that the doublings would exceed 1000. */
gboolean tinker_linear_response(const TinkerLinearOscillators *oscillators, double rate, double h, double *propagator,
                                double *const *forms, double *moments, double *work);

/* rate * h up to which a series over h alone is accurate to rounding. */
#define TINKER_LINEAR_SERIES_REACH 1.0

/* The change within h, rate * |h| <= TINKER_LINEAR_SERIES_REACH, of (scale eta, eta') from the vector z = (scale eta,
 * eta', r): `change` has 2 size entries, `work` room for 2 (2 size + entries). Forms and moments are not looked at. */
void tinker_linear_series(const TinkerLinearOscillators *oscillators, double rate, double h, const double *z,
                          double *change, double *work);

/* How often the time is doubled for a step of h. */
int32_t tinker_linear_doublings(double rate, double h);

/* What the inputs with `count` entries become in h, minus themselves: gain (count x count). */
void tinker_linear_input_gain(const TinkerLinearInput *input, double h, double *gain);

#endif
