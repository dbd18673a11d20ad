/* I d(omega)/dt = -c omega^2: omega = omega0 / (1 + k t) with k = c omega0 / I, and the angle is omega0 log(1 + k t) /
 * k. */
#include "record.h"

int main(int argc, char **argv)
{
    const double start = 8.0, c = 0.1, k = c * start / 0.5;
    Record record = record_run(argc, argv, "Wheel.angle,Wheel.angular velocity,Fan.torque");
    while (record_next(&record)) {
        const double t = record.value[0], rate = start / (1.0 + k * t);
        record_expect(&record, "angle", record.value[1], start * log(1.0 + k * t) / k, 1e-7);
        record_expect(&record, "rate", record.value[2], rate, 1e-7);
        record_expect(&record, "torque", record.value[3], -c * rate * rate, 1e-7);
    }
    return record_finish(&record);
}
