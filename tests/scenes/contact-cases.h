/* What is known of the bundled scenes in which masses touch supports. Each check runs the scene at this path. */
#ifndef TEST_CONTACT_CASES_H
#define TEST_CONTACT_CASES_H

void check_one_sided_support(const char *path);
void check_incline_landing(const char *path);
void check_friction_incline(const char *path);
void check_bouncing_balls(const char *path);
void check_friction_oscillator(const char *path);
void check_stick_slip_belt(const char *path);
void check_lift_off(const char *path);
void check_sliding_ladder(const char *path);
void check_el_centro_block(const char *path);

#endif
