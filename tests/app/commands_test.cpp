// The small commands: what they print, and how they end.
#include <catch2/catch_test_macros.hpp>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "app/tiny_experiment.h"

namespace moire::test {

namespace {

const std::string commands = "run, report, check, list, describe, render, new, schema";

}  // namespace

TEST_CASE("every command explains itself") {
  const Desk desk;
  const std::pair<const char*, const char*> summaries[] = {
      {"run", "Run an experiment and report on it"},
      {"report", "Make the report of a result folder again"},
      {"check", "Check an experiment without running it"},
      {"list", "What there is, and which sampler runs on which scene"},
      {"describe", "A sampler, scene, metric, picture or lookup and its parameters"},
      {"render", "Render one picture"},
      {"new", "Start a plugin of one's own"},
      {"schema", "The JSON Schema of experiment files, for editors"}};
  const Ended all = desk.moire({"--help"});
  CHECK(all.code == 0);
  CHECK(all.out.starts_with("moire compares antialiasing methods: what each shows, what it misses, what it costs.\n"));
  for (const auto& [name, summary] : summaries) {
    CAPTURE(name);
    CHECK(all.out.find(summary) != std::string::npos);
    const Ended one = desk.moire({name, "--help"});
    CHECK(one.code == 0);
    CHECK(one.err == "");
    CHECK(one.out.starts_with(std::string(summary) + "\n"));
  }
}

TEST_CASE("a command that is none is an error that names the commands") {
  const Desk desk;
  const Ended near = desk.moire({"rnu", "experiments/first_look"});
  CHECK(near.code == 2);
  CHECK(near.out == "");
  CHECK(near.err == "rnu: there is no such command; did you mean \"run\"? known are " + commands + "\n");
  CHECK(desk.moire({"frobnicate"}).err == "frobnicate: there is no such command; known are " + commands + "\n");
}

TEST_CASE("missing and wrong arguments are errors of the request") {
  const Desk desk;
  const std::string more = "\nRun with --help for more information.\n";
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{}, "A subcommand is required"},
           {{"run"}, "experiment is required"},
           {{"run", "x", "--nonsense"}, "The following argument was not expected: --nonsense"},
           {{"run", "x", "-j", "0"}, "--threads: Value 0 not in range 1 to 4096"},
           {{"list", "nonsense"}, "what: nonsense not in {samplers,scenes,metrics,pictures,lookups}"}}) {
    const Ended ended = desk.moire(arguments);
    CHECK(ended.code == 2);
    CHECK(ended.out == "");
    CHECK(ended.err == message + more);
  }
}

TEST_CASE("the version is printed alone") { CHECK(Desk().moire({"--version"}).out == MOIRE_VERSION "\n"); }

TEST_CASE("list names what there is, and as JSON too") {
  const Desk desk;
  const Ended text = desk.moire({"list"});
  CHECK(text.code == 0);
  CHECK(text.err == "");
  for (const char* line :
       {"samplers\n", "\nscenes\n", "\nmetrics\n", "\npictures\n", "\nlookups\n", "\n  point            ",
        "\n  cartoon          ", "\n  heightfield      ", "\n  coverage         ", "\n  linear_across    "})
    CHECK(text.out.find(line) != std::string::npos);

  const auto json = nlohmann::json::parse(desk.moire({"list", "--json"}).out);
  for (const char* kind : {"samplers", "scenes", "metrics", "pictures", "lookups"}) {
    for (const auto& entry : json.at(kind)) {
      CHECK(text.out.find("\n  " + entry.at("name").get<std::string>()) != std::string::npos);
      CHECK(text.out.find(entry.at("summary").get<std::string>()) != std::string::npos);
    }
  }
  CHECK(json.at("pairs").size() == json.at("samplers").size() * json.at("scenes").size());
  std::size_t refused = 0;
  for (const auto& pair : json.at("pairs")) {
    INFO(pair.dump());
    const auto why_not = pair.at("why_not").get<std::string>();
    CHECK(why_not.empty() == pair.at("runs").get<bool>());
    if (why_not.empty()) continue;
    ++refused;
    const auto names = [&](const char* key) { return pair.at(key).get<std::string>(); };
    CHECK(why_not.starts_with(fmt::format("\"{}\" asks for ", names("sampler"))));
    CHECK(why_not.find(fmt::format("scene \"{}\"", names("scene"))) != std::string::npos);
    // Below the sampler's line, before the next one's.
    const std::size_t line = text.out.find("\n  " + names("sampler") + " ", text.out.find("\nwhich sampler"));
    const std::size_t reason = text.out.find("not ", line), scene = text.out.find(names("scene"), reason);
    CHECK((line != text.out.npos && scene != text.out.npos));
  }
  CHECK(refused > 0);
  CHECK(nlohmann::json::parse(desk.moire({"list", "--json", "metrics"}).out).at("metrics") == json.at("metrics"));
}

TEST_CASE("a list of one kind is a part of the whole") {
  const Desk desk;
  const Ended part = desk.moire({"list", "scenes"});
  CHECK(part.out.starts_with("scenes\n  cartoon "));
  CHECK(desk.moire({"list"}).out.find(part.out) != std::string::npos);
}

TEST_CASE("what is listed opens neither OpenImageIO nor the module that knows it") {
  const Desk desk;
  desk.file("tiny/experiment.json", tiny_experiment());
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"list"}, {"describe", "heightfield"}, {"schema"}, {"check", "tiny"}}) {
    const Ended ended = desk.moire(command, {{"LD_DEBUG", "libs"}});
    CHECK(ended.code == 0);
    CHECK(ended.err.find("libmoire.so") != std::string::npos);  // the linker did report
    CHECK(ended.err.find("OpenImageIO") == std::string::npos);
    CHECK(ended.err.find("moire_images") == std::string::npos);
  }
}

TEST_CASE("describe prints parameters and meanings, and as JSON too") {
  const Desk desk;
  const Ended text = desk.moire({"describe", "supersample"});
  CHECK(text.code == 0);
  CHECK(text.out.starts_with("supersample (sampler 1.0.0): "));
  CHECK(text.out.find("\nafter Cohen-Or 1997") != std::string::npos);
  CHECK(text.out.find("\n  layout             column       column | grid ") != std::string::npos);
  CHECK(text.out.find("\n  n                  4            1 .. 256 points ") != std::string::npos);
  CHECK(desk.moire({"describe", "error"}).out.find("\n  error.rmse                     levels      ") !=
        std::string::npos);
  const auto json = nlohmann::json::parse(desk.moire({"describe", "supersample", "--json"}).out);
  CHECK(json.at("kind") == "sampler");
  CHECK(json.at("parameters").at(0).at("name") == "n");
}

TEST_CASE("describe knows near misses") {
  const Desk desk;
  const Ended near = desk.moire({"describe", "supersmple"});
  CHECK(near.code == 2);
  CHECK(near.out == "");
  CHECK(near.err ==
        "supersmple: no sampler, scene, metric, picture, lookup or filter has this name; did you mean \"supersample\"? "
        "`moire "
        "list` "
        "shows all\n");
  CHECK(desk.moire({"describe", "unheard_of"}).err ==
        "unheard_of: no sampler, scene, metric, picture, lookup or filter has this name; `moire list` shows all\n");
}

TEST_CASE("the schema for editors is the one beside the sources") {
  INFO("renew it with `moire schema > framework/config/experiment.schema.json`");
  CHECK(Desk().moire({"schema"}).out == bytes_of(MOIRE_SOURCES "/framework/config/experiment.schema.json"));
}

TEST_CASE("check says that nothing is wrong, or what is, and writes nothing") {
  const Desk desk;
  desk.file("tiny/experiment.json", tiny_experiment());
  const Ended right = desk.moire({"check", "tiny"});
  CHECK(right.code == 0);
  CHECK(right.out == "tiny: 1 scene, 2 samplers, 2 metrics: nothing is wrong.\n");
  CHECK(right.err == "");
  const Ended wrong = desk.moire({"check", "tiny", "--set", "image.width=0"});
  CHECK(wrong.code == 2);
  CHECK(wrong.out == "");
  CHECK(wrong.err == "--set image.width=0: image.width: is 0; \"image\" takes 1 to 16384 pixels\n");
  CHECK(desk.files(".").size() == 1);
}

TEST_CASE("render writes one picture") {
  const Desk desk;
  const std::vector<std::string> small{"--set", "scene.size=64", "--width", "24", "--height", "16"};
  const auto render = [&](std::vector<std::string> more) {
    more.insert(more.begin(), "render");
    more.insert(more.end(), small.begin(), small.end());
    return desk.moire(more);
  };
  const Ended right = render({"heightfield", "point", "-o", "a.png"});
  CHECK(right.code == 0);
  CHECK(right.err == "");
  CHECK(right.out == "a.png: point on heightfield[size=64]\n");
  CHECK(desk.bytes("a.png").starts_with("\x89PNG"));

  desk.file("hills.json", R"({"type": "heightfield", "view": {"pitch_deg": -40}})");
  CHECK(render({"hills.json", "supersample", "--set", "sampler.n=2", "-o", "b.exr"}).code == 0);
  CHECK(desk.files(".").size() == 3);
}

TEST_CASE("render refuses what is wrong in words of its own") {
  const Desk desk;
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"heightfield", "pont"},
            "render: samplers[0].type: there is no sampler \"pont\"; did you mean \"point\"? known are "},
           {{"heightfield", "point", "--width", "0"}, "render: image.width: is 0; \"image\" takes 1 to 16384 pixels\n"},
           {{"heightfield", "point", "--set", "size=9"},
            "--set size=9: is neither of the scene nor of the sampler; write scene.NAME=VALUE or sampler.NAME=VALUE\n"},
           {{"heightfield", "point", "--set", "sampler.n=2"},
            "--set samplers[0].n=2: samplers[0].n: unknown key; \"point\" takes rays, lookup, "}}) {
    std::vector<std::string> command{"render"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Ended ended = desk.moire(command);
    CHECK(ended.code == 2);
    CHECK(ended.out == "");
    CHECK(ended.err.starts_with(message));
  }
  CHECK(desk.files(".").empty());
}

TEST_CASE("a new sampler is a folder of two files, and never replaces one that is there") {
  const Desk desk;
  const Ended made = desk.moire({"new", "sampler", "my_dots"});
  CHECK(made.code == 0);
  CHECK(made.out ==
        "./my_dots/my_dots.cpp: a sampler with one point in each pixel's middle; change points() and build it\n");
  const auto files = desk.files(".");
  CHECK(files.size() == 2);
  CHECK(files.at("my_dots/my_dots.cpp").find("class MyDots final") != std::string::npos);
  CHECK(files.at("my_dots/my_dots.cpp").find('@') == std::string::npos);
  CHECK(files.at("my_dots/CMakeLists.txt").ends_with("moire_add_sampler(my_dots my_dots.cpp)\n"));

  const Ended again = desk.moire({"new", "sampler", "my_dots"});
  CHECK(again.code == 2);
  CHECK(again.err == "./my_dots: is there already; choose another name\n");
  CHECK(desk.files(".") == files);
  CHECK(
      desk.moire({"new", "sampler", "My-Dots"}).err ==
      "new sampler: name is \"My-Dots\"; small letters, digits and single underscores would do, such as my_sampler\n");
}

}  // namespace moire::test
