/* What the exhibits have in common: a force element of one end whose force is 0 until t = 1 s, and then misbehaves. One
 * that defines EXHIBIT_FROM (s) misbehaves from then on. */
#ifndef TINKER_RUNNING_EXHIBIT_H
#define TINKER_RUNNING_EXHIBIT_H

#include <stdlib.h>
#include <tinker/sdk.h>

#ifndef EXHIBIT_FROM
#define EXHIBIT_FROM 1.0
#endif

/* What the exhibit shows, asked for the forces of `batch`. */
static void misbehave(const TinkerBatch *batch, double *force);

static TinkerStatus exhibit_force(TinkerBatch *batch, const TinkerPoint *ends, double *force)
{
    for (int32_t i = 0; i < 2 * batch->count; i++)
        force[i] = 0;
    if (batch->time > EXHIBIT_FROM) misbehave(batch, force);
    return TINKER_OK;
}

/* The block type and the plugin, from its physics. */
#define EXHIBIT_OF_PHYSICS(id_, ...)                                                                                   \
    static const TinkerPhysics exhibit_physics = {.struct_size = sizeof(TinkerPhysics), __VA_ARGS__};                  \
    static const TinkerInterface exhibit_interfaces[] = {{TINKER_PHYSICS_INTERFACE, &exhibit_physics}};                \
    EXHIBIT_OF_INTERFACES(id_)

/* From the array exhibit_interfaces. */
#define EXHIBIT_OF_INTERFACES(id_)                                                                                     \
    static const TinkerBlockType exhibit_blocks[] = {                                                                  \
        {TINKER_BLOCK(id_, "Exhibit", TINKER_FORCE), .summary = "Stands in a museum.", .least_ends = 1,                \
         .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .interfaces = TINKER_SPAN(exhibit_interfaces)},           \
    };                                                                                                                 \
    TINKER_DEFINE_PLUGIN("org.example." id_, "Exhibit", "1.0.0", "MIT", exhibit_blocks)

static const TinkerForceElement exhibit_element = {.struct_size = sizeof(TinkerForceElement), .force = exhibit_force};

#define RUNNING_EXHIBIT(id_) EXHIBIT_OF_PHYSICS(id_, .force_element = &exhibit_element)

#endif
