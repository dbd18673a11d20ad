/* The lines that say what a block does: those of textbooks for the blocks of the build, and what becomes of laws that a
 * class of the test's own states. */
#include <string.h>

#include "build-catalogue.h"
#include "law/block-law.h"
#include "law/law-text.h"

static TinkerCatalogue *catalogue;

static const TinkerBlockClass *class_of(const char *id)
{
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, id, &error);
    g_assert_no_error(error);
    return block_class;
}

static void assert_lines(const TinkerBlockClass *block_class, const char *expected)
{
    g_auto(GStrv) lines = tinker_class_law_lines(block_class);
    g_autofree char *all = g_strjoinv("; ", lines);
    g_assert_cmpstr(all, ==, expected);
}

/* As books on mechanics have them. */
static void test_of_blocks(void)
{
    static const char *const books[][2] = {
        {"spring", "T = k (L − L0); V = k (L − L0)² / 2"},
        {"damper", "T = c L̇"},
        {"mass", "m a = ΣF"},
        {"bar", "m a = ΣF; I α = ΣM"},
        {"gravity", "Fx = m g cos(θ); Fy = m g sin(θ); V = −m g (x cos(θ) + y sin(θ))"},
        {"rod", "L − l = 0"},
        {"rope", "L − l ≤ 0"},
        {"pin", "x₂ − x₁ = 0; y₂ − y₁ = 0"},
        {"torsional-spring", "V = k (θ₂ − θ₁ − θ0)² / 2"},
        {"torque", "M₁ = M; M₂ = −M"},
        {"support-motion", "Δx = u cos(θ); Δy = u sin(θ)"},
        {"impulse", "Δpx = J cos(θ) (t = τ); Δpy = J sin(θ) (t = τ); ΔL = H (t = τ)"},
        {"law-connector", "T = T(L, L̇, t); V = V(L)"},
        {"support", ""},
        {"note", ""},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(books); i++)
        assert_lines(class_of(books[i][0]), books[i][1]);
}

/* A copy of the spring's class with another law. */
static void assert_stated(const char *tension, const char *expected)
{
    const TinkerLawEquation equation = {sizeof equation, 0, "tension", tension, NULL, TINKER_DIMENSION_FORCE, 0};
    TinkerBlockClass other = *class_of("spring");
    other.law = (TinkerLawEquation *)&equation;
    other.law_count = 1;
    assert_lines(&other, expected);
}

static void test_follows_the_law(void)
{
    assert_stated("k*(L - L0)^3", "T = k (L − L0)³");
    assert_stated("-2*k*rate", "T = −2 k L̇");
    assert_stated("k*L/t", "T = k L / t");
    assert_stated("k*(", "T_Spring"); /* cannot be read */
}

/* What states none has the name of its force. */
static void test_without_a_law(void)
{
    TinkerBlockClass spring = *class_of("spring"), wind = *class_of("wind"), rod = *class_of("rod");
    spring.law_count = wind.law_count = rod.law_count = 0;
    assert_lines(&spring, "T_Spring");
    assert_lines(&wind, "F_Wind");
    assert_lines(&rod, "λ_Rod");
}

/* Every block of the build that does something has a line, and every property that its law names stands in one. */
static void test_nothing_is_left_out(void)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    int seen = 0;
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        for (guint k = 0; library->types != NULL && k < library->types->len; k++) {
            const TinkerBlockClass *block_class = class_of(((const TinkerTypeEntry *)library->types->pdata[k])->id);
            g_auto(GStrv) lines = tinker_class_law_lines(block_class);
            g_autofree char *all = g_strjoinv("; ", lines);
            const int32_t ends = MAX(block_class->type->least_ends, block_class->type->most_ends);
            g_autoptr(TinkerBlockLaw) law = tinker_block_law_new(block_class, ends, NULL);
            g_assert_true(law == NULL || all[0] != '\0');
            for (guint s = 0; law != NULL && s < law->symbols->len; s++) {
                const TinkerLawSymbol *symbol = &g_array_index(law->symbols, TinkerLawSymbol, s);
                if (symbol->property < 0 || symbol->at_start || !tinker_block_law_names(law, symbol->name)) continue;
                if (strstr(all, symbol->name) == NULL) g_error("%s: no %s", all, symbol->name);
                seen++;
            }
        }
    }
    g_assert_cmpint(seen, >, 30);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    catalogue = test_build_catalogue();
    g_test_add_func("/law-text/of-blocks", test_of_blocks);
    g_test_add_func("/law-text/follows-the-law", test_follows_the_law);
    g_test_add_func("/law-text/without-a-law", test_without_a_law);
    g_test_add_func("/law-text/nothing-is-left-out", test_nothing_is_left_out);
    const int status = g_test_run();
    tinker_catalogue_free(catalogue);
    return status;
}
