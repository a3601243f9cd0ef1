// The cost model of a whole run; fitted by run/cost_analysis.h when all scenes are done.
#include "metrics/registry.h"

namespace moire {

namespace {

using namespace parameter;

constexpr Parameter parameters[] = {
    text("against", "", "the contender that the others' costs are compared with; \"\": none"),
};

constexpr Quantity coefficient(std::string_view name, std::string_view meaning) {
  return {.name = name, .unit = "ns", .meaning = meaning, .is_judged = false};
}

constexpr Quantity quantities[] = {
    coefficient("cost.a", "time of a step of the walk; low and high: 95 % confidence"),
    coefficient("cost.b", "time of a pixel of a column in which an element is seen"),
    coefficient("cost.c", "time of a sampled element"),
    coefficient("cost.d", "time of a hit of a point"),
    coefficient("cost.d_run", "time of a run of a line: d' of the paper"),
    {.name = "cost.held_out",
     .unit = "",
     .meaning = "median of |predicted - measured| / measured over the contenders of a scene that the model was not "
                "fitted to; high: the worst"},
};

constexpr std::string_view basis[] = {"coverage", "speed"};

}  // namespace

const PassDescription cost_description{
    .name = "cost",
    .summary =
        "What steps, pixels, elements and hits cost: a L + b P + c M + d hits + d' runs, fitted over all scenes.",
    .source = "Cohen-Or 1997, section 6",
    .parameters = parameters,
    .quantities = quantities,
    .basis = basis,
};

}  // namespace moire
