#include "run/cost_analysis.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <moire/error.h>

#include "metrics/cost_model.h"

namespace moire {

namespace {

constexpr const char* title = "Cost model";
constexpr std::array names{"cost.a", "cost.b", "cost.c", "cost.d", "cost.d_run"};
constexpr std::array operations{"step (L)", "pixel (P)", "sampled element (M)", "hit of a point", "run of a line"};
static_assert(names.size() == cost_operations && operations.size() == cost_operations);

double value_of(const Results& results, const std::string& scene, const std::string& sampler, const char* metric) {
  const auto row = std::find_if(results.rows.begin(), results.rows.end(), [&](const Row& r) {
    return r.scene == scene && r.sampler == sampler && r.metric == metric;
  });
  return row == results.rows.end() ? std::nan("") : row->value;
}

std::vector<CostSample> samples_of(const Results& results, const std::set<std::string>& on_lines) {
  std::vector<CostSample> samples;
  for (const SceneResult& scene : results.scenes) {
    for (const ContenderResult& contender : results.contenders) {
      const auto value = [&](const char* metric) { return value_of(results, scene.name, contender.name, metric); };
      const double hits = value("coverage.hits");
      const bool is_on_lines = on_lines.contains(contender.name);
      CostSample sample{scene.name,
                        contender.name,
                        {value("coverage.steps"), value("coverage.pixels"), value("coverage.sampled"),
                         is_on_lines ? 0 : hits, is_on_lines ? hits : 0},
                        1e6 * value("speed.ms_per_frame") / results.width};
      const bool is_whole =
          std::none_of(sample.counts.begin(), sample.counts.end(), [](double n) { return std::isnan(n); });
      if (is_whole && sample.time > 0) samples.push_back(std::move(sample));
    }
  }
  return samples;
}

// The contenders of a scene whose time is above that of `base`.
std::string dearer(const std::vector<CostSample>& samples, const CostSample& base, const auto& time_of) {
  std::string list;
  for (const CostSample& sample : samples) {
    if (sample.scene == base.scene && time_of(sample) > time_of(base))
      list += (list.empty() ? "" : ", ") + sample.sampler;
  }
  return list.empty() ? "none" : list;
}

class CostAnalysis {
 public:
  CostAnalysis(Results& results, const std::set<std::string>& on_lines)
      : results_(results), samples_(samples_of(results, on_lines)), model_(fit_cost_model(samples_)) {
    results.analyses.push_back({title, {}});
  }

  void report_coefficients() {
    std::string formula, unsure;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (!model_.coefficients[k]) continue;
      const auto& [value, low, high] = *model_.coefficients[k];
      results_.rows.push_back({title, title, names[k], value, low, high, "ns"});
      const char* sign = value < 0 ? (formula.empty() ? "-" : " - ") : (formula.empty() ? "" : " + ");
      formula += fmt::format("{}{:.1f} ns a {}", sign, std::abs(value), operations[k]);
      if (low <= 0 && high >= 0) unsure += fmt::format("{}{}", unsure.empty() ? "" : ", ", operations[k]);
    }
    say(fmt::format("Time of an image column, fitted to {} runs: {}.", samples_.size(), formula));
    if (!unsure.empty()) say(fmt::format("Not told apart from no cost at all (95 % confidence): {}.", unsure));
  }

  void report_held_out() {
    for (const HeldOut& h : predict_held_out(samples_)) {
      results_.rows.push_back({title, h.scene, "cost.held_out", h.median, std::nan(""), h.worst, ""});
      say(fmt::format("Held out, {} is predicted within {:.0f} % (median), {:.0f} % at worst.", h.scene, 100 * h.median,
                      100 * h.worst));
    }
  }

  void compare_with(const std::string& name) {
    for (const CostSample& base : samples_) {
      if (base.sampler != name) continue;
      say(fmt::format("{}: dearer than {} by the clock: {}; by the model: {}.", base.scene, name,
                      dearer(samples_, base, [](const CostSample& s) { return s.time; }),
                      dearer(samples_, base, [&](const CostSample& s) { return model_.predict(s.counts); })));
    }
  }

 private:
  void say(std::string statement) { results_.analyses.back().statements.push_back(std::move(statement)); }

  Results& results_;
  const std::vector<CostSample> samples_;
  const CostModel model_;
};

}  // namespace

void analyse_cost(const Settings& settings, const std::set<std::string>& on_lines, Results& results) {
  try {
    CostAnalysis analysis(results, on_lines);
    analysis.report_coefficients();
    if (results.scenes.size() > 1) analysis.report_held_out();
    if (const std::string& against = settings.text("against"); !against.empty()) analysis.compare_with(against);
  } catch (const Error& error) {
    results.failures.push_back({title, title, error.what()});
  }
}

}  // namespace moire
