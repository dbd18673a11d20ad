/* Scenes of linear oscillations, held against closed forms and amplitudes of linear systems. */
#ifndef TEST_OSCILLATION_CASES_H
#define TEST_OSCILLATION_CASES_H

void check_spring_mass(const char *path);
void check_damped_oscillator(const char *path);
void check_motor_on_mass(const char *path);
void check_support_motion(const char *path);
void check_base_excitation(const char *path);
void check_stiff_chain(const char *path);
void check_beats(const char *path);
void check_tuned_mass_damper(const char *path);
void check_resonance(const char *path);

#endif
