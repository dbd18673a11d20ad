/* The laws of impact and of closed contacts, which what the solvers answer must keep. */
#ifndef TINKER_TESTS_CONTACT_LAW_CHECKS_H
#define TINKER_TESTS_CONTACT_LAW_CHECKS_H

#include "contact-case.h"
#include "numerics/contact/contact-laws.h"

/* Solves an impact after which each contact parts with `least` at least (m/s), and holds p (N s) against the laws. */
void contact_laws_of_impact(const ContactCase *bodies, const double *least, double *p);

/* What an impact adds to the energy, as a share of the sum of the terms without their signs. */
double contact_laws_energy_gained(const ContactCase *bodies, const double *p);

/* What came out of tinker_contact_modes keeps the laws, where there is a solution: modes and forces f (N). */
TinkerContactResult contact_laws_of_modes(const ContactCase *bodies, const double *dynamic, TinkerContactMode *modes,
                                          double *f);

#endif
