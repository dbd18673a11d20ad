/* What is known of the bundled scenes that show what is often thought otherwise. Each check runs the scene at this
 * path. */
#ifndef TEST_MISTAKE_CASES_H
#define TEST_MISTAKE_CASES_H

void check_thrown_up(const char *path);
void check_normal_forces(const char *path);
void check_rod_tension(const char *path);

#endif
