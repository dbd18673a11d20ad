/* What is known of the bundled scenes in which bodies that turn meet each other, or are held in by what they meet. Each
 * check runs the scene at this path. */
#ifndef TEST_MEETING_CASES_H
#define TEST_MEETING_CASES_H

void check_pulled_spool(const char *path);
void check_dominoes(const char *path);
void check_newtons_cradle_at_once(const char *path);
void check_ball_in_a_box(const char *path);
void check_geneva_wheel(const char *path);
void check_pile_and_ball(const char *path);

#endif
