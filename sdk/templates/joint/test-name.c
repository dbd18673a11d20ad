/* With the ratio r the large wheel counts on the small one's shaft by r^2: M = (I1 + r^2 I2) alpha. */
#include "record.h"

int main(int argc, char **argv)
{
    const double torque = 3.0, ratio = 0.5, large = 6.0, alpha = torque / (0.5 + ratio * ratio * large);
    Record record = record_run(argc, argv, "Small.angle,Large.angle,Belt.torque");
    while (record_next(&record)) {
        const double t = record.value[0], turned = 0.5 * alpha * t * t;
        record_expect(&record, "small", record.value[1], turned, 1e-7);
        record_expect(&record, "large", record.value[2], ratio * turned, 1e-7);
        record_expect(&record, "torque", record.value[3], large * ratio * alpha, 1e-7);
    }
    return record_finish(&record);
}
