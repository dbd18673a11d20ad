/* Several contacts at once: corners, grooves, pushers, and from one support onto the next. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* --- corners --- */

/* Along a floor into a wall, which throws it back at half its speed; then friction stops it. */
static void test_into_a_wall(void)
{
    const double v = 3, friction = 0.2, brake = friction * g, way = 1;
    double hit = sqrt(v * v - 2 * brake * way), touch = (v - hit) / brake, back = 0.5 * hit;
    g_autofree char *wall = contact_plate(1, 0, G_PI / 2, 3, CONTACT_SMOOTH ", 'restitution': 0.5");
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 3, NULL);
        g_autoptr(PhysicsRun) run = physics_run(&options,
                                                CONTACT_WEIGHT CONTACT_FLOOR
                                                ", 'static_friction': 0.2, 'dynamic_friction': 0.2}, %s, " CONTACT_POINT
                                                ", 'velocity': [3, 0]}",
                                                wall);
        double bound = 2 * contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){1 - back * back / 2 / brake, 0, 0, 0}, bound);
        contact_assert_event(run, "impact", "Mass 0, Support 1", touch, bound);
        contact_assert_event(run, "stick", "Mass 0, Support 0", touch + back / brake, bound);
        contact_assert_count(run, "take-off", 0);
        contact_assert_taken(run, brake * way + back * back / 2, (hit * hit - back * back) / 2, 10 * bound);
    }
}

/* Dropped into a corner and pushed there: each side bears its share. */
static void test_pushed_into_a_corner(void)
{
    const double push = 20, angle = -G_PI / 6;
    g_autofree char *wall = contact_plate(1, 0, G_PI / 2, 3, CONTACT_SMOOTH);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 2,
                                                 "Support 0.normal force, Support 1.normal force, Mass "
                                                 "0.normal force, Mass 0.contact force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT CONTACT_FLOOR ", " CONTACT_SMOOTH "}, %s," CONTACT_POINT
                                                     ", 'mass': 2, 'position': [0.5, 0.1]},"
                                                     "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': "
                                                     "20, 'frequency': 0, 'angle': %.17g}",
                        wall, angle);
        double floor = 2 * g - push * sin(angle), side = push * cos(angle);
        contact_assert_state(run, "Mass 0", (double[]){1, 0, 0, 0}, 1e-12);
        physics_assert_near("on the floor", physics_last(run, 0), floor, 1e-9);
        physics_assert_near("on the wall", physics_last(run, 1), side, 1e-9);
        physics_assert_near("the sum of both", physics_last(run, 2), floor + side, 1e-9);
        physics_assert_near("contact force", physics_last(run, 3), hypot(floor, side), 1e-9);
        contact_assert_event(run, "rest", "Mass 0, Support 1", sqrt(2 * 0.5 / (side / 2)),
                             contact_methods[i].polynomial);
    }
}

/* --- grooves --- */

/* Two plates that cross at the origin, rising by `left` to the left and by `right` to the right. (transfer full) */
static char *groove(double left, double right, const char *more)
{
    g_autofree char *one = contact_plate(0, 0, -left, 8, more), *other = contact_plate(0, 0, right, 8, more);
    return g_strdup_printf("%s, %s", one, other);
}

/* Into the very bottom: both at once. Without friction each side bears what statics gives it. */
static void check_groove(double left, double right, double mass)
{
    g_autofree char *plates = groove(left, right, CONTACT_SMOOTH);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1,
                                                 "Support 0.normal force, Support 1.normal force, Mass "
                                                 "0.contact force, Mass 0.y");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s," CONTACT_POINT ", 'mass': %g, 'position': [0, 1]}", plates, mass);
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
        physics_assert_near("left", physics_last(run, 0), mass * g * sin(right) / sin(left + right), 1e-9 * mass);
        physics_assert_near("right", physics_last(run, 1), mass * g * sin(left) / sin(left + right), 1e-9 * mass);
        physics_assert_near("both", physics_last(run, 2), mass * g, 1e-9 * mass);
        contact_assert_taken(run, 0, mass * g, 20 * mass * contact_methods[i].polynomial);
    }
}

static void test_grooves(void)
{
    check_groove(G_PI / 4, G_PI / 4, 1);
    check_groove(G_PI / 6, G_PI / 3, 2);
    check_groove(0.2, 1.3, 5);
    check_groove(0.001, 0.001, 1);
}

/* With friction the shares are indeterminate; their sum is not. */
static void test_rough_groove(void)
{
    g_autofree char *plates = groove(G_PI / 4, G_PI / 3, "");
    PhysicsOptions options = contact_options(&contact_methods[0], 1, "Mass 0.contact force");
    g_autoptr(PhysicsRun) run =
        physics_run(&options, CONTACT_WEIGHT "%s," CONTACT_POINT ", 'mass': 3, 'position': [0, 0.5]}", plates);
    contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
    physics_assert_near("contact force", physics_last(run, 0), 3 * g, 1e-9);
}

/* Beside the bottom: along one side first, then straight against the other. */
static void test_slides_to_the_bottom(void)
{
    const double fall = 0.5, side = 0.3, slope = G_PI / 4;
    double landing = sqrt(2 * fall / g), v = g * landing * sin(slope), a = g * sin(slope), way = side / cos(slope);
    double end = landing + (sqrt(v * v + 2 * a * way) - v) / a;
    g_autofree char *plates = groove(slope, slope, CONTACT_SMOOTH);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.5, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT "%s," CONTACT_POINT ", 'position': [0.3, %.17g]}", plates, side + fall);
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-11);
        contact_assert_event(run, "rest", "Mass 0, Support 1", landing, contact_methods[i].polynomial);
        contact_assert_event(run, "rest", "Mass 0, Support 0", end, 2 * contact_methods[i].polynomial);
        contact_assert_taken(run, 0, g * (fall + side), 20 * contact_methods[i].polynomial);
    }
}

/* --- pushers --- */

/* A leaning plate that accelerates by 2 m/s^2 pushes a mass along the floor: without friction, it also lifts. */
static void check_pusher(const ContactMethod *method, double gap, double bound)
{
    const double lean = G_PI / 3, a = 2, duration = 1.25, pushed = 3 * a / sin(lean);
    g_autofree char *plate = contact_plate(-gap, 0, -lean, 4, CONTACT_SMOOTH);
    PhysicsOptions options = contact_options(method, duration, "Support 0.normal force, Support 1.normal force");
    g_autoptr(PhysicsRun) run =
        physics_run(&options,
                    CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 20, " CONTACT_SMOOTH "}, %s," CONTACT_POINT
                                                 ", 'mass': 3}, {'type': 'support-motion', 'ends': ['Support 1'], "
                                                 "'waveform': {'expression': 't^2'}}",
                    plate);
    contact_assert_state(run, "Mass 0", (double[]){a / 2 * duration * duration - gap, 0, a * duration, 0}, bound);
    physics_assert_near("on the plate", physics_last(run, 1), pushed, 1e-8);
    physics_assert_near("on the floor", physics_last(run, 0), 3 * g - pushed * cos(lean), 1e-8);
}

static void test_pusher(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++)
        check_pusher(&contact_methods[i], 0, 1e-9);
}

/* Where it comes up with the mass at 1 m/s, it throws it off the floor, the floor throws it off the plate, and so on,
 * every time a quarter as long: that ends at about 1.011 s, and from then on it pushes. */
static void test_pusher_catches_up(void)
{
    check_pusher(&contact_methods[0], 0.25, 1e-8);
    check_pusher(&contact_methods[1], 0.25, 1e-8);
}

/* --- from one support onto the next --- */

/* From a floor onto a ramp: what goes across the ramp is lost, up and down again, and what goes across the floor. The
 * centre turns where it stands height / 2 off both. */
static void check_ramp(double height)
{
    const double slope = 20 * G_PI / 180, v = 3, from = -1.5;
    double corner[2] = {-height / 2 * tan(slope / 2), height / 2}, up = v * cos(slope), pull = g * sin(slope);
    double touch = (corner[0] - from) / v, again = touch + 2 * up / pull, climbing = 0.3, back = 0.25;
    double way = up * climbing - pull / 2 * climbing * climbing, speed = up - pull * climbing;
    double high[4] = {corner[0] + way * cos(slope), corner[1] + way * sin(slope), speed * cos(slope),
                      speed * sin(slope)};
    double end[4] = {corner[0] - up * cos(slope) * back, corner[1], -up * cos(slope), 0};
    g_autofree char *floor = contact_plate(-2, 0, 0, 6, CONTACT_SMOOTH);
    g_autofree char *ramp = contact_plate(3 * cos(slope), 3 * sin(slope), slope, 7, CONTACT_SMOOTH);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        for (int k = 0; k < 2; k++) {
            PhysicsOptions options =
                contact_options(&contact_methods[i], k == 0 ? touch + climbing : again + back, NULL);
            g_autoptr(PhysicsRun) run = physics_run(
                &options,
                CONTACT_WEIGHT "%s, %s, {'type': 'mass', 'height': %g, 'position': [%.17g, %.17g], 'velocity': [3, 0]}",
                floor, ramp, height, from, height / 2);
            double bound = 5 * contact_methods[i].polynomial, lost = v * v - up * up;
            contact_assert_state(run, "Mass 0", k == 0 ? high : end, bound);
            contact_assert_event(run, "rest", "Mass 0, Support 1", touch, bound);
            if (k == 1) {
                contact_assert_event(run, "rest", "Mass 0, Support 0", again, bound);
                lost = v * v - end[2] * end[2];
            }
            contact_assert_taken(run, 0, lost / 2, 5 * bound);
        }
    }
}

static void test_onto_a_ramp(void)
{
    check_ramp(0);
    check_ramp(0.8);
}

/* Two plates end to end: no jolt at the seam, at any angle. */
static void check_seam(double slope, double height)
{
    const double friction = 0.1, v = 2, from = -1, duration = 1.1;
    double a = -g * (sin(slope) + friction * cos(slope)), s = from + v * duration + a / 2 * duration * duration;
    double now = v + a * duration, tangent[2] = {cos(slope), sin(slope)}, normal[2] = {-sin(slope), cos(slope)};
    g_assert_cmpfloat(s, >, 0);
    static const char more[] = "'static_friction': 0.1, 'dynamic_friction': 0.1";
    g_autofree char *lower = contact_plate(-2 * tangent[0], -2 * tangent[1], slope, 4, more);
    g_autofree char *upper = contact_plate(2 * tangent[0], 2 * tangent[1], slope, 4, more);
    double start[2], state[4];
    for (int k = 0; k < 2; k++) {
        start[k] = from * tangent[k] + height / 2 * normal[k];
        state[k] = s * tangent[k] + height / 2 * normal[k];
        state[2 + k] = now * tangent[k];
    }
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT "%s, %s, {'type': 'mass', 'height': %g, 'position': [%.17g, "
                                       "%.17g], 'velocity': [%.17g, %.17g]}",
                        lower, upper, height, start[0], start[1], v * tangent[0], v * tangent[1]);
        contact_assert_state(run, "Mass 0", state, contact_methods[i].polynomial);
        contact_assert_count(run, "impact", 0);
        contact_assert_taken(run, friction * g * cos(slope) * (s - from), 0, 20 * contact_methods[i].polynomial);
    }
}

static void test_seams(void)
{
    static const double slopes[] = {0, -20, -7.3, 1.7, -25};
    for (gsize i = 0; i < G_N_ELEMENTS(slopes); i++) {
        check_seam(slopes[i] * G_PI / 180, 0);
        check_seam(slopes[i] * G_PI / 180, 0.8);
    }
}

/* A disc between two slopes of 45 degrees with a torque t on it: nothing determines how they share what holds it, until
 * both are at the limit of their static friction, mu, and of a resistance to rolling, rho: at
 * m g (mu R + rho) / ((1 + mu^2) cos 45). Then both rub by the dynamic one, nu, which takes the like of it. */
static void test_turned_in_groove(void)
{
    const double radius = 0.5, mu = 0.5, nu = 0.3, end = 4;
    const char *friction = "'static_friction': 0.5, 'dynamic_friction': 0.3";
    g_autofree char *right = contact_plate(0, 0, G_PI / 4, 10, friction);
    g_autofree char *left = contact_plate(0, 0, -G_PI / 4, 10, friction);
    static const double resistances[] = {0, 0.05};
    for (gsize i = 0; i < G_N_ELEMENTS(resistances); i++) {
        const double rho = resistances[i], most = g / sqrt(0.5) * (mu * radius + rho) / (1 + mu * mu),
                     rubs = g / sqrt(0.5) * (nu * radius + rho) / (1 + nu * nu);
        g_autofree char *rolls = i == 0 ? g_strdup("") : g_strdup_printf(", 'rolling_resistance': %g", rho);
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = end, .columns = "Disc 0.angular velocity"},
                        CONTACT_WEIGHT "%s, %s, {'type': 'disc', 'radius': 0.5, 'position': [0, %.17g]%s},"
                                       "{'type': 'torque', 'ends': ['Disc 0'], 'waveform': {'expression': 't'}}",
                        right, left, radius / sqrt(0.5), rolls);
        for (guint k = 0; k < run->summary->events->len; k++) {
            const TinkerEvent *event = g_ptr_array_index(run->summary->events, k);
            g_assert_cmpstr(event->kind, ==, "slip");
            physics_assert_near("slips", event->time, most, 1e-8);
        }
        const double turned = 0.5 * (end * end - most * most) - rubs * (end - most);
        physics_assert_near("rate", physics_last(run, 0), turned / (0.5 * radius * radius), 1e-6);
    }
}

/* A disc that resists rolling, in a groove, swayed by a force off its middle that swings and grows: it stands until no
 * share of its load holds any more, by linear programming (the largest reserve of all limits over all shares) at
 * 1.135061113 s. Shares along the way have one contact or the other at a limit, or pressing by nothing. */
static void test_swayed_in_groove(void)
{
    const double right = 0.399455481177645, left = -0.887256337605308, radius = 0.331242675625493;
    const double x = -radius * (cos(left) - cos(right)) / sin(right - left),
                 y = radius * (sin(right) - sin(left)) / sin(right - left);
    g_autofree char *right_wall =
        contact_plate(0, 0, right, 40, "'static_friction': 0.316364744331185, 'dynamic_friction': 0.17223653191865");
    g_autofree char *left_wall =
        contact_plate(0, 0, left, 40, "'static_friction': 0.659417789925834, 'dynamic_friction': 0.651724385929271");
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1.18, .columns = "Disc 0.x, Disc 0.angle"},
        CONTACT_WEIGHT
        "%s, %s, {'type': 'disc', 'mass': 2.20245477307957, 'radius': %.17g, 'position': [%.17g, %.17g],"
        " 'rolling_resistance': 0.054215732963130},"
        "{'type': 'motor', 'ends': [{'block': 'Disc 0', 'at': [-0.167979205476438, 0.0946236607625299]}],"
        " 'angle': 1.14918395376256, 'waveform': {'expression': '15.4855471162093*t*sin(5.96283297878942*t)'}}",
        right_wall, left_wall, radius, x, y);
    const double slips = 1.135061112852816;
    contact_assert_event(run, "slip", "Disc 0, Support 0", slips, 1e-9);
    contact_assert_count(run, "slip", 1);
    for (gsize i = 0; i < physics_samples(run) && physics_time(run, i) < slips; i++) {
        physics_assert_near("x", physics_value(run, i, 0), x, 1e-12);
        physics_assert_near("angle", physics_value(run, i, 1), 0, 1e-12);
    }
}

/* A ladder pushed aside near one end by a force that grows: one end, then the other reaches its limit by a share of the
 * load, the other way than it slips at last; it stands until none holds, by linear programming at 0.570296815 s. */
static void test_pushed_ladder(void)
{
    const double length = 1.20487687670799, lean = 1.91401690461618;
    g_autofree char *floor =
        contact_plate(0, 0, 0, 60, "'static_friction': 0.196142420619274, 'dynamic_friction': 0.125255095885553");
    g_autofree char *wall = contact_plate(0, 0, -G_PI / 2, 60,
                                          "'static_friction': 0.696677816805085, 'dynamic_friction': 0.57402406479358");
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 0.6, .columns = "Bar 0.x"},
        CONTACT_WEIGHT "%s, %s, {'type': 'bar', 'mass': 2.84524617066364, 'length': %.17g, 'width': 0, 'solid': true,"
                       " 'position': [%.17g, %.17g], 'orientation': %.17g},"
                       "{'type': 'motor', 'ends': [{'block': 'Bar 0', 'at': [0.479331122526202, 0]}],"
                       " 'angle': 0.781439939295425, 'waveform': {'expression': '10.1294559709353*t'}}",
        floor, wall, length, -0.5 * length * cos(lean), 0.5 * length * sin(lean), lean);
    g_assert_cmpuint(run->summary->events->len, >, 0);
    const TinkerEvent *first = g_ptr_array_index(run->summary->events, 0);
    physics_assert_near("slips", first->time, 0.570296815, 2e-9);
}

/* A ladder of length 2 on a rough floor at a rough wall stands from tan a = (1 - mu^2) / (2 mu) on, whatever the
 * dynamic friction; pulled at its foot by a force t it slips where both ends are at their limit: with N at the wall m g
 * cos a / 2 / (sin a + mu cos a), at mu (m g - mu N) - N. */
static void test_ladder(void)
{
    const double mu = 0.5, least = atan((1 - mu * mu) / (2 * mu)), angles[] = {least + 1e-3, 0.85, 1};
    const char *friction = "'static_friction': 0.5, 'dynamic_friction': 0.3";
    g_autofree char *floor = contact_plate(0, 0, 0, 20, friction);
    g_autofree char *wall = contact_plate(0, 0, -G_PI / 2, 20, friction);
    for (gsize i = 0; i < G_N_ELEMENTS(angles); i++) {
        const double c = cos(angles[i]), s = sin(angles[i]), leans = 0.5 * g * c / (s + mu * c);
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 3, .columns = "Bar 0.x"},
                        CONTACT_WEIGHT "%s, %s, {'type': 'bar', 'length': 2, 'width': 0, 'solid': true,"
                                       " 'position': [%.17g, %.17g], 'orientation': %.17g},"
                                       "{'type': 'motor', 'ends': [{'block': 'Bar 0', 'at': [-1, 0]}],"
                                       " 'waveform': {'expression': 't'}}",
                        floor, wall, c, s, G_PI - angles[i]);
        g_assert_cmpuint(run->summary->events->len, >, 0);
        const TinkerEvent *first = g_ptr_array_index(run->summary->events, 0);
        g_assert_cmpstr(first->kind, ==, "slip");
        physics_assert_near("slips", first->time, mu * (g - mu * leans) - leans, 1e-7);
    }
}

/* A disc between a push that grows from nothing and a box, which it touches: it would roll, and is held by its friction
 * on the box, which presses that onto the floor. With n on the box this slides at n = mu (m g + mu' n), where the push
 * is n (1 + mu'); mu: box on floor, mu': disc on box. Up to then contacts carry loads that begin at 0. */
static void test_pushed_from_nothing(void)
{
    const double floor_mu = sqrt(0.5 * 0.3), box_mu = 0.3, m = 0.5;
    const double push = floor_mu * m * g * (1 + box_mu) / (1 - floor_mu * box_mu);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.5, .columns = "Box 0.x"}, CONTACT_WEIGHT
                    "{'type': 'support', 'position': [0, -0.2], 'width': 60, 'height': 0.4, 'restitution': 0,"
                    " 'static_friction': 0.5, 'dynamic_friction': 0.5},"
                    "{'type': 'disc', 'mass': 3, 'radius': 0.2, 'position': [-0.2, 0.2], 'static_friction': 0.3,"
                    " 'dynamic_friction': 0.3},"
                    "{'type': 'box', 'mass': 0.5, 'width': 0.6, 'height': 0.5, 'position': [0.3, 0.25],"
                    " 'static_friction': 0.3, 'dynamic_friction': 0.3},"
                    "{'type': 'motor', 'ends': ['Disc 0'], 'waveform': {'expression': '18*t*sin(5*t)'}}");
    g_assert_cmpuint(run->summary->events->len, >, 0);
    const TinkerEvent *first = g_ptr_array_index(run->summary->events, 0);
    g_assert_cmpstr(first->kind, ==, "slip");
    physics_assert_near("push", 18 * first->time * sin(5 * first->time), push, 1e-8 * push);
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-several/into-a-wall", test_into_a_wall);
    g_test_add_func("/physics/contact-several/pushed-into-a-corner", test_pushed_into_a_corner);
    g_test_add_func("/physics/contact-several/grooves", test_grooves);
    g_test_add_func("/physics/contact-several/rough-groove", test_rough_groove);
    g_test_add_func("/physics/contact-several/slides-to-the-bottom", test_slides_to_the_bottom);
    g_test_add_func("/physics/contact-several/pusher", test_pusher);
    g_test_add_func("/physics/contact-several/pusher-catches-up", test_pusher_catches_up);
    g_test_add_func("/physics/contact-several/onto-a-ramp", test_onto_a_ramp);
    g_test_add_func("/physics/contact-several/seams", test_seams);
    g_test_add_func("/physics/contact-several/turned-in-groove", test_turned_in_groove);
    g_test_add_func("/physics/contact-several/swayed-in-groove", test_swayed_in_groove);
    g_test_add_func("/physics/contact-several/ladder", test_ladder);
    g_test_add_func("/physics/contact-several/pushed-ladder", test_pushed_ladder);
    g_test_add_func("/physics/contact-several/pushed-from-nothing", test_pushed_from_nothing);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
