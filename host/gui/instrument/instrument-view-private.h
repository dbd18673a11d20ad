/* What the files of a view share. */
#ifndef TINKER_GUI_INSTRUMENT_VIEW_PRIVATE_H
#define TINKER_GUI_INSTRUMENT_VIEW_PRIVATE_H

#include "gui/instrument/instrument-view.h"

struct _TinkerInstrumentView {
    GtkWidget parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerHand *hand; /* borrowed */
    int number;
    TinkerSceneInstrument *shown; /* as it was when the parts were made */
    double per_si;                /* what is shown of 1 in SI */
    const char *unit;
    gboolean showing; /* changes of the parts are ours */
    GtkAdjustment *adjustment;
    GtkWidget *bar, *title, *part, *value, *note;
    gint64 told; /* us: when a value was told last, */
    char *told_text;

    /* Of a meter: the range of what has been recorded. */
    guint generation;
    TinkerSeriesCursor cursor;
    double low, high;
};

/* What the scene has of it by now; NULL: it is gone. */
const TinkerSceneInstrument *instrument_view_instrument(TinkerInstrumentView *view);

/* Shows the present value; instrument-values.c. */
void instrument_view_show(TinkerInstrumentView *view);
/* Why there is no run; what else was changed; or how many runs a second there is time for, where these are so few that
 * one sees it. What is wrong with a number that was typed stays as long as that number does. */
void instrument_view_show_note(TinkerInstrumentView *view);

/* What turns it: handlers of its parts; instrument-turning.c. */
void instrument_view_on_value_changed(GtkAdjustment *adjustment, TinkerInstrumentView *view);
void instrument_view_on_switched(GtkSwitch *widget, GParamSpec *spec, TinkerInstrumentView *view);
/* The hand lets go where a button or a key is released; a controller of the whole view hears of it. */
void instrument_view_hear_release(TinkerInstrumentView *view);
/* Exactly that number, and the range is widened where it has to be: as a value entry asks for it. */
gboolean instrument_view_take_typed(const char *text, gpointer view);

/* Its menu, with keys; instrument-commands.c. */
void instrument_view_install_commands(GtkWidgetClass *widget_class);
void instrument_view_add_menu(TinkerInstrumentView *view);

#endif
