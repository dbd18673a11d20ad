/* What strikes touches at that time: a step that was searched for events may be far longer than the one that ends at
 * one. */
#include "contact-checks.h"

#include <math.h>

/* A disc falls beside two boxes on a rod that slide, strike and turn down a slope: it is met by a corner of one. Where
 * the run ends just before, the distance from there to the disc is what they come nearer in that time. */
static PhysicsRun *run_to(double duration, const char *columns)
{
    return physics_run(
        &(PhysicsOptions){.method = "dop853", .tolerance = 1e-12, .duration = duration, .columns = columns},
        CONTACT_WEIGHT "{'type': 'support', 'position': [0, -0.1], 'width': 60, 'height': 0.2, 'orientation': -0.3,"
                       " 'restitution': 0.5, " CONTACT_SMOOTH "},"
                       "{'type': 'box', 'mass': 2, 'width': 0.4, 'height': 0.2, 'position': [-1, 1.0999999999999999],"
                       " 'velocity': [0.8291326651697166, 0]},"
                       "{'type': 'box', 'mass': 2, 'width': 0.4, 'height': 0.2,"
                       " 'position': [-0.09999999999999998, 1.0999999999999999], 'velocity': [0.22826986383031422, 0]},"
                       "{'type': 'disc', 'mass': 1.5022541445139241, 'radius': 0.2,"
                       " 'position': [1.1, 1.598909828614937], 'velocity': [-0.5631683670331888, 0]},"
                       "{'type': 'rod', 'ends': ['Box 0', 'Box 1']}");
}

static double first_blow(void)
{
    g_autoptr(PhysicsRun) run = run_to(1.5, NULL);
    for (guint i = 0; i < run->summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(run->summary->events, i);
        if (g_str_equal(event->kind, "impact") && g_str_equal(event->blocks, "Box 1, Disc 0")) return event->time;
    }
    g_error("the disc is not struck");
}

/* From a place to the edges of a box about the origin, in its axes. */
static double distance_to_box(double x, double y, double half_width, double half_height)
{
    return hypot(fmax(fabs(x) - half_width, 0), fmax(fabs(y) - half_height, 0));
}

static void test_touches_where_it_strikes(void)
{
    const double before = 1e-7, fastest = 10;
    g_autoptr(PhysicsRun) run = run_to(first_blow() - before, "Box 1.x, Box 1.y, Box 1.angle, Disc 0.x, Disc 0.y");
    const double x = physics_last(run, 3) - physics_last(run, 0), y = physics_last(run, 4) - physics_last(run, 1);
    const double c = cos(physics_last(run, 2)), s = sin(physics_last(run, 2));
    physics_assert_near("the gap", distance_to_box(c * x + s * y, c * y - s * x, 0.2, 0.1) - 0.2, 0, before * fastest);
}

static void add_tests(void)
{
    g_test_add_func("/contact-located/touches-where-it-strikes", test_touches_where_it_strikes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
