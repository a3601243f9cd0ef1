#include <fmt/format.h>

#include "app/commands.h"
#include "report/html.h"
#include "report/result_folder.h"
#include "report/summary.h"
#include "run/runner.h"

namespace moire::app {

int run(const Session& session, const RunOptions& options) {
  const Experiment experiment = read_experiment(options.experiment, session.vocabulary, options.overrides);
  report::ResultFolder folder(options.output.empty() ? std::filesystem::path("results") / experiment.name
                                                     : options.output);
  folder.save_request(experiment.request);

  catch_interrupts();
  const Workers workers(options.threads);
  const Results results = run_experiment(experiment, session.catalog, workers, folder, options.command);
  report::write_html(folder.path());

  fmt::print("{}\n", report::summary_text(results));
  if (results.interrupted) fmt::print("Interrupted; what was finished is kept.\n");
  fmt::print("Report: {}\n", (folder.path() / "report.html").string());
  return results.interrupted || !results.failures.empty() ? 1 : 0;
}

int check(const Session& session, const std::filesystem::path& path, const Overrides& overrides) {
  const Experiment experiment = read_experiment(path, session.vocabulary, overrides);
  fmt::print("{}: {} scenes, {} samplers, {} metrics: nothing is wrong.\n", experiment.name, experiment.scenes.size(),
             experiment.samplers.size(), experiment.metrics.size());
  return 0;
}

int report(const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    report::write_html(folder);
    fmt::print("Report: {}\n", (folder / "report.html").string());
  }
  return 0;
}

}  // namespace moire::app
