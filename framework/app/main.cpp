// The command line.
#include <cstdio>
#include <functional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <moire/error.h>

#include "app/commands.h"
#include "json/nearest_name.h"

namespace {

using namespace moire;

struct Options {
  std::vector<std::filesystem::path> plugins, folders;
  std::filesystem::path experiment, new_folder;
  app::RunOptions run;
  app::RenderOptions render;
  std::string what, name, kind;
  bool as_json = false;
};

void add_overrides(CLI::App& command, Overrides& overrides) {
  command.add_option("--set", overrides.sets, "Change a value, such as image.width=64 or samplers[1].n=8")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--only", overrides.only, "Run only these: SCENE/SAMPLER, by name or type; either may be empty");
}

// Declares the commands; `chosen` becomes what is to be done.
void declare(CLI::App& cli, Options& o, std::function<int()>& chosen) {
  cli.require_subcommand(1);
  cli.fallthrough();
  cli.set_version_flag("--version", MOIRE_VERSION);
  cli.add_option("--plugins", o.plugins, "A further folder of plugins")->allow_extra_args(false);
  const auto command = [&](const char* name, const char* summary, std::function<int()> work) {
    CLI::App* sub = cli.add_subcommand(name, summary);
    sub->callback([&chosen, work = std::move(work)] { chosen = work; });
    return sub;
  };
  const auto session = [&o] { return app::Session(o.plugins); };

  CLI::App* run =
      command("run", "Run an experiment and report on it", [&, session] { return app::run(session(), o.run); });
  run->add_option("experiment", o.run.experiment, "A folder of experiments/, or its JSON file")->required();
  run->add_option("-o,--output", o.run.output, "Result folder (default: results/<experiment>)");
  run->add_option("-j,--threads", o.run.threads, "Threads (default: all cores)")->check(CLI::Range(1, 4096));
  run->add_flag("--fresh-references", o.run.fresh_references, "Compute references again, whatever is kept");
  add_overrides(*run, o.run.overrides);

  CLI::App* report =
      command("report", "Make the report of a result folder again", [&o] { return app::report(o.folders); });
  report->add_option("folder", o.folders, "Result folders")->required();

  CLI::App* check = command("check", "Check an experiment without running it",
                            [&, session] { return app::check(session(), o.experiment, o.run.overrides); });
  check->add_option("experiment", o.experiment, "A folder of experiments/, or its JSON file")->required();
  add_overrides(*check, o.run.overrides);

  CLI::App* list = command("list", "What there is, and which sampler runs on which scene",
                           [&, session] { return app::list(session(), o.what, o.as_json); });
  list->add_option("what", o.what, "samplers, scenes, metrics, pictures or lookups")
      ->check(CLI::IsMember({"samplers", "scenes", "metrics", "pictures", "lookups"}));
  list->add_flag("--json", o.as_json, "As JSON");

  CLI::App* describe = command("describe", "A sampler, scene, metric, picture or lookup and its parameters",
                               [&, session] { return app::describe(session(), o.name, o.as_json); });
  describe->add_option("name", o.name, "Its name")->required();
  describe->add_flag("--json", o.as_json, "As JSON");

  CLI::App* render = command("render", "Render one picture", [&, session] { return app::render(session(), o.render); });
  render->add_option("scene", o.render.scene, "A scene, or a JSON file of configs/scenes")->required();
  render->add_option("sampler", o.render.sampler, "A sampler")->required();
  render->add_option("-o,--output", o.render.output, "A .png or .exr file")->capture_default_str();
  render->add_option("--width", o.render.width, "Pixels")->capture_default_str();
  render->add_option("--height", o.render.height, "Pixels")->capture_default_str();
  render->add_option("-j,--threads", o.render.threads, "Threads (default: all cores)")->check(CLI::Range(1, 4096));
  render->add_option("--set", o.render.sets, "Change a value, such as scene.view.pitch_deg=-10 or sampler.n=8")
      ->take_all()
      ->allow_extra_args(false);

  CLI::App* fresh =
      command("new", "Start a plugin of one's own", [&o] { return app::new_plugin(o.kind, o.name, o.new_folder); });
  fresh->add_option("kind", o.kind, "sampler")->required()->check(CLI::IsMember({"sampler"}));
  fresh->add_option("name", o.name, "Its name, such as my_sampler")->required();
  fresh->add_option("-o,--output", o.new_folder,
                    "Where to make its folder (default: here, or plugins/samplers of the tree)");

  command("schema", "The JSON Schema of experiment files, for editors", [session] { return app::schema(session()); });
}

// The message about a command that is none; empty if the mistake is another one.
std::string unknown_command(const CLI::App& cli) {
  const std::vector<std::string> left = cli.remaining();
  if (!cli.get_subcommands().empty() || left.empty() || left.front().starts_with('-')) return "";
  std::vector<std::string_view> known;
  for (const CLI::App* command : cli.get_subcommands({})) known.push_back(command->get_name());
  return fmt::format("{}: there is no such command{} known are {}", left.front(), did_you_mean(left.front(), known),
                     listed(known));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli("moire compares antialiasing methods: what each shows, what it misses, what it costs.", "moire");
  Options options;
  options.run.command.assign(argv, argv + argc);
  options.run.command[0] = "moire";
  std::function<int()> chosen;
  declare(cli, options, chosen);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (const std::string message = unknown_command(cli); !message.empty()) {
      fmt::print(stderr, "{}\n", message);
      return app::wrong_request;
    }
    return cli.exit(e) == 0 ? app::done : app::wrong_request;
  }
  try {
    return chosen();
  } catch (const Error& e) {
    fmt::print(stderr, "{}\n", e.what());
  } catch (const std::exception& e) {
    fmt::print(stderr, "moire: {}\n", e.what());
  }
  return app::wrong_request;
}
