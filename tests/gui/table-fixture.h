/* A scene in a folder of its own, edited as the property panel does; what tests of tables as waveforms share. */
#ifndef TEST_TABLE_FIXTURE_H
#define TEST_TABLE_FIXTURE_H

#include "files-fixture.h"
#include "gui/property/property-list.h"

/* Linear: 1 at 0.5 s, 4 at 2 s. Its second column is 2 throughout. */
#define RECORD "time,force,push\n0,0,2\n1,2,2\n3,6,2\n"

#define MOTOR(waveform)                                                                                                \
    "{\"tinker\": 1, \"blocks\": [\n{\"type\": \"mass\", \"name\": \"M\"},\n"                                          \
    "{\"type\": \"motor\", \"name\": \"F\", \"ends\": [\"M\"]" waveform "}]}"
#define SUPPORT "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"S\"}]}"

typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    char *folder;
} TablePanel;

/* The scene in a folder of its own, with this text as record.csv in it (NULL: none), and the block selected. */
TablePanel table_panel_with(const char *scene, const char *record, const char *selected);
void table_panel_clear(TablePanel *panel);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TablePanel, table_panel_clear)

/* NULL where there is none. (transfer full) */
TinkerPropertyRow *table_panel_find_row(TablePanel *panel, const char *group, const char *title);
void table_panel_assert_shown(TablePanel *panel, const char *group, const char *title, const char *text);
void table_panel_assert_absent(TablePanel *panel, const char *group, const char *title);

/* As it would be saved. (transfer full) */
char *table_panel_scene_text(TablePanel *panel);

/* Of the scene as it is once it has been saved and opened again: what the block's waveform is at t. */
double table_panel_reopened_value(TablePanel *panel, const char *name, double t);

/* As its row does it; nothing may be wrong. */
void table_panel_choose_file(TablePanel *panel, const char *group, const char *path);
void table_panel_set(TablePanel *panel, const char *group, const char *title, const char *text);

/* The names in the scene's folder, sorted, with blanks between them. (transfer full) */
char *table_panel_names_in_folder(TablePanel *panel);
void table_panel_assert_names(TablePanel *panel, const char *names);

#endif
