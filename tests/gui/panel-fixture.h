/* What the tests of the property list share: blocks to look at, and a student who selects, reads and types. */
#ifndef TEST_PANEL_FIXTURE_H
#define TEST_PANEL_FIXTURE_H

#include "gui-fixture.h"
#include "gui/property/property-list.h"

#define ONE_MASS    "{'type': 'mass', 'name': 'Mass 0', 'position': [3.2, 2.4]}"
#define ONE_SUPPORT "{'type': 'support', 'name': 'Support 0', 'position': [0, 4]}"
#define ONE_SPRING  "{'type': 'spring', 'name': 'Spring 0', 'ends': ['Support 0', 'Mass 0']}"

void panel_select(GuiFixture *fixture, const char *name);
void panel_select_nothing(GuiFixture *fixture);
void panel_go_english(GuiFixture *fixture);

/* A column of a block by its property's id and component. */
double panel_stored(GuiFixture *fixture, const char *name, const char *id, int component);

/* NULL where there is no such row. (transfer full) */
TinkerPropertyRow *panel_find_row(GuiFixture *fixture, const char *group, const char *title);

void panel_assert_shown(GuiFixture *fixture, const char *group, const char *title, const char *text);
void panel_assert_sensitive(GuiFixture *fixture, const char *group, const char *title, gboolean sensitive);

/* Undo must lead back to the very text, and redo to the edited one. */
void panel_assert_undoes(GuiFixture *fixture, const char *before);

/* Types into a row, which must take it as one step for undo. */
void panel_type(GuiFixture *fixture, const char *group, const char *title, const char *text);
/* Takes the choice with this text. */
void panel_choose(GuiFixture *fixture, const char *group, const char *title, const char *text);

/* Types or chooses what a row must refuse: with a sentence that has these parts, and nothing else changed. */
void panel_assert_refused(GuiFixture *fixture, const char *group, const char *title, const char *text,
                          const char *const *parts);
#define PARTS(...) ((const char *const[]){__VA_ARGS__, NULL})

#endif
