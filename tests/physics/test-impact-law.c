/* The law of impact that a run asks for, and what it says where the laws differ. */
#include "contact-checks.h"

#include <math.h>

#define BALL                                                                                                           \
    "{'type': 'disc', 'radius': 0.1, 'restitution': 1, " CONTACT_SMOOTH ", 'position': [%g, 0], 'velocity': [%g, 0]}"

static PhysicsRun *run_row(const char *law)
{
    g_autofree char *blocks = g_strdup_printf(BALL "," BALL "," BALL, 0.0, 1.0, 0.5, 0.0, 0.7, 0.0);
    return physics_run(
        &(PhysicsOptions){.duration = 0.8, .impact_law = law, .columns = "Disc 0.vx, Disc 1.vx, Disc 2.vx"}, "%s",
        blocks);
}

static const TinkerAlternative *alternative(const PhysicsRun *run, const char *law, int number)
{
    const TinkerEvent *event = NULL;
    for (guint i = 0; i < run->summary->events->len; i++) {
        const TinkerEvent *each = g_ptr_array_index(run->summary->events, i);
        if (each->alternatives != NULL) event = each;
    }
    g_assert_nonnull(event);
    g_assert_nonnull(event->alternatives);
    for (guint i = 0; i < event->alternatives->len; i++) {
        const TinkerAlternative *each = &g_array_index(event->alternatives, TinkerAlternative, i);
        g_autofree char *name = g_strdup_printf("Disc %d", number);
        if (g_str_equal(each->law, law) && g_str_equal(tinker_scene_block_name(run->scene, each->block), name))
            return each;
    }
    g_assert_not_reached();
}

/* One ball strikes two that touch. */
static void test_three_balls(void)
{
    static const struct {
        const char *law;
        double v[3];
    } cases[] = {
        {"newton", {-1.0 / 3, 2.0 / 3, 2.0 / 3}}, {"poisson", {-1.0 / 3, 2.0 / 3, 2.0 / 3}}, {"sequential", {0, 0, 1}}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = run_row(cases[i].law);
        for (gsize k = 0; k < 3; k++)
            physics_assert_near(cases[i].law, physics_last(run, k), cases[i].v[k], 1e-12);
        contact_assert_event(run, i < 2 ? "impact" : "rest", "Disc 0, Disc 1", 0.3, 1e-12);
        for (gsize law = 0; law < G_N_ELEMENTS(cases); law++)
            for (int k = 0; k < 3; k++)
                physics_assert_near("an alternative", alternative(run, cases[law].law, k)->vx, cases[law].v[k], 1e-12);
        g_assert_cmpuint(run->summary->warnings->len, ==, 1);
        const TinkerWarning *warning = g_ptr_array_index(run->summary->warnings, 0);
        g_assert_cmpint(warning->kind, ==, TINKER_WARNING_LAWS);
        g_assert_true(g_str_has_prefix(warning->text, "the outcome depends on the impact law: at 0.3 s"));
        g_assert_true(g_str_has_suffix(warning->brief, "one blow after the other differ"));
        g_assert_true(g_str_has_suffix(warning->text,
                                       "(impact_law in the scene chooses; the events of the summary tell "
                                       "the velocities by each)"));
    }
}

typedef struct {
    double masses[3], e, friction;
    double last_e; /* of the last two, where it is larger than e */
} Row;

static double restitution_of(const Row *row, int pair)
{
    return pair == 1 ? fmax(row->e, row->last_e) : row->e;
}

/* The velocities of three balls of which the first strikes, at 2 m/s, two that touch: in sequence, the pair that
 * approaches faster first. */
static void strike_by_turns(const Row *row, double v[3])
{
    v[0] = 2;
    v[1] = v[2] = 0;
    for (int blow = 0; blow < 1000; blow++) {
        const int k = v[1] - v[0] < v[2] - v[1] ? 0 : 1;
        const double u = v[k + 1] - v[k], a = row->masses[k], b = row->masses[k + 1];
        if (!(u < -1e-14)) break;
        v[k] += (1 + restitution_of(row, k)) * u * b / (a + b);
        v[k + 1] -= (1 + restitution_of(row, k)) * u * a / (a + b);
    }
}

/* The same by Poisson's law: at the end of the first phase all go on together, and each impulse of it is given once
 * more, by its restitution; in these rows nothing approaches after that. */
static void strike_in_phases(const Row *row, double v[3])
{
    const double *m = row->masses, both = 2 * m[0] / (m[0] + m[1] + m[2]);
    const double first = restitution_of(row, 0) * m[0] * (2 - both), last = restitution_of(row, 1) * m[2] * both;
    v[0] = both - first / m[0];
    v[1] = both + (first - last) / m[1];
    v[2] = both + last / m[2];
}

/* By one law the three leave as `truth` says, and none turns. */
static void assert_leave(const char *law, const Row *row, void (*truth)(const Row *row, double v[3]),
                         const char *blocks)
{
    double v[3];
    truth(row, v);
    const PhysicsOptions options = {
        .duration = 0.31,
        .impact_law = law,
        .columns = "Disc 0.vx, Disc 1.vx, Disc 2.vx, Disc 0.angular velocity, Disc 1.angular velocity, "
                   "Disc 2.angular velocity"};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
    for (gsize k = 0; k < 3; k++) {
        physics_assert_near(law, physics_last(run, k), v[k], 1e-12);
        physics_assert_near("turns", physics_last(run, 3 + k), 0, 1e-12);
    }
}

/* What lay at rest rebounds by its own restitution as soon as a blow elsewhere drives it together, also where something
 * rubs or takes energy there: blows along one line turn nothing, however rough it is. */
static void test_driven_together(void)
{
    static const Row rows[] = {{{1, 1, 1}, 1, 0, 0},      {{1, 2, 1}, 0.6, 0, 0},   {{2, 1, 3}, 0.8, 0, 0},
                               {{1, 0.2, 5}, 0.9, 0, 0},  {{2, 1, 3}, 0.8, 0.5, 0}, {{1, 1, 1}, 0.3, 0, 0.9},
                               {{1, 1, 1}, 0.3, 0.5, 0.9}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(GString) blocks = g_string_new(NULL);
        for (int k = 0; k < 3; k++)
            g_string_append_printf(
                blocks,
                "%s{'type': 'disc', 'radius': 0.2, 'mass': %g, 'restitution': %g, 'static_friction': %g,"
                " 'dynamic_friction': %g, 'position': [%g, 0], 'velocity': [%g, 0]}",
                k > 0 ? ", " : "", rows[i].masses[k], k < 2 ? rows[i].e : fmax(rows[i].e, rows[i].last_e),
                rows[i].friction, rows[i].friction, k == 0 ? -1 : 0.4 * (k - 1), k == 0 ? 2.0 : 0.0);
        assert_leave("sequential", &rows[i], strike_by_turns, blocks->str);
        assert_leave("poisson", &rows[i], strike_in_phases, blocks->str);
    }
}

/* Blows one after the other leave nothing open: no warning, and nothing to choose from. */
static void test_one_by_one(void)
{
    g_autofree char *blocks = g_strdup_printf(BALL "," BALL "," BALL, 0.0, 1.0, 0.5, 0.0, 0.9, 0.0);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Disc 0.vx, Disc 1.vx, Disc 2.vx"}, "%s", blocks);
    contact_assert_count(run, "impact", 2);
    physics_assert_near("last", physics_last(run, 2), 1, 1e-12);
    g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    for (guint i = 0; i < run->summary->events->len; i++)
        g_assert_null(((const TinkerEvent *)g_ptr_array_index(run->summary->events, i))->alternatives);
}

static void test_impulses(void)
{
    g_autoptr(PhysicsRun) run =
        physics_try(&(PhysicsOptions){.impulses = TRUE, .impact_law = "poisson"}, CONTACT_FLOOR "}, {'type': 'mass'}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_METHOD, "Newton's law of impact alone", "\"poisson\"", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/physics/impact-law/three-balls", test_three_balls);
    g_test_add_func("/physics/impact-law/driven-together", test_driven_together);
    g_test_add_func("/physics/impact-law/one-by-one", test_one_by_one);
    g_test_add_func("/physics/impact-law/impulses", test_impulses);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
