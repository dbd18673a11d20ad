/* A force square to the velocity leads round in a circle: with w = b / m and r = v / w
 * x = r sin(w t), y = r (1 - cos(w t)), and the force is always b v. */
#include "record.h"

int main(int argc, char **argv)
{
    const double mass = 1.0, v = 3.0, b = 2.0, w = b / mass, r = v / w;
    Record record = record_run(argc, argv, "Mass 0.x,Mass 0.y,Push.force");
    while (record_next(&record)) {
        const double t = record.value[0];
        record_expect(&record, "x", record.value[1], r * sin(w * t), 1e-7);
        record_expect(&record, "y", record.value[2], r * (1.0 - cos(w * t)), 1e-7);
        record_expect(&record, "force", record.value[3], b * v, 1e-7);
    }
    return record_finish(&record);
}
