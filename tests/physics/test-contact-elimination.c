/* Closed contacts of bodies that rods join, solved without their matrix: against the equations themselves in extended
 * precision, against the laws by their definition, and how the work grows. */
#include <math.h>
#include <string.h>

#include "contact-checks.h"
#include "physics/compile/compile.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contact-reach.h"
#include "physics/contact/contacts-private.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

typedef enum { CHAIN, TREE, LADDER, RING, SHAPES } Shape;

/* Masses over a floor, joined by rods; `bent`: out of the straight line. */
static TinkerModel *joined(GRand *random, Shape shape, int masses, double bent)
{
    g_autoptr(GString) text = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 1e5}");
    for (int i = 0; i < masses; i++) {
        const double angle = 2 * G_PI * i / masses, round = masses / G_PI;
        const double x = shape == RING ? round * cos(angle) : shape == LADDER ? i / 2 : i;
        const double y = shape == RING ? round * (1 + sin(angle)) : shape == LADDER ? i % 2 : 0;
        g_string_append_printf(text, ", " CONTACT_POINT ", 'mass': %.17g, 'position': [%.17g, %.17g]}",
                               pow(10, g_rand_double_range(random, -0.5, 0.5)), x,
                               y + bent * g_rand_double_range(random, 0, 1));
    }
    for (int i = 1; i < masses + (shape == RING); i++) {
        const int other = shape == TREE ? (i - 1) / 2 : shape == LADDER && i > 1 ? i - 2 : i - 1;
        g_string_append_printf(text, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i % masses, other);
        if (shape == LADDER && i % 2 == 0)
            g_string_append_printf(text, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i, i - 1);
    }
    g_autoptr(GError) error = NULL;
    TinkerModel *model = tinker_model_new(physics_scene(NULL, text->str), &error);
    g_assert_no_error(error);
    g_assert_cmpint(tinker_model_set_time(model, 0), ==, TINKER_OK);
    tinker_model_set_state(model, model->q_start, model->v_start);
    g_assert_cmpint(tinker_constraints_evaluate(model), ==, TINKER_OK);
    return model;
}

static void free_joined(TinkerModel *model)
{
    TinkerScene *scene = model->scene;
    tinker_model_free(model);
    tinker_scene_free(scene);
}

/* Elimination with row pivoting in extended precision. Answers the smallest pivot. */
static long double dense_solve(int n, long double *a, long double *b)
{
    long double least = INFINITY;
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++)
            if (fabsl(a[i * n + k]) > fabsl(a[pivot * n + k])) pivot = i;
        for (int j = 0; j <= n; j++) {
            long double *left = j < n ? &a[k * n + j] : &b[k], *right = j < n ? &a[pivot * n + j] : &b[pivot];
            const long double kept = *left;
            *left = *right;
            *right = kept;
        }
        least = fminl(least, fabsl(a[k * n + k]));
        for (int i = k + 1; i < n; i++) {
            const long double factor = a[i * n + k] / a[k * n + k];
            for (int j = k; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
            b[i] -= factor * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++)
            b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
    return least;
}

/* Forces of the equations: C M^-1 (D f + J^T mu) = b, J M^-1 (D f + J^T mu) = 0, all of it written down. */
static long double solve_written(const TinkerModel *model, const TinkerContactEquation *of, int count, const double *b,
                                 long double *solved)
{
    const TinkerConstraints *all = &model->constraints;
    const int rows = all->rows, n = count + rows, width = model->coordinates;
    g_autofree long double *row = g_new0(long double, n *width), *force = g_new0(long double, n *width);
    g_autofree long double *matrix = g_new0(long double, n *n);
    for (int e = 0; e < count; e++)
        for (int k = 0; k < 2; k++) {
            row[e * width + 2 * of[e].body + k] = of[e].row[k];
            force[e * width + 2 * of[e].body + k] = of[e].force[k];
        }
    for (int e = 0; e < all->entries; e++)
        for (int k = 0; k < 2 && all->points[e] < model->bodies; k++)
            row[(count + all->row_of[e]) * width + 2 * all->points[e] + k] =
                force[(count + all->row_of[e]) * width + 2 * all->points[e] + k] = all->jacobian[2 * e + k];
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            for (int k = 0; k < width; k++)
                matrix[i * n + j] += row[i * width + k] * force[j * width + k] * model->inverse_mass[k / 2];
        solved[i] = i < count ? b[i] : 0;
    }
    return dense_solve(n, matrix, solved);
}

/* Some bodies slide with friction, one sticks: fewer than the rods leave ways to go. */
static int choose_equations(GRand *random, const TinkerModel *model, TinkerContactEquation *of)
{
    int count = 0;
    const int ways = model->coordinates - model->constraints.rows;
    const int sticks = g_rand_int_range(random, 0, model->bodies);
    for (int i = 0; i < model->bodies; i++) {
        const double slope = g_rand_double_range(random, -0.2, 0.2);
        if (count + 2 >= ways || (i != sticks && g_rand_int_range(random, 0, 3) > 0)) continue;
        of[count++] = (TinkerContactEquation){i, {0, 1}, {i == sticks ? 0 : slope, 1}, 0};
        if (i == sticks) of[count++] = (TinkerContactEquation){i, {1, 0}, {1, 0}, 0};
    }
    return count;
}

static void test_solve(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    for (int trial = 0; trial < 40; trial++) {
        TinkerModel *model = joined(random, (Shape)(trial % SHAPES), 6 + trial % 13, 0.7);
        TinkerContactEquation of[64];
        double b[64], x[64] = {0};
        long double solved[128];
        const int count = choose_equations(random, model, of);
        TinkerContactElimination *elimination =
            tinker_contact_elimination_new(model, model->contacts->group, 0, model->contacts->column);
        g_assert_true(tinker_contact_elimination_make_room(elimination, 64));
        for (int e = 0; e < count; e++)
            b[e] = g_rand_double_range(random, -1, 1);
        tinker_contact_elimination_take(elimination, of, count);
        const gboolean full = tinker_contact_elimination_solve(elimination, b, x);
        const gboolean determined = solve_written(model, of, count, b, solved) > 1e-12L;
        double largest = 0;
        for (int e = 0; e < count; e++)
            largest = fmax(largest, fabs((double)solved[e]));
        for (int e = 0; determined && e < count; e++)
            physics_assert_near("a force", x[e], (double)solved[e], 1e-11 * largest * fmax(1, largest));
        g_assert_true(full == determined); /* a triangle of rods may stand on more than it takes to hold it */
        tinker_contact_elimination_free(elimination);
        free_joined(model);
    }
}

/* All stick, on a straight chain: no force along it is determined. They hold what is asked for, and are those of least
 * norm: what they are made of is motion that the rods let be. */
static void test_least_norm(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(4);
    enum { MASSES = 40 };
    TinkerModel *model = joined(random, CHAIN, MASSES, 0);
    TinkerContactElimination *elimination =
        tinker_contact_elimination_new(model, model->contacts->group, 0, model->contacts->column);
    TinkerContactEquation of[2 * MASSES];
    double b[2 * MASSES], x[2 * MASSES] = {0}, along[2 * MASSES];
    for (int i = 0; i < MASSES; i++) {
        of[2 * i] = (TinkerContactEquation){i, {0, 1}, {0, 1}, 0};
        of[2 * i + 1] = (TinkerContactEquation){i, {1, 0}, {1, 0}, 0};
        b[2 * i] = sin(i);
        b[2 * i + 1] = 0.3; /* the chain moves as one */
    }
    g_assert_true(tinker_contact_elimination_make_room(elimination, 2 * MASSES));
    tinker_contact_elimination_take(elimination, of, 2 * MASSES);
    g_assert_false(tinker_contact_elimination_solve(elimination, b, x));
    tinker_contact_elimination_push(elimination, x, along);
    for (int e = 0; e < 2 * MASSES; e++)
        physics_assert_near("what it does", along[e], b[e], 1e-13);
    /* f = M u with the rods' rows of u 0: the accelerations f / m along the chain are all the same */
    for (int i = 0; i < MASSES; i++)
        physics_assert_near("a share", x[2 * i + 1] * model->inverse_mass[i], 0.3, 1e-10);
    tinker_contact_elimination_free(elimination);
    free_joined(model);
}

/* By the definition in contact-laws.h, with the matrix written down. */
static void check_laws(const TinkerContact *touching, TinkerContacts *contacts, int count, const double *velocity,
                       double friction, const double *p)
{
    const int width = 2 * count;
    g_autofree double *w = g_new(double, width *width);
    tinker_contacts_delassus(contacts, touching, count, w);
    for (int k = 0; k < count; k++) {
        double after[2] = {velocity[2 * k], velocity[2 * k + 1]};
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < width; j++)
                after[i] += w[(2 * k + i) * width + j] * p[j];
        const double pn = p[2 * k], pt = p[2 * k + 1], near = 1e-10;
        g_assert_cmpfloat(pn, >=, 0);
        g_assert_cmpfloat(after[0], >=, -near);
        g_assert_cmpfloat(pn > 0 ? fabs(after[0]) : 0, <=, near);
        g_assert_cmpfloat(fabs(pt), <=, friction * pn * (1 + 1e-12));
        if (fabs(after[1]) > near && pn > 0)
            physics_assert_near("friction", pt, after[1] > 0 ? -friction * pn : friction * pn, 1e-12 * pn);
    }
}

static void test_laws(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(5);
    for (int trial = 0; trial < 24; trial++) {
        const int masses = 14 + 3 * trial;
        TinkerModel *model = joined(random, (Shape)(trial % 2), masses, 0.3);
        g_autofree TinkerContact *touching = g_new0(TinkerContact, masses);
        g_autofree double *velocity = g_new(double, 2 * masses), *p = g_new(double, 2 * masses);
        g_autofree double *friction = g_new(double, masses), *none = g_new0(double, masses);
        TinkerContactReach reach = {.room = 0};
        const double mu = 0.1 + 0.1 * (trial % 4);
        for (int i = 0; i < masses; i++) {
            touching[i].body = i;
            friction[i] = mu;
            velocity[2 * i] = g_rand_double_range(random, -1, 0.3);
            velocity[2 * i + 1] = g_rand_double_range(random, -0.5, 0.5);
        }
        g_assert_true(tinker_contact_reach_take(&reach, model->contacts, touching, masses));
        g_assert_nonnull(reach.motion.context);
        TinkerImpact impact = {.count = masses,
                               .velocity = velocity,
                               .restitution = none,
                               .friction = friction,
                               .least = none,
                               .motion = &reach.motion};
        /* what a velocity asks for has to be something that the rods let be */
        double u[2 * 128] = {0};
        memcpy(u, velocity, 2 * (gsize)masses * sizeof(double));
        for (int i = 0; i < masses; i++) {
            u[2 * i] = velocity[2 * i + 1];
            u[2 * i + 1] = velocity[2 * i];
            model->point[i].vx = u[2 * i];
            model->point[i].vy = u[2 * i + 1];
        }
        gboolean moved;
        tinker_constraints_correct_velocities(model, u, TRUE, &moved);
        for (int i = 0; i < masses; i++) {
            velocity[2 * i] = u[2 * i + 1];
            velocity[2 * i + 1] = u[2 * i];
        }
        g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
        check_laws(touching, model->contacts, masses, velocity, mu, p);
        tinker_contact_reach_clear(&reach);
        free_joined(model);
    }
}

/* Closes all bodies of a chain; answers the entries of the factor that solves them, and adds the solves that forces
 * took. */
static gsize entries_of_chain(int masses, gint64 *solves)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(6);
    TinkerModel *model = joined(random, CHAIN, masses, 0.3);
    TinkerContacts *contacts = model->contacts;
    for (int i = 0; i < masses; i++) {
        const TinkerContact contact = {.body = i,
                                       .mode = i == masses / 2 ? TINKER_CONTACT_STICK : TINKER_CONTACT_SLIP_FORWARD};
        g_array_append_val(contacts->closed, contact);
    }
    g_assert_cmpint(tinker_contacts_list_rows(contacts), ==, TINKER_OK);
    g_autofree double *a = g_new(double, 2 * masses);
    for (int i = 0; i < 2 * masses; i++)
        a[i] = i % 2 == 0 ? sin(i) : -9.81;
    tinker_contacts_accelerate(contacts, a);
    for (int i = 0; i < masses; i++)
        physics_assert_near("an acceleration out of the floor", a[2 * i + 1], 0, 1e-10);
    const TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, 0);
    g_assert_cmpuint(contacts->blocks->len, ==, 1);
    g_assert_null(block->solve[FALSE]);
    const gsize entries = tinker_contact_elimination_fill(block->elimination);
    *solves = tinker_contact_elimination_solves(block->elimination);
    free_joined(model);
    return entries;
}

/* Twice as many bodies: twice as many entries, and as many solves. */
static void test_scale(void)
{
    gint64 fewest = 0;
    for (int masses = 25; masses <= 3200; masses *= 2) {
        gint64 solves = 0;
        g_assert_cmpuint(entries_of_chain(masses, &solves), <=, 2 * masses);
        if (fewest == 0) fewest = solves;
        g_assert_cmpint(solves, <=, fewest + 4);
    }
}

/* Chains that may meet, as their first masses collide, and do not touch: each has the entries of its own rods. All
 * keep their masses on the floor. */
static void test_apart(void)
{
    enum { CHAINS = 6, MASSES = 24, BODIES = CHAINS * MASSES };
    g_autoptr(GString) text = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 1e5}");
    for (int i = 0; i < BODIES; i++) {
        g_string_append_printf(text, ", {'type': 'mass', 'width': 0.1, 'height': 0.1, 'position': [%.17g, %.17g]%s}",
                               i + 0.2 * sin(i), 0.05 + 0.2 * (1 + sin(3 * i)),
                               i % MASSES == 0 ? ", 'collides': true" : "");
        if (i % MASSES > 0) g_string_append_printf(text, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i - 1, i);
    }
    g_autoptr(GError) error = NULL;
    TinkerModel *model = tinker_model_new(physics_scene(NULL, text->str), &error);
    g_assert_no_error(error);
    g_assert_cmpint(tinker_model_set_time(model, 0), ==, TINKER_OK);
    tinker_model_set_state(model, model->q_start, model->v_start);
    g_assert_cmpint(tinker_constraints_evaluate(model), ==, TINKER_OK);
    TinkerContacts *contacts = model->contacts;
    for (int i = 0; i < BODIES; i++) {
        const TinkerContact contact = {.body = i, .mode = TINKER_CONTACT_SLIP_FORWARD};
        g_array_append_val(contacts->closed, contact);
    }
    g_assert_cmpint(tinker_contacts_list_rows(contacts), ==, TINKER_OK);
    g_assert_cmpint(contacts->group[0], ==, contacts->group[BODIES - 1]);
    g_assert_cmpuint(contacts->blocks->len, ==, CHAINS);
    double a[2 * BODIES];
    for (int i = 0; i < 2 * BODIES; i++)
        a[i] = i % 2 == 0 ? sin(i) : -9.81;
    tinker_contacts_accelerate(contacts, a);
    for (int i = 0; i < BODIES; i++)
        physics_assert_near("an acceleration out of the floor", a[2 * i + 1], 0, 1e-10);
    for (int i = 0; i < CHAINS; i++) {
        const TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        g_assert_nonnull(block->elimination);
        g_assert_cmpuint(tinker_contact_elimination_fill(block->elimination), <=, 2 * MASSES);
    }
    free_joined(model);
}

/* A truss of 16 panels stands on as many feet and slides: nothing determines how these share its weight, and friction
 * stops it after v^2 / (2 mu g), whatever they do. With the floor at 0.2 m rounding made contacts open and close
 * without end where they were solved by their matrix. */
static void test_sliding_truss(void)
{
    g_autoptr(GString) blocks = g_string_new(
        CONTACT_WEIGHT "{'type': 'support', 'width': 42, 'static_friction': 0.4, 'dynamic_friction': 0.3}");
    for (int i = 0; i < 32; i++)
        g_string_append_printf(blocks, ", " CONTACT_POINT ", 'mass': %g, 'position': [%d, %g], 'velocity': [0.5, 0]}",
                               1 + 0.1 * (i % 5), i / 2, i % 2 + 0.2);
    for (int i = 0; i < 32; i += 2) {
        g_string_append_printf(blocks, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i, i + 1);
        for (int k = 0; i > 0 && k < 3; k++)
            g_string_append_printf(blocks, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i - (k == 1 ? 1 : 2),
                                   i + (k == 0 ? 0 : 1));
    }
    const double slow = 0.3 * CONTACT_GRAVITY;
    PhysicsOptions options = {.duration = 0.5};
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    for (int i = 0; i < 32; i++) {
        double state[4];
        g_autofree char *name = g_strdup_printf("Mass %d", i);
        physics_state(run, name, state);
        physics_assert_near("x", state[0], i / 2 + 0.25 / (2 * slow), 1e-10);
        physics_assert_near("y", state[1], i % 2 + 0.2, 1e-10);
        physics_assert_near("vx", state[2], 0, 1e-10);
    }
}

static void add_tests(void)
{
    g_test_add_func("/contact-elimination/solve", test_solve);
    g_test_add_func("/contact-elimination/least-norm", test_least_norm);
    g_test_add_func("/contact-elimination/laws", test_laws);
    g_test_add_func("/contact-elimination/scale", test_scale);
    g_test_add_func("/contact-elimination/apart", test_apart);
    g_test_add_func("/contact-elimination/sliding-truss", test_sliding_truss);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
