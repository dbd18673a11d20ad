/* What is known of the bundled scenes of bodies on joints. Each check runs the scene at this path. */
#ifndef TEST_MECHANISM_CASES_H
#define TEST_MECHANISM_CASES_H

void check_compound_pendulum(const char *path);
void check_double_bar_pendulum(const char *path);
void check_four_bar_coupler_curve(const char *path);
void check_slider_crank(const char *path);
void check_scotch_yoke(const char *path);
void check_quick_return(const char *path);
void check_planetary_gear(const char *path);
void check_gear_train(const char *path);
void check_block_and_tackle(const char *path);
void check_balanced_arm(const char *path);
void check_yo_yo(const char *path);
void check_heavy_pulley(const char *path);

#endif
