/* Falls are found in long double: of degree 10 the Bernstein coefficients may be 700 times the values, and what their
 * rounding leaves must stay below the depth of the narrowest dip that counts. */
#include "numerics/roots/step-roots.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include <glib.h>

/* Rows of tables, a whole number of vector registers long. */
#define STRIDE 12

/* Values this small, as a share of the largest, are neither above nor below. */
#define FLAT 5e-15

/* Halvings after which an interval is as narrow as doubles tell places apart. */
#define DEEPEST 54

typedef struct {
    long double bernstein[STRIDE][STRIDE]; /* of values, by columns: coefficient i takes [j][i] of value j */
    double rounded[STRIDE][STRIDE];        /* the same */
    double lebesgue;                       /* at most: the polynomial strays this many half spreads from the middle */
    double rounding;                       /* what may be lost in `rounded` sums, in half spreads */
} Degree;

/* The Bernstein coefficients, of degree n, of Chebyshev's polynomial of degree k over [0, 1]. */
static void chebyshev_in_bernstein(int32_t n, int32_t k, long double *coefficients)
{
    long double inner = 1, outer = 1; /* k over i, 2k over 2i */
    for (int32_t i = 0; i <= k; i++) {
        coefficients[i] = ((k - i) % 2 ? -1 : 1) * outer / inner;
        inner = inner * (k - i) / (i + 1);
        outer = outer * (2 * k - 2 * i) * (2 * k - 2 * i - 1) / ((2 * i + 1) * (2 * i + 2));
    }
    for (int32_t d = k + 1; d <= n; d++) {
        coefficients[d] = coefficients[d - 1];
        for (int32_t i = d - 1; i > 0; i--)
            coefficients[i] = (i * coefficients[i - 1] + (d - i) * coefficients[i]) / d;
    }
}

/* Values to Chebyshev's coefficients (a cosine transform), and those to Bernstein's. */
static void fill_bernstein(int32_t n, Degree *degree)
{
    if (n == 0) degree->bernstein[0][0] = 1;
    for (int32_t k = 0; k <= n && n > 0; k++) {
        long double coefficients[STRIDE];
        chebyshev_in_bernstein(n, k, coefficients);
        for (int32_t j = 0; j <= n; j++) {
            long double weight = 2 * cosl((long double)M_PIl * ((k * (n - j)) % (2 * n)) / n) / n;
            if (j == 0 || j == n) weight /= 2;
            if (k == 0 || k == n) weight /= 2;
            for (int32_t i = 0; i <= n; i++)
                degree->bernstein[j][i] += weight * coefficients[i];
        }
    }
}

/* The Lebesgue constant of the n + 1 extrema of Chebyshev's polynomial of degree n is at most that of its n zeros,
 * which is in closed form. Source: Ehlich, Zeller, "Auswertung der Normen von Interpolationsoperatoren", Math. Ann. 164
 * (1966). */
static double lebesgue_bound(int32_t n)
{
    double sum = n == 0;
    for (int32_t k = 1; k <= n; k++)
        sum += 1 / tan((2 * k - 1) * G_PI / (4 * n)) / n;
    return sum * (1 + 1e-14);
}

static const Degree *degrees(void)
{
    static Degree all[TINKER_MOST_DEGREE + 1];
    static gsize once = 0;
    if (g_once_init_enter(&once)) {
        for (int32_t n = 0; n <= TINKER_MOST_DEGREE; n++) {
            double largest = 0;
            fill_bernstein(n, &all[n]);
            for (int32_t i = 0; i <= n; i++) {
                double row = 0;
                for (int32_t j = 0; j <= n; j++) {
                    all[n].rounded[j][i] = (double)all[n].bernstein[j][i];
                    row += fabs(all[n].rounded[j][i]);
                }
                largest = MAX(largest, row);
            }
            all[n].lebesgue = lebesgue_bound(n);
            all[n].rounding = (n + 3) * DBL_EPSILON * largest;
        }
        g_once_init_leave(&once, 1);
    }
    return all;
}

void tinker_step_nodes(int32_t degree, double *nodes)
{
    for (int32_t k = 0; 2 * k <= degree; k++) {
        double root = sin(k * G_PI / (2.0 * MAX(degree, 1)));
        nodes[degree - k] = 1 - root * root;
        nodes[k] = root * root;
    }
    if (degree > 0 && degree % 2 == 0) nodes[degree / 2] = 0.5;
}

/* What a bound needs to know of values. */
typedef struct {
    double middle, half; /* of what they lie between */
    double rounding;     /* of a value */
} Spread;

/* FALSE where a value is no number. */
static gboolean find_spread(int32_t degree, const double *values, Spread *spread)
{
    double low = values[0], high = values[0], total = values[0];
    for (int32_t j = 1; j <= degree; j++) {
        low = values[j] < low ? values[j] : low;
        high = values[j] > high ? values[j] : high;
        total += values[j];
    }
    *spread = (Spread){low + 0.5 * (high - low), 0.5 * (high - low), 8 * DBL_EPSILON * MAX(fabs(low), fabs(high))};
    return isfinite(total);
}

/* The coefficients of what the polynomial is beyond the middle of its values. */
static void fill_coefficients(int32_t degree, const double *values, double middle, double coefficients[STRIDE])
{
    const Degree *table = &degrees()[degree];
    memset(coefficients, 0, STRIDE * sizeof(double));
    for (int32_t j = 0; j <= degree; j++)
        for (int32_t i = 0; i < STRIDE; i++)
            coefficients[i] += table->rounded[j][i] * (values[j] - middle);
}

static double least_coefficient(int32_t degree, const double *coefficients)
{
    double least = coefficients[0];
    for (int32_t i = 1; i <= degree; i++)
        least = coefficients[i] < least ? coefficients[i] : least;
    return least;
}

double tinker_step_least(int32_t degree, const double *values)
{
    const Degree *table = &degrees()[degree];
    double coefficients[STRIDE];
    Spread of;
    if (!find_spread(degree, values, &of)) return -HUGE_VAL;
    double cheap = of.middle - (table->lebesgue * of.half + of.rounding);
    if (cheap > 0) return cheap;
    fill_coefficients(degree, values, of.middle, coefficients);
    double least = least_coefficient(degree, coefficients);
    return MAX(cheap, of.middle + least - (table->rounding * of.half + of.rounding));
}

double tinker_step_least_before(int32_t degree, const double *values, double place)
{
    double c[STRIDE];
    Spread of;
    if (!find_spread(degree, values, &of)) return -HUGE_VAL;
    fill_coefficients(degree, values, of.middle, c);
    for (int32_t level = 1; level <= degree; level++)
        for (int32_t i = degree; i >= level; i--)
            c[i] = (1 - place) * c[i - 1] + place * c[i];
    /* averages are rounded 2 n times at most, by as much as the coefficients are large */
    return of.middle + least_coefficient(degree, c) - (3 * degrees()[degree].rounding * of.half + of.rounding);
}

typedef struct {
    int32_t degree;
    long double whole[STRIDE]; /* coefficients over [0, 1] */
    long double flat;
    gboolean above;     /* where the search is, the polynomial was last seen above rather than below */
    double above_place; /* the last place where it was, if so */
    double *places;
    int32_t room, count;
} Search;

/* Of the halves of an interval, by de Casteljau: `coefficients` become those of the left one. */
static void halve(int32_t degree, long double *coefficients, long double *right)
{
    for (int32_t last = degree; last >= 0; last--) {
        right[last] = coefficients[degree];
        for (int32_t i = degree; i > degree - last; i--)
            coefficients[i] = (coefficients[i - 1] + coefficients[i]) / 2;
    }
}

static double evaluate(void *data, double place)
{
    const Search *search = data;
    long double coefficients[STRIDE], share = place;
    memcpy(coefficients, search->whole, sizeof coefficients);
    for (int32_t last = search->degree; last > 0; last--)
        for (int32_t i = 0; i < last; i++)
            coefficients[i] = (1 - share) * coefficients[i] + share * coefficients[i + 1];
    return (double)coefficients[0];
}

static void see_above(Search *search, double place)
{
    search->above = TRUE;
    search->above_place = place;
}

static void see_below(Search *search, double place)
{
    if (search->above && search->count < search->room)
        search->places[search->count++] = tinker_step_refine(search->above_place, place, evaluate, search);
    search->above = FALSE;
}

/* Looks at an interval whose polynomial keeps to one side or is monotonic; FALSE where it has to be halved. */
static gboolean look(Search *search, const long double *coefficients, double from, double to)
{
    int32_t degree = search->degree;
    long double flat = search->flat, low = coefficients[0], high = coefficients[0];
    gboolean rises = TRUE, falls = TRUE;
    for (int32_t i = 1; i <= degree; i++) {
        low = MIN(low, coefficients[i]);
        high = MAX(high, coefficients[i]);
        rises = rises && coefficients[i] >= coefficients[i - 1];
        falls = falls && coefficients[i] <= coefficients[i - 1];
    }
    long double first = coefficients[0], last = coefficients[degree];
    gboolean may_be_below = low<-flat, may_be_above = high> flat;
    if ((may_be_below && may_be_above && !rises && !falls) || (may_be_below && first >= -flat && last >= -flat) ||
        (may_be_above && first <= flat && last <= flat))
        return FALSE;
    if (first > flat) see_above(search, from);
    if (first < -flat) see_below(search, from);
    if (last > flat) see_above(search, to);
    if (last < -flat) see_below(search, to);
    return TRUE;
}

static void scan(Search *search, long double *coefficients, double from, double to, int32_t depth)
{
    if (look(search, coefficients, from, to)) return;
    if (depth == DEEPEST) {
        if (coefficients[search->degree] > search->flat) see_above(search, to);
        if (coefficients[search->degree] < -search->flat) see_below(search, to);
        return;
    }
    long double right[STRIDE];
    double middle = from + 0.5 * (to - from);
    halve(search->degree, coefficients, right);
    scan(search, coefficients, from, middle, depth + 1);
    scan(search, right, middle, to, depth + 1);
}

int32_t tinker_step_falls(int32_t degree, const double *values, double level, double *places, int32_t room)
{
    const Degree *table = &degrees()[degree];
    Search search = {.degree = degree, .places = places, .room = room};
    double largest = fabs(level), total = level;
    for (int32_t j = 0; j <= degree; j++) {
        largest = MAX(largest, fabs(values[j]));
        total += values[j];
        for (int32_t i = 0; i <= degree; i++)
            search.whole[i] += table->bernstein[j][i] * ((long double)values[j] - level);
    }
    if (!isfinite(total)) return 0;
    search.flat = FLAT * largest;
    /* at both ends signs count as they are, so that a fall between two steps belongs to exactly one */
    search.above = values[0] >= level;
    long double coefficients[STRIDE];
    memcpy(coefficients, search.whole, sizeof coefficients);
    scan(&search, coefficients, 0, 1, 0);
    if (values[degree] < level) see_below(&search, 1);
    return search.count;
}

double tinker_step_refine(double from, double to, double (*f)(void *data, double place), void *data)
{
    enum { MOST_CLEVER = 40, MOST = 97 };
    double a = to, f_a = f(data, to), b = from, f_b = f(data, from), c, f_c;
    if (!(f_b > 0)) return from;
    if (f_a > 0) return to;
    double smallest = 1e-18 * fabs(to - from), share = 0.5;
    for (int32_t asked = 0;; asked++) {
        double best = fabs(f_a) < fabs(f_b) ? a : b;
        double least_share = (0.5 * DBL_EPSILON * fabs(best) + smallest) / fabs(b - a);
        if (f_a == 0 || f_b == 0 || !(least_share < 0.5) || asked == MOST) return best;
        double place = a + CLAMP(share, least_share, 1 - least_share) * (b - a);
        if (place == a || place == b) return best;
        double f_place = f(data, place);
        if ((f_place > 0) == (f_a > 0)) {
            c = a;
            f_c = f_a;
        } else {
            c = b;
            f_c = f_b;
            b = a;
            f_b = f_a;
        }
        a = place;
        f_a = f_place;
        /* Chandrupatla, Adv. Eng. Softw. 28 (1997): the inverse parabola where that is safe, else half of the bracket
         */
        double xi = (a - b) / (c - b), phi = (f_a - f_b) / (f_c - f_b);
        gboolean safe = asked < MOST_CLEVER && phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
        share = !safe
                    ? 0.5
                    : f_a / (f_b - f_a) * f_c / (f_b - f_c) + (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b);
    }
}
