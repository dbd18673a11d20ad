/* The walk over a tree, which is the same in every format: where brackets are needed, what is a fraction, a root, a
 * power. */
#include "law/typeset-private.h"

#include <math.h>
#include <string.h>

#include "law/build.h"

typedef struct {
    GString *text;
    const TinkerTypesetStyle *style;
    TinkerLookFunc look;
    void *data;
} Typesetter;

static void put_node(const Typesetter *to, const TinkerExpression *node, TinkerBinding least);
static void write_inside(const Typesetter *to, const TinkerExpression *node);

static TinkerBinding binding_of(const TinkerExpression *node, const TinkerTypesetStyle *style)
{
    switch (node->kind) {
    case TINKER_EXPRESSION_NUMBER:
        return node->number < 0 ? TINKER_BINDS_SIGN : TINKER_BINDS_ATOM;
    case TINKER_EXPRESSION_SUM:
        return TINKER_BINDS_SUM;
    case TINKER_EXPRESSION_NEGATIVE:
        return TINKER_BINDS_SIGN;
    case TINKER_EXPRESSION_PRODUCT:
        return TINKER_BINDS_PRODUCT;
    case TINKER_EXPRESSION_QUOTIENT:
        return style->stacked ? TINKER_BINDS_POWER : TINKER_BINDS_PRODUCT;
    case TINKER_EXPRESSION_POWER:
        return TINKER_BINDS_POWER;
    case TINKER_EXPRESSION_COMPARISON:
        return TINKER_BINDS_COMPARISON;
    default:
        return TINKER_BINDS_ATOM;
    }
}

static void put(const Typesetter *to, const char *text)
{
    g_string_append(to->text, text);
}

/* Whether it is higher than a line: a fraction, or cases, are in it. */
static gboolean is_high(const TinkerExpression *node)
{
    const gboolean cases = node->kind == TINKER_EXPRESSION_FUNCTION && strcmp(node->name, "if") == 0;
    gboolean high = node->kind == TINKER_EXPRESSION_QUOTIENT || cases;
    for (int i = 0; !high && i < node->count; i++)
        high = is_high(node->parts[i]);
    return high;
}

/* A bracket around what a node is, or its parts are. */
static void put_bracket(const Typesetter *to, const TinkerExpression *node, gboolean opens)
{
    const TinkerTypesetStyle *style = to->style;
    if (style->high[0] != NULL && is_high(node))
        put(to, style->high[opens ? 0 : 1]);
    else
        put(to, opens ? style->open : style->close);
}

/* One behind others. */
static void write_term(const Typesetter *to, const TinkerExpression *part)
{
    if (part->kind == TINKER_EXPRESSION_NEGATIVE) {
        put(to, to->style->minus);
        put_node(to, part->parts[0], TINKER_BINDS_PRODUCT);
    } else if (part->kind == TINKER_EXPRESSION_NUMBER && part->number < 0) {
        put(to, to->style->minus);
        to->style->number(to->text, -part->number);
    } else {
        put(to, to->style->plus);
        put_node(to, part, TINKER_BINDS_PRODUCT);
    }
}

static void write_sum(const Typesetter *to, const TinkerExpression *node)
{
    put_node(to, node->parts[0], TINKER_BINDS_SIGN);
    for (int i = 1; i < node->count; i++)
        write_term(to, node->parts[i]);
}

static gboolean begins_with_digit(const TinkerExpression *node)
{
    while (node->count > 0 && node->kind != TINKER_EXPRESSION_FUNCTION && node->kind != TINKER_EXPRESSION_SUM)
        node = node->parts[0];
    return node->kind == TINKER_EXPRESSION_NUMBER && node->number != G_PI; /* which is a letter */
}

static gboolean begins_with_function(const TinkerExpression *node)
{
    while (node->kind == TINKER_EXPRESSION_POWER || node->kind == TINKER_EXPRESSION_PRODUCT)
        node = node->parts[0];
    return node->kind == TINKER_EXPRESSION_FUNCTION;
}

static const char *times_before(const Typesetter *to, const TinkerExpression *factor)
{
    const TinkerTypesetStyle *style = to->style;
    if (begins_with_digit(factor)) return style->times_number;
    return style->times_function != NULL && begins_with_function(factor) ? style->times_function : style->times;
}

static void write_product(const Typesetter *to, const TinkerExpression *node)
{
    for (int i = 0; i < node->count; i++) {
        if (i > 0) put(to, times_before(to, node->parts[i]));
        const gboolean signed_first = i == 0 && node->parts[i]->kind == TINKER_EXPRESSION_NEGATIVE;
        /* in a line of text a quotient would take what stands behind it */
        put_node(to, node->parts[i], signed_first ? TINKER_BINDS_SIGN : TINKER_BINDS_POWER);
    }
}

static void write_quotient(const Typesetter *to, const TinkerExpression *node)
{
    const TinkerTypesetStyle *style = to->style;
    put(to, style->fraction[0]);
    put_node(to, node->parts[0], style->stacked ? TINKER_BINDS_COMPARISON : TINKER_BINDS_PRODUCT);
    put(to, style->fraction[1]);
    put_node(to, node->parts[1], style->stacked ? TINKER_BINDS_COMPARISON : TINKER_BINDS_POWER);
    put(to, style->fraction[2]);
}

/* In a line of text a whole number from 0 to 9 is raised, x². */
static gboolean write_raised(const Typesetter *to, const TinkerExpression *exponent)
{
    if (exponent->kind != TINKER_EXPRESSION_NUMBER) return FALSE;
    const double n = exponent->number;
    if (n != floor(n) || n < 0 || n > 9 || to->style->raised[(int)n] == NULL) return FALSE;
    put(to, to->style->raised[(int)n]);
    return TRUE;
}

/* A symbol has its exponent over its index, not behind it. */
static void write_raised_symbol(const Typesetter *to, const TinkerExpression *node)
{
    const gsize symbol = to->text->len;
    g_autoptr(GString) exponent = g_string_new(NULL);
    const Typesetter above = {exponent, to->style, to->look, to->data};
    write_inside(to, node->parts[0]);
    put_node(&above, node->parts[1], TINKER_BINDS_COMPARISON);
    to->style->raise(to->text, symbol, exponent->str);
}

static void write_power(const Typesetter *to, const TinkerExpression *node)
{
    const TinkerTypesetStyle *style = to->style;
    if (style->raise != NULL && node->parts[0]->kind == TINKER_EXPRESSION_SYMBOL) {
        write_raised_symbol(to, node);
        return;
    }
    put(to, style->power[0]);
    put(to, style->group[0]);
    put_node(to, node->parts[0], TINKER_BINDS_ATOM);
    put(to, style->group[1]);
    if (write_raised(to, node->parts[1])) return;
    put(to, style->power[1]);
    put_node(to, node->parts[1], style->stacked ? TINKER_BINDS_COMPARISON : TINKER_BINDS_ATOM);
    put(to, style->power[2]);
}

static void write_cases(const Typesetter *to, const TinkerExpression *node)
{
    const TinkerTypesetStyle *style = to->style;
    put(to, style->cases[0]);
    put_node(to, node->parts[1], TINKER_BINDS_COMPARISON);
    put(to, style->cases[1]);
    put_node(to, node->parts[0], TINKER_BINDS_COMPARISON);
    put(to, style->cases[2]);
    put_node(to, node->parts[2], TINKER_BINDS_COMPARISON);
    put(to, style->otherwise);
    put(to, style->cases[3]);
}

static void write_function(const Typesetter *to, const TinkerExpression *node)
{
    const TinkerTypesetStyle *style = to->style;
    const gboolean root = strcmp(node->name, "sqrt") == 0;
    if (strcmp(node->name, "if") == 0) {
        write_cases(to, node);
    } else if ((root && style->stacked) || strcmp(node->name, "abs") == 0) {
        const char *const *around = root ? style->root : style->absolute;
        put(to, around[0]);
        put_node(to, node->parts[0], TINKER_BINDS_COMPARISON);
        put(to, around[1]);
    } else {
        if (root)
            put(to, style->root[0]);
        else
            style->function(to->text, node->name);
        put_bracket(to, node, TRUE);
        for (int i = 0; i < node->count; i++) {
            if (i > 0) put(to, style->comma);
            put_node(to, node->parts[i], TINKER_BINDS_COMPARISON);
        }
        put_bracket(to, node, FALSE);
    }
}

static void write_inside(const Typesetter *to, const TinkerExpression *node)
{
    TinkerSymbolLook look = {0};
    switch (node->kind) {
    case TINKER_EXPRESSION_NUMBER:
        if (node->number < 0) put(to, to->style->sign);
        to->style->number(to->text, fabs(node->number));
        break;
    case TINKER_EXPRESSION_SYMBOL:
        to->look(node->name, &look, to->data);
        to->style->symbol(to->text, &look);
        break;
    case TINKER_EXPRESSION_SUM:
        write_sum(to, node);
        break;
    case TINKER_EXPRESSION_PRODUCT:
        write_product(to, node);
        break;
    case TINKER_EXPRESSION_NEGATIVE:
        put(to, to->style->sign);
        put_node(to, node->parts[0], TINKER_BINDS_PRODUCT);
        break;
    case TINKER_EXPRESSION_QUOTIENT:
        write_quotient(to, node);
        break;
    case TINKER_EXPRESSION_POWER:
        write_power(to, node);
        break;
    case TINKER_EXPRESSION_COMPARISON:
        put_node(to, node->parts[0], TINKER_BINDS_SUM);
        to->style->compare(to->text, node->name);
        put_node(to, node->parts[1], TINKER_BINDS_SUM);
        break;
    case TINKER_EXPRESSION_FUNCTION:
        write_function(to, node);
        break;
    }
}

static void put_node(const Typesetter *to, const TinkerExpression *node, TinkerBinding least)
{
    const gboolean brackets = binding_of(node, to->style) < least;
    put(to, to->style->group[0]);
    if (brackets) put_bracket(to, node, TRUE);
    write_inside(to, node);
    if (brackets) put_bracket(to, node, FALSE);
    put(to, to->style->group[1]);
}

static const TinkerTypesetStyle *style_of(TinkerTypesetFormat format)
{
    static const TinkerTypesetStyle *const styles[] = {&tinker_text_style, &tinker_latex_style, &tinker_mathml_style};
    return format == TINKER_TYPESET_SPEECH ? tinker_speech_style() : styles[format];
}

static char *finish(const Typesetter *to, TinkerTypesetFormat format)
{
    if (format == TINKER_TYPESET_SPEECH) tinker_speech_tidy(to->text);
    return g_string_free(to->text, FALSE);
}

char *tinker_expression_typeset(const TinkerExpression *expression, TinkerTypesetFormat format, TinkerLookFunc look,
                                void *data)
{
    const Typesetter to = {g_string_new(NULL), style_of(format), look, data};
    put_node(&to, expression, TINKER_BINDS_COMPARISON);
    return finish(&to, format);
}

char *tinker_expression_typeset_factor(const TinkerExpression *expression, TinkerTypesetFormat format,
                                       TinkerLookFunc look, void *data)
{
    const Typesetter to = {g_string_new(NULL), style_of(format), look, data};
    put_node(&to, expression, TINKER_BINDS_PRODUCT);
    return finish(&to, format);
}

char *tinker_expression_typeset_term(const TinkerExpression *expression, gboolean first, TinkerTypesetFormat format,
                                     TinkerLookFunc look, void *data)
{
    const Typesetter to = {g_string_new(NULL), style_of(format), look, data};
    if (first)
        put_node(&to, expression, TINKER_BINDS_SIGN);
    else
        write_term(&to, expression);
    return finish(&to, format);
}

void tinker_symbol_typeset(GString *text, const TinkerSymbolLook *look, TinkerTypesetFormat format)
{
    style_of(format)->symbol(text, look);
}

static void look_again(G_GNUC_UNUSED const char *symbol, TinkerSymbolLook *look, void *data)
{
    *look = *(const TinkerSymbolLook *)data;
}

char *tinker_symbol_squared(const TinkerSymbolLook *look, TinkerTypesetFormat format)
{
    g_autoptr(TinkerExpression) square = tinker_expression_squared(tinker_expression_symbol(look->stem));
    return tinker_expression_typeset(square, format, look_again, (void *)look);
}

const char *tinker_typeset_sign(TinkerTypesetFormat format, char sign)
{
    const TinkerTypesetStyle *style = style_of(format);
    return sign == '+' ? style->plus : sign == '-' ? style->minus : style->times;
}
