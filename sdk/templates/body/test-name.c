/* A force in proportion to the distance from a centre makes an ellipse: with w^2 = k / m
 * x = a cos(w t), y = (v / w) sin(w t), and the angular momentum stays m a v. */
#include "record.h"

int main(int argc, char **argv)
{
    const double mass = 2.0, a = 3.0, v = 4.0, w = 2.0;
    Record record = record_run(argc, argv, "Body.x,Body.y,Body.angular momentum");
    while (record_next(&record)) {
        const double t = record.value[0];
        record_expect(&record, "x", record.value[1], a * cos(w * t), 1e-7);
        record_expect(&record, "y", record.value[2], v / w * sin(w * t), 1e-7);
        record_expect(&record, "angular momentum", record.value[3], mass * a * v, 1e-6);
    }
    return record_finish(&record);
}
