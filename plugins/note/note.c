/* Note: lines of text with formulas, to explain on the canvas. It acts on nothing, so that a scene moves with it as
 * without it. */
#include <tinker/sdk.h>

enum { COLUMN_POSITION, COLUMN_SIZE = COLUMN_POSITION + 2 };

#define LETTERS  0.8 /* symbol sizes: their height, at size 1 */
#define WIDTH    1.0 /* heights: no letter is wider, */
#define LINE     1.6 /* and no line higher, */
#define FRACTION 1.0 /* but for what a fraction adds */
#define USUAL    0.6 /* of the greatest width: what is usual, and is hit */

static const TinkerPropertyType properties[] = {
    {TINKER_VECTOR_PROPERTY("position", "Global Position", "Global Position", "X", "Y", TINKER_DIMENSION_LENGTH),
     .description = "Where its middle is", .meaning = TINKER_MEANING_POSITION, .variability = TINKER_TUNABLE,
     TINKER_ANY_VALUE(0, -10.0, 10.0)},
    {TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_TEXT, "text", "Text", "Note", TINKER_DIMENSION_NONE),
     .description = "What it says; \\n begins a line, and what stands between dollar signs is a formula, as in "
                    "$omega = sqrt(k/m)$ or $F = k*(L - L_0)$",
     .variability = TINKER_TUNABLE, .default_text = "Note"},
    {TINKER_REAL_PROPERTY("size", "Text Size", "Note", TINKER_DIMENSION_NONE),
     .description = "Of its letters: 1 is that of symbols", .variability = TINKER_TUNABLE, .default_value = {1.0, 0.0},
     TINKER_POSITIVE(0, 0.5, 4.0)},
};

/* Its text; of a host that hands out none, nothing. */
static const char *text_of(const TinkerInstance *instance)
{
    const int known = TINKER_HAS(TinkerInstance, instance, texts) && instance->text_count > 0;
    return known ? instance->texts[0] : "";
}

static double letters_of(const TinkerInstance *instance)
{
    return LETTERS * instance->columns[COLUMN_SIZE] * tinker_instance_symbol_size(instance);
}

/* Half of its width and of its height at the most: what it is measured by is the host's. */
static void find_half(const TinkerInstance *instance, double half[2])
{
    const char *text = text_of(instance);
    const double letters = letters_of(instance);
    int letters_here = 0, most = 1, lines = 1, fractions = 0;
    for (; *text != '\0'; text++) {
        const int ends = *text == '\n' || (*text == '\\' && text[1] == 'n');
        letters_here += ((unsigned char)*text & 0xc0) != 0x80;
        fractions += *text == '/';
        if (letters_here > most) most = letters_here;
        if (!ends) continue;
        letters_here = 0;
        lines++;
    }
    half[0] = 0.5 * WIDTH * letters * most;
    half[1] = 0.5 * letters * (LINE * lines + FRACTION * (fractions < lines ? fractions : lines));
}

/* Drawing */

/* Without a text, as in a palette, it is drawn as lines. */
static void draw_lines(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const double symbol = style->symbol_size, x = instance->x, y = instance->y;
    for (int k = -1; k <= 1; k++) {
        const double right = k < 0 ? 0.2 * symbol : symbol;
        style->line(style, cairo, TINKER_COLOUR_TEXT, x - symbol, y + 0.5 * k * symbol, x + right,
                    y + 0.5 * k * symbol);
    }
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const char *text = text_of(instance);
    if (*text == '\0') {
        draw_lines(instance, cairo, style);
    } else if (TINKER_HAS(TinkerStyle, style, note) && style->note != NULL) {
        style->note(style, cairo, TINKER_COLOUR_TEXT, instance->x, instance->y, letters_of(instance), text);
    } else {
        style->text(style, cairo, TINKER_COLOUR_TEXT, instance->x, instance->y, text);
    }
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    double half[2];
    const double least = style->symbol_size + tinker_drawing_margin(style);
    find_half(instance, half);
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->x, instance->y, least);
    for (int side = -1; side <= 1; side += 2)
        tinker_bounds_add(box, instance->x + side * half[0], instance->y + side * half[1], 0.0);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    double half[2];
    const double symbol = tinker_instance_symbol_size(instance);
    find_half(instance, half);
    const int inside = fabs(x - instance->x) <= fmax(USUAL * half[0], symbol) + reach &&
                       fabs(y - instance->y) <= fmax(half[1], 0.6 * symbol) + reach;
    return inside ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    if (part != TINKER_PART_WHOLE) return;
    editor->set(editor, COLUMN_POSITION, instance->columns[COLUMN_POSITION] + dx);
    editor->set(editor, COLUMN_POSITION + 1, instance->columns[COLUMN_POSITION + 1] + dy);
}

static void move_absolute(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor)
{
    (void)instance;
    if (part != TINKER_PART_WHOLE) return;
    editor->set(editor, COLUMN_POSITION, x);
    editor->set(editor, COLUMN_POSITION + 1, y);
}

/* Tables */

static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move_absolute, NULL};

static const TinkerInterface interfaces[] = {
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("note", "Note", TINKER_MEASURE), .summary = "Text with formulas on the canvas",
     .properties = TINKER_SPAN(properties), .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.note", "Note", "0.1.0", "MIT", blocks)
