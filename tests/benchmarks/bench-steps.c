/* What a step costs: small scenes, chains of rods and lattices of springs through the plugins, and beside each the
 * floor of floors.h, measured in turns in the same run. */
#include <math.h>
#include <string.h>

#include "floors.h"
#include "numerics/sharing/sharing.h"
#include "report.h"
#include "scene-text.h"
#include "subject.h"

#define METHOD "rk4"
/* After which a chain's lengths and a lattice's places are looked at. */
#define ERROR_STEPS 100

/* A floor under the clock: its state goes on, or starts over as the scene's does. */
typedef struct {
    double step;
    FloorOscillator oscillator;
    FloorDoublePendulum pendulum;
    FloorChain *chain;
    FloorLattice *lattice;
    FloorFrame frame;
    FloorStiffChain *stiff;
    FloorBars *bars;
    long lap, done; /* steps */
} Floor;

/* Starts over after each lap: what has died away is reckoned in numbers too small for the fast ways of a processor. */
static double time_oscillator(gint64 steps, void *data)
{
    Floor *floor = data;
    double started = benchmark_processor_time();
    for (; steps > 0; steps -= floor->lap) {
        floor->oscillator = (FloorOscillator){1, 0};
        floor_oscillator_steps(&floor->oscillator, floor->step, MIN((long)steps, floor->lap));
    }
    return benchmark_processor_time() - started;
}

static double time_pendulum(gint64 steps, void *data)
{
    Floor *floor = data;
    floor->pendulum = (FloorDoublePendulum){{G_PI / 2, G_PI / 2}, {0, 0}};
    double started = benchmark_processor_time();
    floor_double_pendulum_steps(&floor->pendulum, floor->step, steps);
    return benchmark_processor_time() - started;
}

static double time_chain(gint64 steps, void *data)
{
    Floor *floor = data;
    double seconds = 0;
    while (steps > 0) {
        if (floor->done >= floor->lap) {
            floor_chain_reset(floor->chain);
            floor->done = 0;
        }
        long now = MIN((long)steps, floor->lap - floor->done);
        double started = benchmark_processor_time();
        floor_chain_steps(floor->chain, floor->step, now);
        seconds += benchmark_processor_time() - started;
        floor->done += now;
        steps -= now;
    }
    return seconds;
}

static double time_lattice(gint64 steps, void *data)
{
    Floor *floor = data;
    double started = benchmark_processor_time();
    floor_lattice_steps(floor->lattice, floor->step, steps);
    return benchmark_processor_time() - started;
}

static double time_frame(gint64 steps, void *data)
{
    Floor *floor = data;
    floor->frame = (FloorFrame){0};
    double started = benchmark_processor_time();
    floor_frame_steps(&floor->frame, floor->step, steps);
    return benchmark_processor_time() - started;
}

static double time_stiff_chain(gint64 steps, void *data)
{
    Floor *floor = data;
    floor_stiff_chain_reset(floor->stiff);
    double started = benchmark_processor_time();
    floor_stiff_chain_steps(floor->stiff, steps);
    return benchmark_processor_time() - started;
}

static double time_bars(gint64 steps, void *data)
{
    Floor *floor = data;
    double started = benchmark_processor_time();
    floor_bars_steps(floor->bars, floor->step, steps);
    return benchmark_processor_time() - started;
}

/* Fills in what the clock says, and reports. */
static void measure(BenchmarkReport *report, BenchmarkStep step, BenchmarkSubject *subject, BenchmarkWork floor_work,
                    Floor *floor)
{
    BenchmarkTask plain = {.work = floor_work, .data = floor};
    BenchmarkTask ours = {.work = benchmark_subject_work, .data = subject};
    benchmark_time_pair(&plain, &ours);
    if (step.method == NULL) step.method = METHOD;
    step.step = ours.timing;
    step.floor = plain.timing;
    benchmark_report_step(report, &step);
}

static void measure_oscillator(BenchmarkReport *report, const char *scene, char *text, double h)
{
    g_autofree char *own_text = text;
    if (!benchmark_report_wants(report, scene)) return;
    BenchmarkSubject subject = benchmark_subject(text, METHOD, h);
    Floor floor = {.step = h, .lap = lround(100 / h)};
    subject.lap = 100;
    measure(report, (BenchmarkStep){.scene = scene, .elements = 1, .goal = 80}, &subject, time_oscillator, &floor);
    benchmark_subject_clear(&subject);
}

static void measure_double_pendulum(BenchmarkReport *report)
{
    const char *scene = "S2 double pendulum";
    if (!benchmark_report_wants(report, scene)) return;
    const double level[2] = {G_PI / 2, G_PI / 2};
    g_autofree char *text = benchmark_chain(2, level, 1.0);
    BenchmarkSubject subject = benchmark_subject(text, METHOD, 1e-3);
    Floor floor = {.step = 1e-3};
    subject.lap = 5;
    measure(report, (BenchmarkStep){.scene = scene, .elements = 1, .goal = 260}, &subject, time_pendulum, &floor);
    benchmark_subject_clear(&subject);
}

/* The largest relative error of a length that the run itself has seen. */
static double chain_error(BenchmarkSubject *subject)
{
    for (int i = 0; i < ERROR_STEPS; i++)
        benchmark_subject_step(subject);
    return tinker_simulation_summary(subject->simulation)->constraint_position_error;
}

/* The chain's fastest mode is about 2 n sqrt(g / length): a step of 1/1000 s carries 1000 rods of a chain of 10 m, more
 * need a shorter one. */
static void measure_chain(BenchmarkReport *report, int rods, double *angles, const char *kind, double lap)
{
    g_autofree double *own_angles = angles;
    g_autofree char *scene = g_strdup_printf("S3 chain of %d rods, %s", rods, kind);
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = benchmark_chain(rods, angles, 10.0 / rods);
    double h = rods > 1000 ? 1e-4 : 1e-3;
    BenchmarkSubject subject = benchmark_subject(text, METHOD, h);
    Floor floor = {.step = h,
                   .lap = isinf(lap) ? G_MAXLONG : lround(lap / h),
                   .chain = floor_chain_new(rods, angles, 10.0 / rods)};
    subject.lap = lap;
    BenchmarkStep step = {.scene = scene, .elements = rods, .goal = 80, .error_kind = "length error"};
    step.error = chain_error(&subject);
    floor_chain_steps(floor.chain, h, ERROR_STEPS);
    floor.done = ERROR_STEPS;
    step.floor_error = floor_chain_error(floor.chain);
    measure(report, step, &subject, time_chain, &floor);
    floor_chain_free(floor.chain);
    benchmark_subject_clear(&subject);
}

static void measure_bars(BenchmarkReport *report, int bars)
{
    g_autofree double *angles = benchmark_hanging_angles(bars);
    g_autofree char *scene = g_strdup_printf("S9 chain of %d pinned bars, hanging", bars);
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = benchmark_bars(bars, angles, 10.0 / bars);
    double h = bars > 100 ? 1e-4 : 1e-3;
    BenchmarkSubject subject = benchmark_subject(text, "verlet", h);
    Floor floor = {.step = h, .bars = floor_bars_new(bars, angles, 10.0 / bars)};
    BenchmarkStep step = {
        .scene = scene, .method = "verlet", .elements = bars, .goal = 150, .error_kind = "gap of a pin"};
    step.error = chain_error(&subject);
    floor_bars_steps(floor.bars, h, ERROR_STEPS);
    step.floor_error = floor_bars_error(floor.bars);
    subject.lap = INFINITY;
    measure(report, step, &subject, time_bars, &floor);
    floor_bars_free(floor.bars);
    benchmark_subject_clear(&subject);
}

/* A bar pendulum; in place of a floor the pendulum of a mass on a rod, of which it may cost twice as much. */
static void measure_bar_pendulum(BenchmarkReport *report)
{
    const char *scene = "S8 bar pendulum, beside a rod's";
    if (!benchmark_report_wants(report, scene)) return;
    const double level = G_PI / 2;
    g_autofree char *bar = benchmark_bars(1, &level, 1.0), *rod = benchmark_chain(1, &level, 1.0);
    BenchmarkSubject subject = benchmark_subject(bar, METHOD, 1e-3), plain = benchmark_subject(rod, METHOD, 1e-3);
    subject.lap = plain.lap = 100;
    BenchmarkTask beside = {.work = benchmark_subject_work, .data = &plain};
    BenchmarkTask ours = {.work = benchmark_subject_work, .data = &subject};
    benchmark_time_pair(&beside, &ours);
    BenchmarkStep step = {.scene = scene, .method = METHOD, .elements = 1, .goal = NAN};
    step.step = ours.timing;
    step.floor = beside.timing;
    benchmark_report_step(report, &step);
    benchmark_subject_clear(&subject);
    benchmark_subject_clear(&plain);
}

/* Both take the same steps, so they must end at the same places but for rounding. */
static double lattice_difference(BenchmarkSubject *subject, FloorLattice *lattice, int n)
{
    double worst = 0;
    for (int i = 0; i < ERROR_STEPS; i++)
        benchmark_subject_step(subject);
    floor_lattice_steps(lattice, 1e-3, ERROR_STEPS);
    for (int i = 0; i < n * n; i++) {
        double ours[2], plain[2];
        g_autofree char *name = g_strdup_printf("M%d", i);
        benchmark_subject_place(subject, name, ours);
        floor_lattice_place(lattice, i, plain);
        worst = fmax(worst, hypot(ours[0] - plain[0], ours[1] - plain[1]));
    }
    return worst;
}

static void measure_lattice(BenchmarkReport *report, int n)
{
    g_autofree char *scene = g_strdup_printf("S4 lattice %d x %d", n, n);
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = benchmark_lattice(n);
    g_autofree double *places = benchmark_lattice_places(n);
    BenchmarkSubject subject = benchmark_subject(text, METHOD, 1e-3);
    Floor floor = {.step = 1e-3, .lattice = floor_lattice_new(n, places)};
    BenchmarkStep step = {
        .scene = scene, .goal = n > 300 ? 25 : 14, .error_kind = "off the floor's places by m", .floor_error = NAN};
    step.elements = floor_lattice_springs(floor.lattice);
    step.error = lattice_difference(&subject, floor.lattice, n);
    measure(report, step, &subject, time_lattice, &floor);
    floor_lattice_free(floor.lattice);
    benchmark_subject_clear(&subject);
}

/* How far a mass of a line is off the floor's displacement. */
static double line_difference(BenchmarkSubject *subject, int mass, double displacement)
{
    double place[2];
    g_autofree double *rests = benchmark_line_rests(mass + 1);
    g_autofree char *name = g_strdup_printf("M%d", mass);
    benchmark_subject_place(subject, name, place);
    return fabs(place[0] - rests[mass] - displacement);
}

static void measure_frame(BenchmarkReport *report, const char *scene, char *text)
{
    g_autofree char *own_text = text;
    if (!benchmark_report_wants(report, scene)) return;
    BenchmarkSubject subject = benchmark_subject(text, METHOD, 0.01);
    Floor floor = {.step = 0.01};
    BenchmarkStep step = {
        .scene = scene, .elements = 1, .goal = NAN, .error_kind = "off the floor's places by m", .floor_error = NAN};
    floor_frame_steps(&floor.frame, floor.step, ERROR_STEPS);
    for (int i = 0; i < ERROR_STEPS; i++)
        benchmark_subject_step(&subject);
    for (int i = 0; i < BENCHMARK_STOREYS; i++)
        step.error = fmax(step.error, line_difference(&subject, i, floor.frame.x[i]));
    subject.lap = 10;
    measure(report, step, &subject, time_frame, &floor);
    benchmark_subject_clear(&subject);
}

/* By average acceleration, at the step that has an error of 1e-4 after 10 s. */
static void measure_stiff_chain(BenchmarkReport *report, const char *scene, char *text)
{
    g_autofree char *own_text = text;
    if (!benchmark_report_wants(report, scene)) return;
    BenchmarkSubject subject = benchmark_subject(text, "newmark", 1.0 / 800);
    Floor floor = {.step = 1.0 / 800, .stiff = floor_stiff_chain_new(1.0 / 800)};
    BenchmarkStep step = {.scene = scene,
                          .method = "newmark",
                          .elements = 1,
                          .goal = NAN,
                          .error_kind = "off the floor's places by m",
                          .floor_error = NAN};
    floor_stiff_chain_steps(floor.stiff, ERROR_STEPS);
    for (int i = 0; i < ERROR_STEPS; i++)
        benchmark_subject_step(&subject);
    for (int i = 0; i < BENCHMARK_STIFF_MASSES; i++)
        step.error = fmax(step.error, line_difference(&subject, i, floor_stiff_chain_place(floor.stiff, i)));
    subject.lap = 10;
    measure(report, step, &subject, time_stiff_chain, &floor);
    floor_stiff_chain_free(floor.stiff);
    benchmark_subject_clear(&subject);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    tinker_share_set_threads(1);
    measure_oscillator(report, "S1 oscillator, 1/1000 s", benchmark_oscillator(FALSE), 1e-3);
    measure_oscillator(report, "S1 oscillator, 1/100 s", benchmark_oscillator(FALSE), 1e-2);
    measure_oscillator(report, "S1 hanging, solid, 1/1000 s", benchmark_oscillator(TRUE), 1e-3);
    measure_oscillator(report, "S1 hanging, solid, 1/100 s", benchmark_oscillator(TRUE), 1e-2);
    measure_oscillator(report, "S1 in the plane, 1/1000 s", benchmark_off_line(benchmark_oscillator(FALSE)), 1e-3);
    measure_double_pendulum(report);
    const int rods[] = {10, 100, 1000, 10000};
    for (gsize i = 0; i < G_N_ELEMENTS(rods); i++)
        measure_chain(report, rods[i], benchmark_hanging_angles(rods[i]), "hanging", INFINITY);
    for (gsize i = 0; i < 3; i++)
        measure_chain(report, rods[i], benchmark_level_angles(rods[i]), "from level", 0.2);
    const int sides[] = {10, 32, 100, 316};
    for (gsize i = 0; i < G_N_ELEMENTS(sides); i++)
        measure_lattice(report, sides[i]);
    measure_frame(report, "S5 frame of 4 storeys, 1/100 s", benchmark_frame());
    measure_frame(report, "S5 in the plane, 1/100 s", benchmark_off_line(benchmark_frame()));
    measure_stiff_chain(report, "S6 stiff chain, 1/800 s", benchmark_stiff_chain());
    measure_stiff_chain(report, "S6 in the plane, 1/800 s", benchmark_off_line(benchmark_stiff_chain()));
    for (gsize i = 0; i < 3; i++)
        measure_bars(report, rods[i]);
    measure_bar_pendulum(report);
    return benchmark_report_end(report);
}
