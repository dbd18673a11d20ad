/* What the files of the outline share. */
#ifndef TINKER_GUI_OUTLINE_PRIVATE_H
#define TINKER_GUI_OUTLINE_PRIVATE_H

#include "gui/canvas/outline.h"

#define OUTLINE_TYPE_ITEM (outline_item_get_type())
G_DECLARE_FINAL_TYPE(OutlineItem, outline_item, OUTLINE, ITEM, GObject)

struct _OutlineItem {
    GObject parent_instance;
    TinkerBlockId block;
    char *name;
    char *folded; /* name and title of the type, for the search */
};

/* (transfer full) */
OutlineItem *outline_item_new(TinkerScene *scene, TinkerBlockId block);

struct _TinkerOutline {
    GtkWidget parent_instance;
    TinkerDocument *document;
    GtkWidget *search, *list, *count;
    GListStore *items;
    GtkFilter *filter;
    GtkSelectionModel *selection;
    GHashTable *rows; /* GtkListItem that are shown */
    char *wanted;     /* what is searched for, folded; "" for everything */
    gboolean mirroring;
    TinkerPointed reached; /* what is pointed at from here */
    guint refresh;         /* id of the source that will refresh it, or 0 */
};

/* What makes rows of items. (transfer full) */
GtkListItemFactory *outline_row_factory(TinkerOutline *outline);
/* What a screen reader says of the rows that are shown, anew. */
void outline_describe_rows(TinkerOutline *outline);

/* A label at the left of a box, with a class of the style sheet (may be NULL). */
GtkWidget *outline_add_label(GtkWidget *box, const char *css_class);

#endif
