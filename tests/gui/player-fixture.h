/* What the tests of the player share: a mass of 1 kg on a spring of 25 N/m, which swings about its equilibrium with
 * 5 rad/s, and a player that counts what it says. */
#ifndef TEST_PLAYER_FIXTURE_H
#define TEST_PLAYER_FIXTURE_H

#include "gui-fixture.h"

#define OMEGA 5.0  /* rad/s */
#define CLOSE 1e-7 /* m: of tolerance 1e-9 */

/* Without gravity, let go 1 m below its rest at y = 2; a support 2 m above. */
#define OSCILLATOR "'run': {'duration': 4, 'interval': 0.01}, " OSCILLATOR_BLOCKS
#define OSCILLATOR_BLOCKS                                                                                              \
    "'blocks': ["                                                                                                      \
    "{'type': 'support', 'name': 'S', 'position': [0, 4], 'orientation': '180 deg'},"                                  \
    "{'type': 'mass', 'name': 'M', 'position': [0, 1]},"                                                               \
    "{'type': 'spring', 'name': 'K', 'ends': ['S', 'M'], 'stiffness': 25, 'rest_length': 2}]"

typedef struct {
    GuiFixture *base;
    TinkerDocument *document; /* of the base */
    TinkerPlayer *player;     /* of the base */
    int rewound, failed;      /* how often it said so */
} PlayerFixture;

/* Of a scene's members, with ' in place of ". (transfer full) */
PlayerFixture *player_fixture_new(const char *members);
void player_fixture_free(PlayerFixture *fixture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(PlayerFixture, player_fixture_free)

void player_play(PlayerFixture *fixture);
/* Until the run has reached a time (s). */
void player_wait_until(PlayerFixture *fixture, double time);

/* m: of the mass M, as it is shown. */
double player_height(PlayerFixture *fixture);
/* A quantity of the mass M. */
TinkerQuantity player_quantity(PlayerFixture *fixture, const char *id);

void player_assert_close(double value, double expected, double tolerance);

#endif
