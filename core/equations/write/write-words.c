/* The words that stand behind symbols: English in the tree and in JSON, and as the locale has them on a page. */
#include <glib/gi18n-lib.h>
#include <stdio.h>
#include <string.h>

#include "equations/write/page-private.h"

static const char *const words[] = {
    NC_("equations", "a connector is not linear"),
    NC_("equations", "a constraint holds it"),
    NC_("equations", "a force on it is not linear"),
    NC_("equations", "a torque on it is not linear"),
    NC_("equations", "a step of its law"),
    NC_("equations", "angle"),
    NC_("equations", "angle at the start"),
    NC_("equations", "arm from the centre of mass"),
    NC_("equations", "coefficient of friction of the two"),
    NC_("equations", "contact as impulses: its forces are the means of the last step"),
    NC_("equations", "damping"),
    NC_("equations", "direction across its edge"),
    NC_("equations", "direction at that end"),
    NC_("equations", "direction of sliding"),
    NC_("equations", "direction of the normal force"),
    NC_("equations", "displacement in x"),
    NC_("equations", "displacement in y"),
    NC_("equations", "distance between the ends"),
    NC_("equations", "distance of what touches"),
    NC_("equations", "force"),
    NC_("equations", "friction force"),
    NC_("equations", "from its centre to its corner"),
    NC_("equations", "from its centre to its edge"),
    NC_("equations", "from its joint to its centre of mass"),
    NC_("equations", "from joint to joint"),
    NC_("equations", "from joint to joint, across the way to its centre of mass"),
    NC_("equations", "it hangs on no rod from a support"),
    NC_("equations", "it has too many angles to be written out (24 can be)"),
    NC_("equations", "it has too many coordinates to be written out (256 can be, or 512 without dampers)"),
    NC_("equations", "it is linear in the plane, not along one line"),
    NC_("equations", "it is not linear, or not in a way that the plan knows"),
    NC_("equations", "it lies on something"),
    NC_("equations", "its acceleration"),
    NC_("equations", "its corner, in its own axes"),
    NC_("equations", "its force"),
    NC_("equations", "its law does not say what it does to its ends"),
    NC_("equations", "its plugin states no law"),
    NC_("equations", "its rods and pins are no tree of angles on one support"),
    NC_("equations", "its velocity"),
    NC_("equations", "its waveform is a table"),
    NC_("equations", "length along the ends"),
    NC_("equations", "lever of friction"),
    NC_("equations", "lever of the normal force"),
    NC_("equations", "minus its tension"),
    NC_("equations", "moment against rolling"),
    NC_("equations", "multiplier"),
    NC_("equations", "normal force"),
    NC_("equations", "place along its edge"),
    NC_("equations", "place along the other"),
    NC_("equations", "place along the other where it has not turned"),
    NC_("equations", "place along the top"),
    NC_("equations", "place along the top where it has not turned"),
    NC_("equations", "rate"),
    NC_("equations", "rate at which that grows"),
    NC_("equations", "something else than rods and pins holds it"),
    NC_("equations", "stiffness"),
    NC_("equations", "stored energy"),
    NC_("equations", "tension"),
    NC_("equations", "the moment that resists its rolling is a number here"),
    NC_("equations", "torque"),
    NC_("equations", "turned by"),
    NC_("equations", "velocity of that end"),
    NC_("equations", "vx"),
    NC_("equations", "vy"),
    NC_("equations", "what moves its support is not written"),
    NC_("equations", "where it touches, in the body's axes"),
    NC_("equations", "where its end is"),
    NC_("equations", "where its motion has it"),
    NC_("equations", "x at the start"),
    NC_("equations", "y at the start"),
};

/* What a plugin says, of its law or of a property, stands among the texts of descriptors. */
const char *tinker_page_words(const char *english)
{
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++)
        if (strcmp(words[i], english) == 0) return g_dpgettext2(GETTEXT_PACKAGE, "equations", english);
    return english[0] != '\0' ? g_dgettext(GETTEXT_PACKAGE, english) : english;
}

/* The label of a property in another language; NULL where there is none, or where it is a letter. Borrowed. */
static const char *translated_label(const TinkerBlockClass *block_class, const char *id)
{
    const int32_t property = block_class != NULL ? tinker_block_class_property(block_class, id) : -1;
    if (property < 0) return NULL;
    const char *title = block_class->properties[property].title, *translated = g_dgettext(GETTEXT_PACKAGE, title);
    return translated != title && g_utf8_strlen(title, -1) > 1 ? translated : NULL;
}

char *tinker_page_property_words(const TinkerEquations *equations, const TinkerEquationSymbol *symbol)
{
    int end;
    char axis;
    if (sscanf(symbol->property, "ends %d at %c", &end, &axis) == 2)
        return g_strdup_printf(C_("equations", "%c where its end %d is attached"), axis, end + 1);
    const char *gap = strchr(symbol->property, ' ');
    g_autofree char *id =
        gap != NULL ? g_strndup(symbol->property, (gsize)(gap - symbol->property)) : g_strdup(symbol->property);
    const char *label = translated_label(tinker_scene_block_class(equations->scene, symbol->block), id);
    return g_strconcat(label != NULL ? label : tinker_page_words(g_strdelimit(id, "_", ' ')), gap, NULL);
}
