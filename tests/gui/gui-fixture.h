/* What the tests of the window's logic share: a document of these blocks with its player, without a display. */
#ifndef TEST_GUI_FIXTURE_H
#define TEST_GUI_FIXTURE_H

#include "gui/document/player.h"
#include "scene-fixture.h"

typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    gboolean trims; /* the property list leaves out zeros behind the last digit that counts; FALSE at first */
} GuiFixture;

/* Blocks alone, with ' in place of ". (transfer full) */
GuiFixture *gui_fixture_new(const char *blocks);
void gui_fixture_free(GuiFixture *fixture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(GuiFixture, gui_fixture_free)

/* Another scene in the same document: of these blocks, or of these members, likewise with '. */
void gui_fixture_start(GuiFixture *fixture, const char *blocks);
void gui_fixture_start_scene(GuiFixture *fixture, const char *members);

/* The scene as it would be saved, in SI units. (transfer full) */
char *gui_fixture_text(GuiFixture *fixture);

TinkerBlockId gui_fixture_block(GuiFixture *fixture, const char *name);

/* A component of the property with a meaning. */
double gui_fixture_get(GuiFixture *fixture, const char *name, int32_t meaning, int32_t component);

/* Sets a property in a step of its own, as an entry of the panel does. */
void gui_fixture_set(GuiFixture *fixture, const char *name, const char *property, double x, double y);

/* Lets the main loop run until `is_so`, for 10 s at most; answers whether it came to be. */
gboolean gui_fixture_wait(gboolean (*is_so)(void *data), void *data);
/* Lets it run for as long. */
void gui_fixture_pass(guint milliseconds);

#endif
