/* The law of a block type, line by line. */
#include "law/law-text.h"

#include <string.h>

#include "law/block-law.h"
#include "law/build.h"
#include "law/typeset.h"

#define AT_START "(0)"

/* How the symbols of roles look, and what stands left of an equals sign. A number behind the name is the index. */
static const struct {
    const char *name;
    TinkerSymbolLook look;
} looks[] = {
    {"x_start", {"x", "", 0, AT_START}},
    {"y_start", {"y", "", 0, AT_START}},
    {"theta_start", {"θ", "", 0, AT_START}},
    {"x", {"x", "", 0, NULL}},
    {"y", {"y", "", 0, NULL}},
    {"vx", {"x", "", 1, NULL}},
    {"vy", {"y", "", 1, NULL}},
    {"theta", {"θ", "", 0, NULL}},
    {"omega", {"θ", "", 1, NULL}},
    {"rate", {"L", "", 1, NULL}},
    {"m", {"m", "", 0, NULL}},
    {"tension", {"T", "", 0, NULL}},
    {"potential", {"V", "", 0, NULL}},
    {"pair_potential", {"V", "", 0, NULL}},
    {"force_x", {"F", "", 0, "x"}},
    {"force_y", {"F", "", 0, "y"}},
    {"pair_force_x", {"F", "", 0, "x"}},
    {"pair_force_y", {"F", "", 0, "y"}},
    {"torque", {"M", "", 0, NULL}},
    {"impulse_x", {"Δp", "", 0, "x"}},
    {"impulse_y", {"Δp", "", 0, "y"}},
    {"angular_impulse", {"ΔL", "", 0, NULL}},
    {"displacement_x", {"Δx", "", 0, NULL}},
    {"displacement_y", {"Δy", "", 0, NULL}},
    {"rotation", {"Δθ", "", 0, NULL}},
};

typedef struct {
    const TinkerBlockClass *block_class;
    const TinkerBlockLaw *law; /* NULL: one that is typed */
} Text;

/* The digits in or behind a name, "2" of x2_start and of force_x2; "" where there are none. Static. */
static const char *number_in(const char *name)
{
    const char *at = name + strcspn(name, "0123456789");
    const gsize count = strspn(at, "0123456789");
    g_autofree char *digits = g_strndup(at, count);
    return g_intern_string(digits);
}

/* (transfer full) */
static char *without_number(const char *name)
{
    const gsize before = strcspn(name, "0123456789");
    return g_strdup_printf("%.*s%s", (int)before, name, name + before + strspn(name + before, "0123456789"));
}

/* Whether a property has the letter that a role's symbol looks like, as the angle of a motor and that of its body,
 * which then is θ₁. */
static gboolean is_taken(const Text *text, const TinkerSymbolLook *look)
{
    if (look->dots > 0 || look->index[0] != '\0') return FALSE;
    for (int32_t i = 0; i < text->block_class->property_count; i++) {
        const TinkerPropertyType *type = &text->block_class->properties[i];
        const gboolean vector = type->kind == TINKER_KIND_VECTOR;
        if (type->kind == TINKER_KIND_TEXT || (type->flags & TINKER_READ_ONLY) != 0) continue;
        if (vector == (look->component != NULL) && g_strcmp0(type->symbol, look->stem) == 0) return TRUE;
    }
    return FALSE;
}

static void look_of_role(const Text *text, const char *name, TinkerSymbolLook *look)
{
    const char *number = number_in(name);
    g_autofree char *stem = without_number(name);
    *look = (TinkerSymbolLook){.stem = g_intern_string(name), .index = ""};
    for (gsize i = 0; i < G_N_ELEMENTS(looks); i++) {
        if (strcmp(looks[i].name, stem) != 0) continue;
        *look = looks[i].look;
        look->index = number;
        break;
    }
    if (is_taken(text, look)) look->index = "1";
}

static void look_of(const char *name, TinkerSymbolLook *look, void *data)
{
    const Text *text = data;
    const TinkerLawSymbol *symbol = text->law != NULL ? tinker_block_law_symbol(text->law, name) : NULL;
    const gboolean step = symbol == NULL && tinker_law_is_step(name) && text->law != NULL;
    if (!step && (symbol == NULL || symbol->property < 0)) {
        look_of_role(text, name, look);
        return;
    }
    const gboolean start = symbol != NULL && symbol->at_start;
    g_autofree char *stem = start ? g_strndup(name, strlen(name) - strlen("_start")) : NULL;
    *look = (TinkerSymbolLook){start ? g_intern_string(stem) : name, "", 0, start ? AT_START : NULL};
}

/* (transfer full) */
static char *symbol_text(const Text *text, const char *name)
{
    GString *shown = g_string_new(NULL);
    TinkerSymbolLook look;
    look_of(name, &look, (void *)text);
    tinker_symbol_typeset(shown, &look, TINKER_TYPESET_TEXT);
    return g_string_free(shown, FALSE);
}

/* What an end is on turns here: a law that a point mass drops a part of is shown with that part. */
static TinkerExpression *turning(const char *symbol, void *data)
{
    const TinkerLawSymbol *known = tinker_block_law_symbol(data, symbol);
    const gboolean turns = known != NULL && g_strcmp0(known->quantity, "turns") == 0;
    return turns ? tinker_expression_number(1) : NULL;
}

/* Of one that acts at an instant, when. Borrowed. */
static const char *instant_of(const TinkerBlockClass *block_class)
{
    const int32_t property = block_class->meanings[TINKER_MEANING_INSTANT];
    return property >= 0 ? block_class->properties[property].symbol : NULL;
}

/* (transfer full) */
static char *line_of(const Text *text, const TinkerLawDefinition *definition)
{
    const char *name = definition->symbol, *instant = instant_of(text->block_class);
    g_autoptr(TinkerExpression) is = tinker_expression_replace(definition->is, turning, (void *)text->law);
    g_autofree char *right = tinker_expression_typeset(is, TINKER_TYPESET_TEXT, look_of, (void *)text);
    if (text->law->role == TINKER_LAW_CONSTRAINT && !tinker_law_is_step(name)) {
        const gboolean slack = text->block_class->physics->constraint->unilateral != 0;
        return g_strdup_printf("%s %s 0", right, slack ? "≤" : "=");
    }
    g_autofree char *left = symbol_text(text, name);
    const gboolean blow = g_str_has_prefix(name, "impulse_") || strcmp(name, "angular_impulse") == 0;
    return blow && instant != NULL ? g_strdup_printf("%s = %s (t = %s)", left, right, instant)
                                   : g_strdup_printf("%s = %s", left, right);
}

/* What is 0 where the law says something else, too, and what another number of ends would have. */
static gboolean is_left_out(const TinkerBlockLaw *law, const TinkerLawDefinition *definition, int32_t ends)
{
    if (tinker_law_is_step(definition->symbol)) return FALSE;
    if (law->definitions->len > 1 && tinker_expression_is_number(definition->is, 0)) return TRUE;
    return law->role == TINKER_LAW_FORCE && strcmp(definition->symbol, "potential") != 0 && ends > 1 &&
           number_in(definition->symbol)[0] == '\0';
}

static void add_stated(const TinkerBlockClass *block_class, GPtrArray *lines)
{
    const int32_t ends = MAX(block_class->type->least_ends, block_class->type->most_ends);
    g_autoptr(TinkerBlockLaw) law = tinker_block_law_new(block_class, ends, NULL);
    const Text text = {block_class, law};
    for (guint i = 0; law != NULL && i < law->definitions->len; i++) {
        const TinkerLawDefinition *definition = &g_array_index(law->definitions, TinkerLawDefinition, i);
        if (!is_left_out(law, definition, ends)) g_ptr_array_add(lines, line_of(&text, definition));
    }
}

/* "T = T(L, L̇, t)" of each law that may be typed. */
static void add_typed(const TinkerBlockClass *block_class, GPtrArray *lines)
{
    const Text text = {block_class, NULL};
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *type = &block_class->properties[i];
        if ((type->flags & TINKER_TEXT_LAW) == 0) continue;
        g_autofree char *left = symbol_text(&text, type->id);
        g_autoptr(GString) over = g_string_new(NULL);
        for (int32_t k = 0; k < type->choice_count; k++) {
            g_autofree char *argument = symbol_text(&text, type->choices[k]);
            g_string_append_printf(over, "%s%s", k > 0 ? ", " : "", argument);
        }
        g_ptr_array_add(lines, g_strdup_printf("%s = %s(%s)", left, left, over->str));
    }
}

static void add_of_body(const TinkerBody *body, GPtrArray *lines)
{
    if (body->degrees_of_freedom > 0) g_ptr_array_add(lines, g_strdup("m a = ΣF"));
    if (body->degrees_of_freedom > 2) g_ptr_array_add(lines, g_strdup("I α = ΣM"));
}

char **tinker_class_law_lines(const TinkerBlockClass *block_class)
{
    static const char *const stems[] = {"T", "F", "F", "λ", "u"}; /* by role */
    const TinkerLawRole role = tinker_law_role(block_class);
    g_autoptr(GPtrArray) lines = g_ptr_array_new();
    if (role == TINKER_LAW_NONE) {
        if (block_class->physics != NULL && block_class->physics->body != NULL)
            add_of_body(block_class->physics->body, lines);
    } else {
        add_stated(block_class, lines);
        if (lines->len == 0) add_typed(block_class, lines);
        if (lines->len == 0) g_ptr_array_add(lines, g_strconcat(stems[role], "_", block_class->type->title, NULL));
    }
    g_ptr_array_add(lines, NULL);
    return (char **)g_ptr_array_free(g_steal_pointer(&lines), FALSE);
}
