#include "equations/write/lines.h"

#include "equations/write/page-private.h"

GPtrArray *tinker_equations_lines(const TinkerEquations *equations, const TinkerMatrixForm *matrix,
                                  const TinkerAngleForm *angles, const TinkerEquationsShown *shown)
{
    TinkerPage page;
    tinker_page_begin(&page, shown->format, equations, "");
    page.lines = tinker_page_lines_new();
    if (matrix != NULL)
        tinker_equations_put_matrix(&page, matrix, shown);
    else if (angles != NULL)
        tinker_equations_put_angles(&page, angles, shown);
    else
        tinker_equations_put_newton(&page, shown);
    GPtrArray *lines = page.lines;
    g_free(tinker_page_end(&page));
    return lines;
}
