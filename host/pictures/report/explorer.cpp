#include "host/pictures/report/explorer.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/pictures/drawing/palette.hpp"
#include "host/pictures/report/embedded_table.hpp"
#include "host/pictures/report/report_style.hpp"

namespace brdftab {
namespace {

constexpr std::size_t colour_steps = 256;

// The scale of colours, as the script reads it.
std::string scale_json(const drawing::ChartAxis& axis) {
  nlohmann::json scale{{"low", axis.low}, {"high", axis.high}, {"ticks", nlohmann::json::array()}};
  for (const drawing::Tick& tick : ticks(axis))
    scale["ticks"].push_back({{"value", tick.value}, {"label", tick.label}});
  for (std::size_t k = 0; k < colour_steps; ++k)
    scale["colours"].push_back(
        drawing::viridis.at(static_cast<double>(k) / static_cast<double>(colour_steps - 1)).hex());
  return scale.dump();
}

std::string thinning_html(const NodeSubset& nodes, const Grid& grid) {
  return fmt::format(
      " <b>The table is too large for a page: these are {} of its {} θ<sub>i</sub>, {} of {} θ<sub>s</sub> "
      "and "
      "{} of {} φ<sub>s</sub>, spread evenly; narrow peaks between them are not seen here.</b>",
      nodes.theta_i.size(), grid.theta_i.size(), nodes.theta_s.size(), grid.theta_s.size(),
      nodes.phi_s.size(), grid.phi_s.size());
}

}  // namespace

Explorer explorer(const Subject& table, std::size_t most, const Watch& watch) {
  const EmbeddedTable embedded = embed(table, most, watch);
  return {
      fmt::format(
          "<h2>The hemisphere at each angle of incidence</h2>\n<div class=\"explorer\">\n<div "
          "class=\"controls\"><label for=\"slider\">incidence <i>θ</i><sub>i</sub></label><input "
          "id=\"slider\" type=\"range\" min=\"0\" step=\"1\"><output id=\"theta_i\" "
          "for=\"slider\"></output><label>light <select id=\"sets\"></select></label></div>\n"
          "<div><canvas id=\"map\" role=\"img\" aria-label=\"Map of the BRDF over the "
          "hemisphere\"></canvas>\n<p id=\"reading\"></p></div>\n"
          "<div><canvas id=\"cut\" role=\"img\" aria-label=\"The BRDF in the plane of "
          "incidence\"></canvas>\n<p class=\"faint\">Point at the map to read <i>f</i><sub>r</sub>. Forward "
          "is to the right; the cross is the mirror direction, the ring retro-reflection; circles are at "
          "<i>θ</i><sub>s</sub> = 30° and 60°. Drawn from the table's own samples, linear in ln <i>f</i> "
          "between its nodes, which are the dots of the curve.{}</p></div>\n</div>\n",
          embedded.whole ? "" : thinning_html(embedded.nodes, table.table().grid)),
      fmt::format("<script type=\"application/json\" id=\"axes\">{}</script>\n<script "
                  "type=\"application/json\" id=\"scale\">{}</script>\n"
                  "<script type=\"text/plain\" id=\"samples\">{}</script>\n<script>{}</script>\n",
                  embedded.json, scale_json(embedded.scale), embedded.float32, report_script)};
}

}  // namespace brdftab
