/* Bodies that turn on tops: rolling, rocking, tipping, landing on a corner, going over an end, against closed forms and
 * integrals of the motions of one coordinate. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

static const double g = CONTACT_GRAVITY;

#define ROUGH  "'static_friction': 1000, 'dynamic_friction': 1000"
#define MIDDLE "'static_friction': 0.5, 'dynamic_friction': 0.5"

/* A disc on a rough slope rolls with 2/3 of g sin a, to rounding: the contact does not slip at all. */
static void test_rolls(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        const double angle = 0.3, r = 0.25, t = 2;
        g_autofree char *plate = contact_plate(0, 0, -angle, 40, MIDDLE);
        PhysicsOptions options = contact_options(&contact_methods[i], t,
                                                 "Disc 0.x, Disc 0.y, Disc 0.angle, Disc 0.angular velocity,"
                                                 "Disc 0.normal force, Disc 0.friction force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, {'type': 'disc', 'radius': 0.25, 'position': [%.17g, %.17g]}",
                        plate, r * sin(angle), r * cos(angle));
        const double way = g * sin(angle) * t * t / 3, bound = contact_methods[i].polynomial;
        physics_assert_near("x", physics_last(run, 0), r * sin(angle) + way * cos(angle), bound);
        physics_assert_near("y", physics_last(run, 1), r * cos(angle) - way * sin(angle), bound);
        physics_assert_near("rolled", physics_last(run, 2) * r, -way, bound);
        physics_assert_near("rate", physics_last(run, 3) * r, -2 * way / t, bound);
        physics_assert_near("normal force", physics_last(run, 4), g * cos(angle), 1e-9);
        physics_assert_near("friction", physics_last(run, 5), -g * sin(angle) / 3, 1e-9);
        const double rolled = hypot(physics_last(run, 0) - r * sin(angle), physics_last(run, 1) - r * cos(angle));
        physics_assert_near("slipped", rolled + physics_last(run, 2) * r, 0, 1e-12);
        g_assert_cmpuint(run->summary->events->len, ==, 0);
    }
}

/* What lies on a slope below the friction angle stays there, and a disc on a level top goes on, without creep. */
static void test_no_creep(void)
{
    const double angle = 0.35;
    g_autofree char *slope = contact_plate(0, 0, angle, 10, MIDDLE);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 600, .columns = "Box 0.x, Box 0.y, Box 0.angle, Disc 0.x, Disc 0.angle"},
        CONTACT_WEIGHT "%s, {'type': 'box', 'width': 0.4, 'height': 0.3, 'orientation': 0.35,"
                       " 'position': [%.17g, %.17g]}, {'type': 'support', 'position': [60, -20],"
                       " 'width': 200}, {'type': 'disc', 'radius': 0.5, 'position': [0, -19.3],"
                       " 'velocity': [0.1, 0], 'angular_velocity': -0.2}",
        slope, -0.15 * sin(angle), 0.15 * cos(angle));
    physics_assert_near("x", physics_last(run, 0), -0.15 * sin(angle), 1e-14);
    physics_assert_near("y", physics_last(run, 1), 0.15 * cos(angle), 1e-14);
    physics_assert_near("angle", physics_last(run, 2), angle, 1e-14);
    physics_assert_near("rolled to", physics_last(run, 3), 60, 1e-11);
    physics_assert_near("turned", physics_last(run, 4), -120, 1e-10);
}

/* A disc that is set down sliding: v = v0 - mu g t, until v = r w at v0 / (3 mu g); from there it rolls at 2/3 v0. */
static void test_slides_then_rolls(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        const double friction = 0.2, v = 5, stops = v / (3 * friction * g), bound = contact_methods[i].polynomial;
        PhysicsOptions options =
            contact_options(&contact_methods[i], 2, "Disc 0.vx, Disc 0.angular velocity, Disc 0.x");
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                ", 'width': 40, 'static_friction': 0.2, 'dynamic_friction': 0.2},"
                                                "{'type': 'disc', 'radius': 0.3, 'position': [0, 0.3],"
                                                " 'velocity': [5, 0]}");
        contact_assert_event(run, "stick", "Disc 0, Support 0", stops, fmax(bound, 1e-9));
        physics_assert_near("vx", physics_last(run, 0), 2 * v / 3, fmax(bound, 1e-11));
        physics_assert_near("rate", physics_last(run, 1), -2 * v / 3 / 0.3, fmax(bound, 1e-10));
        contact_assert_taken(run, v * v / 6, 0, fmax(bound, 1e-8));
    }
}

/* A block 0.2 m wide and 1 m high that was tilted by half the angle of its diagonal rocks from corner to corner, and
 * keeps 1 - 3/2 sin^2 of that angle of its rate at each blow. The times are of closed integrals. Source: G. W. Housner,
 * "The behavior of inverted pendulum structures during earthquakes", Bulletin of the Seismological Society of America
 * 53 (1963) 403-417. */
static void test_rocks(void)
{
    static const double hits[] = {0.347093586789, 0.950920536478, 1.48793964311};
    const double diagonal = atan2(0.1, 0.5), tilt = diagonal / 2;
    static const char *const adaptive[] = {"dop853", "dopri5", "auto"};
    for (gsize i = 0; i < G_N_ELEMENTS(adaptive); i++) {
        const double before = hits[0] - 1e-9, after = hits[0] + 1e-9, at[] = {0, before, after, 1.6};
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .method = adaptive[i], .duration = 1.6, .at = at, .at_count = 4, .columns = "Box 0.angular velocity"},
            CONTACT_WEIGHT CONTACT_FLOOR ", " ROUGH
                                         "}, {'type': 'box', 'width': 0.2, 'height': 1, 'orientation': %.17g,"
                                         " 'position': [%.17g, %.17g]}",
            tilt, 0.1 * cos(tilt) - 0.5 * sin(tilt), 0.1 * sin(tilt) + 0.5 * cos(tilt));
        for (gsize k = 0; k < G_N_ELEMENTS(hits); k++)
            contact_assert_event(run, "rest", "Box 0, Support 0", hits[k], 1e-9);
        const double kept = 1 - 1.5 * sin(diagonal) * sin(diagonal);
        physics_assert_near("kept", physics_value(run, 2, 0) / physics_value(run, 1, 0), kept, 1e-7);
    }
}

/* A smooth rod of 1 m lands at 30 degrees with 1 m/s and e = 0.5: the blow at its lower end is
 * 1.5 v m / (1 + 3 cos^2). */
static void test_rod_lands(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.2, .columns = "Bar 0.angular velocity, Bar 0.vy, Bar 0.vx"},
                    CONTACT_FLOOR ", 'width': 20, " CONTACT_SMOOTH
                                  ", 'restitution': 0.5}, {'type': 'bar', 'width': 0, 'solid': true,"
                                  " 'position': [0, 0.35], 'orientation': %.17g, 'velocity': [0, -1]}",
                    G_PI / 6);
    const double rate = 9 * cos(G_PI / 6) / (1 + 3 * cos(G_PI / 6) * cos(G_PI / 6));
    contact_assert_event(run, "impact", "Bar 0, Support 0", 0.1, 1e-12);
    physics_assert_near("rate", fabs(physics_last(run, 0)), 2.398224195, 1e-9);
    physics_assert_near("by hand", fabs(physics_last(run, 0)), rate, 1e-12);
    physics_assert_near("vx", physics_last(run, 2), 0, 1e-14);
}

static void falling_rod(double t, const double *y, double *rate, const void *data)
{
    rate[0] = y[1];
    rate[1] = 1.5 * g * sin(y[0]);
}

/* A rod of 1 m falls over about its lower end, which a rough floor holds: its angle from the vertical, and the forces
 * of the floor that the centre's acceleration asks for. Their ratio is the largest at 35.1 degrees, 0.3706. */
static void test_rod_falls(void)
{
    const double start = 0.1;
    double y[2] = {start, 0}, peak = 0;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1.1,
                          .interval = 0.01,
                          .columns = "Bar 0.angle, Bar 0.angular velocity, Bar 0.normal force, Bar 0.friction force"},
        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 20, " ROUGH "}, {'type': 'bar', 'width': 0, 'solid': true,"
                                     " 'position': [%.17g, %.17g], 'orientation': %.17g}",
        0.5 * sin(start), 0.5 * cos(start), G_PI / 2 - start);
    for (gsize i = 0; i < physics_samples(run); i++) {
        if (i > 0) physics_rk4(2, y, physics_time(run, i - 1), physics_time(run, i), 40, falling_rod, NULL);
        if (y[0] > 1.2) break;
        const double alpha = 1.5 * g * sin(y[0]), w = y[1];
        const double push = g - 0.5 * (alpha * sin(y[0]) + w * w * cos(y[0]));
        const double along = 0.5 * (alpha * cos(y[0]) - w * w * sin(y[0]));
        physics_assert_near("angle", G_PI / 2 - physics_value(run, i, 0), y[0], 1e-8);
        physics_assert_near("rate", -physics_value(run, i, 1), w, 1e-8);
        physics_assert_near("normal force", physics_value(run, i, 2), push, 1e-7);
        physics_assert_near("friction force", physics_value(run, i, 3), along, 1e-7);
        if (along > 0) peak = fmax(peak, along / push);
    }
    g_assert_cmpfloat(peak, >, 0.3);
}

/* A disc slides off a box without friction: it leaves the box's end, and not the box its own, in either order. Below
 * sqrt(g r), 0.99 m/s, it goes round the corner there; above that nothing holds it on it. */
static void test_leaves_the_end_of_a_body(void)
{
    static const char
        disc[] = "{'type': 'disc', 'name': 'Disc', 'radius': 0.1, 'position': [0.1, 0.5],"
                 " 'velocity': [%g, 0], " CONTACT_SMOOTH "}",
        box[] = "{'type': 'box', 'name': 'Box', 'width': 1, 'height': 0.4, 'position': [0, 0.2], " CONTACT_SMOOTH "}";
    static const double speeds[] = {0.8, 1, 2};
    static const char *const methods[] = {"auto", "rk4", "verlet", "semi-implicit-euler"};
    for (gsize i = 0; i < 2 * G_N_ELEMENTS(methods) * G_N_ELEMENTS(speeds); i++) {
        const double speed = speeds[i / 2 % G_N_ELEMENTS(speeds)];
        const char *method = methods[i / 2 / G_N_ELEMENTS(speeds)];
        g_autofree char *moving = g_strdup_printf(disc, speed);
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.method = method, .step = 1e-3, .duration = 0.6, .columns = "Disc.x"},
                        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 20, " CONTACT_SMOOTH "}, %s, %s",
                        i % 2 == 0 ? moving : box, i % 2 == 0 ? box : moving);
        contact_assert_event(run, "end", "Disc, Box", 0.4 / speed, 1e-9);
        g_assert_cmpint(contact_event_at(run, "end", 0.4 / speed)->stays, ==, speed * speed < 0.1 * g);
    }
}

/* A box of 0.6 m slides at 1 m/s to the end of its top, 1 m away: at 0.7 s a corner passes that, at 1 s the centre does
 * and the box begins to tip on it; only later does it leave. */
static void test_leaves_by_its_last_corner(void)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 2}, CONTACT_WEIGHT CONTACT_FLOOR
                                            ", 'width': 2, " CONTACT_SMOOTH
                                            "}, {'type': 'box', 'width': 0.6, 'height': 0.4, 'position': [0, 0.2], "
                                            "'velocity': [1, 0], " CONTACT_SMOOTH "}");
    const TinkerEvent *passes = contact_event_at(run, "end", 0.7), *tips = contact_event_at(run, "take-off", 1),
                      *leaves = g_ptr_array_index(run->summary->events, run->summary->events->len - 1);
    g_assert_nonnull(passes);
    g_assert_true(passes->stays);
    g_assert_nonnull(tips);
    g_assert_true(tips->stays);
    g_assert_cmpstr(leaves->kind, ==, "take-off");
    g_assert_cmpfloat(leaves->time, >, 1.1);
    g_assert_false(leaves->stays);
}

/* Of a box that tips without friction about an end of its top, y = (s, a, u, a'): the centre is s ahead of the end
 * along the box, which is turned by a, and h over it; u = s' - h a' is the centre's velocity along the box. With the
 * inertia k by mass,
 *
 *     u' = s a'^2 - g sin a,   (s^2 + k) a'' = h u' - 2 s s' a' - g (s cos a - h sin a). */
static void tips_over_end(double t, const double *y, double *rate, const void *data)
{
    const double h = 0.2, k = (0.36 + 0.16) / 12, s = y[0], a = y[1], w = y[3];
    rate[0] = y[2] + h * w;
    rate[1] = w;
    rate[2] = s * w * w - g * sin(a);
    rate[3] = (h * rate[2] - 2 * s * rate[0] * w - g * (s * cos(a) - h * sin(a))) / (s * s + k);
}

/* The same box at 20 m/s hardly tips by the time at which its last corner passes the end, and leaves there: nothing
 * follows. */
static void test_leaves_when_its_last_corner_passes(void)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 0.3}, CONTACT_WEIGHT CONTACT_FLOOR
                                            ", 'width': 2, " CONTACT_SMOOTH
                                            "}, {'type': 'box', 'width': 0.6, 'height': 0.4, 'position': [0, 0.2], "
                                            "'velocity': [20, 0], " CONTACT_SMOOTH "}");
    const TinkerEvent *passes = contact_event_at(run, "end", 0.035),
                      *leaves = g_ptr_array_index(run->summary->events, run->summary->events->len - 1);
    double y[4] = {0, 0, 20, 0};
    g_assert_nonnull(passes);
    g_assert_true(passes->stays);
    g_assert_cmpstr(leaves->kind, ==, "end");
    g_assert_cmpstr(leaves->blocks, ==, "Box 0, Support 0");
    g_assert_false(leaves->stays);
    physics_rk4(4, y, 0.05, leaves->time, 1000, tips_over_end, NULL);
    physics_assert_near("the last corner is at the end", y[0], 0.3, 1e-7);
}

static void over_end(double t, const double *y, double *rate, const void *data)
{
    rate[0] = y[1];
    rate[1] = 2 * g / 3 / 0.3 * sin(y[0]);
}

/* A disc rolls to the end of its top and over the corner there, about which it turns then: an event, but no jump. */
static void test_rolls_over_an_end(void)
{
    const double at[] = {0, 0.9, 1.1, 1.4};
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1.4, .at = at, .at_count = 4, .columns = "Disc 0.x, Disc 0.y, Disc 0.vx"},
        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 2, " ROUGH "}, {'type': 'disc', 'radius': 0.3, 'position': [0.8, 0.3],"
                                     " 'velocity': [0.2, 0], 'angular_velocity': %.17g}",
        -0.2 / 0.3);
    contact_assert_event(run, "end", "Disc 0, Support 0", 1, 1e-9);
    g_assert_true(contact_event_at(run, "end", 1)->stays);
    physics_assert_near("before", physics_value(run, 1, 0), 0.98, 1e-12);
    for (gsize i = 2; i < 4; i++) {
        double y[2] = {0, 0.2 / 0.3};
        physics_rk4(2, y, 1, at[i], 1000, over_end, NULL);
        physics_assert_near("x", physics_value(run, i, 0), 1 + 0.3 * sin(y[0]), 1e-8);
        physics_assert_near("y", physics_value(run, i, 1), 0.3 * cos(y[0]), 1e-8);
        physics_assert_near("vx", physics_value(run, i, 2), 0.3 * y[1] * cos(y[0]), 1e-8);
    }
}

/* On a slope of tan a a box slides where that is above the friction, and tips over where it is above width / height:
 * about its lower corner, with r from there to the centre at r'' = m g r sin(..) / (I + m r^2). */
static void test_tips_or_slides(void)
{
    static const struct {
        double slope, friction;
        gboolean slides, tips;
    } rows[] = {{0.3, 0.4, FALSE, FALSE}, {0.3, 0.2, TRUE, FALSE}, {0.6, 0.8, FALSE, TRUE}, {0.6, 0.4, TRUE, FALSE}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        const double a = atan(rows[i].slope), w = 0.25, h = 0.5, t = 0.02;
        g_autofree char *friction =
            g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g", rows[i].friction, rows[i].friction);
        g_autofree char *plate = contact_plate(0, 0, -a, 10, friction);
        const double at[] = {0, t};
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = t,
                                          .at = at,
                                          .at_count = 2,
                                          .columns = "Box 0.ax, Box 0.ay, Box 0.angular acceleration, Box 0.x"},
                        CONTACT_WEIGHT "%s, {'type': 'box', 'width': 0.5, 'height': 1, 'orientation': %.17g,"
                                       " 'position': [%.17g, %.17g]}",
                        plate, -a, h * sin(a), h * cos(a));
        const double pull = g * (sin(a) - rows[i].friction * cos(a)), r2 = w * w + h * h;
        const double tips = g * (h * sin(a) - w * cos(a)) / (r2 / 3 + r2);
        physics_assert_near("angular acceleration", -physics_value(run, 0, 2), rows[i].tips ? tips : 0, 1e-9);
        if (!rows[i].tips)
            physics_assert_near("ax", physics_value(run, 0, 0), rows[i].slides ? pull * cos(a) : 0, 1e-9);
    }
}

/* From below it goes through, and past the end of a top, too; what comes from above lands. */
static void test_passes_from_below(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Box 0.vy, Box 1.vx, Box 2.y, Box 0.angle, Box 1.y"},
                    "{'type': 'support', 'position': [0, -0.2], 'width': 4},"
                    "{'type': 'box', 'position': [0, -2], 'velocity': [0, 4], 'angular_velocity': 3},"
                    "{'type': 'box', 'position': [-4, 0], 'velocity': [3, 0]},"
                    "{'type': 'box', 'position': [1.2, 1], 'velocity': [0, -1], 'height': 0.5}");
    physics_assert_near("vy", physics_last(run, 0), 4, 1e-12);
    physics_assert_near("angle", physics_last(run, 3), 3, 1e-12);
    physics_assert_near("vx", physics_last(run, 1), 3, 1e-12);
    physics_assert_near("y", physics_last(run, 2), 0.25, 1e-12);
    contact_assert_event(run, "rest", "Box 2, Support 0", 0.75, 1e-12);
    contact_assert_count(run, "rest", 1);
}

/* A box that tumbles down with restitution and friction comes to rest flat, and the books close; all methods of order 4
 * and more agree on where. */
static void test_tumbles(void)
{
    double first = NAN;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 3, "Box 0.x, Box 0.y, Box 0.angle, Box 0.vx");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                        ", 'width': 40, 'restitution': 0.3, 'static_friction': 0.4, 'dynamic_friction': 0.4},"
                        "{'type': 'box', 'width': 0.6, 'height': 0.4, 'position': [0, 1], 'orientation': 0.3,"
                        " 'velocity': [1, 0], 'angular_velocity': 1}");
        physics_assert_near("the error of the books", run->summary->energy_balance_error, 0,
                            fmax(1e-6, contact_methods[i].smooth));
        physics_assert_near("lies", physics_last(run, 1), fabs(cos(physics_last(run, 2))) > 0.5 ? 0.2 : 0.3, 1e-9);
        physics_assert_near("rests", physics_last(run, 3), 0, 1e-9);
        if (i == 0) first = physics_last(run, 0);
        physics_assert_near("x", physics_last(run, 0), first, fmax(1e-6, 100 * contact_methods[i].smooth));
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-turning/rolls", test_rolls);
    g_test_add_func("/physics/contact-turning/no-creep", test_no_creep);
    g_test_add_func("/physics/contact-turning/slides-then-rolls", test_slides_then_rolls);
    g_test_add_func("/physics/contact-turning/rocks", test_rocks);
    g_test_add_func("/physics/contact-turning/rod-lands", test_rod_lands);
    g_test_add_func("/physics/contact-turning/rod-falls", test_rod_falls);
    g_test_add_func("/physics/contact-turning/rolls-over-an-end", test_rolls_over_an_end);
    g_test_add_func("/physics/contact-turning/leaves-by-its-last-corner", test_leaves_by_its_last_corner);
    g_test_add_func("/physics/contact-turning/leaves-when-its-last-corner-passes",
                    test_leaves_when_its_last_corner_passes);
    g_test_add_func("/physics/contact-turning/leaves-the-end-of-a-body", test_leaves_the_end_of_a_body);
    g_test_add_func("/physics/contact-turning/tips-or-slides", test_tips_or_slides);
    g_test_add_func("/physics/contact-turning/passes-from-below", test_passes_from_below);
    g_test_add_func("/physics/contact-turning/tumbles", test_tumbles);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
