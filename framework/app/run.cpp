#include <fmt/format.h>

#include "app/commands.h"
#include "config/json_files.h"
#include "report/html.h"
#include "report/result_folder.h"
#include "report/summary.h"
#include "run/runner.h"

namespace moire::app {

namespace {

std::string counted(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

void say_what_is_left_out(const Experiment& experiment) {
  for (const std::string& note : experiment.left_out) fmt::print(stderr, "{}\n", note);
}

}  // namespace

int attempt(const std::function<int()>& work) {
  try {
    return work();
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return failed;
  }
}

int run(const Session& session, const RunOptions& options) {
  const Experiment experiment = read_experiment(options.experiment, session.vocabulary, options.overrides);
  say_what_is_left_out(experiment);
  report::ResultFolder folder(options.output.empty() ? std::filesystem::path("results") / experiment.name
                                                     : options.output);
  folder.save_request(experiment.request);

  catch_interrupts();
  const Workers workers(options.threads);
  return attempt([&] {
    const ReferenceStore store(kept_references_folder(find_experiment(options.experiment).root),
                               ContentHashes().of_program(), options.fresh_references);
    const Results results = run_experiment(experiment, session.catalog, workers, folder, store, options.command);
    report::write_html(folder.path());
    fmt::print("{}\nReport: {}\n", report::summary_text(results), (folder.path() / "report.html").string());
    return results.interrupted || !results.failures.empty() ? failed : done;
  });
}

int check(const Session& session, const std::filesystem::path& path, const Overrides& overrides) {
  const Experiment experiment = read_experiment(path, session.vocabulary, overrides);
  say_what_is_left_out(experiment);
  fmt::print("{}: {}, {}, {}: nothing is wrong.\n", experiment.name, counted(experiment.scenes.size(), "scene"),
             counted(experiment.samplers.size(), "sampler"), counted(experiment.metrics.size(), "metric"));
  return done;
}

int report(const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    report::write_html(folder);
    fmt::print("Report: {}\n", (folder / "report.html").string());
  }
  return done;
}

}  // namespace moire::app
