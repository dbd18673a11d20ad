/* What is known of the bundled scenes in which bodies that turn touch supports, or turn on pins with friction. Each
 * check runs the scene at this path. */
#ifndef TEST_ROLLING_CASES_H
#define TEST_ROLLING_CASES_H

void check_rolling_race(const char *path);
void check_slipping_to_rolling(const char *path);
void check_rolling_resistance(const char *path);
void check_pin_friction(const char *path);
void check_tip_or_slide(const char *path);
void check_rocking_block(const char *path);
void check_ladder_on_wall(const char *path);
void check_newtons_cradle(const char *path);

#endif
