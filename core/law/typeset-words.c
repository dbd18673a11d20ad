/* Digits and letters that the formats share. */
#include <string.h>

#include "law/typeset-private.h"

void tinker_typeset_digits(char digits[32], double number)
{
    char format[32];
    g_ascii_formatd(format, sizeof format, "%.6g", number);
    g_strlcpy(digits, format, 32);
}

gboolean tinker_typeset_power(char digits[32], int *power)
{
    char *sign = strchr(digits, 'e');
    if (sign == NULL) return FALSE;
    *sign = '\0';
    *power = (int)g_ascii_strtoll(sign + 1, NULL, 10);
    return TRUE;
}

const char *tinker_typeset_comparison(const char *sign)
{
    return strcmp(sign, "<=") == 0   ? "≤"
           : strcmp(sign, ">=") == 0 ? "≥"
           : strcmp(sign, "!=") == 0 ? "≠"
           : strcmp(sign, "==") == 0 ? "="
                                     : sign;
}

gsize tinker_stem_letters(const char *stem)
{
    return (guchar)stem[0] < 0x80 ? strcspn(stem, "0123456789") : (gsize)(g_utf8_next_char(stem) - stem);
}

const char *tinker_greek_name(const char *letter)
{
    /* keyboards have the micro sign, which looks like the letter */
    static const struct {
        const char *letter, *name;
    } letters[] = {{"α", "alpha"}, {"β", "beta"},  {"γ", "gamma"},  {"δ", "delta"}, {"ε", "varepsilon"},
                   {"ζ", "zeta"},  {"η", "eta"},   {"θ", "theta"},  {"κ", "kappa"}, {"λ", "lambda"},
                   {"μ", "mu"},    {"µ", "mu"},    {"ν", "nu"},     {"ξ", "xi"},    {"ρ", "rho"},
                   {"σ", "sigma"}, {"τ", "tau"},   {"φ", "varphi"}, {"χ", "chi"},   {"ψ", "psi"},
                   {"ω", "omega"}, {"Δ", "Delta"}, {"Ω", "Omega"},  {"Φ", "Phi"},   {"Θ", "Theta"},
                   {"π", "pi"}};
    for (gsize i = 0; i < G_N_ELEMENTS(letters); i++)
        if (strcmp(letters[i].letter, letter) == 0) return letters[i].name;
    return NULL;
}
