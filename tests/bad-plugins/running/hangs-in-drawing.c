/* Never comes back from drawing. */
#include <unistd.h>

#include "exhibit.h"

static volatile int forever = 1;

static void misbehave(const TinkerBatch *batch, double *force) {}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    if (write(STDOUT_FILENO, "hangs\n", 6) != 6) abort();
    while (forever)
        ;
}

static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .force_element = &exhibit_element};
static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw};
static const TinkerInterface exhibit_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &physics},
                                                     {TINKER_RENDER_INTERFACE, &render}};

EXHIBIT_OF_INTERFACES("hangs-in-drawing")
