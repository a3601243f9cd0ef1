// report.html: one page that holds everything, opens from disk and asks no network.
#include "report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/whole_file.h"
#include "report/curve_chart.h"
#include "report/flattened.h"
#include "report/html_histogram.h"
#include "report/html_pictures.h"
#include "report/html_table.h"
#include "report/numbers.h"
#include "report/stylesheet.h"

namespace moire::report {
namespace {

constexpr const char* content_policy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

std::string scene_anchor(std::size_t index) { return fmt::format("scene-{}", index + 1); }

std::string analysis_anchor(std::size_t index) { return fmt::format("analysis-{}", index + 1); }

std::string counted(std::size_t count, const std::string& one) {
  return count == 1 ? fmt::format("one {}", one) : fmt::format("{} {}s", count, one);
}

Markup section(const std::string& anchor, const Markup& title, const Markup& content) {
  return tag("section", {{"id", anchor}}, tag("h2", title) + content);
}

Markup details(const std::string& title, const Markup& content) {
  return tag("details", tag("summary", title) + content);
}

Markup settings_text(const nlohmann::ordered_json& settings) {
  std::string text;
  for (const auto& [name, value] : flattened(settings)) text += (text.empty() ? "" : "\n") + name + " = " + value;
  return text.empty() ? tag("span", {{"class", "none"}}, "none") : tag("code", text);
}

Markup name_value_table(const std::string& label, const std::vector<std::pair<std::string, std::string>>& entries) {
  Markup rows;
  for (const auto& [name, value] : entries)
    rows += tag("tr", tag("th", {{"scope", "row"}}, name) + tag("td", {{"class", "prose"}}, value));
  return scrolling_table(label, {}, rows);
}

std::string own_error(const ReportData& data, const SceneResult& scene) {
  const std::string& how = scene.reference_error_how;
  if (std::isnan(scene.reference_error)) return how.empty() ? "" : fmt::format(" Its own error is {}.", how);
  return fmt::format(" Its own error is {} {}{}.", readable_text(scene.reference_error), data.error_unit,
                     how.empty() ? "" : fmt::format(" ({})", how));
}

Markup left_out(const SceneResult& scene) {
  std::string names;
  for (const auto& [sampler, missing] : scene.without)
    names += fmt::format("{}{} (no {})", names.empty() ? "" : ", ", sampler, missing);
  return names.empty() ? Markup() : tag("p", {{"class", "note"}}, "Left out here: " + names + ".");
}

Markup reference_text(const ReportData& data, const SceneResult& scene) {
  if (scene.reference.empty())
    return tag("p", {{"class", "note"}}, "No reference: nothing here is judged by its error.");
  Markup text = "Reference: " + tag("code", scene.reference) + ", " + scene.reference_origin + ".";
  text += own_error(data, scene);
  if (!scene.fragments_reference.empty())
    text += " Fragments are held against " + tag("code", scene.fragments_reference) +
            ", on the frame that the contenders see.";
  return tag("p", {{"class", "note"}}, text);
}

// One paragraph: what was compared with what.
Markup lede(const ReportData& data) {
  const Results& results = data.results;
  std::string names;
  for (const SceneView& view : data.scenes) names += (names.empty() ? "" : ", ") + view.scene.name;
  Markup text = fmt::format("{} on {} ({}), {} \u00d7 {} pixels.", counted(results.contenders.size(), "contender"),
                            counted(results.scenes.size(), "scene"), names, results.width, results.height);
  const auto& scenes = results.scenes;
  const bool is_one_reference = std::all_of(scenes.begin(), scenes.end(), [&](const SceneResult& scene) {
    return scene.reference == scenes.front().reference;
  });
  if (!scenes.empty() && is_one_reference && !scenes.front().reference.empty()) {
    text += " Errors are distances from the reference " + tag("code", scenes.front().reference) + ".";
  } else if (!is_one_reference) {
    text += " Errors are distances from each scene\u2019s own reference, named there.";
  }
  return tag("p", {{"class", "lede"}}, text);
}

Markup navigation(const ReportData& data) {
  Markup links;
  for (std::size_t i = 0; i < data.scenes.size(); ++i) {
    links += tag("a", {{"href", fmt::format("#{}", scene_anchor(i))}}, data.scenes[i].scene.name);
  }
  for (std::size_t i = 0; i < data.results.analyses.size(); ++i) {
    links += tag("a", {{"href", fmt::format("#{}", analysis_anchor(i))}}, data.results.analyses[i].title);
  }
  links += tag("a", {{"href", "#contenders"}}, "Contenders");
  links += tag("a", {{"href", "#metrics"}}, "Metrics") + tag("a", {{"href", "#provenance"}}, "Provenance");
  return tag("nav", {{"aria-label", "Sections"}}, links);
}

// What a reader must know before believing a number.
Markup notices(const Results& results) {
  Markup out;
  if (results.interrupted) {
    out += tag("div", {{"class", "notice"}, {"role", "note"}},
               tag("strong", "This run was interrupted.") + " Only what had finished is shown.");
  }
  if (results.failures.empty()) return out;
  Markup rows;
  for (const Failure& failure : results.failures) {
    rows += tag("tr", tag("th", {{"scope", "row"}}, failure.sampler) + tag("td", failure.scene) +
                          tag("td", {{"class", "prose"}}, failure.message));
  }
  const Markup head = tag("th", {{"scope", "col"}}, "contender") + tag("th", {{"scope", "col"}}, "scene") +
                      tag("th", {{"scope", "col"}}, "reason");
  return out + tag("div", {{"class", "notice"}, {"role", "note"}},
                   tag("strong", counted(results.failures.size(), "failure") + ".") +
                       " The rest of the run is not affected." + scrolling_table("Failures", tag("tr", head), rows));
}

Markup contenders(const Results& results) {
  Markup head, rows;
  for (const char* title : {"name", "type", "settings", "lookup", "what it does"})
    head += tag("th", {{"scope", "col"}}, title);
  for (const ContenderResult& contender : results.contenders) {
    Markup what = contender.summary;
    if (!contender.source.empty()) what += tag("span", {{"class", "source"}}, contender.source);
    rows += tag("tr", tag("th", {{"scope", "row"}}, contender.name) +
                          tag("td", contender.type + tag("span", {{"class", "unit"}}, contender.version)) +
                          tag("td", {{"class", "settings"}}, settings_text(contender.settings)) +
                          tag("td", contender.lookup) + tag("td", {{"class", "prose"}}, what));
  }
  return scrolling_table("Contenders", tag("tr", head), rows);
}

Markup findings(const SceneView& view) {
  Markup list;
  for (const Finding& finding : view.findings) {
    list += tag("div", tag("dt", finding.title) + tag("dd", tag("b", finding.name) + tag("span", finding.detail)));
  }
  return list.text().empty() ? Markup() : tag("dl", {{"class", "findings"}}, list);
}

Markup speed_against_error(const SceneView& view) {
  if (view.chart.points.empty()) return {};
  std::string note =
      "Left and down is better. The line is the Pareto front: no contender beats these in both; the others are dimmed.";
  if (std::any_of(view.chart.points.begin(), view.chart.points.end(),
                  [&](const ChartPoint& p) { return view.chart.floor > 0 && p.y <= view.chart.floor; }))
    note += " Hollow points are below the reference\u2019s accuracy and stand at it: as good as can be told.";
  std::string missing;
  for (const std::string& name : view.not_in_chart) missing += (missing.empty() ? "" : ", ") + name;
  if (!missing.empty()) note += " Without both numbers, and so not shown: " + missing + ".";
  return tag("h3", "Speed against error") +
         tag("figure", {{"class", "chart"}}, scatter_chart(view.chart) + tag("figcaption", {{"class", "note"}}, note));
}

// A chart for each kind of curve that the scene has.
Markup curves(const Results& results, const std::string& scene) {
  std::vector<const CurveResult*> kinds;
  for (const CurveResult& curve : results.curves) {
    const bool is_new = std::none_of(kinds.begin(), kinds.end(), [&](const auto* k) { return k->kind == curve.kind; });
    if (curve.scene == scene && is_new) kinds.push_back(&curve);
  }
  Markup out;
  for (const CurveResult* kind : kinds) {
    std::vector<ChartCurve> lines;
    for (const CurveResult& curve : results.curves) {
      if (curve.scene == scene && curve.kind == kind->kind) lines.push_back({curve.sampler, curve.points});
    }
    out += tag("h3", kind->title) +
           tag("figure", {{"class", "chart"}}, curve_chart(kind->title, kind->x_axis, kind->y_axis, lines));
  }
  return out;
}

Markup numbers(const Results& results, const SceneView& view) {
  if (view.table.columns.empty()) return {};
  return tag("h3", "Numbers") + metric_tables(results, view.table) +
         tag("p", {{"class", "note"}},
             "Bold is the best contender of a column. A dotted line marks what is below the "
             "reference\u2019s accuracy: as good as can be told. Small figures are intervals.");
}

// A run may have kept none.
bool has_images(const SceneView& view) {
  return std::any_of(view.images.panels.begin(), view.images.panels.end(),
                     [](const Panel& panel) { return panel.picture != Panel::no_picture; });
}

Markup scene_section(const ReportData& data, std::size_t index) {
  const SceneView& view = data.scenes[index];
  Markup content = reference_text(data, view.scene) + left_out(view.scene) + findings(view);
  if (has_images(view))
    content += side_by_side(data, view) + magnified(data, view) + one_over_the_other(data, view, index);
  for (const PictureRow& row : view.other_rows) content += picture_row(data, row);
  content += speed_against_error(view) + curves(data.results, view.scene.name) +
             change_histogram(data.results, view.table, view.scene.name) + numbers(data.results, view);
  content += details("Scene: " + view.scene.type + " " + view.scene.version,
                     tag("p", view.scene.summary) + name_value_table("Settings", flattened(view.scene.settings)));
  return section(scene_anchor(index), view.scene.name, content);
}

Markup analysis_section(const Results& results, std::size_t index) {
  const Analysis& analysis = results.analyses[index];
  Markup statements, rows;
  for (const std::string& statement : analysis.statements) statements += tag("li", statement);
  for (const Row& row : results.rows) {
    if (row.scene != analysis.title) continue;
    const auto cell = [](double number) { return tag("td", std::isnan(number) ? "" : readable_text(number)); };
    rows += tag("tr", tag("th", {{"scope", "row"}}, row.metric) + tag("td", row.sampler) + cell(row.value) +
                          cell(row.low) + cell(row.high) + tag("td", row.unit));
  }
  Markup head;
  for (const char* title : {"metric", "of", "value", "low", "high", "unit"})
    head += tag("th", {{"scope", "col"}}, title);
  return section(
      analysis_anchor(index), analysis.title,
      tag("ul", {{"class", "statements"}}, statements) + scrolling_table(analysis.title, tag("tr", head), rows));
}

Markup provenance(const Results& results) {
  std::vector<std::pair<std::string, std::string>> jobs(results.jobs.begin(), results.jobs.end());
  Markup content = name_value_table("Manifest", flattened(results.manifest));
  if (!jobs.empty()) content += details("Keys of the " + counted(jobs.size(), "job"), name_value_table("Jobs", jobs));
  return content;
}

Markup head(const ReportData& data) {
  return tag("head", void_tag("meta", {{"charset", "utf-8"}}) +
                         void_tag("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", content_policy}}) +
                         void_tag("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) +
                         void_tag("meta", {{"name", "color-scheme"}, {"content", "light dark"}}) +
                         tag("title", data.results.question + " \u2013 moire") +
                         tag("style", Markup::verbatim(stylesheet)) + picture_styles(data));
}

}  // namespace

std::string html_text(const ReportData& data) {
  const Results& results = data.results;
  Markup page =
      tag("header", tag("p", {{"class", "overline"}}, results.experiment) + tag("h1", results.question) + lede(data));
  Markup main = notices(results);
  for (std::size_t i = 0; i < data.scenes.size(); ++i) main += scene_section(data, i);
  for (std::size_t i = 0; i < results.analyses.size(); ++i) main += analysis_section(results, i);
  main += section("contenders", "Contenders", contenders(results));
  main += section("metrics", "Metrics", glossary(results)) + section("provenance", "Provenance", provenance(results));
  page += navigation(data) + tag("main", main);
  return "<!doctype html>\n" + tag("html", {{"lang", "en"}}, head(data) + tag("body", page)).text() + '\n';
}

void write_html(const std::filesystem::path& folder) {
  write_whole_file(folder / "report.html", html_text(read_report_data(folder)));
}

}  // namespace moire::report
