/* A new scene: the template, with the settings that the user has chosen. No widget. */
#ifndef TINKER_GUI_NEW_SCENE_H
#define TINKER_GUI_NEW_SCENE_H

#include "gui/document/document.h"
#include "units/quantity/units.h"

typedef struct {
    TinkerUnitSystem units;
    double width; /* m: of the canvas */
} TinkerNewScene;

/* What the dialog begins with: a round width in either system, as text with its unit. Static. */
const char *tinker_new_scene_default_width(TinkerUnitSystem units);

/* Reads a width; a plain number is in the system's own unit. Errors say what would be right. */
gboolean tinker_new_scene_parse_width(const char *text, TinkerUnitSystem units, double *width, GError **error);

/* Starts the document anew. */
gboolean tinker_new_scene_start(TinkerDocument *document, const TinkerNewScene *settings, GError **error);

#endif
