/* The method keeps its order on a damped oscillator, between its steps, too:
 * x = 2 + 0.5 exp(-t / 5) (cos(w t) + sin(w t) / (5 w)) with w^2 = 4 - 1 / 25; half the step, a quarter of the error.
 */
#include "record.h"

/* The largest error with this step (s); 0.1 s, the recording interval, is no multiple of either. */
static double largest_error(char **argv, const char *step)
{
    const double w = sqrt(4.0 - 0.04);
    char *with_step[] = {argv[0], argv[1], argv[2], argv[3], "--step", (char *)step};
    double largest = 0.0;
    Record record = record_run(6, with_step, "Mass 0.x");
    while (record_next(&record)) {
        const double t = record.value[0];
        const double exact = 2.0 + 0.5 * exp(-0.2 * t) * (cos(w * t) + 0.2 / w * sin(w * t));
        largest = fmax(largest, fabs(record.value[1] - exact));
    }
    return record_finish(&record) == 0 ? largest : NAN;
}

int main(int argc, char **argv)
{
    if (argc != 4) return 2;
    const double coarse = largest_error(argv, "0.008"), fine = largest_error(argv, "0.004");
    const double order = log2(coarse / fine);
    printf("errors %g m and %g m: order %.3f\n", coarse, fine, order);
    return fabs(order - 2.0) < 0.05 && fine < 1e-4 ? 0 : 1;
}
