#include "run/budget_analysis.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace moire {

namespace {

constexpr const char* title = "At equal time and at equal error";

std::vector<double> numbers_of(const std::string& key, const std::string& text, Results& results) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::istringstream in(word);
    double number = 0;
    if (in >> number && in.eof() && number > 0) {
      numbers.push_back(number);
    } else {
      results.failures.push_back({title, title, fmt::format("budget.{}: \"{}\" is no number above 0", key, word)});
    }
  }
  return numbers;
}

std::vector<Priced> priced_on(const std::string& scene, const Results& results) {
  const auto value = [&](const std::string& sampler, const char* metric) {
    const auto row = std::find_if(results.rows.begin(), results.rows.end(), [&](const Row& r) {
      return r.scene == scene && r.sampler == sampler && r.metric == metric;
    });
    return row == results.rows.end() ? std::nan("") : row->value;
  };
  std::vector<Priced> all;
  for (const ContenderResult& contender : results.contenders) {
    const Priced priced{contender.name, value(contender.name, "speed.ms_per_frame"),
                        value(contender.name, "error.rmse")};
    if (std::isfinite(priced.ms) && std::isfinite(priced.error)) all.push_back(priced);
  }
  return all;
}

double told(double error, double floor) { return error < floor ? floor : error; }

std::string error_text(const Priced& p, double floor) {
  return p.error < floor ? "below the reference's accuracy" : fmt::format("{:.3g} levels", p.error);
}

}  // namespace

std::optional<Priced> best_within_time(const std::vector<Priced>& all, double ms, double floor) {
  std::optional<Priced> best;
  for (const Priced& p : all) {
    if (p.ms > ms) continue;
    const double own = told(p.error, floor), least = best ? told(best->error, floor) : HUGE_VAL;
    if (!best || own < least || (own == least && p.ms < best->ms)) best = p;
  }
  return best;
}

std::optional<Priced> fastest_within_error(const std::vector<Priced>& all, double error, double floor) {
  std::optional<Priced> best;
  for (const Priced& p : all) {
    if (p.error <= told(error, floor) && (!best || p.ms < best->ms)) best = p;
  }
  return best;
}

void analyse_budgets(const Settings& settings, Results& results) {
  const auto times = numbers_of("times", settings.text("times"), results);
  const auto errors = numbers_of("errors", settings.text("errors"), results);
  Analysis analysis{title, {}};
  for (const SceneResult& scene : results.scenes) {
    const auto all = priced_on(scene.name, results);
    if (all.empty()) continue;
    const double floor = scene.reference_error;
    const double fastest =
        std::min_element(all.begin(), all.end(), [](const Priced& a, const Priced& b) { return a.ms < b.ms; })->ms;
    const auto keep = [&](const std::string& budget, const Priced& p, const char* metric, double value,
                          const char* unit) {
      results.rows.push_back({.scene = title,
                              .sampler = fmt::format("{}, {}: {}", scene.name, budget, p.name),
                              .metric = metric,
                              .value = value,
                              .unit = unit});
      analysis.statements.push_back(
          fmt::format("{}, {}: {} ({:.3g} ms, {}).", scene.name, budget, p.name, p.ms, error_text(p, floor)));
    };
    for (double factor : times) {
      if (const auto p = best_within_time(all, factor * fastest, floor))
        keep(fmt::format("{:g} x the fastest time", factor), *p, "budget.error_at_time", p->error, "levels");
    }
    for (double error : errors) {
      const std::string budget = fmt::format("{:g} levels", error);
      if (const auto p = fastest_within_error(all, error, floor)) {
        keep(budget, *p, "budget.ms_at_error", p->ms, "ms");
      } else {
        analysis.statements.push_back(fmt::format("{}, {}: none.", scene.name, budget));
      }
    }
  }
  results.analyses.push_back(std::move(analysis));
}

}  // namespace moire
