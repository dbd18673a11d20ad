/* declaration: what a person reads, beyond what the host insists on when it opens the library. */
#include <string.h>

#include "conformance/kit-private.h"

static gboolean is_missing(const char *text)
{
    return text == NULL || text[0] == '\0';
}

static void look_at_property(KitCheck *check, const TinkerPropertyType *property)
{
    if (is_missing(property->description)) kit_fail(check, "property \"%s\" has no description", property->id);
    if (is_missing(property->group)) kit_fail(check, "property \"%s\" has no group to stand under", property->id);
    if (!(property->flags & TINKER_HAS_SOFT_RANGE)) return;
    if ((property->flags & TINKER_HAS_MINIMUM && property->soft_minimum < property->hard_minimum) ||
        (property->flags & TINKER_HAS_MAXIMUM && property->soft_maximum > property->hard_maximum))
        kit_fail(check, "property \"%s\": the slider's range %g to %g goes beyond the allowed one", property->id,
                 property->soft_minimum, property->soft_maximum);
}

/* Two rows of one group with one label cannot be told apart. */
static void look_at_titles(KitCheck *check)
{
    const TinkerBlockClass *c = check->block_class;
    for (int32_t i = 0; i < c->property_count; i++)
        for (int32_t k = 0; k < i; k++)
            if (strcmp(c->properties[i].title, c->properties[k].title) == 0 &&
                strcmp(c->properties[i].group, c->properties[k].group) == 0)
                kit_fail(check, "properties \"%s\" and \"%s\" both have the title \"%s\" in the group \"%s\"",
                         c->properties[k].id, c->properties[i].id, c->properties[i].title, c->properties[i].group);
    for (int32_t i = 0; i < c->quantity_count; i++) {
        if (is_missing(c->quantities[i].description))
            kit_fail(check, "quantity \"%s\" has no description", c->quantities[i].id);
        for (int32_t k = 0; k < i; k++)
            if (strcmp(c->quantities[i].title, c->quantities[k].title) == 0)
                kit_fail(check, "quantities \"%s\" and \"%s\" both have the title \"%s\"", c->quantities[k].id,
                         c->quantities[i].id, c->quantities[i].title);
    }
}

static gboolean is_letter(gunichar c)
{
    return g_unichar_isalnum(c) || c == '_';
}

/* Whether the word appears by itself. */
static gboolean has_word(const char *text, const char *word)
{
    for (const char *at = strstr(text, word); at != NULL; at = strstr(at + 1, word)) {
        const char *before = at == text ? NULL : g_utf8_find_prev_char(text, at);
        const char *behind = at + strlen(word);
        if ((before == NULL || !is_letter(g_utf8_get_char(before))) && !is_letter(g_utf8_get_char(behind))) return TRUE;
    }
    return FALSE;
}

/* A formula speaks of what can be set; a symbol that is no part of it may belong to the drawing or to contacts. One that is
 * declared twice means two things. */
static void look_at_formula(KitCheck *check)
{
    const TinkerBlockClass *c = check->block_class;
    gboolean any = FALSE;
    int32_t with_symbol = 0;
    for (int32_t i = 0; i < c->property_count; i++) {
        const char *symbol = c->properties[i].symbol;
        if (is_missing(symbol)) continue;
        with_symbol++;
        any = any || (c->type->formula != NULL && has_word(c->type->formula, symbol));
        for (int32_t k = 0; k < i; k++)
            if (g_strcmp0(symbol, c->properties[k].symbol) == 0)
                kit_fail(check, "properties \"%s\" and \"%s\" both have the symbol \"%s\"", c->properties[k].id,
                         c->properties[i].id, symbol);
    }
    if (c->type->formula != NULL && with_symbol > 0 && !any)
        kit_fail(check, "no symbol of a property appears in the formula \"%s\"", c->type->formula);
}

void kit_try_declaration(KitCheck *check)
{
    const TinkerBlockClass *c = check->block_class;
    if (is_missing(c->type->summary)) kit_fail(check, "it has no summary");
    for (int32_t i = 0; i < c->property_count; i++)
        look_at_property(check, &c->properties[i]);
    look_at_titles(check);
    look_at_formula(check);
}
