// What to choose for a given time or a given error; worked out by run/budget_analysis.h when all scenes are done.
#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    text("times", "2 8 32", "budgets of time, as multiples of the fastest contender's on the scene"),
    text("errors", "4 1", "budgets of error: error.rmse, in its own levels"),
};

constexpr Quantity quantities[] = {
    {.name = "budget.error_at_time",
     .unit = "levels",
     .meaning =
         "lowest error.rmse of a contender within a time, named with it; what is below the reference's own error "
         "counts as equal, and of equals the fastest is named",
     .is_judged = false},
    {.name = "budget.ms_at_error",
     .unit = "ms",
     .meaning = "lowest time of a contender whose error.rmse is within a budget, named with it",
     .is_judged = false},
};

constexpr std::string_view basis[] = {"error", "speed"};

}  // namespace

const PassDescription budget_description{
    .name = "budget",
    .summary = "The contender with the least error at equal time, and the fastest at equal error, on each scene.",
    .source = "",
    .parameters = parameters,
    .quantities = quantities,
    .basis = basis,
};

}  // namespace moire
