/* m dv/dt = -c v^2: v = v0 / (1 + v0 t c / m), x = (m / c) ln(1 + v0 t c / m); the drag's power is -c v^3. */
#include "record.h"

int main(int argc, char **argv)
{
    const double mass = 2.0, c = 0.5, v0 = 4.0;
    Record record = record_run(argc, argv, "Mass 0.x,Mass 0.vx,Drag.power");
    while (record_next(&record)) {
        const double slower = 1.0 + v0 * record.value[0] * c / mass, v = v0 / slower;
        record_expect(&record, "x", record.value[1], mass / c * log(slower), 1e-7);
        record_expect(&record, "vx", record.value[2], v, 1e-7);
        record_expect(&record, "power", record.value[3], -c * v * v * v, 1e-6);
    }
    return record_finish(&record);
}
