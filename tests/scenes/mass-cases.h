/* Scenes of masses that fly, hang or swing, held against closed forms and conserved quantities. */
#ifndef TEST_MASS_CASES_H
#define TEST_MASS_CASES_H

void check_network(const char *path);
void check_pendulum(const char *path);
void check_free_fall(const char *path);
void check_double_pendulum(const char *path);
void check_pendulum_wave(const char *path);
void check_rotating_square(const char *path);
void check_hanging_cable(const char *path);
void check_terminal_velocity(const char *path);
void check_four_bar(const char *path);
void check_kapitza(const char *path);
void check_falling_chain(const char *path);
void check_projectiles(const char *path);
void check_spring_pendulum(const char *path);

#endif
