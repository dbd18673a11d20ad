/* Nothing is known here of how long the run is: what lies beyond it is empty. */
#include "gui/document/time-span.h"

#include <string.h>

struct _TinkerTimeSpan {
    GObject parent_instance;
    gboolean is_set;
    double range[2];
};

G_DEFINE_FINAL_TYPE(TinkerTimeSpan, tinker_time_span, G_TYPE_OBJECT)

static guint changed;

gboolean tinker_time_span_get(TinkerTimeSpan *span, double range[2])
{
    memcpy(range, span->range, sizeof span->range);
    return span->is_set;
}

void tinker_time_span_set(TinkerTimeSpan *span, const double *range)
{
    if (range == NULL && !span->is_set) return;
    span->is_set = range != NULL;
    if (range != NULL) memcpy(span->range, range, sizeof span->range);
    g_signal_emit(span, changed, 0);
}

static void tinker_time_span_class_init(TinkerTimeSpanClass *class)
{
    changed = g_signal_new("changed", TINKER_TYPE_TIME_SPAN, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_time_span_init(TinkerTimeSpan *span) {}

TinkerTimeSpan *tinker_time_span_new(void)
{
    return g_object_new(TINKER_TYPE_TIME_SPAN, NULL);
}
