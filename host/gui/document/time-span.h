/* The stretch of time that graphs over time show: all of them the same, so that what stands above each other belongs
 * together. Signal: "changed". No widget. */
#ifndef TINKER_GUI_TIME_SPAN_H
#define TINKER_GUI_TIME_SPAN_H

#include <glib-object.h>

#define TINKER_TYPE_TIME_SPAN (tinker_time_span_get_type())
G_DECLARE_FINAL_TYPE(TinkerTimeSpan, tinker_time_span, TINKER, TIME_SPAN, GObject)

/* All of the time. (transfer full) */
TinkerTimeSpan *tinker_time_span_new(void);

/* From and to (s). FALSE where all is shown. */
gboolean tinker_time_span_get(TinkerTimeSpan *span, double range[2]);
/* NULL: all. */
void tinker_time_span_set(TinkerTimeSpan *span, const double *range);

#endif
