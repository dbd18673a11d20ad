/* In the frame of the support the mass starts at its place of rest, backwards at the speed v: x = -L0 + v t - (v / w)
 * sin(w t) with w^2 = k / m. */
#include "record.h"

int main(int argc, char **argv)
{
    const double v = 0.5, w = 3.0, rest_length = 2.0;
    Record record = record_run(argc, argv, "Mass 0.x,Mass 0.y,Ride.distance");
    while (record_next(&record)) {
        const double t = record.value[0];
        record_expect(&record, "x", record.value[1], v * t - rest_length - v / w * sin(w * t), 1e-7);
        record_expect(&record, "y", record.value[2], 0.0, 1e-12);
        record_expect(&record, "distance", record.value[3], v * t, 1e-12);
    }
    return record_finish(&record);
}
