/* More bodies that meet than are decided upon all together: rows and crowds whose motion is known. And the list of what
 * is near, against all pairs. */
#include <math.h>
#include <string.h>

#include "contact-checks.h"
#include "physics/compile/compile.h"
#include "physics/contact/contact-neighbours.h"
#include "physics/model/model-data.h"

static const double g = CONTACT_GRAVITY;

/* A hundred equal discs in a row, a metre apart: the speed of the first is handed on, and each comes to rest where the
 * next one was touched. */
static void test_handed_on(void)
{
    enum { DISCS = 100 };
    const double speed = 20, radius = 0.2, way = 1 - 2 * radius, duration = 4;
    g_autoptr(GString) blocks = g_string_new(NULL);
    for (int i = 0; i < DISCS; i++)
        g_string_append_printf(blocks,
                               "%s{'type': 'disc', 'name': 'D%d', 'radius': 0.2, 'position': [%d, 0], 'velocity': [%d, "
                               "0], 'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0}",
                               i > 0 ? ", " : "", i, i, i == 0 ? (int)speed : 0);
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = duration}, "%s", blocks->str);
    const double last = (DISCS - 1) * way / speed; /* s: it is touched then */
    for (int i = 0; i < DISCS; i++) {
        g_autofree char *name = g_strdup_printf("D%d", i);
        double state[4];
        physics_state(run, name, state);
        const gboolean is_last = i == DISCS - 1;
        physics_assert_near(name, state[0], is_last ? i + speed * (duration - last) : i + way, 1e-9);
        physics_assert_near(name, state[2], is_last ? speed : 0, 1e-9);
    }
    contact_assert_count(run, "impact", DISCS - 1);
    for (int i = 0; i + 1 < DISCS; i += 33) {
        g_autofree char *names = g_strdup_printf("D%d, D%d", i, i + 1);
        contact_assert_event(run, "impact", names, (i + 1) * way / speed, 1e-10);
    }
}

/* Boxes beside one another that fall from heights so far apart: each lands and stays. */
static void check_row_lands(double apart)
{
    enum { BOXES = 80 };
    g_autoptr(GString) blocks =
        g_string_new(CONTACT_WEIGHT "{'type': 'support', 'position': [0, -0.1], 'width': 500, 'height': 0.2}");
    double height[BOXES], lost = 0;
    for (int i = 0; i < BOXES; i++) {
        height[i] = 0.2 + apart * ((i * 37) % BOXES);
        lost += g * height[i];
        g_string_append_printf(blocks,
                               ", {'type': 'box', 'name': 'B%d', 'mass': 1, 'width': 1, 'height': 0.4, 'position': "
                               "[%.17g, %.17g], 'restitution': 0}",
                               i, 1.5 * (i - BOXES / 2), 0.2 + height[i]);
    }
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 0.6}, "%s", blocks->str);
    for (int i = 0; i < BOXES; i++) {
        g_autofree char *name = g_strdup_printf("B%d", i), *names = g_strdup_printf("%s, Support 0", name);
        double state[4];
        physics_state(run, name, state);
        physics_assert_near(name, state[1], 0.2, 1e-10);
        contact_assert_event(run, "rest", names, sqrt(2 * height[i] / g), 1e-9);
    }
    contact_assert_count(run, "rest", BOXES);
    contact_assert_taken(run, 0, lost, 1e-8 * lost);
}

static void test_row_lands(void)
{
    check_row_lands(0.01);
}

/* All at one instant. */
static void test_lands_at_once(void)
{
    check_row_lands(0);
}

/* A box with one that falls onto it aslant and turning, ten metres aside from the ones before, and a little later. */
static void add_two(GString *blocks, int copy)
{
    g_string_append_printf(
        blocks,
        ", {'type': 'box', 'name': 'L%d', 'mass': 2, 'width': 1, 'height': 0.5, 'position': [%d, "
        "0.25], 'restitution': 0.2, 'static_friction': 0.5, 'dynamic_friction': 0.4}"
        ", {'type': 'box', 'name': 'U%d', 'mass': 1, 'width': 0.4, 'height': 0.4, 'position': [%.17g, "
        "%.17g], 'orientation': 0.3, 'angular_velocity': 0.5, 'restitution': 0.2, 'static_friction': "
        "0.5, 'dynamic_friction': 0.4}",
        copy, 10 * copy, copy, 10 * copy + 0.1, 0.85 + 0.004 * copy);
}

static PhysicsRun *run_of_twos(int first, int end)
{
    g_autoptr(GString) blocks =
        g_string_new(CONTACT_WEIGHT "{'type': 'support', 'position': [0, -0.1], 'width': 2000, 'height': 0.2}");
    for (int copy = first; copy < end; copy++)
        add_two(blocks, copy);
    return physics_run(&(PhysicsOptions){.duration = 0.3}, "%s", blocks->str);
}

/* Pairs of boxes that are far from each other move as if each were alone, whatever the others do at that time. */
static void test_others_far_off(void)
{
    enum { COPIES = 34 };
    g_autoptr(PhysicsRun) all = run_of_twos(0, COPIES);
    for (int copy = 0; copy < COPIES; copy += 11) {
        g_autoptr(PhysicsRun) one = run_of_twos(copy, copy + 1);
        for (int k = 0; k < 2; k++) {
            g_autofree char *name = g_strdup_printf("%c%d", "LU"[k], copy);
            double state[4];
            physics_state(one, name, state);
            contact_assert_state(all, name, state, 1e-9);
        }
    }
}

/* Smooth masses that fly about in a box of walls and rebound fully: what moves keeps its energy, and none of two is
 * ever in the other. */
static void test_crowd(void)
{
    enum { ROW = 9, MASSES = ROW * ROW };
    const double size = 0.15;
    g_autoptr(GRand) random = g_rand_new_with_seed(5);
    g_autoptr(GString) blocks = g_string_new(NULL), columns = g_string_new(NULL);
    const char smooth[] = "'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0";
    const double middle = 0.25 * ROW, off[] = {-0.1, 0.5 * ROW + 0.1};
    for (int i = 0; i < 4; i++)
        g_string_append_printf(blocks,
                               "%s{'type': 'support', 'position': [%.17g, %.17g], 'width': 6, 'height': 0.2, "
                               "'orientation': '%d deg', %s}",
                               i > 0 ? ", " : "", i < 2 ? middle : off[i - 2], i < 2 ? off[i] : middle,
                               (const int[]){0, 180, -90, 90}[i], smooth);
    double energy = 0;
    for (int i = 0; i < MASSES; i++) {
        const double vx = g_rand_double_range(random, -2, 2), vy = g_rand_double_range(random, -2, 2);
        energy += 0.5 * (vx * vx + vy * vy);
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'name': 'M%d', 'mass': 1, 'width': %g, 'height': %g, 'collides': "
                               "true, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g], %s}",
                               i, size, size, 0.25 + 0.5 * (i % ROW), 0.25 + 0.5 * (i / ROW), vx, vy, smooth);
        g_string_append_printf(columns, "%sM%d.x, M%d.y, M%d.vx, M%d.vy", i > 0 ? ", " : "", i, i, i, i);
    }
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .interval = 0.02, .columns = columns->str}, "%s", blocks->str);
    for (gsize k = 0; k < physics_samples(run); k++) {
        double now = 0;
        for (gsize i = 0; i < MASSES; i++) {
            const double vx = physics_value(run, k, 4 * i + 2), vy = physics_value(run, k, 4 * i + 3);
            now += 0.5 * (vx * vx + vy * vy);
            for (gsize j = 0; j < i; j++) {
                const double x = fabs(physics_value(run, k, 4 * i) - physics_value(run, k, 4 * j)),
                             y = fabs(physics_value(run, k, 4 * i + 1) - physics_value(run, k, 4 * j + 1));
                g_assert_cmpfloat(fmax(x, y), >=, size - 1e-9);
            }
        }
        physics_assert_near("kinetic energy", now, energy, 1e-9 * energy);
    }
    g_assert_cmpuint(run->summary->events->len, >, MASSES);
}

/* On random ways every pair that comes as near as is asked for is listed, and is filled in. */
static void test_near_pairs(void)
{
    enum { BODIES = 30, WAYS = 2000 };
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    g_autoptr(GString) text = g_string_new("{'type': 'support', 'width': 4}");
    for (int i = 0; i < BODIES; i++)
        g_string_append_printf(text, ", {'type': 'disc', 'radius': %.17g, 'position': [%d, 3]}",
                               g_rand_double_range(random, 0.1, 0.4), i);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, text->str);
    TinkerModel *model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerContacts *contacts = model->contacts;
    TinkerContactNeighbours near;
    tinker_contact_neighbours_init(&near, contacts);
    g_autofree double *q = g_memdup2(model->q_start, 3 * BODIES * sizeof(double)),
                      *to = g_memdup2(q, 3 * BODIES * sizeof(double));
    guint listed = 0;
    for (int way = 0; way < WAYS; way++) {
        const double travel = pow(10, g_rand_double_range(random, -3, 0));
        for (int i = 0; i < 2 * BODIES; i++)
            to[i] = q[i] + travel * g_rand_double_range(random, -1, 1);
        tinker_contact_neighbours_find_pairs(&near, q, to, travel, 3 * travel);
        for (int32_t k = 0, place = 0; k < contacts->pair_count; k++) {
            const TinkerTouchingPair *pair = &contacts->pairs[k];
            while (place < (int32_t)near.pairs->len && g_array_index(near.pairs, int32_t, place) < k)
                place++;
            const gboolean found = place < (int32_t)near.pairs->len && g_array_index(near.pairs, int32_t, place) == k;
            const double least =
                fmin(tinker_contact_pair_distance(contacts, pair, q), tinker_contact_pair_distance(contacts, pair, to));
            g_assert_true(found || least > travel);
            g_assert_true(!found || (pair->filled && contacts->plates[pair->first].gap != NULL));
            listed += found;
        }
        memcpy(q, to, 2 * BODIES * sizeof(double));
    }
    g_assert_cmpuint(listed, <, WAYS * (guint)contacts->pair_count / 2);
    tinker_contact_neighbours_clear(&near);
    tinker_model_free(model);
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-many/handed-on", test_handed_on);
    g_test_add_func("/physics/contact-many/row-lands", test_row_lands);
    g_test_add_func("/physics/contact-many/lands-at-once", test_lands_at_once);
    g_test_add_func("/physics/contact-many/others-far-off", test_others_far_off);
    g_test_add_func("/physics/contact-many/crowd", test_crowd);
    g_test_add_func("/physics/contact-many/near-pairs", test_near_pairs);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
