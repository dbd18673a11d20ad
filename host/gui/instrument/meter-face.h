/* The face of a meter: a dial with a hand, or a bar, over a range with round numbers. */
#ifndef TINKER_GUI_METER_FACE_H
#define TINKER_GUI_METER_FACE_H

#include <gtk/gtk.h>

#define TINKER_TYPE_METER_FACE (tinker_meter_face_get_type())
G_DECLARE_FINAL_TYPE(TinkerMeterFace, tinker_meter_face, TINKER, METER_FACE, GtkWidget)

/* (transfer floating) */
GtkWidget *tinker_meter_face_new(gboolean dial);

/* The range grows to round numbers about this one, and 0. */
void tinker_meter_face_set_range(TinkerMeterFace *face, double low, double high);
/* NAN: nothing is shown. */
void tinker_meter_face_set_value(TinkerMeterFace *face, double value);

#endif
