/* Down a slope of angle a: the bead has come s = g sin(a) t^2 / 2 along it, and the rail bears m g cos(a). */
#include "record.h"

int main(int argc, char **argv)
{
    const double mass = 2.0, g = 9.81, sine = 0.5, cosine = sqrt(0.75);
    Record record = record_run(argc, argv, "Bead.x,Bead.y,Rail.force");
    while (record_next(&record)) {
        const double t = record.value[0], s = 0.5 * g * sine * t * t;
        record_expect(&record, "x", record.value[1], 1.0 + s * cosine, 1e-7);
        record_expect(&record, "y", record.value[2], 2.0 - s * sine, 1e-7);
        record_expect(&record, "force", record.value[3], mass * g * cosine, 1e-7);
    }
    return record_finish(&record);
}
