#include "contact-checks.h"

#include <math.h>

/* Steps that no event falls on. Semi-implicit Euler is of first order even where the acceleration is constant. */
const ContactMethod contact_methods[CONTACT_METHODS] = {
    {"auto", 0, 1e-10, 1e-9},
    {"dop853", 0, 1e-10, 1e-9},
    {"rk4", 0.0077, 1e-10, 1e-5},
    {"verlet", 0.00077, 1e-10, 1e-4},
    {"verlet6", 0.0077, 1e-10, 1e-7},
    {"newmark", 0.00077, 1e-10, 1e-4},
    {"semi-implicit-euler", 0.000077, 5e-3, 5e-2},
};

PhysicsOptions contact_options(const ContactMethod *method, double duration, const char *columns)
{
    return (PhysicsOptions){
        .method = method->method, .step = method->step, .tolerance = 1e-11, .duration = duration, .columns = columns};
}

static gboolean is_of(const TinkerEvent *event, const char *kind, const char *blocks)
{
    return g_str_equal(event->kind, kind) && (blocks == NULL || g_str_equal(event->blocks, blocks));
}

void contact_assert_event(const PhysicsRun *run, const char *kind, const char *blocks, double time, double bound)
{
    double nearest = INFINITY;
    for (guint i = 0; i < run->summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(run->summary->events, i);
        if (is_of(event, kind, blocks) && fabs(event->time - time) < fabs(nearest - time)) nearest = event->time;
    }
    g_autofree char *what = g_strdup_printf("the time of the nearest %s%s%s", kind, blocks != NULL ? " of " : "",
                                            blocks != NULL ? blocks : "");
    physics_assert_near(what, nearest, time, bound);
}

void contact_assert_count(const PhysicsRun *run, const char *kind, int count)
{
    int found = 0;
    for (guint i = 0; i < run->summary->events->len; i++)
        found += is_of(g_ptr_array_index(run->summary->events, i), kind, NULL);
    g_autofree char *what = g_strdup_printf("the number of events \"%s\"", kind);
    physics_assert_near(what, found, count, 0);
}

const TinkerEvent *contact_event_at(const PhysicsRun *run, const char *kind, double time)
{
    const TinkerEvent *nearest = NULL;
    for (guint i = 0; i < run->summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(run->summary->events, i);
        const double away = fabs(event->time - time);
        if (is_of(event, kind, NULL) && away < (nearest != NULL ? fabs(nearest->time - time) : 1e-7)) nearest = event;
    }
    return nearest;
}

void contact_assert_state(const PhysicsRun *run, const char *mass, const double state[4], double bound)
{
    static const char *const names[] = {"x", "y", "vx", "vy"};
    double now[4];
    physics_state(run, mass, now);
    for (int i = 0; i < 4; i++) {
        g_autofree char *what = g_strdup_printf("%s.%s", mass, names[i]);
        physics_assert_near(what, now[i], state[i], bound);
    }
}

/* A tight method's books close to the limit that contact must keep; those of a fixed step, as far as it is exact. */
static double balance_limit(const TinkerSummary *summary)
{
    for (gsize i = 0; i < CONTACT_METHODS && !summary->adaptive; i++)
        if (g_str_equal(contact_methods[i].method, summary->method)) return contact_methods[i].smooth;
    return 1e-9;
}

void contact_assert_taken(const PhysicsRun *run, double friction, double impacts, double bound)
{
    physics_assert_near("what friction gave", run->summary->books[TINKER_BOOK_FRICTION], -friction, bound);
    physics_assert_near("what impacts gave", run->summary->books[TINKER_BOOK_CONTACTS], -impacts, bound);
    physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, balance_limit(run->summary));
}

char *contact_plate(double x, double y, double angle, double width, const char *more)
{
    const double height = 0.4;
    return g_strdup_printf(
        "{'type': 'support', 'position': [%.17g, %.17g], 'orientation': %.17g, 'width': %.17g, 'height': "
        "%.17g%s%s}",
        x + sin(angle) * height / 2, y - cos(angle) * height / 2, angle, width, height, more[0] != '\0' ? ", " : "",
        more);
}

double contact_bisect(double from, double to, double (*f)(double, const void *), const void *data)
{
    gboolean rising = f(from, data) < 0;
    for (int i = 0; i < 100; i++) {
        double middle = 0.5 * (from + to);
        if ((f(middle, data) < 0) == rising) {
            from = middle;
        } else {
            to = middle;
        }
    }
    return 0.5 * (from + to);
}

static double apart(const PhysicsRun *left, const PhysicsRun *right)
{
    double most = 0;
    for (gsize k = 0; k < physics_samples(left); k++)
        for (gsize c = 0; c < left->columns->len; c++)
            most = fmax(most, fabs(physics_value(left, k, c) - physics_value(right, k, c)));
    return most;
}

void contact_check_converges(const char *blocks, const char *columns, double duration, double coarsest, double slope)
{
    PhysicsOptions exactly = {.method = "dop853", .tolerance = 1e-11, .duration = duration, .columns = columns};
    g_autoptr(PhysicsRun) events = physics_run(&exactly, "%s", blocks);
    for (double step = coarsest; step > 2e-5; step /= 4) {
        PhysicsOptions options = {.impulses = TRUE, .step = step, .duration = duration, .columns = columns};
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
        g_autofree char *what = g_strdup_printf("the distance from events at steps of %g s", step);
        physics_assert_near(what, apart(run, events), 0, slope * step);
        physics_assert_near("the constraints' error", run->summary->constraint_position_error, 0, 1e-13);
    }
}
