/* What the files of the window share. */
#ifndef TINKER_GUI_WINDOW_PARTS_H
#define TINKER_GUI_WINDOW_PARTS_H

#include "gui/accuracy/accuracy-page.h"
#include "gui/canvas/canvas.h"
#include "gui/document/autosave.h"
#include "gui/equation/equations-page.h"
#include "gui/film/film-task.h"
#include "gui/graph/graph-layer.h"
#include "gui/instrument/instrument-layer.h"
#include "gui/property/palette.h"
#include "gui/widget/notice-bar.h"
#include "gui/window/playbar.h"
#include "gui/window/status-line.h"
#include "gui/window/window.h"

struct _TinkerWindow {
    AdwApplicationWindow parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerAutosave *autosave;
    guint ticks;        /* id of the tick callback while it plays, or 0 */
    gint64 last_tick;   /* us; 0: none yet */
    gboolean may_close; /* the user has said so */

    /* Parts of window.ui. */
    TinkerCanvas *canvas;
    GtkWidget *header;
    GtkWidget *switcher; /* of the pages, in the header */
    TinkerPalette *palette;
    TinkerPlaybar *playbar;
    AdwToastOverlay *toasts;
    AdwWindowTitle *title;
    AdwViewStack *pages;
    GtkBox *panel;
    GtkBox *palette_side, *panel_side; /* what folds away */
    GtkWidget *side_panel;             /* what is in the right one */
    GtkWidget *properties;             /* the panel of properties */
    GtkWidget *equations;              /* the page of equations */
    GtkBox *dock;
    GtkBox *status;
    GtkBox *banners;
    GtkOverlay *canvas_overlay;
    TinkerGraphLayer *graph_layer;
    TinkerInstrumentLayer *instruments;
    TinkerAccuracyPage *accuracy;
    AdwSplitButton *open_button;
    GMenu *recent_menu;
    GMenu *examples_menu;

    /* Of window-accuracy.c. */
    TinkerPlanTask *plan;
    TinkerStatusLine *status_line;
    TinkerNoticeBar *notices; /* whoever has something to say tells it here, under a name of its own */
    guint refresh;            /* id of the timer, or 0 */
    gboolean told_look;       /* that where the run stops is looked for */
    double told_changed;      /* s: that a change counts from there on; NAN: none does */
    guint told_run;           /* which run's warnings are shown */

    /* Of window-film.c. */
    TinkerFilmTask *film;
    GtkWidget *film_bar, *film_cancel; /* NULL while there is none */
    GtkProgressBar *film_progress;     /* likewise */
};

/* Actions win.*; window-actions.c. */
void window_add_actions(TinkerWindow *window);
/* One that switches a property of an object. */
void window_add_switch(TinkerWindow *window, const char *name, gpointer object, const char *property);
/* Enables those that can do something now. */
void window_update_actions(TinkerWindow *window);

/* The status line, the notices and the page "Accuracy"; window-accuracy.c. */
void window_add_accuracy(TinkerWindow *window);
void window_remove_accuracy(TinkerWindow *window);

/* Films; window-film.c. Gets ready; asks what it is to be; whether another one can be asked for. */
void window_add_film(TinkerWindow *window);
void window_export_film(TinkerWindow *window);
gboolean window_can_export_film(TinkerWindow *window);

/* Pictures of the canvas, and printing; window-paper.c. */
void window_save_picture(TinkerWindow *window);
void window_print(TinkerWindow *window);

/* Full screen for a projector, with large type; window-present.c. */
void window_add_present(TinkerWindow *window);

/* A line that goes by itself. */
void window_toast(TinkerWindow *window, const char *text);
/* A message that has to be read. */
void window_message(TinkerWindow *window, const char *heading, const char *body);

/* Graphs, where they are shown and their commands; window-graphs.c. */
void window_add_graphs(TinkerWindow *window);

/* Ruler and protractor on the canvas; window-measure.c. */
void window_add_measuring(TinkerWindow *window);

/* Marks of a curve's extrema on the time line; window-extrema.c. To be removed before the document and the player. */
void window_add_extrema(TinkerWindow *window);
void window_remove_extrema(TinkerWindow *window);

/* Goes to where a graph can be chosen. */
void window_new_graph(TinkerWindow *window);
/* Keeps the present run to be compared with; those that are kept. */
void window_keep_run(TinkerWindow *window);
void window_kept_runs(TinkerWindow *window);
/* Appends what graphs the selected block can have, if it can have any. */
void window_append_graph_menu(TinkerWindow *window, GMenu *menu);
/* Controls and meters on the canvas; window-instruments.c. Shows them; appends which the selected block, or the scene,
 * can have. */
void window_add_instruments(TinkerWindow *window);
void window_append_instrument_menu(TinkerWindow *window, GMenu *menu);
void window_add_outline_actions(TinkerWindow *window);
void window_append_outline_menu(TinkerWindow *window, GMenu *menu);
/* How things start; window-start.c. Adds the advice and the action; the page of the panel (transfer floating); the
 * submenu for what is selected. */
void window_add_start(TinkerWindow *window);
GtkWidget *window_new_start_panel(TinkerWindow *window);
void window_add_start_menu(TinkerWindow *window, GMenu *menu);

/* Offers a joint where a body is dropped onto another; window-joints.c. */
void window_add_joints(TinkerWindow *window);

/* Saving; window-files.c. Each asks where something could be lost. */
void window_save(TinkerWindow *window, gboolean under_another_name);
/* Asks whether to save; then closes. */
void window_ask_to_close(TinkerWindow *window);

/* New and open; window-open.c. Each asks first about changes that are not saved. */
void window_choose_file(TinkerWindow *window);
/* The scene of a new window: as new ones are, without asking for their settings. */
void window_start_first(TinkerWindow *window);
/* The menu of recent and example scenes, and its actions. */
void window_add_open_menu(TinkerWindow *window);

/* Unsaved work is kept safe; window-recovery.c. */
void window_add_autosave(TinkerWindow *window);

/* Sizes and what is shown, from the last window and for the next one; window-state.c. */
void window_restore_state(TinkerWindow *window);
void window_store_state(TinkerWindow *window);

#endif
