#include "svg.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <moire/error.h>

#include "drawing/pen.h"
#include "lines.h"
#include "numbers.h"
#include "shapes.h"
#include "style.h"
#include "transform.h"

namespace cartoon {

namespace {

using moire::Error;

constexpr int deepest = 1000;               // levels of groups; bounds the recursion
constexpr std::size_t longest_list = 1000;  // unmodelled parts named in a message

// What is never painted itself. What refers to it is told by the attribute that does.
constexpr std::string_view unpainted[] = {
    "defs",   "metadata", "title",          "desc",           "symbol",        "clipPath",
    "mask",   "filter",   "linearGradient", "radialGradient", "pattern",       "marker",
    "script", "cursor",   "font",           "font-face",      "color-profile", "view",
};

// `name` with our own signs only, for messages.
std::string printable(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > 60 ? shown + "..." : shown;
}

class Reader {
 public:
  Reader(std::string_view text, std::string_view name) : name_(name), lines_(text), pen_(drawing_) {
    document_.reset();
    const pugi::xml_parse_result result =
        document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
      throw Error(fmt::format("{}:{}: is not XML ({}); an SVG drawing is", name_,
                              lines_.line_of(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0))),
                              result.description()));
    }
  }

  Drawing read(Unmodelled unmodelled) {
    const pugi::xml_node root = document_.document_element();
    if (local_name(root) != "svg") {
      throw Error(fmt::format("{}:{}: begins with <{}>; an SVG drawing begins with <svg>", name_, line_of(root),
                              printable(root.name())));
    }
    read_view_box(root);
    visit_children(root, Style{}, moire::Affine{}, 0);
    if (count_ > 0 && unmodelled == Unmodelled::refuse) {
      if (count_ > longest_list) list_ += fmt::format("{}: and {} more\n", name_, count_ - longest_list);
      throw Error(
          fmt::format("{0}{1}: has {2} part{3} that cannot be shown (listed above); \"unsupported\": \"skip\" "
                      "leaves {4} out",
                      list_, name_, count_, count_ == 1 ? "" : "s", count_ == 1 ? "it" : "them"));
    }
    return std::move(drawing_);
  }

 private:
  // Without the prefix that some programs write; nothing for elements of other vocabularies.
  static std::string_view local_name(const pugi::xml_node& element) {
    std::string_view name = element.name();
    if (name.starts_with("svg:")) name.remove_prefix(4);
    return name.find(':') == name.npos ? name : std::string_view();
  }

  std::size_t line_of(const pugi::xml_node& element) const {
    return lines_.line_of(static_cast<std::size_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0)));
  }

  // `drawing.svg:12: <path id="eye">`
  std::string where(const pugi::xml_node& element) const {
    const std::string_view id = element.attribute("id").value();
    return fmt::format("{}:{}: <{}{}>", name_, line_of(element), printable(element.name()),
                       id.empty() ? "" : fmt::format(" id=\"{}\"", printable(id)));
  }

  [[noreturn]] void fail(const pugi::xml_node& element, std::string_view what) const {
    throw Error(fmt::format("{}: {}", where(element), what));
  }

  void list(const pugi::xml_node& element, std::string_view what) {
    if (++count_ > longest_list) return;
    list_ += fmt::format("{}{}{}\n", where(element), what.empty() ? "" : ": ", printable(what));
  }

  void read_view_box(const pugi::xml_node& root) {
    const std::string_view text = root.attribute("viewBox").value();
    if (trimmed(text).empty()) return;
    Numbers numbers(text);
    double values[4];
    numbers.skip_space();
    for (double& value : values) {
      const std::optional<double> number = numbers.number();
      if (!number) fail(root, fmt::format("viewBox is {}; it takes x y width height", shown_front(text)));
      value = *number;
      numbers.skip_separator();
    }
    if (!numbers.at_end()) fail(root, fmt::format("viewBox is {}; it takes x y width height", shown_front(text)));
    drawing_.view_box = {values[0], values[1], values[2], values[3]};
  }

  void visit_children(const pugi::xml_node& parent, Style style, const moire::Affine& outer, int depth) {
    if (depth > deepest) fail(parent, fmt::format("is nested more than {} levels deep", deepest));
    moire::Affine transform = outer;
    if (!begin(parent, style, transform)) return;
    for (const pugi::xml_node& child : parent.children()) {
      if (child.type() == pugi::node_element) visit(child, style, transform, depth);
    }
  }

  // Makes style and transform those of the element. False: nothing of it is shown.
  bool begin(const pugi::xml_node& element, Style& style, moire::Affine& transform) {
    OwnStyle own;
    try {
      own = read_style(element, style);
    } catch (const Error& error) {
      fail(element, error.what());
    }
    if (!own.shown) return false;
    for (const std::string& what : own.unmodelled) list(element, what);
    if (!own.unmodelled.empty()) return false;
    if (const char* text = element.attribute("transform").value(); *text != '\0') {
      try {
        transform = then(parse_transform(text), transform);
      } catch (const Error& error) {
        fail(element, fmt::format("transform {}", error.what()));
      }
    }
    return true;
  }

  void visit(const pugi::xml_node& element, const Style& style, const moire::Affine& transform, int depth) {
    const std::string_view name = local_name(element);
    if (name == "g" || name == "a") return visit_children(element, style, transform, depth + 1);
    if (name.empty()) return;  // an editor's own
    if (name == "style" && trimmed(element.text().get()).empty()) return;
    if (std::ranges::find(unpainted, name) != std::end(unpainted)) return;
    visit_shape(element, name, style, transform);
  }

  void visit_shape(const pugi::xml_node& element, std::string_view name, Style style, moire::Affine transform) {
    if (!begin(element, style, transform)) return;
    for (const pugi::xml_node& child : element.children()) {
      const std::string_view within = local_name(child);
      if (within.starts_with("animate") || within == "set") list(child, "");
    }
    pen_.set_transform(transform);
    try {
      if (name != "line" && !draw_shape(name, element, pen_)) return list(element, "");
    } catch (const Error& error) {
      fail(element, error.what());
    }
    paint(element, style);
  }

  // Makes a layer of what was drawn, if it is filled.
  void paint(const pugi::xml_node& element, const Style& style) {
    using enum Paint::Kind;
    const bool is_line = local_name(element) == "line";
    if (!style.visible || !(pen_.has_drawn() || is_line)) return pen_.discard();
    if (style.stroke.kind != none && style.stroke_has_width && style.stroke_opacity > 0) {
      list(element, fmt::format("stroke {}", style.stroke.text));
    }
    const bool is_filled = style.fill.kind != none && style.fill_opacity > 0 && !is_line;
    if (is_filled && style.fill.kind == unmodelled) {
      list(element, fmt::format("fill {}", style.fill.text));
    } else if (is_filled && style.fill_opacity < 1) {
      list(element, fmt::format("fill-opacity {:g}", style.fill_opacity));
    } else if (is_filled) {
      return pen_.finish(style.fill.kind == current ? style.color : style.fill.rgb, style.rule);
    }
    pen_.discard();
  }

  std::string_view name_;
  Lines lines_;
  pugi::xml_document document_;
  Drawing drawing_;
  Pen pen_;
  std::size_t count_ = 0;  // of unmodelled parts
  std::string list_;       // a line for each
};

}  // namespace

Drawing read_svg(std::string_view text, std::string_view name, Unmodelled unmodelled) {
  return Reader(text, name).read(unmodelled);
}

}  // namespace cartoon
