/* The tail of a test block with one physics role: `role_` is its member of TinkerPhysics. */
#ifndef TEST_PHYSICS_BLOCK_H
#define TEST_PHYSICS_BLOCK_H

#include <tinker/sdk.h>

#define TEST_BLOCK(id_, title_, category_, least_, most_, accepts_, role_)                                             \
    static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), role_};                                \
    static const TinkerInterface interfaces[] = {{TINKER_PHYSICS_INTERFACE, &physics}};                                \
    static const TinkerBlockType blocks[] = {                                                                          \
        {TINKER_BLOCK(id_, title_, category_), .summary = "A block for tests", .least_ends = (least_),                 \
         .most_ends = (most_), .end_accepts = (accepts_), .properties = TINKER_SPAN(properties),                       \
         .interfaces = TINKER_SPAN(interfaces)},                                                                       \
    };                                                                                                                 \
    TINKER_DEFINE_PLUGIN("org.example.test." id_, title_, "1.0.0", "MIT", blocks)

#define TEST_ANY (TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT)

#endif
