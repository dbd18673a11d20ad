/* What the band stored becomes the motion of the mass: at every place m v^2 / 2 = E(e0) - E(e) with
 * E(e) = k e^2 / 2 + k3 e^4 / 4, and where it is slack the mass flies on evenly,
 * until the band catches it on the other side. */
#include "record.h"

static double energy(double e)
{
    const double k = 20.0, k3 = 10.0;
    return e > 0.0 ? 0.5 * k * e * e + 0.25 * k3 * e * e * e * e : 0.0;
}

int main(int argc, char **argv)
{
    const double mass = 0.5, rest_length = 2.0, e0 = 1.0;
    int slack = 0;
    Record record = record_run(argc, argv, "Mass 0.x,Mass 0.vx,Band.tension");
    while (record_next(&record)) {
        const double e = fabs(record.value[1]) - rest_length, v = record.value[2];
        record_expect(&record, "m v^2 / 2", 0.5 * mass * v * v, energy(e0) - energy(e), 1e-7);
        record_expect(&record, "tension", record.value[3], e > 0.0 ? 20.0 * e + 10.0 * e * e * e : 0.0, 1e-9);
        slack += e < 0.0;
    }
    if (slack == 0) fprintf(stderr, "the band was never slack\n");
    return record_finish(&record) != 0 || slack == 0;
}
