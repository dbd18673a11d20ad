/* The card of a scene: what it is called and about, what of it is modelled and what is left out, to be read. */
#ifndef TINKER_GUI_SCENE_CARD_H
#define TINKER_GUI_SCENE_CARD_H

#include <gtk/gtk.h>

#include "gui/document/plan-task.h"

#define TINKER_TYPE_SCENE_CARD (tinker_scene_card_get_type())
G_DECLARE_FINAL_TYPE(TinkerSceneCard, tinker_scene_card, TINKER, SCENE_CARD, GtkWidget)

/* Takes a reference of each. */
GtkWidget *tinker_scene_card_new(TinkerDocument *document, TinkerPlanTask *plan);

#endif
