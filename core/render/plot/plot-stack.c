/* Each plot in a strip of its own. */
#include "render/plot/plot-stack.h"

#include "render/draw/surface.h"

typedef struct {
    const TinkerStackedPlot *plots;
    int count;
} Stack;

static void draw_stack(cairo_t *cairo, double width, double height, gpointer data)
{
    const Stack *stack = data;
    double whole = 0, top = 0;
    for (int i = 0; i < stack->count; i++)
        whole += stack->plots[i].share;
    for (int i = 0; i < stack->count; i++) {
        double strip = height * stack->plots[i].share / whole;
        cairo_save(cairo);
        cairo_translate(cairo, 0, top);
        cairo_rectangle(cairo, 0, 0, width, strip);
        cairo_clip(cairo);
        tinker_plot_draw(cairo, &stack->plots[i].plot, width, strip);
        cairo_restore(cairo);
        top += strip;
    }
}

gboolean tinker_plot_stack_to_file(const TinkerStackedPlot *plots, int count, int width, int height, const char *path,
                                   GError **error)
{
    Stack stack = {plots, count};
    return tinker_surface_to_file(draw_stack, &stack, width, height, path, error);
}
