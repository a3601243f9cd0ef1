#include "config/frames.h"

#include <catch2/catch_test_macros.hpp>

#include "config/frames_reader.h"
#include "experiment_folder.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

// The problems of an experiment with these frames; with `scenes` in line 4, and the frames in line 6.
std::string problems(const std::string& frames, const std::string& scenes = R"(["heightfield"])") {
  return ExperimentFolder().problems_with({R"("scenes": )" + scenes, R"("frames": )" + frames});
}

}  // namespace

TEST_CASE("a track is straight between its keyframes and constant outside") {
  const Track track{"view.x", {{2, -1}, {6, 7}, {7, 100}, {17, 95}}, false};
  CHECK(track.at(0) == -1);
  CHECK(track.at(2) == -1);
  CHECK(track.at(3) == 1);
  CHECK(track.at(5) == 5);
  CHECK(track.at(6) == 7);
  CHECK(track.at(7) == 100);
  CHECK(track.at(8) == 99.5);
  CHECK(track.at(17) == 95);
  CHECK(track.at(1000) == 95);
}

TEST_CASE("a track of one keyframe is constant") {
  const Track track{"view.x", {{3, 0.1}}, false};
  for (const int frame : {0, 2, 3, 4, 99}) CHECK(track.at(frame) == 0.1);
}

TEST_CASE("a frame's settings are the scene's own, but for the tracks") {
  static constexpr Parameter table[] = {parameter::real("view.x", 1, -100, 100, "", "").per_frame(),
                                        parameter::real("view.y", 2, -100, 100, "", "").per_frame(),
                                        parameter::integer("size", 3, 0, 9, "", "")};
  const Frames frames{10, 0, {{"view.x", {{0, 10}, {9, 19}}}, {"view.y", {{0, 0}, {9, -18}}, true}}};
  Settings expected(table);
  for (int frame = 0; frame < 10; ++frame) {
    expected.set("view.x", 10.0 + frame);
    expected.set("view.y", 2.0 - 2 * frame);  // added to the scene's own 2
    CHECK(settings_at(Settings(table), frames, frame) == expected);
  }
}

TEST_CASE("what is added is read and written apart, and its sum with each scene's own value is in range") {
  const std::string scenes = R"([{"type": "heightfield", "view": {"pitch_deg": [-20, 80]}}])";
  const Frames frames =
      ExperimentFolder()
          .read(experiment_with(
              {R"("scenes": )" + scenes, R"("frames": {"count": 5, "move": {"view.pitch_deg": [[0, 0], [4, 10]]}})"}))
          .frames;
  REQUIRE(frames.tracks.size() == 1);
  CHECK(frames.tracks[0].is_added);
  CHECK(written(frames).dump() == R"({"count":5,"still":0,"animate":{},"move":{"view.pitch_deg":[[0,0.0],[4,10.0]]}})");
  CHECK(problems(R"({"count": 5, "move": {"view.pitch_deg": [[0, 0], [4, 11]]}})", scenes) ==
        "edges/experiment.json:6: frames.move.view.pitch_deg[1][1]: makes 91 of \"view.pitch_deg\"; "
        "\"heightfield\" takes -90 to 90");
  CHECK(problems(R"({"animate": {"view.pitch_deg": [[0, 0]]}, "move": {"view.pitch_deg": [[0, 1]]}})") ==
        "edges/experiment.json:6: frames.move.view.pitch_deg: is animated already; one of the two would do");
}

TEST_CASE("a parameter of a group may be written as its member, as in a scene") {
  const Frames frames =
      ExperimentFolder()
          .read(experiment_with({R"("frames": {"count": 5, "move": {"view": {"height": [[0, 1]]}}})"}))
          .frames;
  REQUIRE(frames.tracks.size() == 1);
  CHECK(frames.tracks[0].parameter == "view.height");
  CHECK(problems(R"({"move": {"view": {"heigth": [[0, 1]]}}})") ==
        "edges/experiment.json:6: frames.move.view.heigth: cannot be animated in scene \"heightfield\"; did you mean "
        "\"view.height\"? what can is view.pitch_deg, view.height");
}

TEST_CASE("an experiment that says nothing of frames has one, and nothing moves") {
  const Frames frames = ExperimentFolder().read(experiment_with({})).frames;
  CHECK(frames.count == 1);
  CHECK(frames.still == 0);
  CHECK(frames.tracks.empty());
}

TEST_CASE("frames are read as they are written") {
  const Frames frames = ExperimentFolder()
                            .read(experiment_with({R"("frames": {"count": 400, "still": 399,
          "animate": {"view.height": [[0, 100], [9, 0.5], [399, -1e3]], "view.pitch_deg": [[200, -90]]}})"}))
                            .frames;
  CHECK(frames.count == 400);
  CHECK(frames.still == 399);
  REQUIRE(frames.tracks.size() == 2);
  CHECK(frames.tracks[0].parameter == "view.height");
  REQUIRE(frames.tracks[0].keys.size() == 3);
  CHECK(frames.tracks[0].keys[0].frame == 0);
  CHECK(frames.tracks[0].keys[0].value == 100);
  CHECK(frames.tracks[0].keys[1].frame == 9);
  CHECK(frames.tracks[0].keys[1].value == 0.5);
  CHECK(frames.tracks[0].keys[2].frame == 399);
  CHECK(frames.tracks[0].keys[2].value == -1000);
  CHECK(frames.tracks[1].parameter == "view.pitch_deg");
  REQUIRE(frames.tracks[1].keys.size() == 1);
  CHECK(frames.tracks[1].keys[0].value == -90);
}

TEST_CASE("frames are an object of known keys") {
  CHECK(problems("400") ==
        "edges/experiment.json:6: frames: is 400; it takes an object with count, still, animate, move");
  CHECK(problems(R"({"cuont": 3, "stills": 0, "rate": 25})") ==
        "edges/experiment.json:6: frames.cuont: unknown key; did you mean \"count\"? frames take count, still, "
        "animate, move\n"
        "edges/experiment.json:6: frames.stills: unknown key; did you mean \"still\"? frames take count, still, "
        "animate, move\n"
        "edges/experiment.json:6: frames.rate: unknown key; frames take count, still, animate, move");
}

TEST_CASE("a wrong count is said once: what is within the largest count is not held against it") {
  CHECK(problems(R"({"count": 0, "still": 7, "animate": {"view.height": [[0, 1], [99, 2]]}})") ==
        "edges/experiment.json:6: frames.count: is 0; \"frames\" takes 1 to 1000000 frames");
  CHECK(problems(R"({"count": 2.5})") ==
        "edges/experiment.json:6: frames.count: is 2.5; \"frames\" takes a whole number, 1 to 1000000 frames");
  CHECK(problems(R"({"count": 1000001})") ==
        "edges/experiment.json:6: frames.count: is 1000001; \"frames\" takes 1 to 1000000 frames");
  CHECK(problems(R"({"count": "all"})") ==
        "edges/experiment.json:6: frames.count: is \"all\"; \"frames\" takes a whole number, 1 to 1000000 frames");
}

TEST_CASE("the still is one of the frames") {
  CHECK(problems(R"({"count": 5, "still": 4})") == "(no error)");
  CHECK(problems(R"({"count": 5, "still": 5})") ==
        "edges/experiment.json:6: frames.still: is 5; frames are numbered from 0 to 4");
  CHECK(problems(R"({"still": 1})") == "edges/experiment.json:6: frames.still: is 1; frames are numbered from 0 to 0");
  CHECK(problems(R"({"count": 5, "still": -1})") ==
        "edges/experiment.json:6: frames.still: is -1; \"frames\" takes 0 to 999999");
}

TEST_CASE("what is animated is an object of tracks") {
  CHECK(problems(R"({"count": 9, "animate": ["view.height"]})") ==
        "edges/experiment.json:6: frames.animate: is a list; it takes an object such as {\"view.x\": [[0, 1.5], [8, "
        "9]]}");
  CHECK(problems(R"({"animate": 3})") ==
        "edges/experiment.json:6: frames.animate: is 3; it takes an object such as {\"view.x\": [[0, 1.5]]}");
}

TEST_CASE("only what a scene says may be animated can be, and every kind of scene must say so") {
  CHECK(problems(R"({"animate": {"view.heigth": [[0, 1]]}})") ==
        "edges/experiment.json:6: frames.animate.view.heigth: cannot be animated in scene \"heightfield\"; did you "
        "mean \"view.height\"? what can is view.pitch_deg, view.height");
  // Known, but no number, or fixed once the scene is made.
  CHECK(problems(R"({"animate": {"hierarchy": [[0, 1]]}})") ==
        "edges/experiment.json:6: frames.animate.hierarchy: cannot be animated in scene \"heightfield\"; what can is "
        "view.pitch_deg, view.height");
  CHECK(problems(R"({"animate": {"credit": [[0, 1]]}})") ==
        "edges/experiment.json:6: frames.animate.credit: cannot be animated in scene \"heightfield\"; what can is "
        "view.pitch_deg, view.height");
  CHECK(problems(R"({"animate": {"view.height": [[0, 1]]}})", R"(["cartoon", "heightfield"])") ==
        "edges/experiment.json:6: frames.animate.view.height: scene \"cartoon\" has nothing that can be animated");
  // A grid of scenes has one table, and one thing wrong.
  CHECK(problems(R"({"animate": {"sky": [[0, 1]]}})", R"([{"type": "heightfield", "view": {"height": [1, 2, 3]}}])") ==
        "edges/experiment.json:6: frames.animate.sky: cannot be animated in scene \"heightfield\"; what can is "
        "view.pitch_deg, view.height");
}

TEST_CASE("a track is a list of keyframes, one at least") {
  CHECK(problems(R"({"count": 10, "animate": {"view.height": 7}})") ==
        "edges/experiment.json:6: frames.animate.view.height: is 7; it takes keyframes such as [[0, 1.5], [9, 9]]");
  CHECK(problems(R"({"count": 10, "animate": {"view.height": []}})") ==
        "edges/experiment.json:6: frames.animate.view.height: is an empty list; it takes keyframes such as [[0, 1.5], "
        "[9, 9]]");
  CHECK(problems(R"({"animate": {"view.height": {}}})") ==
        "edges/experiment.json:6: frames.animate.view.height: is an object; it takes keyframes such as [[0, 1.5]]");
}

TEST_CASE("a keyframe is a pair of a whole frame and a number") {
  for (const char* key : {"3", "[]", "[0]", "[0, 1, 2]", "[0.5, 1]", R"(["0", 1])", R"([0, "1"])", "[0, [1]]",
                          "[0, true]", "[0, null]"}) {
    INFO(key);
    CHECK(problems(std::string(R"({"count": 10, "animate": {"view.height": [[0, 1], )") + key + "]}}") ==
          "edges/experiment.json:6: frames.animate.view.height[1]: is no keyframe; one is [frame, value], such as [0, "
          "1.5]");
  }
}

TEST_CASE("keyframes lie within the frames, and rise") {
  CHECK(problems(R"({"count": 10, "animate": {"view.height": [[-1, 0], [10, 1], [9, 2]]}})") ==
        "edges/experiment.json:6: frames.animate.view.height[0]: is at frame -1; frames are numbered from 0 to 9\n"
        "edges/experiment.json:6: frames.animate.view.height[1]: is at frame 10; frames are numbered from 0 to 9");
  CHECK(problems(R"({"count": 10, "animate": {"view.height": [[4, 0], [4, 1], [3, 1], [5, 2]]}})") ==
        "edges/experiment.json:6: frames.animate.view.height[1]: is at frame 4, after one at 4; frames of keyframes "
        "rise\n"
        "edges/experiment.json:6: frames.animate.view.height[2]: is at frame 3, after one at 4; frames of keyframes "
        "rise");
  // Beyond what an int holds.
  CHECK(problems(R"({"count": 10, "animate": {"view.height": [[4294967296, 0]]}})") ==
        "edges/experiment.json:6: frames.animate.view.height[0]: is at frame 4294967296; frames are numbered from 0 to "
        "9");
}

TEST_CASE("values of keyframes have the parameter's range") {
  CHECK(problems(R"({"count": 10, "animate": {"view.pitch_deg": [[0, -90], [5, 90.5], [9, -91]]}})") ==
        "edges/experiment.json:6: frames.animate.view.pitch_deg[1][1]: is 90.5; \"heightfield\" takes -90 to 90 "
        "degrees\n"
        "edges/experiment.json:6: frames.animate.view.pitch_deg[2][1]: is -91; \"heightfield\" takes -90 to 90 "
        "degrees");
}

}  // namespace moire::test
