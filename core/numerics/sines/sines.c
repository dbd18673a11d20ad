/* Sine and cosine of many angles: an angle less the multiple of pi/2 that is nearest to it (Cody and Waite: Software
 * Manual for the Elementary Functions, 1980, with pi/2 in three parts), and there the polynomials of fdlibm
 * (k_sin.c, k_cos.c; Sun Microsystems, 1993). No branch, so that a compiler does several angles at once. */
#include "numerics/sines/sines.h"

#include <math.h>
#include <string.h>
#include <tinker/types.h>

/* Below it a multiple has at most 20 bits, and its product with a part of 33 is exact. */
#define LARGEST 1e6

/* pi/2, by 33 bits, 33 bits and the rest. */
#define QUARTER_HEAD   0x1.921fb544p+0
#define QUARTER_MIDDLE 0x1.0b4611a6p-34
#define QUARTER_TAIL   0x1.3198a2e037073p-69

/* Added to a number below 2^51, it leaves the nearest integer in the last bits. */
#define ROUNDER 0x1.8p52

typedef struct {
    uint64_t quarters; /* the multiple, modulo 4 in its last two bits */
    double rest, tail; /* of the angle, |rest| <= pi/4 */
} Reduced;

static inline uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline Reduced reduce(double angle)
{
    const double rounded = angle * M_2_PI + ROUNDER, n = rounded - ROUNDER;
    const double first = angle - n * QUARTER_HEAD, middle = n * QUARTER_MIDDLE;
    /* what the difference of the two lost in rounding (Knuth's sum of two) */
    const double difference = first - middle, back = difference - first;
    const double lost = (first - (difference - back)) - (middle + back) - n * QUARTER_TAIL;
    const double rest = difference + lost;
    return (Reduced){bits_of(rounded), rest, (difference - rest) + lost};
}

static inline double sine_near_zero(double x, double tail)
{
    const double z = x * x, v = z * x;
    const double r = 0x1.111111110f8a6p-7 +
                     z * (-0x1.a01a019c161d5p-13 +
                          z * (0x1.71de357b1fe7dp-19 + z * (-0x1.ae5e68a2b9cebp-26 + z * 0x1.5d93a5acfd57cp-33)));
    return x - ((z * (0.5 * tail - v * r) - tail) - v * -0x1.5555555555549p-3);
}

static inline double cosine_near_zero(double x, double tail)
{
    const double z = x * x, w = z * z;
    const double r = z * (0x1.555555555554cp-5 + z * (-0x1.6c16c16c15177p-10 + z * 0x1.a01a019cb159p-16)) +
                     w * w * (-0x1.27e4f809c52adp-22 + z * (0x1.1ee9ebdb4b1c4p-29 + z * -0x1.8fae9be8838d4p-37));
    const double half = 0.5 * z, head = 1 - half;
    return head + (((1 - head) - half) + (z * r - x * tail));
}

TINKER_VARIANTS void tinker_sines(int32_t count, const double *restrict angles, double *restrict sines,
                                  double *restrict cosines)
{
    for (int32_t i = 0; i < count; i++) {
        const Reduced at = reduce(angles[i]);
        const uint64_t sine = bits_of(sine_near_zero(at.rest, at.tail));
        const uint64_t cosine = bits_of(cosine_near_zero(at.rest, at.tail));
        const uint64_t odd = -(at.quarters & 1); /* all bits or none: the two change places */
        sines[i] = of_bits(((sine & ~odd) | (cosine & odd)) ^ ((at.quarters & 2) << 62));
        cosines[i] = of_bits(((cosine & ~odd) | (sine & odd)) ^ (((at.quarters + 1) & 2) << 62));
    }
    for (int32_t i = 0; i < count; i++)
        if (!(fabs(angles[i]) < LARGEST)) {
            sines[i] = sin(angles[i]);
            cosines[i] = cos(angles[i]);
        }
}
