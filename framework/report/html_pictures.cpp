// The pictures of a page.
#include "report/html_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "report/error_map.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

constexpr int magnification = 8;

std::string class_of(std::size_t picture) { return fmt::format("picture p{}", picture); }

std::string box_style(ImageSize size) { return fmt::format("width:{}px;height:{}px", size.width, size.height); }

Markup whole_picture(const ReportData& data, const Panel& panel, const std::string& label, const Markup& overlay = {}) {
  return tag("div",
             {{"class", class_of(panel.picture)},
              {"role", "img"},
              {"aria-label", label},
              {"style", box_style(data.pictures[panel.picture].size)}},
             overlay);
}

// The window of the picture, each of its pixels a square.
Markup picture_detail(const ReportData& data, const Panel& panel, const SceneView& view) {
  const auto [x, y, width, height] = view.detail_window;
  const ImageSize size = data.pictures[panel.picture].size;
  const std::string style =
      fmt::format("{};background-size:{}px {}px;background-position:{}px {}px",
                  box_style({width * magnification, height * magnification}), size.width * magnification,
                  size.height * magnification, -x * magnification, -y * magnification);
  return tag("div",
             {{"class", class_of(panel.picture)},
              {"role", "img"},
              {"style", style},
              {"aria-label", fmt::format("{}: {} by {} pixels from ({}, {}), magnified {} times", panel.name, width,
                                         height, x, y, magnification)}},
             "");
}

Markup caption(const Panel& panel) {
  Markup content = tag("span", {{"class", "name"}}, panel.name);
  if (!panel.error.empty()) {
    const Markup number =
        panel.is_below_reference ? tag("span", {{"class", "below"}}, panel.error) : Markup(panel.error);
    content += tag("span", {{"class", "value"}}, Markup(main_error + " ") + number);
  }
  if (!panel.caption.empty()) content += tag("span", {{"class", "what"}}, panel.caption);
  return tag("figcaption", content);
}

// What there is instead of a picture: the reason.
Markup missing_picture(const ReportData& data, const Panel& panel) {
  return tag("div", {{"class", "missing"}, {"style", fmt::format("width:{}px", data.results.width)}},
             tag("p", panel.problem));
}

Markup figure(const ReportData& data, const Panel& panel, const Markup& picture) {
  return tag("figure", (panel.picture == Panel::no_picture ? missing_picture(data, panel) : picture) + caption(panel));
}

// Wide rows scroll by themselves, by keyboard too, and leave the page where it is.
Markup strip(const std::string& label, const Markup& figures) {
  return tag("div", {{"class", "strip"}, {"role", "region"}, {"aria-label", label}, {"tabindex", "0"}}, figures);
}

// Shows where the detail was taken.
Markup window_frame(const SceneView& view) {
  const auto [x, y, width, height] = view.detail_window;
  return tag("span",
             {{"class", "window"}, {"style", fmt::format("left:{}px;top:{}px;{}", x, y, box_style({width, height}))}},
             "");
}

bool is_signed(const PictureRow& row) { return row.kind == "error_signed"; }

// A ramp of the map's own colours, near enough to each other for a browser to fill in.
std::string ramp_style(const PictureRow& row) {
  constexpr int steps = 32;
  std::string style = "background:linear-gradient(to right";
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    style += ',' + css_color(is_signed(row) ? signed_error_color(2 * t - 1, 1) : absolute_error_color(t, 1));
  }
  return style + ')';
}

Markup color_scale(const ReportData& data, const PictureRow& row) {
  constexpr int ticks = 4;
  const double low = is_signed(row) ? -row.scale : 0;
  const int decimals = decimals_for({&row.scale, 1});
  Markup labels;
  for (int i = 0; i <= ticks; ++i) {
    const double value = low + (row.scale - low) * i / ticks;
    const bool is_end = i == ticks || (i == 0 && is_signed(row));
    const std::string sign = value > 0 && is_signed(row) ? "+" : "";
    labels += tag("li", (is_end ? (value < 0 ? "\u2264 " : "\u2265 ") : "") + sign +
                            readable_text(value, value == 0 ? 0 : decimals));
  }
  const std::string unit = data.error_unit.empty() ? "" : " in " + data.error_unit;
  return tag("div", {{"class", "scale"}},
             tag("div", {{"class", "ramp"}, {"style", ramp_style(row)}}, "") + tag("ol", labels) +
                 tag("p", is_signed(row) ? "Method minus reference" + unit +
                                               ": blue is darker, red is brighter than the reference."
                                         : "Distance from the reference" + unit + ": black is none."));
}

std::string title_of(const PictureRow& row) {
  if (row.kind == "error_absolute") return "Absolute error";
  if (row.kind == "error_signed") return "Signed error";
  // "enlarged_pixel_2": the second picture that the experiment asks for.
  std::string title = row.kind;
  std::replace(title.begin(), title.end(), '_', ' ');
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

}  // namespace

Markup picture_styles(const ReportData& data) {
  std::string css;
  for (std::size_t i = 0; i < data.pictures.size(); ++i) {
    css += fmt::format(".p{}{{background-image:url(data:image/png;base64,{})}}\n", i, data.pictures[i].base64);
  }
  // Of one_over_the_other: the layer of the checked choice is the one that shows.
  for (std::size_t i = 1; i <= data.results.contenders.size() + 1; ++i) {
    css += fmt::format(".flip:has(label:nth-of-type({0}) :checked) .layer:nth-child({0}){{visibility:visible}}\n", i);
  }
  return tag("style", Markup::verbatim(css));
}

Markup side_by_side(const ReportData& data, const SceneView& view) {
  Markup figures, frame = window_frame(view);  // on the first picture only, since it hides pixels
  for (const Panel& panel : view.images.panels) {
    if (panel.picture == Panel::no_picture) {
      figures += figure(data, panel, {});
    } else {
      figures += figure(data, panel, whole_picture(data, panel, view.scene.name + " by " + panel.name, frame));
      frame = {};
    }
  }
  return tag("h3", "Pixel for pixel") + strip("Pictures of " + view.scene.name, figures);
}

Markup magnified(const ReportData& data, const SceneView& view) {
  Markup figures;
  for (const Panel& panel : view.images.panels) {
    if (panel.picture != Panel::no_picture) figures += figure(data, panel, picture_detail(data, panel, view));
  }
  const auto [x, y, width, height] = view.detail_window;
  return tag("h3", fmt::format("Magnified {} times", magnification)) +
         tag("p", {{"class", "note"}},
             fmt::format("The framed window of {} \u00d7 {} pixels at ({}, {}).", width, height, x, y)) +
         strip("Details of " + view.scene.name, figures);
}

Markup one_over_the_other(const ReportData& data, const SceneView& view, std::size_t scene_index) {
  Markup choices, stack;
  for (const Panel& panel : view.images.panels) {
    if (panel.picture == Panel::no_picture) continue;
    const std::string group = fmt::format("flip-{}", scene_index);
    const Markup button = choices.text().empty()
                              ? void_tag("input", {{"type", "radio"}, {"name", group}, {"checked", ""}})
                              : void_tag("input", {{"type", "radio"}, {"name", group}});
    choices += tag("label", button + tag("span", {{"class", "name"}}, panel.name) +
                                tag("span", {{"class", "value"}}, panel.error));
    stack += tag("div", {{"class", "layer"}},
                 whole_picture(data, panel, view.scene.name + " by " + panel.name) + picture_detail(data, panel, view));
  }
  const Markup note = "Choose one and press the arrow keys: what changes from method to method catches the eye.";
  return tag("div", {{"class", "in-one-place"}},
             tag("h3", "In one place") + tag("p", {{"class", "note"}}, note) +
                 tag("div", {{"class", "flip"}},
                     tag("fieldset", tag("legend", "Shown") + choices) + tag("div", {{"class", "stack"}}, stack)));
}

Markup picture_row(const ReportData& data, const PictureRow& row) {
  Markup figures;
  for (const Panel& panel : row.panels) {
    if (panel.picture == Panel::no_picture) {
      figures += figure(data, panel, {});
    } else {
      figures += figure(data, panel, whole_picture(data, panel, title_of(row) + " of " + panel.name));
    }
  }
  return tag("h3", title_of(row)) + (row.scale > 0 ? color_scale(data, row) : Markup()) + strip(title_of(row), figures);
}

}  // namespace moire::report
