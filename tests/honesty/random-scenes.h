/* Random scenes of every kind of motion, drawn from a seed. */
#ifndef TEST_RANDOM_SCENES_H
#define TEST_RANDOM_SCENES_H

#include <glib.h>

/* One island: bodies m0, m1, ..., and anchors A0, A1, ... that something is attached to. */
typedef struct {
    char *text; /* the scene file */
    int bodies, anchors;
    double duration; /* s */
    double rate;     /* 1/s: above the fastest frequency and decay, for methods of fixed step */
} RandomScene;

/* What kinds there are, ended by NULL. */
extern const char *const random_scene_kinds[];

/* A scene of the kind with this number: the same for the same seed. (transfer full) */
RandomScene *random_scene_new(guint kind, guint32 seed);
void random_scene_free(RandomScene *scene);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(RandomScene, random_scene_free)

#endif
