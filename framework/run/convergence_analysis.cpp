#include "run/convergence_analysis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <boost/math/distributions/students_t.hpp>

namespace moire {

namespace {

constexpr const char* title = "Convergence";
constexpr const char *samples_metric = "convergence.samples", *error_metric = "convergence.rmse";

// Of the logarithm of an error, from the ends of its 95 % interval.
double deviation(const ErrorAt& e) {
  if (!(e.low > 0) || !(e.high > e.low)) return std::nan("");
  return std::log(e.high / e.low) / (2 * 1.96);
}

struct LogPoint {
  double x, y, weight;
};

// Where no interval is known all weigh alike.
std::vector<LogPoint> log_points(const std::vector<ErrorAt>& errors) {
  std::vector<LogPoint> points;
  bool all_known = true;
  for (const ErrorAt& e : errors) {
    if (!(e.error > 0)) continue;
    const double sd = deviation(e);
    all_known = all_known && sd > 0;
    points.push_back({std::log(e.samples), std::log(e.error), 1 / (sd * sd)});
  }
  if (!all_known) {
    for (LogPoint& p : points) p.weight = 1;
  }
  return points;
}

struct Prediction {
  std::string scene, family;
  double slope;
  std::optional<double> constant;
  bool is_used = false;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\n"), last = text.find_last_not_of(" \t\n");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

class ConvergenceAnalysis {
 public:
  ConvergenceAnalysis(const Settings& settings, Results& results)
      : over_(settings.text("over")),
        against_(settings.text("against")),
        from_samples_(settings.real("from_samples")),
        results_(results) {
    results_.analyses.push_back({title, {}});
    read_theory(settings.text("theory"));
  }

  void run() {
    for (const SceneResult& scene : results_.scenes) {
      const Families families = families_on(scene.name);
      for (const auto& [family, errors] : families) report(scene.name, family, errors);
      if (!against_.empty()) compare(scene.name, families);
    }
    for (const Prediction& p : predictions_) {
      if (!p.is_used) fail(fmt::format("theory for {}/{}: no such family with two sizes or more", p.scene, p.family));
    }
  }

 private:
  using Families = std::vector<std::pair<std::string, std::vector<ErrorAt>>>;

  void fail(std::string message) { results_.failures.push_back({title, title, std::move(message)}); }
  void say(std::string statement) { results_.analyses.back().statements.push_back(std::move(statement)); }

  void read_theory(const std::string& text) {
    std::istringstream entries(text);
    for (std::string entry; std::getline(entries, entry, ';');) {
      entry = trimmed(entry);
      if (entry.empty()) continue;
      const auto colon = entry.rfind(':'), slash = entry.find('/');
      std::istringstream numbers(colon == std::string::npos ? "" : entry.substr(colon + 1));
      Prediction p;
      if (slash == std::string::npos || slash > colon || !(numbers >> p.slope)) {
        fail(fmt::format("theory: \"{}\" cannot be read; write SCENE/FAMILY: SLOPE [CONSTANT]", entry));
        continue;
      }
      if (double constant; numbers >> constant) p.constant = constant;
      p.scene = trimmed(entry.substr(0, slash));
      p.family = trimmed(entry.substr(slash + 1, colon - slash - 1));
      predictions_.push_back(p);
    }
  }

  Families families_on(const std::string& scene) const {
    Families families;
    std::map<std::string, double> samples;
    for (const Row& row : results_.rows) {
      if (row.scene != scene) continue;
      if (row.metric == samples_metric) samples[row.sampler] = row.value;
      if (row.metric != error_metric) continue;
      const std::string family = family_of(row.sampler, over_);
      auto found = std::find_if(families.begin(), families.end(), [&](const auto& f) { return f.first == family; });
      if (found == families.end()) found = families.insert(found, {family, {}});
      found->second.push_back({samples[row.sampler], row.value, row.low, row.high});
    }
    for (auto& [family, errors] : families) {
      std::sort(errors.begin(), errors.end(), [](const ErrorAt& a, const ErrorAt& b) { return a.samples < b.samples; });
    }
    return families;
  }

  void report(const std::string& scene, const std::string& family, const std::vector<ErrorAt>& errors) {
    CurveResult curve{scene, family, error_metric, "Error over samples", "samples a pixel", "rmse (1: full scale)", {}};
    std::vector<ErrorAt> fitted;
    for (const ErrorAt& e : errors) {
      if (e.error > 0) curve.points.push_back({e.samples, e.error});
      if (e.samples >= from_samples_) fitted.push_back(e);
    }
    if (curve.points.size() > 1) results_.curves.push_back(std::move(curve));
    const auto law = fit_power_law(fitted);
    if (!law) return;

    const auto theory = std::find_if(predictions_.begin(), predictions_.end(),
                                     [&](const Prediction& p) { return p.scene == scene && p.family == family; });
    const bool is_predicted = theory != predictions_.end();
    const double constant = is_predicted ? constant_for(fitted, theory->slope) : law->constant;
    results_.rows.push_back({scene, family, "convergence.slope", law->slope, law->low, law->high, ""});
    results_.rows.push_back(
        {.scene = scene, .sampler = family, .metric = "convergence.constant", .value = constant, .unit = ""});
    std::string statement =
        fmt::format("{} / {}: slope {:.3f} ({:.3f} to {:.3f})", scene, family, law->slope, law->low, law->high);
    if (is_predicted) {
      theory->is_used = true;
      const bool agrees = law->low <= theory->slope && theory->slope <= law->high;
      statement +=
          fmt::format(", theory {:.3f}: {}", theory->slope, agrees ? "within the interval" : "outside the interval");
      statement += fmt::format("; constant {:.3f}", constant);
      if (theory->constant) {
        statement +=
            fmt::format(", theory {:.3f} ({:+.1f} %)", *theory->constant, 100 * (constant / *theory->constant - 1));
      }
    } else {
      statement += fmt::format("; constant {:.3g}", constant);
    }
    say(statement + ".");
  }

  // What every contender saves over the family `against`.
  void compare(const std::string& scene, const Families& families) {
    const auto base =
        std::find_if(families.begin(), families.end(), [&](const auto& f) { return f.first == against_; });
    if (base == families.end())
      return fail(fmt::format("against \"{}\": no contender of this family ran on {}", against_, scene));
    std::vector<Row> rows;
    for (const Row& row : results_.rows) {
      if (row.scene != scene || row.metric != error_metric || !(row.value > 0)) continue;
      const double saving = samples_at(row.value, base->second) / samples_of(scene, row.sampler);
      rows.push_back(
          {.scene = scene, .sampler = row.sampler, .metric = "convergence.saving", .value = saving, .unit = "times"});
    }
    results_.rows.insert(results_.rows.end(), rows.begin(), rows.end());
  }

  double samples_of(const std::string& scene, const std::string& sampler) const {
    for (const Row& row : results_.rows) {
      if (row.scene == scene && row.sampler == sampler && row.metric == samples_metric) return row.value;
    }
    return std::nan("");
  }

  std::string over_, against_;
  double from_samples_;
  std::vector<Prediction> predictions_;
  Results& results_;
};

}  // namespace

double samples_at(double error, const std::vector<ErrorAt>& family) {
  const auto between = [&](const ErrorAt& a, const ErrorAt& b) {
    const double share = std::log(error / a.error) / std::log(b.error / a.error);
    return a.samples * std::pow(b.samples / a.samples, share);
  };
  for (std::size_t k = 1; k < family.size(); ++k) {
    const ErrorAt &a = family[k - 1], &b = family[k];
    if (b.error <= error && error <= a.error && 0 < b.error && b.error < a.error) return between(a, b);
  }
  const auto law = fit_power_law(family);
  if (!law || !(law->slope < 0)) return std::nan("");
  const ErrorAt& end = error > family.front().error ? family.front() : family.back();
  return end.error > 0 ? end.samples * std::pow(error / end.error, 1 / law->slope) : std::nan("");
}

std::optional<PowerLaw> fit_power_law(const std::vector<ErrorAt>& errors) {
  const auto points = log_points(errors);
  if (std::none_of(points.begin(), points.end(), [&](const LogPoint& p) { return p.x != points.front().x; }))
    return std::nullopt;
  double weight = 0, x = 0, y = 0;
  for (const LogPoint& p : points) {
    weight += p.weight;
    x += p.weight * p.x;
    y += p.weight * p.y;
  }
  x /= weight;
  y /= weight;
  double xx = 0, xy = 0;
  for (const LogPoint& p : points) {
    xx += p.weight * (p.x - x) * (p.x - x);
    xy += p.weight * (p.x - x) * (p.y - y);
  }
  const double slope = xy / xx;
  double scatter = 0;
  for (const LogPoint& p : points) scatter += p.weight * std::pow(p.y - y - slope * (p.x - x), 2);
  // Where weights are those of the intervals, 1 / xx is the slope's variance; the scatter's expectation is the number
  // of points less two.
  const bool has_intervals =
      std::all_of(errors.begin(), errors.end(), [](const ErrorAt& e) { return deviation(e) > 0; });
  const auto freedom = static_cast<double>(points.size()) - 2;
  double margin = has_intervals ? 1.96 / std::sqrt(xx) : 0;
  if (freedom > 0) {
    const double student = quantile(boost::math::students_t(freedom), 0.975);
    margin = std::max(margin, student * std::sqrt(scatter / freedom / xx));
  }
  return PowerLaw{slope, slope - margin, slope + margin, std::exp(y - slope * x)};
}

double constant_for(const std::vector<ErrorAt>& errors, double slope) {
  double weight = 0, sum = 0;
  for (const LogPoint& p : log_points(errors)) {
    weight += p.weight;
    sum += p.weight * (p.y - slope * p.x);
  }
  return std::exp(sum / weight);
}

std::string family_of(std::string_view contender, std::string_view over) {
  const auto bracket = contender.find('[');
  if (bracket == std::string_view::npos || contender.back() != ']') return std::string(contender);
  std::istringstream words{std::string(over)};
  std::vector<std::string> names;
  for (std::string name; words >> name;) names.push_back(name);

  std::istringstream settings(std::string(contender.substr(bracket + 1, contender.size() - bracket - 2)));
  std::string kept;
  for (std::string setting; std::getline(settings, setting, ',');) {
    if (std::find(names.begin(), names.end(), setting.substr(0, setting.find('='))) != names.end()) continue;
    kept += (kept.empty() ? "" : ",") + setting;
  }
  const std::string start(contender.substr(0, bracket));
  return kept.empty() ? start : fmt::format("{}[{}]", start, kept);
}

void analyse_convergence(const Settings& settings, Results& results) { ConvergenceAnalysis(settings, results).run(); }

}  // namespace moire
