/* Bodies that are joined follow the one that a hand moves: a four-bar linkage closes on its circles, a rod of given
 * length keeps it, what is left to where it is placed gives way. */
#include "physics-fixture.h"

#include "physics/compile/assemble.h"

#include <math.h>

#define CRANK   0.1
#define COUPLER 0.4
#define ROCKER  0.3
#define GROUND  0.4

/* Where coupler and rocker meet for a crank at this angle: the upper of two circles' common points. */
static void meeting(double angle, double end[2], double place[2])
{
    end[0] = CRANK * cos(angle);
    end[1] = CRANK * sin(angle);
    const double across[2] = {GROUND - end[0], -end[1]}, distance = hypot(across[0], across[1]);
    const double along = (COUPLER * COUPLER - ROCKER * ROCKER + distance * distance) / (2 * distance);
    const double aside = sqrt(COUPLER * COUPLER - along * along);
    place[0] = end[0] + (along * across[0] - aside * across[1]) / distance;
    place[1] = end[1] + (along * across[1] + aside * across[0]) / distance;
}

/* A bar between two places, of this length. */
static char *bar_text(const char *name, const double a[2], const double b[2], double length)
{
    return g_strdup_printf("{'type': 'bar', 'name': '%s', 'length': %.17g, 'position': [%.17g, %.17g], 'orientation': "
                           "%.17g, 'mass': 3}",
                           name, length, 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), atan2(b[1] - a[1], b[0] - a[0]));
}

static TinkerScene *four_bar(double angle)
{
    static const double origin[2] = {0, 0}, ground[2] = {GROUND, 0};
    double end[2], place[2];
    meeting(angle, end, place);
    g_autofree char *crank = bar_text("Crank", origin, end, CRANK);
    g_autofree char *coupler = bar_text("Coupler", end, place, COUPLER);
    g_autofree char *rocker = bar_text("Rocker", ground, place, ROCKER);
    g_autofree char *blocks = g_strdup_printf(
        "{'type': 'support', 'name': 'Wall', 'position': [0, 0]}, %s, %s, %s,"
        "{'type': 'mass', 'name': 'Apart', 'position': [9, 9]},"
        "{'type': 'pin', 'ends': ['Wall', {'block': 'Crank', 'at': [-0.05, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Crank', 'at': [0.05, 0]}, {'block': 'Coupler', 'at': [-0.2, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Coupler', 'at': [0.2, 0]}, {'block': 'Rocker', 'at': [0.15, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Wall', 'at': [0.4, 0]}, {'block': 'Rocker', 'at': [-0.15, 0]}]}",
        crank, coupler, rocker);
    return physics_scene(NULL, blocks);
}

static void set(TinkerScene *scene, const char *name, int32_t meaning, const double *values)
{
    g_autoptr(GError) error = NULL;
    const TinkerBlockId block = tinker_scene_find_block(scene, name);
    tinker_scene_set(scene, block, tinker_scene_block_class(scene, block)->meanings[meaning], values, &error);
    g_assert_no_error(error);
}

static const TinkerAssembledBody *find(const GArray *bodies, TinkerScene *scene, const char *name)
{
    for (guint i = 0; i < bodies->len; i++) {
        const TinkerAssembledBody *body = &g_array_index(bodies, TinkerAssembledBody, i);
        if (g_str_equal(tinker_scene_block_name(scene, body->block), name)) return body;
    }
    return NULL;
}

/* The crank is turned in steps, as a hand does; the others are written back, as whoever assembles does. */
static void test_four_bar(void)
{
    g_autoptr(TinkerScene) scene = four_bar(1.0);
    for (double angle = 1.1; angle < 7.5; angle += 0.1) {
        g_autoptr(GError) error = NULL;
        set(scene, "Crank", TINKER_MEANING_ORIENTATION, &angle);
        const TinkerHeldBody held = {tinker_scene_find_block(scene, "Crank"), FALSE, TRUE};
        g_autoptr(GArray) bodies = tinker_assemble(scene, &held, &error);
        g_assert_no_error(error);
        g_assert_cmpuint(bodies->len, ==, 3); /* and not what is apart */
        double end[2], place[2];
        const double turned = find(bodies, scene, "Crank")->orientation;
        physics_assert_near("crank", turned, angle, 1e-5);
        meeting(turned, end, place);
        const TinkerAssembledBody *coupler = find(bodies, scene, "Coupler"), *rocker = find(bodies, scene, "Rocker");
        physics_assert_near("coupler's x", coupler->place[0], 0.5 * (end[0] + place[0]), 1e-9);
        physics_assert_near("coupler's y", coupler->place[1], 0.5 * (end[1] + place[1]), 1e-9);
        physics_assert_near("rocker", tan(rocker->orientation), place[1] / (place[0] - GROUND), 1e-8);
        for (guint i = 0; i < bodies->len; i++) {
            const TinkerAssembledBody *body = &g_array_index(bodies, TinkerAssembledBody, i);
            const char *name = tinker_scene_block_name(scene, body->block);
            set(scene, name, TINKER_MEANING_POSITION, body->place);
            set(scene, name, TINKER_MEANING_ORIENTATION, &body->orientation);
        }
    }
}

/* The place that is held is met as nearly as the pin lets it: on its circle. */
static void test_held_place(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'support'}, {'type': 'disc', 'position': [1, 0]},"
                            "{'type': 'pin', 'ends': ['Support 0', {'block': 'Disc 0', 'at': [-1, 0]}]}");
    set(scene, "Disc 0", TINKER_MEANING_POSITION, (const double[]){0.9, 0.5});
    const TinkerHeldBody held = {tinker_scene_find_block(scene, "Disc 0"), TRUE, FALSE};
    g_autoptr(GArray) bodies = tinker_assemble(scene, &held, &error);
    g_assert_no_error(error);
    const TinkerAssembledBody *disc = find(bodies, scene, "Disc 0");
    physics_assert_near("radius", hypot(disc->place[0], disc->place[1]), 1.0, 1e-12);
    physics_assert_near("direction", atan2(disc->place[1], disc->place[0]), atan2(0.5, 0.9), 1e-3);
    physics_assert_near("orientation", disc->orientation, atan2(disc->place[1], disc->place[0]), 1e-9);
}

static void test_rods(void)
{
    static const char *const rod[] = {"", ", 'length': 1"};
    for (gsize given = 0; given < 2; given++) {
        g_autoptr(GError) error = NULL;
        g_autofree char *blocks = g_strdup_printf("{'type': 'support'}, {'type': 'mass', 'position': [0, -1]},"
                                                  "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']%s}",
                                                  rod[given]);
        g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
        set(scene, "Mass 0", TINKER_MEANING_POSITION, (const double[]){0.5, -1.2});
        const TinkerHeldBody held = {tinker_scene_find_block(scene, "Mass 0"), TRUE, FALSE};
        g_autoptr(GArray) bodies = tinker_assemble(scene, &held, &error);
        g_assert_no_error(error);
        g_assert_cmpuint(bodies->len, ==, given);
        if (given == 0) continue;
        const TinkerAssembledBody *mass = find(bodies, scene, "Mass 0");
        g_assert_false(mass->turns);
        physics_assert_near("x", mass->place[0], 0.5 / 1.3, 1e-12);
        physics_assert_near("y", mass->place[1], -1.2 / 1.3, 1e-12);
    }
}

/* Too far to be reached: the error names what does not fit. */
static void test_out_of_reach(void)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = physics_scene(
        NULL, "{'type': 'support'}, {'type': 'support', 'position': [5, 0]}, {'type': 'bar', 'position': [0, 0]},"
              "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]},"
              "{'type': 'pin', 'ends': ['Support 1', {'block': 'Bar 0', 'at': [0.5, 0]}]}");
    const TinkerHeldBody held = {tinker_scene_find_block(scene, "Bar 0"), TRUE, FALSE};
    g_assert_null(tinker_assemble(scene, &held, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_CONTRADICTION);
    g_assert_nonnull(strstr(error->message, "Pin"));
}

static void add_tests(void)
{
    g_test_add_func("/physics/assemble/four-bar", test_four_bar);
    g_test_add_func("/physics/assemble/held-place", test_held_place);
    g_test_add_func("/physics/assemble/rods", test_rods);
    g_test_add_func("/physics/assemble/out-of-reach", test_out_of_reach);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
