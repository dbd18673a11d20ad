/* What random scenes are written with: dice, blocks, and the writers of all kinds. */
#ifndef TEST_RANDOM_DRAFT_H
#define TEST_RANDOM_DRAFT_H

#include "random-scenes.h"

/* A scene that is being written. Dice are thrown in statements of their own, one in a call at most: in which order a
 * compiler works out several arguments is its own affair, and a seed is to give the same scene with any. */
typedef struct {
    GRand *dice;
    GString *blocks;
    RandomScene *scene;
} RandomDraft;

/* Names of bodies and anchors by their numbers. */
extern const char *const draft_masses[6], *const draft_anchors[4];

double draft_between(RandomDraft *draft, double low, double high);

/* Any order of magnitude is as likely as the others. */
double draft_about(RandomDraft *draft, double low, double high);

gboolean draft_happens(RandomDraft *draft, double probability);

void draft_is_as_fast_as(RandomDraft *draft, double rate);

/* Blocks are written with ' in place of ". */
void draft_add(RandomDraft *draft, const char *format, ...) G_GNUC_PRINTF(2, 3);

void draft_add_gravity(RandomDraft *draft);
void draft_add_anchor(RandomDraft *draft, double x, double y);
void draft_add_mass(RandomDraft *draft, double mass, double x, double y, double vx, double vy);
/* One whose mass is drawn. */
void draft_add_some_mass(RandomDraft *draft, double least, double most, double x, double y, double vx, double vy);
void draft_add_spring(RandomDraft *draft, const char *from, const char *to, double stiffness, double mass);
/* Under tension or pressure as it is placed. */
void draft_add_tense_spring(RandomDraft *draft, const char *from, const char *to, double stiffness, double mass,
                            double rest_length);
void draft_add_damper(RandomDraft *draft, const char *from, const char *to, double damping, double mass);
void draft_add_rod(RandomDraft *draft, const char *from, const char *to);
void draft_add_support_motion(RandomDraft *draft, const char *support, double angle, double amplitude,
                              double frequency);
void draft_add_motor(RandomDraft *draft, const char *mass, double angle);
void draft_add_wind(RandomDraft *draft);
/* A solid support whose top goes through (x, y). */
void draft_add_floor(RandomDraft *draft, const char *name, double x, double y, double angle, double width,
                     double restitution, double friction);
double draft_some_restitution(RandomDraft *draft);
double draft_some_friction(RandomDraft *draft);
/* Rods in a row from an anchor. */
void draft_add_chain(RandomDraft *draft, int count, double lowest, double highest);

/* Motions without contacts. */
void draft_write_straight(RandomDraft *draft);
void draft_write_passing(RandomDraft *draft);
void draft_write_plane(RandomDraft *draft);
void draft_write_pendulum(RandomDraft *draft);
void draft_write_linkage(RandomDraft *draft);
void draft_write_driven(RandomDraft *draft);
void draft_write_motors(RandomDraft *draft);
void draft_write_wind(RandomDraft *draft);
void draft_write_stiff(RandomDraft *draft);

/* Motions with contacts. */
void draft_write_landing(RandomDraft *draft);
void draft_write_bouncing(RandomDraft *draft);
void draft_write_elastic(RandomDraft *draft);
void draft_write_incline(RandomDraft *draft);
void draft_write_wedge(RandomDraft *draft);
void draft_write_springs_over_floor(RandomDraft *draft);
void draft_write_rods_onto_floor(RandomDraft *draft);
void draft_write_pendulum_onto_floor(RandomDraft *draft);
void draft_write_moving_floor(RandomDraft *draft);
void draft_write_stick_slip(RandomDraft *draft);
void draft_write_wind_over_floor(RandomDraft *draft);
void draft_write_motor_on_floor(RandomDraft *draft);

#endif
