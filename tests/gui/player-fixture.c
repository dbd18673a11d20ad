#include "player-fixture.h"

#include <math.h>

static void on_rewound(PlayerFixture *fixture)
{
    fixture->rewound++;
}

static void on_failed(TinkerPlayer *player, const char *message, PlayerFixture *fixture)
{
    fixture->failed++;
}

PlayerFixture *player_fixture_new(const char *members)
{
    PlayerFixture *fixture = g_new0(PlayerFixture, 1);
    fixture->base = gui_fixture_new("");
    fixture->document = fixture->base->document;
    fixture->player = fixture->base->player;
    gui_fixture_start_scene(fixture->base, members);
    g_signal_connect_swapped(fixture->player, "rewound", G_CALLBACK(on_rewound), fixture);
    g_signal_connect(fixture->player, "failed", G_CALLBACK(on_failed), fixture);
    return fixture;
}

void player_fixture_free(PlayerFixture *fixture)
{
    gui_fixture_free(fixture->base);
    g_free(fixture);
}

void player_play(PlayerFixture *fixture)
{
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    tinker_player_play(fixture->player, &culprit, &error);
    g_assert_no_error(error);
}

void player_wait_until(PlayerFixture *fixture, double time)
{
    g_autoptr(GError) error = NULL;
    tinker_player_wait(fixture->player, time, &error);
    g_assert_no_error(error);
}

double player_height(PlayerFixture *fixture)
{
    double x, y, orientation;
    tinker_frame_centre(tinker_player_frame(fixture->player), gui_fixture_block(fixture->base, "M"), &x, &y,
                        &orientation);
    return y;
}

TinkerQuantity player_quantity(PlayerFixture *fixture, const char *id)
{
    TinkerBlockId block = gui_fixture_block(fixture->base, "M");
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_document_scene(fixture->document), block);
    return (TinkerQuantity){block, tinker_block_class_quantity(block_class, id)};
}

void player_assert_close(double value, double expected, double tolerance)
{
    if (fabs(value - expected) > tolerance) g_test_message("%.12g is not %.12g", value, expected);
    g_assert_cmpfloat(fabs(value - expected), <=, tolerance);
}
