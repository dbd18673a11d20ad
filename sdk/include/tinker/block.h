/* Tinker SDK: what a block type declares as data.
 *
 * From this data the host builds the property panel, conversion of units, validation, undo, reading and writing of
 * scenes, help and `tinker plugins show`. The author of a block writes no user interface and no JSON.
 */
#ifndef TINKER_BLOCK_H
#define TINKER_BLOCK_H

#include "law.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Kinds of property. In brackets: how many columns of doubles an instance takes (see TinkerBatch). */
#define TINKER_KIND_REAL     0 /* [1] a number with a dimension */
#define TINKER_KIND_INTEGER  1 /* [1] a whole number */
#define TINKER_KIND_SWITCH   2 /* [1] 0 or 1; true or false in a scene */
#define TINKER_KIND_CHOICE   3 /* [1] the index of one of `choices`; its text in a scene */
#define TINKER_KIND_TEXT     4 /* [0] text, which physics never sees */
#define TINKER_KIND_VECTOR   5 /* [2] x and y */
#define TINKER_KIND_WAVEFORM 6 /* [3] a function of time: value, first and second derivative, kept up by the host */

/* When a property may change. */
#define TINKER_STRUCTURAL 0 /* changing it makes another model: the run starts anew */
#define TINKER_INITIAL    1 /* read once, at the start of a run */
#define TINKER_TUNABLE    2 /* may change while a run is paused */

/* What a property means to the host, so that nothing in it has to know a block by name. At most one property of a
 * type carries each meaning; TINKER_MEANING_NONE is the plugin's own affair. */
#define TINKER_MEANING_NONE             0
#define TINKER_MEANING_POSITION         1  /* vector, m: where the block's centre is placed */
#define TINKER_MEANING_VELOCITY         2  /* vector, m/s: start velocity */
#define TINKER_MEANING_ORIENTATION      3  /* rad, counter-clockwise */
#define TINKER_MEANING_MASS             4  /* kg */
#define TINKER_MEANING_INERTIA          5  /* kg m^2 about the centre */
#define TINKER_MEANING_ANGULAR_VELOCITY 6  /* rad/s at the start */
#define TINKER_MEANING_LOCAL_ORIGIN     7  /* vector, m: where the offset shown to the user is measured from */
#define TINKER_MEANING_WIDTH            8  /* m, along the block's own x axis */
#define TINKER_MEANING_HEIGHT           9  /* m, along its y axis */
#define TINKER_MEANING_SOLID            10 /* switch: whether others collide with it */
#define TINKER_MEANING_STATIC_FRICTION  11
#define TINKER_MEANING_DYNAMIC_FRICTION 12
#define TINKER_MEANING_RESTITUTION      13
#define TINKER_MEANING_LENGTH           14 /* m: the length that a connector keeps or tends to */
#define TINKER_MEANING_RADIUS           15 /* m: of a disc about the block's centre */
#define TINKER_MEANING_INSTANT          16 /* s: when in a run something happens; before 0: it has */
#define TINKER_MEANING_CENTRE_OF_MASS   17 /* vector, m: in the axes of the points of an outline */
#define TINKER_MEANING_COLLIDES         18 /* switch, of a point mass: whether it meets others and bodies that turn */
#define TINKER_MEANING_ROLLING_RESISTANCE                                                                              \
    19 /* m, of a disc: the moment that resists its rolling, at most, per normal force */
#define TINKER_MEANING_COUNT 20

/* Flags of a property. */
#define TINKER_HAS_MINIMUM    (1u << 0) /* hard_minimum counts */
#define TINKER_HAS_MAXIMUM    (1u << 1) /* hard_maximum counts */
#define TINKER_OPEN_MINIMUM   (1u << 2) /* the minimum itself is not allowed */
#define TINKER_OPEN_MAXIMUM   (1u << 3) /* the maximum itself is not allowed */
#define TINKER_HAS_SOFT_RANGE (1u << 4) /* soft_minimum and soft_maximum count: the range of a slider */
#define TINKER_READ_ONLY      (1u << 5) /* shown, never typed; not part of a scene */
#define TINKER_DERIVED        (1u << 6) /* its value is that of the quantity with the same id */
#define TINKER_DEFAULT_AS_PLACED                                                                                       \
    (1u << 7)                               /* left out: the length from end to end at t = 0, or of an                 \
                                               angle that from what the first end is on to what the                    \
                                               second is on; needs two ends.                                           \
                                               Of a property that means the radius:                                    \
                                               that of what the first end is on; a length                              \
                                               beside it is that of the tangent from                                   \
                                               there to the second end */
#define TINKER_DEFAULT_SAME_AS   (1u << 8)  /* left out, it equals the property that `default_from` names */
#define TINKER_DEFAULT_AS_SHAPED (1u << 9)  /* left out, a body works it out: TinkerBody.as_shaped (physics.h) */
#define TINKER_REQUIRED          (1u << 14) /* a scene gives it; the default is that of a new block */
#define TINKER_DEFAULT_NONE      (1u << 13) /* left out, it has no value: NaN in its column; of a real alone */
#define TINKER_TEXT_LAW          (1u << 10) /* a text in the grammar of expressions: see typed-law.h */
#define TINKER_TEXT_POINTS       (1u << 12) /* a text that is a list of points, "x y; x y; ..."; [[x, y], ...] in a scene */
#define TINKER_TEXT_QUANTITY     (1u << 11) /* a text that is a number with any unit, which laws name by its id */

/* A property. The window has a row for it, labelled by its title. A vector has two, labelled by its title and a
 * component's, "Centre X"; by the component's alone where that or the group has the title in it: "X Velocity", "Global
 * Position". */
typedef struct TinkerPropertyType {
    uint32_t struct_size;
    int32_t kind;              /* TINKER_KIND_... */
    const char *id;            /* stable name in small letters, "rest_length": the key in a scene */
    const char *title;         /* label of the row, "Undeformed Length" */
    const char *group;         /* heading it stands under, "Spring Properties" */
    const char *symbol;        /* as in its law, "k"; NULL where there is none */
    const char *description;   /* one sentence for the tooltip */
    TinkerDimension dimension; /* of a waveform: of its value */
    uint32_t flags;
    int32_t meaning;     /* TINKER_MEANING_... */
    int32_t variability; /* TINKER_STRUCTURAL, TINKER_INITIAL, TINKER_TUNABLE */
    int32_t panel;       /* -1: shown in its own block's panel; n >= 0: in that of the block at its end n */
    int32_t choice_count;
    const char *const *choices; /* of a choice: its texts */
    double default_value[2];    /* real, integer, switch, choice: [0]; vector: both */
    double hard_minimum, hard_maximum;
    double soft_minimum, soft_maximum;
    const char *default_text;        /* of a text; of a waveform its kind: "none", "sine", "cosine" */
    const char *default_from;        /* id of another property of the type, with TINKER_DEFAULT_SAME_AS */
    const char *component_titles[2]; /* of a vector: "X", "Y" */
    const char *amplitude;           /* of a waveform: ids of the properties that scale it, turn it and shift it: */
    const char *frequency;           /*   value = amplitude * sin(frequency * t + phase) or cos(...) */
    const char *phase;
} TinkerPropertyType;

/* Flags of a quantity. */
#define TINKER_RECORDED (1u << 0) /* among the columns of a record unless the user picks others */

/* Something that can be graphed and recorded. Its values come from the graph interface (graph.h). */
typedef struct TinkerQuantityType {
    uint32_t struct_size;
    uint32_t flags;
    const char *id;    /* stable name, "kinetic energy": used as "Mass 0.kinetic energy" */
    const char *title; /* name of the curve, "Y Position" */
    const char *description;
    TinkerDimension dimension;
    int32_t reserved;
} TinkerQuantityType;

/* Categories: where the palette shows a block. What the block does is said by its interfaces. `tinker plugins check`
 * asks of a force element of two or more ends that its forces sum to zero, unless it is of the category "force". */
#define TINKER_CONNECTABLE "connectable"
#define TINKER_CONNECTOR   "connector" /* acts between its ends */
#define TINKER_FORCE       "force"     /* acts on its ends from outside */
#define TINKER_MOTION      "motion"
#define TINKER_FIELD       "field"
#define TINKER_JOINT       "joint"   /* ties bodies together */
#define TINKER_ROPE        "rope"    /* ropes and wheels */
#define TINKER_MEASURE     "measure" /* acts on nothing: shows what others do */

/* What an end accepts. */
#define TINKER_ACCEPTS_BODY    (1u << 0) /* blocks that can move */
#define TINKER_ACCEPTS_SUPPORT (1u << 1) /* blocks whose place is a known function of time */

/* Flags of a block type. */
#define TINKER_LEAVES_PATH (1u << 0) /* the host remembers where its first end has been: TinkerInstance.path */
#define TINKER_HAS_SPAN    (1u << 1) /* ... and how far its first two ends have been apart: TinkerInstance.span */

typedef struct TinkerBlockType {
    uint32_t struct_size;
    int32_t schema_version; /* of the block's properties, starting at 1 */
    const char *id;         /* stable name in small letters: the "type" in a scene, "spring" */
    const char *title;      /* "Spring"; new blocks are called "Spring 0", "Spring 1", ... */
    const char *category;
    const char *summary; /* one sentence: what it is for */
    /* A PNG beside the library, for palettes, where it is fitted into 48 by 32 pixels (make it larger, for fine
     * screens); on whatever is behind, light or dark. NULL, or where it cannot be read: the block is drawn with its
     * default properties, a connector from left to right. */
    const char *icon_path;
    const char *help_link; /* NULL: none */
    int32_t least_ends;
    int32_t most_ends; /* -1: any number */
    uint32_t end_accepts;
    uint32_t flags;        /* TINKER_LEAVES_... */
    TinkerSpan properties; /* of TinkerPropertyType; their order fixes the columns */
    TinkerSpan quantities; /* of TinkerQuantityType */
    TinkerSpan interfaces; /* of TinkerInterface */
    TinkerSpan law;        /* of TinkerLawEquation (law.h): what its code works out, as data; none: not stated */
} TinkerBlockType;

/* The points of a property with TINKER_TEXT_POINTS, in SI; a text that cannot be read has none. */
typedef struct TinkerPointList {
    const double *points; /* x and y by turns */
    int32_t count;
    int32_t reserved;
} TinkerPointList;

/* Batches of instances ------------------------------------------------------------------------------------------- */

/* A range of the instances of one type. Every array of a call is indexed from 0 to count - 1 within the range.
 * A property's first column is the sum of the column counts of the properties declared before it.
 * Everything is borrowed for the length of the call. */
typedef struct TinkerBatch {
    uint32_t struct_size;
    int32_t first;                /* number of the range's first instance within the type, for messages only */
    int32_t count;                /* instances in the range */
    int32_t ends;                 /* ends of each instance; -1 where they differ: see end_offsets */
    const int32_t *end_offsets;   /* count + 1 entries where ends is -1, else NULL: instance i has the ends
                                     end_offsets[i] to end_offsets[i + 1] - 1 of the arrays of ends */
    const double *const *columns; /* columns[c][i]: column c of instance i, SI */
    void *scratch;                /* memory that `scratch_size` asked for, per type, zeroed before `prepare`; or NULL */
    double time;                  /* s */
    double origin[2];             /* m: positions of a physics call are relative to this point of the world, so that a
                                     scene far from the world's origin loses no digits */
    int32_t failed_instance;      /* set by the callee before it answers TINKER_FAILED, 0 to count - 1; it may be set
                                     before TINKER_RETRY_SMALLER, for where no step is small enough */
    int32_t law_count;            /* laws of each instance: the properties with TINKER_TEXT_LAW, in order */
    const char *failure;          /* likewise: static text, what is wrong and what would be right */
    const struct TinkerTypedLaw *const *laws; /* of instance i from i * law_count on; NULL: an empty text */
    const double *end_masses; /* kg: of a force element with a text of the kind TINKER_TEXT_LAW, in `force` and
                                 `energy`: the mass of what each end is on, INFINITY of a support, laid out as its
                                 ends; NULL elsewhere */
    /* Of roles that ask for angles (physics.h), in calls that have ends, and indexed as those are; else NULL. */
    const TinkerPose *poses;             /* how what each end is on is turned: a mass not at all */
    const TinkerPoint *placed;           /* the ends where the scene places them, at t = 0, ... */
    const TinkerPose *placed_poses;      /* ... and how what they are on is turned there */
    const int32_t *has_angle;            /* 0 where what the end is on has no angle, as a mass; else 1 */
    const double *const *placed_columns; /* the columns as they are at t = 0: waveforms are there at their start */
    double *angular; /* what the callee writes of angles, zeroed before the call: of a force element the torque (N m) on
                        what each end is on, counter-clockwise; of a constraint the third column of each end */
    const TinkerPointList *point_lists; /* of instance i from i * point_list_count on; NULL: there are none */
    int32_t point_list_count;           /* of each instance: the properties with TINKER_TEXT_POINTS, in order */
    int32_t reserved;
} TinkerBatch;

#ifdef __cplusplus
}
#endif
#endif
