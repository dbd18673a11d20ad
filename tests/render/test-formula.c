/* Formulas: where the ink of their parts lies. */
#include <math.h>

#include "picture.h"
#include "render/formula/formula.h"

#define SIZE   40
#define WIDTH  600
#define HEIGHT 200
#define LEFT   20
#define LINE   110

#define X   "<mi>x</mi>"
#define DOT "<mover>" X "<mo>˙</mo></mover>"
#define TWO "<mover>" X "<mo>¨</mo></mover>"

typedef struct {
    TestPicture *picture;
    TinkerMathText *formula;
    double width, above, below;
} Drawn;

static void draw(Drawn *drawn, const char *mathml)
{
    GError *error = NULL;
    drawn->picture = test_picture_new(WIDTH, HEIGHT);
    drawn->formula = tinker_math_text_new(mathml, SIZE, &error);
    g_assert_no_error(error);
    tinker_math_text_measure(drawn->formula, &drawn->width, &drawn->above, &drawn->below);
    cairo_set_source_rgb(drawn->picture->cairo, 0, 0, 0);
    tinker_math_text_draw(drawn->formula, drawn->picture->cairo, LEFT, LINE);
}

static void clear(Drawn *drawn)
{
    test_picture_free(drawn->picture);
    tinker_math_text_free(drawn->formula);
}

/* Whether a pixel is more ink than ground. */
static gboolean ink(const Drawn *drawn, int x, int y)
{
    double rgba[4];
    test_picture_pixel(drawn->picture, x, y, rgba);
    return rgba[3] > 0.4;
}

static int ink_in_row(const Drawn *drawn, int y)
{
    int count = 0;
    for (int x = 0; x < WIDTH; x++)
        count += ink(drawn, x, y);
    return count;
}

/* Takes away what hangs together with this pixel. */
static void flood(gboolean *left, int x, int y)
{
    g_autoptr(GArray) todo = g_array_new(FALSE, FALSE, sizeof(int));
    int place = y * WIDTH + x;
    g_array_append_val(todo, place);
    while (todo->len > 0) {
        const int at = g_array_index(todo, int, todo->len - 1);
        g_array_set_size(todo, todo->len - 1);
        if (!left[at]) continue;
        left[at] = FALSE;
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) {
                place = at + dy * WIDTH + dx;
                g_array_append_val(todo, place);
            }
    }
}

static int pieces(const Drawn *drawn)
{
    g_autofree gboolean *left = g_new0(gboolean, WIDTH * HEIGHT);
    int count = 0;
    for (int y = 1; y < HEIGHT - 1; y++)
        for (int x = 1; x < WIDTH - 1; x++)
            left[y * WIDTH + x] = ink(drawn, x, y);
    for (int y = 1; y < HEIGHT - 1; y++)
        for (int x = 1; x < WIDTH - 1; x++)
            if (left[y * WIDTH + x]) {
                flood(left, x, y);
                count++;
            }
    return count;
}

/* An x, with a dot for each time it is differentiated by time. */
static void test_dots(void)
{
    static const char *const texts[] = {X, DOT, TWO};
    for (int dots = 0; dots < 3; dots++) {
        Drawn drawn;
        draw(&drawn, texts[dots]);
        g_assert_cmpint(pieces(&drawn), ==, 1 + dots);
        clear(&drawn);
    }
}

/* Above the line of a fraction nothing of what it divides by, and the line is as wide as the wider of both. */
static void test_fraction(void)
{
    Drawn drawn, wide;
    draw(&wide, "<mn>1234</mn>");
    draw(&drawn, "<mfrac><mn>1</mn><mn>1234</mn></mfrac>");
    int longest = 0, line = 0;
    for (int y = 0; y < HEIGHT; y++)
        if (ink_in_row(&drawn, y) > longest) longest = ink_in_row(&drawn, line = y);
    g_assert_cmpint(longest, >=, (int)(0.8 * wide.width));
    g_assert_cmpint(line, <, LINE);
    g_assert_cmpint(line, >, LINE - SIZE / 2);
    g_assert_cmpint(ink_in_row(&drawn, line - 4), ==, 0);
    g_assert_cmpint(ink_in_row(&drawn, line + 4), ==, 0);
    g_assert_cmpint(pieces(&drawn), ==, 6);
    clear(&drawn);
    clear(&wide);
}

/* As high as what they are around. */
static void test_brackets(void)
{
    static const char *const inside[] = {"<mfrac>" X X "</mfrac>", "<mfrac><mfrac>" X X "</mfrac>" X "</mfrac>"};
    for (gsize i = 0; i < G_N_ELEMENTS(inside); i++) {
        Drawn bare, drawn;
        g_autofree char *text = g_strdup_printf("<mo>(</mo>%s<mo>)</mo>", inside[i]);
        draw(&bare, inside[i]);
        draw(&drawn, text);
        g_assert_cmpfloat(drawn.above, >=, bare.above - 1e-9);
        g_assert_cmpfloat(drawn.below, >=, bare.below - 1e-9);
        /* the first and the last column of ink are theirs, and bend: their ink begins at the ends */
        int top = 0, bottom = HEIGHT - 1;
        while (ink_in_row(&drawn, top) == 0)
            top++;
        while (ink_in_row(&drawn, bottom) == 0)
            bottom--;
        g_assert_cmpint(top, <=, (int)(LINE - bare.above) + 3);
        g_assert_cmpint(bottom, >=, (int)(LINE + bare.below) - 3);
        g_assert_cmpint(pieces(&drawn), ==, pieces(&bare) + 2);
        clear(&bare);
        clear(&drawn);
    }
}

/* A power stands above half the height of what it is over; an index hangs below the line. Both stand one over the
 * other. */
static void test_scripts(void)
{
    Drawn plain, power, index, both;
    draw(&both, "<msubsup>" X "<mn>2</mn><mn>2</mn></msubsup>");
    draw(&plain, X);
    draw(&power, "<msup>" X "<mn>2</mn></msup>");
    draw(&index, "<msub>" X "<mn>2</mn></msub>");
    g_assert_cmpfloat(power.above, >, 1.25 * plain.above);
    g_assert_cmpfloat(power.below, <=, plain.below + 0.5);
    g_assert_cmpfloat(index.below, >, plain.below + 0.1 * SIZE);
    g_assert_cmpfloat(index.above, <=, plain.above + 0.5);
    g_assert_cmpint(pieces(&power), ==, 2);
    g_assert_cmpint(pieces(&both), ==, 3);
    g_assert_cmpfloat(fabs(both.width - fmax(power.width, index.width)), <, 0.5);
    g_assert_cmpfloat(fabs(both.above - power.above), <, 0.5);
    g_assert_cmpfloat(fabs(both.below - index.below), <, 0.5);
    clear(&both);
    clear(&plain);
    clear(&power);
    clear(&index);
}

/* Ink lies within what is measured, whatever is put together. */
static void test_extents(void)
{
    static const char *const texts[] = {
        X,
        TWO "<mo>+</mo><mfrac><mrow><mn>1</mn><mo>−</mo>" X "</mrow><msqrt>" X "</msqrt></mfrac>",
        "<msqrt><msup><mrow><mo>(</mo>" X "<mo>−</mo><mi>y</mi><mo>)</mo></mrow><mn>2</mn></msup><mo>+</mo>" X
        "</msqrt>",
        "<mi>F</mi><mo>=</mo><mo>{</mo><mtable><mtr><mtd>" X "</mtd><mtd><mtext>if </mtext>" X
        "<mo>&lt;</mo><mn>0</mn></mtd></mtr><mtr><mtd><mn>0</mn></mtd><mtd><mtext>else</mtext></mtd></mtr></mtable>",
        "<msub><mi>μd</mi><mrow><mn>3</mn><mo>,</mo>" X "</mrow></msub><mo>&#x2062;</mo>"
        "<mi>sin</mi><mo>&#x2061;</mo><mo>(</mo><mi>φ</mi><mo>)</mo>",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        Drawn drawn;
        draw(&drawn, texts[i]);
        g_assert_cmpfloat(drawn.width, <, WIDTH - 2 * LEFT);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                if (ink(&drawn, x, y)) {
                    g_assert_cmpfloat(x, >=, LEFT - 0.1 * SIZE);
                    g_assert_cmpfloat(x, <=, LEFT + drawn.width + 0.1 * SIZE);
                    g_assert_cmpfloat(y, >=, LINE - drawn.above - 2);
                    g_assert_cmpfloat(y, <=, LINE + drawn.below + 2);
                }
        clear(&drawn);
    }
}

static void test_errors(void)
{
    static const char *const texts[] = {"<table/>", "<mfrac><mi>x</mi></mfrac>", "<mi>x", "<mi>x</mn>"};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        g_autoptr(GError) error = NULL;
        g_assert_null(tinker_math_text_new(texts[i], SIZE, &error));
        g_assert_nonnull(error);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/formula/dots", test_dots);
    g_test_add_func("/formula/fraction", test_fraction);
    g_test_add_func("/formula/brackets", test_brackets);
    g_test_add_func("/formula/scripts", test_scripts);
    g_test_add_func("/formula/extents", test_extents);
    g_test_add_func("/formula/errors", test_errors);
    return g_test_run();
}
