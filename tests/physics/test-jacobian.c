/* The derivatives of the applied forces against differences of the forces themselves, role by role, at states where
 * nothing is aligned, at rest or relaxed. */
#include "physics-fixture.h"
#include "physics/model/model-data.h"
#include "physics/model/model.h"
#include "physics/system/system.h"

#include <math.h>

#define THREE_MASSES                                                                                                   \
    "{'type': 'support', 'position': [-1, 0.3]}, {'type': 'mass', 'mass': 0.7, 'position': [0, 0]},"                   \
    "{'type': 'mass', 'mass': 1.9, 'position': [1.2, 0.4]}, {'type': 'mass', 'mass': 0.4, 'position': [0.3, 1.5]}"
#define SPRINGS                                                                                                        \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 40, 'rest_length': 0.8},"                        \
    "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 25, 'rest_length': 2.1},"                           \
    "{'type': 'spring', 'ends': ['Mass 1', 'Mass 2'], 'stiffness': 90, 'rest_length': 0}"

static const double distant_q[] = {0.13, -0.21, 1.02, 0.55, 0.41, 1.33, -0.77, 2.2};
static const double distant_v[] = {1.7, -0.6, -0.9, 2.3, 0.35, 0.8, -1.4, 0.2};

typedef struct {
    PhysicsRun *run;
    TinkerModelSystem system;
    int32_t n;
    double q[8], v[8];
    double *stiffness, *damping; /* in the order of the pattern */
} Case;

/* A case of up to four masses, moved away from where they were placed. */
static void case_init(Case *this, const char *blocks)
{
    *this = (Case){.run = physics_prepare(&(PhysicsOptions){.duration = 1}, "%s", blocks)};
    tinker_model_system_init(&this->system, this->run->model, NULL);
    g_assert_null(this->system.system.pattern);
    tinker_model_system_offer_jacobian(&this->system);
    this->n = this->system.system.size;
    g_assert_cmpint(this->n, <=, G_N_ELEMENTS(distant_q));
    for (int32_t i = 0; i < this->n; i++) {
        this->q[i] = distant_q[i];
        this->v[i] = distant_v[i];
    }
    gsize entries = (gsize)this->system.system.pattern->entries;
    this->stiffness = g_new(double, entries);
    this->damping = g_new(double, entries);
}

static void case_evaluate(Case *this)
{
    TinkerSystem *system = &this->system.system;
    g_assert_cmpint(system->jacobian(system->context, 0.37, this->q, this->v, this->stiffness, this->damping), ==,
                    TINKER_OK);
}

static void case_clear(Case *this)
{
    g_free(this->stiffness);
    g_free(this->damping);
    tinker_model_system_clear(&this->system);
    physics_run_free(this->run);
}

/* The entry of a matrix; 0 outside the pattern. */
static double entry(const Case *this, const double *values, int32_t row, int32_t column)
{
    const TinkerPattern *pattern = this->system.system.pattern;
    for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
        if (pattern->columns[k] == column) return values[k];
    return 0;
}

static void force_at(const Case *this, const double *q, const double *v, double *force)
{
    const TinkerSystem *system = &this->system.system;
    g_assert_cmpint(system->applied(system->context, 0.37, q, v, force, NULL), ==, TINKER_OK);
    for (int32_t i = 0; i < this->n; i++)
        force[i] *= system->mass[i];
}

/* -df/dx_k by differences over h and 2 h: errors of h^4. */
static void difference(Case *this, gboolean of_velocity, int32_t k, double *column)
{
    const double h = 1e-4;
    double *x = of_velocity ? this->v : this->q, kept = x[k], force[4][8];
    const double shift[4] = {-2 * h, -h, h, 2 * h};
    for (int i = 0; i < 4; i++) {
        x[k] = kept + shift[i];
        force_at(this, this->q, this->v, force[i]);
    }
    x[k] = kept;
    for (int32_t i = 0; i < this->n; i++)
        column[i] = -(force[0][i] - 8 * force[1][i] + 8 * force[2][i] - force[3][i]) / (12 * h);
}

static void assert_pattern(const TinkerPattern *pattern)
{
    g_assert_cmpint(pattern->row_starts[0], ==, 0);
    g_assert_cmpint(pattern->row_starts[pattern->size], ==, pattern->entries);
    for (int32_t row = 0; row < pattern->size; row++) {
        gboolean diagonal = FALSE;
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++) {
            int32_t column = pattern->columns[k];
            gboolean mirrored = FALSE;
            if (k > pattern->row_starts[row]) g_assert_cmpint(column, >, pattern->columns[k - 1]);
            diagonal |= column == row;
            for (int32_t m = pattern->row_starts[column]; m < pattern->row_starts[column + 1]; m++)
                mirrored |= pattern->columns[m] == row;
            g_assert_true(mirrored);
        }
        g_assert_true(diagonal);
    }
}

/* Both matrices, all entries, those outside the pattern included. */
static void assert_exact(Case *this, double bound)
{
    case_evaluate(this);
    assert_pattern(this->system.system.pattern);
    for (int32_t column = 0; column < this->n; column++) {
        double by_place[8], by_velocity[8];
        difference(this, FALSE, column, by_place);
        difference(this, TRUE, column, by_velocity);
        for (int32_t row = 0; row < this->n; row++) {
            g_autofree char *where = g_strdup_printf("(%d, %d)", row, column);
            physics_assert_near(where, entry(this, this->stiffness, row, column), by_place[row], bound);
            physics_assert_near(where, entry(this, this->damping, row, column), by_velocity[row], bound);
        }
    }
}

static double asymmetry(const Case *this, const double *values)
{
    double largest = 0;
    for (int32_t row = 0; row < this->n; row++)
        for (int32_t column = 0; column < row; column++)
            largest = fmax(largest, fabs(entry(this, values, row, column) - entry(this, values, column, row)));
    return largest;
}

static void test_springs(void)
{
    Case this;
    case_init(&this, THREE_MASSES "," SPRINGS);
    g_assert_cmpint(this.system.system.pattern->entries, ==, 4 * (3 + 2 * 2));
    assert_exact(&this, 1e-8);
    g_assert_cmpfloat(asymmetry(&this, this.stiffness), <=, 1e-13);
    case_clear(&this);
}

/* Dampers whose ends move across them: their pull turns with them, which is not symmetric. */
static void test_dampers(void)
{
    Case this;
    case_init(&this, THREE_MASSES "," SPRINGS ", {'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': 3},"
                                  "{'type': 'damper', 'ends': ['Mass 2', 'Support 0'], 'damping': 1.7}");
    assert_exact(&this, 1e-8);
    g_assert_cmpfloat(asymmetry(&this, this.stiffness), >, 0.1);
    g_assert_cmpfloat(asymmetry(&this, this.damping), <=, 1e-14);
    case_clear(&this);
}

static void test_fields(void)
{
    Case this;
    case_init(&this,
              THREE_MASSES "," SPRINGS ", {'type': 'gravity'}, {'type': 'wind', 'velocity': [1.5, -0.7], 'drag': 0.9}");
    assert_exact(&this, 1e-8);
    case_clear(&this);
    case_init(&this, THREE_MASSES ", {'type': 'wind', 'velocity': [1.5, -0.7], 'drag': 0.9, 'drag_quadratic': 0.31}");
    g_assert_cmpint((int)this.run->model->asked_fields->len, ==, 1);
    assert_exact(&this, 1e-8);
    case_clear(&this);
}

/* A law without derivatives of its own. */
static void test_asked_lines(void)
{
    Case this;
    case_init(&this, THREE_MASSES ", {'type': 'cubic', 'ends': ['Support 0', 'Mass 2'], 'stiffness': 7, 'length': 2},"
                                  "{'type': 'cubic', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 5, 'length': 0.4}");
    g_assert_cmpint(tinker_model_sizes(this.run->model).nonlinear_lines, ==, 2);
    assert_exact(&this, 1e-7);
    g_assert_cmpfloat(asymmetry(&this, this.stiffness), <=, 1e-12);
    case_clear(&this);
}

/* Three ends, one of them on a support, and ends of any number. */
static void test_elements(void)
{
    Case this;
    case_init(&this,
              THREE_MASSES ", {'type': 'torsion', 'ends': ['Support 0', 'Mass 1', 'Mass 2'], 'stiffness': 5},"
                           "{'type': 'bundle', 'ends': ['Mass 0', 'Support 0', 'Mass 2', 'Mass 1'], 'stiffness': 4.5},"
                           "{'type': 'bundle', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 2}");
    assert_exact(&this, 1e-7);
    case_clear(&this);
}

/* Of a field that couples bodies the own part: between two masses the force on each by its own place is the whole. */
static void test_coupled_field(void)
{
    Case this;
    case_init(&this, "{'type': 'mass', 'mass': 2, 'position': [0, 0]}, {'type': 'mass', 'position': [1, 1]},"
                     "{'type': 'attraction', 'strength': 3}");
    case_evaluate(&this);
    for (int32_t column = 0; column < this.n; column++) {
        double truth[8];
        difference(&this, FALSE, column, truth);
        for (int32_t row = column / 2 * 2; row < column / 2 * 2 + 2; row++)
            physics_assert_near("own part", entry(&this, this.stiffness, row, column), truth[row], 1e-7);
    }
    g_assert_cmpint(this.system.system.pattern->entries, ==, 8);
    case_clear(&this);
}

/* A spring without rest length is linear, also where its ends meet. */
static void test_ends_that_meet(void)
{
    Case this;
    case_init(&this, "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                     "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 6, 'rest_length': 0}");
    TinkerPoint *support = &this.run->model->point[1];
    this.q[0] = support->x;
    this.q[1] = support->y;
    case_evaluate(&this);
    for (int32_t row = 0; row < 2; row++)
        for (int32_t column = 0; column < 2; column++)
            g_assert_cmpfloat(entry(&this, this.stiffness, row, column), ==, row == column ? 6 : 0);
    case_clear(&this);
}

/* A law with T(0) = 0 pulls smoothly through the place where its ends meet, so differences of the forces hold there: of
 * two masses and a support at one place, with and without derivatives, beside what is not at one place. */
static void test_laws_that_meet(void)
{
    Case this;
    case_init(&this,
              THREE_MASSES ", {'type': 'magnet', 'ends': ['Support 0', 'Mass 0'], 'strength': 3, 'softening': 1.1},"
                           "{'type': 'plain-magnet', 'ends': ['Mass 0', 'Mass 1'], 'strength': 2, 'softening': 1},"
                           "{'type': 'magnet', 'ends': ['Mass 1', 'Mass 2'], 'strength': 2, 'softening': 0.9}");
    const TinkerPoint *support = &this.run->model->point[3];
    this.q[0] = this.q[2] = support->x;
    this.q[1] = this.q[3] = support->y;
    assert_exact(&this, 1e-7);
    physics_assert_near("of the support's", 3 / pow(1.1, 5) + 2, entry(&this, this.stiffness, 0, 0), 1e-7);
    physics_assert_near("of the other mass'", -2, entry(&this, this.stiffness, 1, 3), 1e-7);
    g_assert_cmpfloat(asymmetry(&this, this.stiffness), <=, 1e-12);
    case_clear(&this);
}

/* T = k L^3 is smooth there and has no stiffness. */
static void test_cubes_that_meet(void)
{
    Case this;
    case_init(&this, "{'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                     "{'type': 'cubic', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 6, 'length': 0}");
    this.q[0] = this.run->model->point[1].x;
    this.q[1] = this.run->model->point[1].y;
    this.v[0] = this.v[1] = 0;
    assert_exact(&this, 1e-7);
    case_clear(&this);
}

/* One with a pull there has no derivative there; nothing is put in its place, and nothing fails. */
static void test_pulls_that_meet(void)
{
    static const char *const laws[] = {"'spring', 'stiffness': 6, 'rest_length': 1",
                                       "'magnet', 'softening': 1, 'strength': 6, 'pull': 1, 'resistance': 2",
                                       "'plain-magnet', 'softening': 1, 'strength': 6, 'pull': 1, 'resistance': 2"};
    for (gsize i = 0; i < G_N_ELEMENTS(laws); i++) {
        Case this;
        g_autofree char *blocks = g_strdup_printf("{'type': 'support'}, {'type': 'mass', 'position': [1, 0]},"
                                                  "{'type': %s, 'ends': ['Support 0', 'Mass 0']}",
                                                  laws[i]);
        case_init(&this, blocks);
        this.q[0] = this.run->model->point[1].x;
        this.q[1] = this.run->model->point[1].y;
        case_evaluate(&this);
        for (int32_t k = 0; k < 4; k++) {
            g_assert_cmpfloat(entry(&this, this.stiffness, k / 2, k % 2), ==, 0);
            g_assert_cmpfloat(entry(&this, this.damping, k / 2, k % 2), ==, 0);
        }
        case_clear(&this);
    }
}

/* A rod between two masses and one to a support, with the mass that moves along each: 1 / (1/m + 1/m') and m. */
static void test_row_masses(void)
{
    Case this;
    case_init(&this, THREE_MASSES ", {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
                                  "{'type': 'rod', 'ends': ['Mass 2', 'Support 0']}");
    TinkerSystem *system = &this.system.system;
    const TinkerPoint *support = &this.run->model->point[3];
    double joined = 1 / (1 / 0.7 + 1 / 1.9), dx = this.q[2] - this.q[0], dy = this.q[3] - this.q[1];
    double ex = this.q[4] - support->x, ey = this.q[5] - support->y;
    double rod[2] = {dx / hypot(dx, dy), dy / hypot(dx, dy)}, hanger[2] = {ex / hypot(ex, ey), ey / hypot(ex, ey)};
    g_assert_cmpint(system->row_masses(system->context, 0.37, this.q, this.stiffness), ==, TINKER_OK);
    for (int32_t row = 0; row < 6; row++) {
        for (int32_t column = 0; column < 6; column++) {
            double truth = 0;
            if (row < 4 && column < 4)
                truth = (row / 2 == column / 2 ? 1 : -1) * joined * rod[row % 2] * rod[column % 2];
            if (row >= 4 && column >= 4) truth = 0.4 * hanger[row % 2] * hanger[column % 2];
            g_assert_cmpfloat(fabs(entry(&this, this.stiffness, row, column) - truth), <=, 1e-15);
        }
    }
    assert_pattern(system->pattern);
    case_clear(&this);
}

static void add_tests(void)
{
    g_test_add_func("/physics/jacobian/springs", test_springs);
    g_test_add_func("/physics/jacobian/dampers", test_dampers);
    g_test_add_func("/physics/jacobian/fields", test_fields);
    g_test_add_func("/physics/jacobian/asked-lines", test_asked_lines);
    g_test_add_func("/physics/jacobian/elements", test_elements);
    g_test_add_func("/physics/jacobian/coupled-field", test_coupled_field);
    g_test_add_func("/physics/jacobian/ends-that-meet", test_ends_that_meet);
    g_test_add_func("/physics/jacobian/laws-that-meet", test_laws_that_meet);
    g_test_add_func("/physics/jacobian/cubes-that-meet", test_cubes_that_meet);
    g_test_add_func("/physics/jacobian/pulls-that-meet", test_pulls_that_meet);
    g_test_add_func("/physics/jacobian/row-masses", test_row_masses);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
