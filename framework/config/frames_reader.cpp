#include "config/frames_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "config/experiment_format.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

bool can_move(const Parameter& parameter) { return parameter.type == Type::real && parameter.is_per_frame; }

class FramesReader {
 public:
  FramesReader(const std::vector<Choice>& scenes, const Reading& reading) : scenes_(scenes), reading_(reading) {}

  Frames read(const JsonNode& node) {
    if (!node.is(JsonKind::object)) {
      problem(node.place, "frames", fmt::format("is {}; it takes an object with {}", shown(node), listed(keys)));
      return {};
    }
    for (const JsonMember& member : node.members) {
      if (std::find(std::begin(keys), std::end(keys), member.key) == std::end(keys)) {
        problem(member.place, member_path("frames", member.key),
                fmt::format("unknown key{} frames take {}", did_you_mean(member.key, keys), listed(keys)));
      }
    }
    frames_.count = whole(node, format::frame_count);
    frames_.still = whole(node, format::still_frame);
    if (frames_.still >= frames_.count) {
      problem(node.find(format::still_frame.name)->place, "frames.still",
              fmt::format("is {}; frames are numbered from 0 to {}", frames_.still, frames_.count - 1));
    }
    for (std::string_view key : {format::animate_key, format::move_key}) {
      if (const JsonNode* tracks = node.find(key))
        read_tracks(*tracks, member_path("frames", key), key == format::move_key);
    }
    return std::move(frames_);
  }

 private:
  static constexpr std::string_view keys[] = {format::frame_count.name, format::still_frame.name, format::animate_key,
                                              format::move_key};

  void problem(const Place& place, const std::string& path, const std::string& what) {
    reading_.problems.add(place, path, what);
  }

  // Of a wrong count the largest there may be, so that nothing is said about the frames that are within it.
  int whole(const JsonNode& object, const Parameter& parameter) {
    const JsonNode* node = object.find(parameter.name);
    if (!node) return static_cast<int>(parameter.number);
    const auto cell = read_value(*node, member_path("frames", parameter.name), parameter, "frames", reading_);
    if (cell) return static_cast<int>(std::get<std::int64_t>(cell->value));
    return static_cast<int>(parameter.name == format::frame_count.name ? parameter.largest : parameter.number);
  }

  // "[[0, 1.5], [399, 9]]", of frames that there are.
  std::string example() const {
    return frames_.count > 1 ? fmt::format("[[0, 1.5], [{}, 9]]", frames_.count - 1) : "[[0, 1.5]]";
  }

  void read_tracks(const JsonNode& tracks, const std::string& where, bool is_added) {
    if (!tracks.is(JsonKind::object)) {
      return problem(tracks.place, where,
                     fmt::format("is {}; it takes an object such as {{\"view.x\": {}}}", shown(tracks), example()));
    }
    read_members(tracks, where, "", is_added);
  }

  // Those that stand under `prefix`: "view.x" may be written as a member of "view".
  void read_members(const JsonNode& tracks, const std::string& where, const std::string& prefix, bool is_added) {
    for (const JsonMember& member : tracks.members) {
      const std::string path = member_path(where, member.key), name = prefix + member.key;
      if (member.value.is(JsonKind::object) && is_group(name)) {
        read_members(member.value, path, name + ".", is_added);
        continue;
      }
      const auto is_same = [&](const Track& track) { return track.parameter == name; };
      if (std::any_of(frames_.tracks.begin(), frames_.tracks.end(), is_same)) {
        problem(member.place, path, "is animated already; one of the two would do");
        continue;
      }
      bool is_known = true;
      const Plugin* last = nullptr;  // the scenes of a grid lie side by side and have one table
      for (const Choice& scene : scenes_) {
        if (scene.plugin != last) is_known = is_movable(scene, name, member.place, path) && is_known;
        last = scene.plugin;
      }
      if (is_known) read_track(name, member.value, path, is_added);
    }
  }

  bool is_group(const std::string& name) const {
    return std::any_of(scenes_.begin(), scenes_.end(), [&](const Choice& scene) {
      return std::any_of(scene.table.begin(), scene.table.end(),
                         [&](const Parameter& parameter) { return parameter.name.starts_with(name + "."); });
    });
  }

  bool is_movable(const Choice& scene, const std::string& name, const Place& place, const std::string& path) {
    std::vector<std::string_view> movable;
    for (const Parameter& parameter : scene.table) {
      if (!can_move(parameter)) continue;
      if (parameter.name == name) return true;
      movable.push_back(parameter.name);
    }
    problem(place, path,
            movable.empty() ? fmt::format("scene \"{}\" has nothing that can be animated", scene.plugin->name)
                            : fmt::format("cannot be animated in scene \"{}\"{} what can is {}", scene.plugin->name,
                                          did_you_mean(name, movable), listed(movable)));
    return false;
  }

  void read_track(const std::string& name, const JsonNode& list, const std::string& path, bool is_added) {
    if (!list.is(JsonKind::list) || list.items.empty()) {
      return problem(list.place, path,
                     fmt::format("is {}; it takes keyframes such as {}",
                                 list.is(JsonKind::list) ? "an empty list" : shown(list), example()));
    }
    Track track{name, {}, is_added};
    for (std::size_t i = 0; i < list.items.size(); ++i) read_key(list.items[i], item_path(path, i), track);
    if (track.keys.size() == list.items.size()) frames_.tracks.push_back(std::move(track));
  }

  void read_key(const JsonNode& node, const std::string& path, Track& track) {
    const bool is_pair = node.is(JsonKind::list) && node.items.size() == 2 && node.items[0].is(JsonKind::integer) &&
                         node.items[1].is_number();
    if (!is_pair) return problem(node.place, path, "is no keyframe; one is [frame, value], such as [0, 1.5]");
    const std::int64_t frame = node.items[0].integer;
    if (frame < 0 || frame >= frames_.count) {
      return problem(node.place, path,
                     fmt::format("is at frame {}; frames are numbered from 0 to {}", frame, frames_.count - 1));
    }
    if (!track.keys.empty() && frame <= track.keys.back().frame) {
      return problem(
          node.place, path,
          fmt::format("is at frame {}, after one at {}; frames of keyframes rise", frame, track.keys.back().frame));
    }
    for (const Choice& scene : scenes_) {
      const auto parameter = std::find_if(scene.table.begin(), scene.table.end(),
                                          [&](const Parameter& p) { return p.name == track.parameter; });
      if (!is_allowed(node.items[1], item_path(path, 1), scene, *parameter, track.is_added)) return;
    }
    track.keys.push_back({static_cast<int>(frame), node.items[1].real});
  }

  // What is added must leave the sum within the parameter's range.
  bool is_allowed(const JsonNode& node, const std::string& path, const Choice& scene, const Parameter& parameter,
                  bool is_added) {
    if (!is_added) return read_value(node, path, parameter, scene.plugin->name, reading_).has_value();
    const double sum = settings_of(scene.table, scene.cells).real(parameter.name) + node.real;
    if (sum >= parameter.smallest && sum <= parameter.largest) return true;
    problem(node.place, path,
            fmt::format("makes {} of \"{}\"; \"{}\" takes {} to {}", sum, parameter.name, scene.plugin->name,
                        parameter.smallest, parameter.largest));
    return false;
  }

  const std::vector<Choice>& scenes_;
  const Reading& reading_;
  Frames frames_;
};

}  // namespace

Frames read_frames(const JsonNode* node, const std::vector<Choice>& scenes, const Reading& reading) {
  return node ? FramesReader(scenes, reading).read(*node) : Frames();
}

nlohmann::ordered_json written(const Frames& frames) {
  nlohmann::ordered_json animate = nlohmann::ordered_json::object(), move = animate;
  for (const Track& track : frames.tracks) {
    for (const Keyframe& key : track.keys)
      (track.is_added ? move : animate)[track.parameter].push_back({key.frame, key.value});
  }
  return {{format::frame_count.name, frames.count},
          {format::still_frame.name, frames.still},
          {format::animate_key, std::move(animate)},
          {format::move_key, std::move(move)}};
}

}  // namespace moire
