/* declaration: what a person reads and writes, beyond what the host insists on when it opens the library. */
#include <string.h>

#include "conformance/probe/kit.h"

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

/* In a law, and in the equations of a scene, one that is declared twice would mean two things. */
static void look_at_symbols(KitCheck *check)
{
    const TinkerBlockClass *c = check->block_class;
    for (int32_t i = 0; i < c->property_count; i++)
        for (int32_t k = 0; k < i; k++)
            if (!is_missing(c->properties[i].symbol) &&
                g_strcmp0(c->properties[i].symbol, c->properties[k].symbol) == 0)
                kit_fail(check, "properties \"%s\" and \"%s\" both have the symbol \"%s\"", c->properties[k].id,
                         c->properties[i].id, c->properties[i].symbol);
}

/* Ids -------------------------------------------------------------------------------------------------------------- */

/* A stable name: words of small letters and digits, the first of them a letter, between single dashes, underscores or
 * dots. */
static gboolean is_plain_id(const char *id)
{
    return g_regex_match_simple("^[a-z][a-z0-9]*([-_.][a-z0-9]+)*$", id, G_REGEX_DOLLAR_ENDONLY, 0);
}

/* (transfer full) */
static char *plain_id(const char *id, char joint)
{
    GString *plain = g_string_new(NULL);
    for (const char *p = id; *p != '\0'; p++) {
        if (g_ascii_isalpha(*p) || (plain->len > 0 && g_ascii_isdigit(*p)))
            g_string_append_c(plain, g_ascii_tolower(*p));
        else if (plain->len > 0 && plain->str[plain->len - 1] != joint)
            g_string_append_c(plain, joint);
    }
    if (plain->len > 0 && plain->str[plain->len - 1] == joint) g_string_truncate(plain, plain->len - 1);
    return g_string_free(plain, FALSE);
}

void kit_look_at_id(KitCheck *check, const char *whose, const char *id, char joint)
{
    if (is_plain_id(id)) return;
    g_autofree char *better = plain_id(id, joint);
    kit_fail(check,
             "%s id \"%s\" is not of small letters and digits, with single dashes, underscores or dots between; "
             "\"%s\" would be",
             whose, id, better[0] != '\0' ? better : "name");
}

/* Of a library: what plugin.h says of its id and version. */
void kit_try_library_declaration(KitCheck *check)
{
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(check->catalogue);
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        if (g_strcmp0(library->path, check->path) != 0) continue;
        const char *id = library->id != NULL ? library->id : "", *version = library->version;
        if (!g_regex_match_simple("^[A-Za-z0-9_-]+([.][A-Za-z0-9_-]+)+$", id, G_REGEX_DOLLAR_ENDONLY, 0))
            kit_fail(check, "the plugin's id is \"%s\"; a reversed domain was expected, as \"org.example.my-plugin\"",
                     id);
        if (version == NULL || !g_regex_match_simple("^[0-9]+[.][0-9]+[.][0-9]+(-[0-9A-Za-z.-]+)?([+][0-9A-Za-z.-]+)?$",
                                                     version, G_REGEX_DOLLAR_ENDONLY, 0))
            kit_fail(check, "the plugin's version is \"%s\"; three numbers were expected, as \"1.0.0\"",
                     version != NULL ? version : "");
    }
}

void kit_try_declaration(KitCheck *check)
{
    const TinkerBlockClass *c = check->block_class;
    kit_look_at_id(check, "its", c->type->id, '-');
    for (int32_t i = 0; i < c->property_count; i++)
        kit_look_at_id(check, "a property's", c->properties[i].id, '_');
    if (is_missing(c->type->summary)) kit_fail(check, "it has no summary");
    for (int32_t i = 0; i < c->property_count; i++)
        look_at_property(check, &c->properties[i]);
    look_at_titles(check);
    look_at_symbols(check);
}
