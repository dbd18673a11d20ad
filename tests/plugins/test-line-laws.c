/* Spring and damper against their laws. */
#include <math.h>
#include <string.h>

#include "plugin-fixture.h"

#define COUNT 37 /* no multiple of a vector's width */

typedef struct {
    double length[COUNT], rate[COUNT], tension[COUNT];
} Lines;

static BlockBatch *random_batch(const char *name, Lines *lines)
{
    BlockBatch *batch = block_batch_new(block_open(name), COUNT);
    for (int i = 0; i < COUNT; i++) {
        lines->length[i] = fabs(random_value());
        lines->rate[i] = random_value();
        for (int32_t column = 0; column < block_columns(batch->block); column++) {
            batch->columns[column][i] = fabs(random_value());
        }
    }
    return batch;
}

static const TinkerLineLaw *law_of(const char *name)
{
    const TinkerLineLaw *law = block_physics(block_open(name))->line_law;
    g_assert_nonnull(law);
    return law;
}

static double tension_of(BlockBatch *batch, double length, double rate)
{
    TinkerBatch view = block_batch_view(batch, 0, 1);
    double tension = NAN;
    g_assert_cmpint(law_of(batch->block->id)->tension(&view, &length, &rate, &tension), ==, TINKER_OK);
    return tension;
}

static void test_spring_law(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("spring"), 1);
    block_batch_set(batch, 0, "rest_length", 0, 2);
    g_assert_cmpfloat(tension_of(batch, 3, 7), ==, 25);
    g_assert_cmpfloat(tension_of(batch, 1.5, -7), ==, -12.5);
    g_assert_cmpfloat(tension_of(batch, 2, 1), ==, 0);
    g_assert_cmpfloat(tension_of(batch, 0, 0), ==, -50);
    block_batch_set(batch, 0, "rest_length", 0, 0);
    g_assert_cmpfloat(tension_of(batch, 0, 0), ==, 0);
    g_assert_cmpfloat(tension_of(batch, 1e-200, 0), ==, 25e-200);
}

static void test_damper_law(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("damper"), 1);
    g_assert_cmpfloat(tension_of(batch, 3, 7), ==, 7);
    block_batch_set(batch, 0, "damping", 0, 2.5);
    g_assert_cmpfloat(tension_of(batch, 3, -2), ==, -5);
    g_assert_cmpfloat(tension_of(batch, 0, 0), ==, 0);
    g_assert_null(law_of("damper")->energy);
}

/* Both laws are polynomials of degree one, so central differences are exact but for rounding. */
static void test_derivatives(gconstpointer data)
{
    Lines lines;
    g_autoptr(BlockBatch) batch = random_batch(data, &lines);
    const TinkerLineLaw *law = law_of(data);
    double by_length[COUNT], by_rate[COUNT], up[COUNT], down[COUNT], moved_up[COUNT], moved_down[COUNT];
    TinkerBatch view = block_batch_view(batch, 0, COUNT);
    g_assert_cmpint(law->derivatives(&view, lines.length, lines.rate, by_length, by_rate), ==, TINKER_OK);
    for (int variable = 0; variable < 2; variable++) {
        const double *at = variable == 0 ? lines.length : lines.rate, *wanted = variable == 0 ? by_length : by_rate;
        for (int i = 0; i < COUNT; i++) {
            moved_up[i] = at[i] + 1000;
            moved_down[i] = at[i] - 1000;
        }
        g_assert_cmpint(
            law->tension(&view, variable == 0 ? moved_up : lines.length, variable == 1 ? moved_up : lines.rate, up), ==,
            TINKER_OK);
        g_assert_cmpint(law->tension(&view, variable == 0 ? moved_down : lines.length,
                                     variable == 1 ? moved_down : lines.rate, down),
                        ==, TINKER_OK);
        for (int i = 0; i < COUNT; i++) {
            g_assert_cmpfloat_with_epsilon((up[i] - down[i]) / 2000, wanted[i],
                                           1e-14 * (fabs(up[i]) + fabs(down[i]) + fabs(wanted[i])));
        }
    }
}

/* The tension is the derivative of the energy; of a parabola central differences are exact but for rounding. */
static void test_spring_energy(void)
{
    Lines lines;
    g_autoptr(BlockBatch) batch = random_batch("spring", &lines);
    double up[COUNT], down[COUNT], at[COUNT], longer[COUNT], shorter[COUNT];
    const double zero_rate[COUNT] = {0};
    for (int i = 0; i < COUNT; i++) {
        longer[i] = lines.length[i] + 1;
        shorter[i] = lines.length[i] - 1;
    }
    TinkerBatch view = block_batch_view(batch, 0, COUNT);
    const TinkerLineLaw *law = law_of("spring");
    g_assert_cmpint(law->energy(&view, longer, up), ==, TINKER_OK);
    g_assert_cmpint(law->energy(&view, shorter, down), ==, TINKER_OK);
    g_assert_cmpint(law->energy(&view, lines.length, at), ==, TINKER_OK);
    g_assert_cmpint(law->tension(&view, lines.length, zero_rate, lines.tension), ==, TINKER_OK);
    for (int i = 0; i < COUNT; i++) {
        g_assert_cmpfloat_with_epsilon((up[i] - down[i]) / 2, lines.tension[i], 1e-14 * (up[i] + down[i]));
        g_assert_cmpfloat(at[i], >=, 0);
    }
}

/* T = tension + stiffness (L - length) + damping rate, as the linear form has it, is the law. */
static void test_linear(gconstpointer data)
{
    Lines lines;
    g_autoptr(BlockBatch) batch = random_batch(data, &lines);
    const TinkerLineLaw *law = law_of(data);
    double stiffness[COUNT], damping[COUNT], length[COUNT], tension[COUNT];
    TinkerBatch view = block_batch_view(batch, 0, COUNT);
    g_assert_cmpint(law->linear(&view, stiffness, damping, length, tension), ==, TINKER_OK);
    g_assert_cmpint(law->tension(&view, lines.length, lines.rate, lines.tension), ==, TINKER_OK);
    for (int i = 0; i < COUNT; i++) {
        g_assert_cmpfloat(tension[i] + stiffness[i] * (lines.length[i] - length[i]) + damping[i] * lines.rate[i], ==,
                          lines.tension[i]);
    }
}

static void test_slices(gconstpointer data)
{
    Lines lines;
    g_autoptr(BlockBatch) batch = random_batch(data, &lines);
    const TinkerLineLaw *law = law_of(data);
    TinkerBatch view = block_batch_view(batch, 0, COUNT);
    double single[COUNT];
    g_assert_cmpint(law->tension(&view, lines.length, lines.rate, lines.tension), ==, TINKER_OK);
    for (int i = 0; i < COUNT; i++) {
        TinkerBatch one = block_batch_view(batch, i, 1);
        g_assert_cmpint(law->tension(&one, &lines.length[i], &lines.rate[i], &single[i]), ==, TINKER_OK);
    }
    g_assert_cmpmem(single, sizeof single, lines.tension, sizeof lines.tension);
}

static void test_dimensions(gconstpointer data)
{
    Lines lines;
    g_autoptr(BlockBatch) batch = random_batch(data, &lines);
    const TinkerLineLaw *law = law_of(data);
    double rescaled[COUNT];
    TinkerBatch view = block_batch_view(batch, 0, COUNT);
    g_assert_cmpint(law->tension(&view, lines.length, lines.rate, lines.tension), ==, TINKER_OK);
    block_batch_rescale(batch);
    for (int i = 0; i < COUNT; i++) {
        lines.length[i] *= rescale_factor((TinkerDimension)TINKER_DIMENSION_LENGTH);
        lines.rate[i] *= rescale_factor((TinkerDimension)TINKER_DIMENSION_VELOCITY);
    }
    g_assert_cmpint(law->tension(&view, lines.length, lines.rate, rescaled), ==, TINKER_OK);
    for (int i = 0; i < COUNT; i++) {
        g_assert_cmpfloat(rescaled[i], ==, lines.tension[i] * rescale_factor((TinkerDimension)TINKER_DIMENSION_FORCE));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/spring/law", test_spring_law);
    g_test_add_func("/plugins/spring/energy", test_spring_energy);
    g_test_add_func("/plugins/damper/law", test_damper_law);
    static const char *const names[] = {"spring", "damper"};
    const struct {
        const char *name;
        GTestDataFunc function;
    } tests[] = {{"derivatives", test_derivatives},
                 {"linear", test_linear},
                 {"slices", test_slices},
                 {"dimensions", test_dimensions}};
    for (size_t k = 0; k < G_N_ELEMENTS(names); k++) {
        for (size_t i = 0; i < G_N_ELEMENTS(tests); i++) {
            g_autofree char *path = g_strdup_printf("/plugins/%s/%s", names[k], tests[i].name);
            g_test_add_data_func(path, names[k], tests[i].function);
        }
    }
    return g_test_run();
}
