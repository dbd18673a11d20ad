/* The panels that books are integrated over: who gets them where they run short. */
#include <glib.h>

#include "equations/balance/book-nodes-private.h"

#define PANELS 4
#define POINTS 8

/* Jumps in the second panel, and a hundred times as high in the last one, at the same place of it. */
static GArray *panels_with_jumps(void)
{
    g_autoptr(GArray) none = g_array_new(FALSE, FALSE, sizeof(TinkerBookCut));
    GArray *panels = tinker_book_panels(0, PANELS, none, PANELS);
    for (guint i = 0; i < panels->len; i++)
        for (int point = 0; point < POINTS; point++) {
            const double step = point < 3 ? 0 : i == 1 ? 1 : i == PANELS - 1 ? 100 : 0;
            const double values[TINKER_BOOK_FUNCTIONS] = {step};
            tinker_book_panel_take(&g_array_index(panels, TinkerBookPanel, i), point, values);
        }
    return panels;
}

/* How many of the panels begin within the one that began at `from`. */
static guint parts_within(const GArray *panels, double from)
{
    guint count = 0;
    for (guint i = 0; i < panels->len; i++) {
        const double begin = g_array_index(panels, TinkerBookPanel, i).from;
        count += begin >= from && begin < from + 1;
    }
    return count;
}

/* Of 15 more panels, what one jump asks for, the higher one gets all, though the other lies before it. */
static void test_worst_first(void)
{
    const double allowed[TINKER_BOOK_FUNCTIONS] = {1e-9, 1e-9, 1e-9, 1e-9};
    g_autoptr(GArray) panels = panels_with_jumps();
    g_assert_true(tinker_book_panels_refine(panels, allowed, PANELS + 15));
    g_assert_cmpuint(panels->len, ==, PANELS + 15);
    g_assert_cmpuint(parts_within(panels, PANELS - 1), ==, 16);
    g_autoptr(GArray) full = panels_with_jumps();
    g_assert_false(tinker_book_panels_refine(full, allowed, PANELS));
}

/* Halving says whether there was anything to halve, and keeps to the limit. */
static void test_halving(void)
{
    g_autoptr(GArray) none = g_array_new(FALSE, FALSE, sizeof(TinkerBookCut));
    g_autoptr(GArray) panels = tinker_book_panels(0, PANELS, none, PANELS);
    g_assert_false(tinker_book_panels_halve(panels, 1.5, 100));
    g_assert_cmpuint(panels->len, ==, PANELS);
    g_assert_true(tinker_book_panels_halve(panels, 0.9, PANELS + 1));
    g_assert_cmpuint(panels->len, ==, PANELS + 1);
    g_assert_true(tinker_book_panels_halve(panels, 0.9, 100));
    g_assert_cmpuint(panels->len, ==, 2 * PANELS);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/books/worst-first", test_worst_first);
    g_test_add_func("/books/halving", test_halving);
    return g_test_run();
}
