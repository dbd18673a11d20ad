/* A bar for what the user should know and can do something about: one notice at a time, the gravest first, each with
 * its cure as a button. */
#ifndef TINKER_GUI_NOTICE_BAR_H
#define TINKER_GUI_NOTICE_BAR_H

#include <gtk/gtk.h>

typedef enum {
    TINKER_NOTICE_HINT,
    TINKER_NOTICE_WARNING,
    TINKER_NOTICE_ERROR,
} TinkerNoticeSeverity;

typedef struct {
    TinkerNoticeSeverity severity;
    char *text;               /* a sentence */
    char *button;             /* what the cure is called; NULL: there is none */
    void (*cure)(void *data); /* called when it is clicked */
    void *data;
    GDestroyNotify free_data; /* may be NULL */
    void (*locate)(
        void *data); /* called when the text is clicked: shows what it is about. NULL: it cannot be clicked */
} TinkerNotice;

/* Texts are copied; `data` is the notice's; `locate` may be set afterwards. (transfer full) */
TinkerNotice *tinker_notice_new(TinkerNoticeSeverity severity, const char *text, const char *button,
                                void (*cure)(void *data), void *data, GDestroyNotify free_data);
void tinker_notice_free(TinkerNotice *notice);

#define TINKER_TYPE_NOTICE_BAR (tinker_notice_bar_get_type())
/* Signal: "done", when a button of it was pressed: whoever had the focus before may want it back. */
G_DECLARE_FINAL_TYPE(TinkerNoticeBar, tinker_notice_bar, TINKER, NOTICE_BAR, GtkWidget)

TinkerNoticeBar *tinker_notice_bar_new(void);

/* Replaces what this source ("plan") has to say by these, of TinkerNotice * (transfer full; freed by
 * tinker_notice_free). A notice that the user has closed stays closed until its source stops giving it. One that
 * several give is shown once. */
void tinker_notice_bar_set(TinkerNoticeBar *bar, const char *source, GPtrArray *notices);

/* Tells how high (px) the picture is that the bar lies over. On a low one, notices are no more than three lines high;
 * the whole text is their tip. May be called while widgets get their places: what changes, changes afterwards. */
void tinker_notice_bar_set_room(TinkerNoticeBar *bar, int height);

#endif
