/* The height follows from the width: whether they are side by side, too. */
#include "gui/widget/beside.h"

#include "gui/widget/unparent.h"

#define GAP 6 /* px */

struct _TinkerBeside {
    GtkWidget parent_instance;
    GtkWidget *first, *second;
    int least; /* px */
};

G_DEFINE_FINAL_TYPE(TinkerBeside, tinker_beside, GTK_TYPE_WIDGET)

static int natural(GtkWidget *widget, GtkOrientation orientation, int for_size)
{
    int size;
    gtk_widget_measure(widget, orientation, for_size, NULL, &size, NULL, NULL);
    return size;
}

/* How wide the first one is beside the second; 0: it lies above it. */
static int width_beside(const TinkerBeside *beside, int width)
{
    const int second = natural(beside->second, GTK_ORIENTATION_HORIZONTAL, -1);
    const int left = second > 0 ? width - second - GAP : width;
    return left >= MIN(beside->least, natural(beside->first, GTK_ORIENTATION_HORIZONTAL, -1)) ? left : 0;
}

static void measure_width(const TinkerBeside *beside, int *minimum, int *wanted)
{
    int least[2], best[2];
    gtk_widget_measure(beside->first, GTK_ORIENTATION_HORIZONTAL, -1, &least[0], &best[0], NULL, NULL);
    gtk_widget_measure(beside->second, GTK_ORIENTATION_HORIZONTAL, -1, &least[1], &best[1], NULL, NULL);
    *minimum = MAX(least[0], least[1]);
    *wanted = best[0] + (best[1] > 0 ? best[1] + GAP : 0);
}

static int height_for(const TinkerBeside *beside, int width)
{
    const int first = width_beside(beside, width);
    const int above = natural(beside->first, GTK_ORIENTATION_VERTICAL, first > 0 ? first : width);
    const int second = natural(beside->second, GTK_ORIENTATION_VERTICAL, first > 0 ? -1 : width);
    return first > 0 ? MAX(above, second) : above + GAP + second;
}

static void measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum, int *wanted,
                    int *minimum_baseline, int *natural_baseline)
{
    const TinkerBeside *beside = TINKER_BESIDE(widget);
    measure_width(beside, minimum, wanted);
    if (orientation == GTK_ORIENTATION_VERTICAL)
        *minimum = *wanted = height_for(beside, for_size >= 0 ? for_size : *wanted);
}

static void allocate(GtkWidget *widget, int width, int height, int baseline)
{
    const TinkerBeside *beside = TINKER_BESIDE(widget);
    const gboolean mirrored = gtk_widget_get_direction(widget) == GTK_TEXT_DIR_RTL;
    const int left = width_beside(beside, width);
    const int first = left > 0 ? left : width;
    const int second = MIN(natural(beside->second, GTK_ORIENTATION_HORIZONTAL, -1), width);
    const int above = left > 0 ? height : natural(beside->first, GTK_ORIENTATION_VERTICAL, width);
    const int top = left > 0 ? 0 : MIN(above + GAP, height);
    const GtkAllocation of_first = {mirrored ? width - first : 0, 0, first, above};
    const GtkAllocation of_second = {mirrored ? 0 : width - second, top, second, height - top};
    gtk_widget_size_allocate(beside->first, &of_first, -1);
    gtk_widget_size_allocate(beside->second, &of_second, -1);
}

static GtkSizeRequestMode request_mode(GtkWidget *widget)
{
    return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

static void tinker_beside_dispose(GObject *object)
{
    tinker_unparent_children(GTK_WIDGET(object));
    G_OBJECT_CLASS(tinker_beside_parent_class)->dispose(object);
}

static void tinker_beside_class_init(TinkerBesideClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_beside_dispose;
    GTK_WIDGET_CLASS(class)->measure = measure;
    GTK_WIDGET_CLASS(class)->size_allocate = allocate;
    GTK_WIDGET_CLASS(class)->get_request_mode = request_mode;
}

static void tinker_beside_init(TinkerBeside *beside)
{
    beside->least = TINKER_BESIDE_LEAST;
}

GtkWidget *tinker_beside_new(GtkWidget *first, GtkWidget *second)
{
    TinkerBeside *beside = g_object_new(TINKER_TYPE_BESIDE, NULL);
    beside->first = first;
    beside->second = second;
    gtk_widget_set_parent(first, GTK_WIDGET(beside));
    gtk_widget_set_parent(second, GTK_WIDGET(beside));
    return GTK_WIDGET(beside);
}

void tinker_beside_set_least(TinkerBeside *beside, int least)
{
    beside->least = least;
    gtk_widget_queue_resize(GTK_WIDGET(beside));
}

void tinker_beside_wrap(GtkWidget *button)
{
    GtkLabel *label = GTK_LABEL(gtk_button_get_child(GTK_BUTTON(button)));
    gtk_label_set_wrap(label, TRUE);
    gtk_label_set_wrap_mode(label, PANGO_WRAP_WORD_CHAR);
    gtk_label_set_natural_wrap_mode(label, GTK_NATURAL_WRAP_NONE);
}
