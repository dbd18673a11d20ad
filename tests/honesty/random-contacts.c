/* Motions with contacts. */
#include "random-draft.h"

#include <math.h>

static void write_thrown(RandomDraft *draft, double restitution, double friction)
{
    draft_add_gravity(draft);
    draft_add_floor(draft, "F", 0, 0, draft_happens(draft, 0.5) ? 0 : draft_between(draft, -0.4, 0.4), 60, restitution,
                    friction);
    double vy = draft_between(draft, -2, 4), vx = draft_between(draft, -4, 4), y = draft_between(draft, 0.2, 3);
    draft_add_some_mass(draft, 0.3, 3, 0, y, vx, vy);
}

void draft_write_landing(RandomDraft *draft)
{
    write_thrown(draft, 0, draft_some_friction(draft));
}

void draft_write_bouncing(RandomDraft *draft)
{
    double friction = draft_some_friction(draft);
    write_thrown(draft, draft_between(draft, 0.2, 0.95), friction);
}

void draft_write_elastic(RandomDraft *draft)
{
    write_thrown(draft, 1, draft_happens(draft, 0.7) ? 0 : draft_between(draft, 0.05, 0.5));
}

void draft_write_incline(RandomDraft *draft)
{
    double angle = draft_between(draft, -0.7, 0.7), from = draft_between(draft, -1, 1),
           speed = draft_between(draft, -4, 4);
    draft_add_gravity(draft);
    draft_add_floor(draft, "F", 0, 0, angle, 60, 0, draft_some_friction(draft));
    draft_add_mass(draft, draft_about(draft, 0.3, 3), from * cos(angle), from * sin(angle), speed * cos(angle),
                   speed * sin(angle));
    if (draft_happens(draft, 0.3)) return;
    draft_add_anchor(draft, 3 * cos(angle), 3 * sin(angle));
    draft_add_spring(draft, "m0", "A0", draft_about(draft, 5, 300), 0.3);
}

void draft_write_wedge(RandomDraft *draft)
{
    double restitution = draft_happens(draft, 0.35) ? 1 : draft_some_restitution(draft),
           friction = draft_some_friction(draft);
    draft_add_gravity(draft);
    draft_add_floor(draft, "F0", -2, 2, draft_between(draft, -1.1, -0.3), 8, restitution, friction);
    draft_add_floor(draft, "F1", 2, 2, draft_between(draft, 0.3, 1.1), 8, restitution, friction);
    double vx = draft_between(draft, -1, 1), y = draft_between(draft, 3, 5), x = draft_between(draft, -1, 1);
    draft_add_some_mass(draft, 0.3, 3, x, y, vx, 0);
}

void draft_write_springs_over_floor(RandomDraft *draft)
{
    draft_add_gravity(draft);
    double friction = draft_some_friction(draft), restitution = draft_some_restitution(draft);
    draft_add_floor(draft, "F", 0, 0, draft_happens(draft, 0.6) ? 0 : draft_between(draft, -0.3, 0.3), 60, restitution,
                    friction);
    double x = draft_between(draft, -0.5, 0.5), height = draft_between(draft, 0.7, 2);
    draft_add_some_mass(draft, 0.3, 2, 0, height, draft_happens(draft, 0.5) ? 0 : draft_between(draft, -2, 2), 0);
    if (draft_happens(draft, 0.5)) {
        draft_add_some_mass(draft, 0.3, 2, x, height + 1, 0, draft_between(draft, -2, 0));
        draft_add_spring(draft, "m0", "m1", draft_about(draft, 20, 1000), 0.3);
        if (draft_happens(draft, 0.5)) draft_add_damper(draft, "m0", "m1", draft_about(draft, 0.1, 5), 0.3);
    } else {
        draft_add_anchor(draft, draft_happens(draft, 0.5) ? 0 : x, height + 2);
        double rest = draft_between(draft, 1.5, 4);
        draft_add_tense_spring(draft, "m0", "A0", draft_about(draft, 5, 200), 0.3, rest);
    }
}

void draft_write_rods_onto_floor(RandomDraft *draft)
{
    int count = g_rand_int_range(draft->dice, 2, 4);
    draft_add_gravity(draft);
    double friction = draft_some_friction(draft), restitution = draft_some_restitution(draft);
    draft_add_floor(draft, "F", 0, 0, draft_happens(draft, 0.6) ? 0 : draft_between(draft, -0.3, 0.3), 60, restitution,
                    friction);
    for (int i = 0; i < count; i++) {
        double vx = draft_between(draft, -1, 1), y = draft_between(draft, 0.8, 1.6);
        draft_add_some_mass(draft, 0.3, 2, i, y, vx, 0);
    }
    for (int i = 1; i < count; i++)
        draft_add_rod(draft, draft_masses[i - 1], draft_masses[i]);
    draft_is_as_fast_as(draft, 30);
}

void draft_write_pendulum_onto_floor(RandomDraft *draft)
{
    draft_add_gravity(draft);
    draft_add_chain(draft, g_rand_int_range(draft->dice, 1, 3), 0.7, 1.7);
    double friction = draft_some_friction(draft), restitution = draft_some_restitution(draft);
    draft_add_floor(draft, "F", 0, draft_between(draft, -1.2, -0.2), 0, 60, restitution, friction);
}

void draft_write_moving_floor(RandomDraft *draft)
{
    double friction = draft_some_friction(draft);
    write_thrown(draft, draft_some_restitution(draft), friction);
    double frequency = draft_about(draft, 1, 15), amplitude = draft_about(draft, 0.02, 0.2);
    draft_add_support_motion(draft, "F", draft_happens(draft, 0.6) ? G_PI / 2 : draft_between(draft, -3, 3), amplitude,
                             frequency);
}

/* What sticks and slips: a block on a floor that moves along, held by a spring. */
void draft_write_stick_slip(RandomDraft *draft)
{
    draft_add_gravity(draft);
    draft_add_floor(draft, "F", 0, 0, 0, 60, 0, draft_between(draft, 0.1, 0.7));
    draft_add_some_mass(draft, 0.3, 2, 0, 0, draft_between(draft, -2, 2), 0);
    double y = draft_happens(draft, 0.5) ? 0 : 0.3;
    draft_add_anchor(draft, draft_between(draft, 1, 3), y);
    draft_add_spring(draft, "m0", "A0", draft_about(draft, 10, 200), 0.3);
    double frequency = draft_about(draft, 1, 10);
    draft_add_support_motion(draft, "F", 0, draft_about(draft, 0.05, 0.6), frequency);
}

void draft_write_wind_over_floor(RandomDraft *draft)
{
    double friction = draft_some_friction(draft);
    write_thrown(draft, draft_some_restitution(draft), friction);
    draft_add_wind(draft);
}

void draft_write_motor_on_floor(RandomDraft *draft)
{
    draft_add_gravity(draft);
    double friction = draft_some_friction(draft);
    draft_add_floor(draft, "F", 0, 0, 0, 100, draft_some_restitution(draft), friction);
    draft_add_some_mass(draft, 0.5, 2, 0, draft_happens(draft, 0.4) ? 0 : draft_between(draft, 0.1, 1), 0, 0);
    draft_add_motor(draft, "m0", draft_happens(draft, 0.7) ? 0 : draft_between(draft, -3, 3));
}
