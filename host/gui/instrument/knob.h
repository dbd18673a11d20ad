/* A knob: a number of a range, turned by dragging up and down, by the wheel or by keys. */
#ifndef TINKER_GUI_KNOB_H
#define TINKER_GUI_KNOB_H

#include <gtk/gtk.h>

#define TINKER_TYPE_KNOB (tinker_knob_get_type())
G_DECLARE_FINAL_TYPE(TinkerKnob, tinker_knob, TINKER, KNOB, GtkWidget)

/* Takes a reference of the adjustment, whose value it shows and sets. (transfer floating) */
GtkWidget *tinker_knob_new(GtkAdjustment *adjustment);

#endif
