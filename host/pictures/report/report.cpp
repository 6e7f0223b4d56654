#include "host/pictures/report/report.hpp"

#include <fmt/format.h>

#include <span>

#include "host/base/numbers.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/model/variant.hpp"
#include "host/pictures/angles_sketch.hpp"
#include "host/pictures/drawing/svg.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/report/explorer.hpp"
#include "host/pictures/report/report_style.hpp"
#include "host/pictures/table_slice.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

// A symbol such as σ_surface as HTML: what follows the underscore is lowered.
std::string symbol_html(std::string_view symbol) {
  const std::size_t line = symbol.find('_');
  if (line == symbol.npos) return fmt::format("<i>{}</i>", xml_escaped(symbol));
  return fmt::format("<i>{}</i><sub>{}</sub>", xml_escaped(symbol.substr(0, line)),
                     xml_escaped(symbol.substr(line + 1)));
}

// Shows a number of the table with a few digits. `path` is its place in what the command `info` prints as
// JSON.
std::string number_html(const std::string& path, double value) {
  return fmt::format("<data data-path=\"{}\" value=\"{}\">{:.4g}</data>", xml_escaped(path), shortest(value),
                     value);
}

std::string image_html(const std::string& svg, std::string_view alt, std::string_view caption) {
  return fmt::format("<figure><img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">{}</figure>\n",
                     xml_escaped(alt), drawing::base64(std::as_bytes(std::span<const char>(svg))),
                     caption.empty() ? "" : fmt::format("<figcaption>{}</figcaption>", caption));
}

class Page {
 public:
  Page(const Subject& table, const LazyEngine& engine, const std::string& origin)
      : table_(table), info_(table.reader().info()), engine_(engine), origin_(origin) {}

  std::string html() {
    const std::string name = xml_escaped(table_.name());
    body_ = fmt::format("<h1>BRDF of {}</h1>\n", name);
    introduce();
    explore();
    parameters();
    conventions();
    pictures();
    figures();
    integrals();
    command();
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n<title>BRDF "
        "of {}</title>\n"
        "<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        name, report_style, body_);
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    body_ += fmt::format(format, std::forward<Args>(args)...);
  }

  std::string text(std::string_view name) const {
    const AttributeValue* value = info_.attribute(name);
    const auto* found = value ? std::get_if<std::string>(value) : nullptr;
    return found ? xml_escaped(*found) : "";
  }

  // The cells of a table with an attribute's number, or with one number for each band.
  std::string number_cells(const std::string& name) const {
    const AttributeValue* value = info_.attribute(name);
    if (!value) return "<td class=\"number\">not in the table</td>";
    if (const auto* number = std::get_if<double>(value))
      return fmt::format("<td class=\"number\">{}</td>", number_html("attributes/" + name, *number));
    std::string cells;
    if (const auto* numbers = std::get_if<std::vector<double>>(value))
      for (std::size_t k = 0; k < numbers->size(); ++k)
        cells += fmt::format("<td class=\"number\">{}</td>",
                             number_html(fmt::format("attributes/{}/{}", name, k), (*numbers)[k]));
    return cells;
  }

  std::string band_heads(std::string_view first) const {
    std::string cells = fmt::format("<tr><th>{}</th>", first);
    for (const Band& band : table_.material().bands())
      cells += fmt::format("<th class=\"number\">{}</th>",
                           band.wavelength_nm ? shortest(*band.wavelength_nm) + " nm" : "value");
    return cells;
  }

  void introduce() {
    const Material& material = table_.material();
    if (!material.description().empty()) add("<p>{}</p>\n", xml_escaped(material.description()));
    if (!material.source().empty())
      add("<p class=\"faint\">Source: {}</p>\n", xml_escaped(material.source()));
    if (!material.license().empty())
      add("<p class=\"faint\">Licence: {}</p>\n", xml_escaped(material.license()));
    add("<p>A table of the bidirectional reflectance distribution function <i>f</i><sub>r</sub>, in "
        "sr<sup>−1</sup>, by the model of {}. {}</p>\n",
        xml_escaped(paper_reference), xml_escaped(origin_));
    for (const auto& fault : table_.table().faults) add("<p class=\"warning\">{}</p>\n", xml_escaped(fault));
    add("<div class=\"scroll\"><table>\n<tr><th>axis</th><th class=\"number\">nodes</th><th "
        "class=\"number\">from</th><th class=\"number\">to</th><th>meaning</th></tr>\n");
    for (const auto& row : axis_table) {
      Grid grid = table_.table().grid;
      const Axis& axis = grid[row.kind];
      const std::string path = fmt::format("variables/{}/values/", row.name);
      const std::string symbol =
          fmt::format("{}_{}", row.name.starts_with("theta") ? "θ" : "φ", row.name.back());
      add("<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}°</td><td "
          "class=\"number\">{}°</td><td>{}</td></tr>\n",
          symbol_html(symbol), axis.size(), number_html(path + "0", axis[0]),
          number_html(fmt::format("{}{}", path, axis.size() - 1), axis[axis.size() - 1]),
          xml_escaped(row.long_name));
    }
    add("</table></div>\n");
    std::vector<std::string> light;
    for (const Polarization polarization : table_.table().polarizations)
      light.emplace_back(light_word(share_s(polarization)));
    add("<p>{} directions{} in {} light, stored as {}. {}</p>\n", table_.table().grid.directions(),
        table_.material().has_wavelengths()
            ? fmt::format(" at each of {} wavelengths", table_.material().bands().size())
            : "",
        fmt::join(light, ", "), name_of(table_.table().precision),
        text("device").empty() ? "" : fmt::format("Computed on {}.", text("device")));
  }

  void explore() {
    if (!has_hemispheres(table_.table().grid)) {
      add("<p>The table's azimuths leave gaps above 90°: there is no hemisphere to map.</p>\n");
      return;
    }
    round_ = true;
    Explorer map = explorer(table_, most_embedded, engine_().watch());
    body_ += map.section;
    scripts_ = std::move(map.scripts);
  }

  void parameters() {
    add("<h2>Parameters</h2>\n<div class=\"scroll\"><table>\n{}<th "
        "class=\"number\">range</th><th>meaning</th></tr>\n",
        band_heads("parameter"));
    for (const auto& row : parameter_table) {
      add("<tr><td>{} <code>{}</code></td>", symbol_html(row.symbol), row.name);
      for (const Band& band : table_.material().bands()) {
        const double value = band.parameters.*row.member;
        // A table of several bands has no attribute for the parameter of each.
        add("<td class=\"number\">{}</td>", table_.material().has_wavelengths()
                                                ? fmt::format("{:.4g}", value)
                                                : number_html(fmt::format("attributes/{}", row.name), value));
      }
      add("<td class=\"number\">{} … {}</td><td>{}{}</td></tr>\n", row.minimum, row.maximum,
          xml_escaped(row.meaning), row.unit == "1" ? "" : fmt::format(" ({})", row.unit));
    }
    add("</table></div>\n<p class=\"faint\">Variant of the model: ");
    for (const auto& row : variant_table())
      add("{}<code>{} = {}</code>", &row == &variant_table().front() ? "" : ", ", row.name,
          choice_name(row, table_.material().variant()));
    add(".</p>\n");
  }

  void conventions() {
    add("<h2>Angles</h2>\n{}",
        image_html(angles_sketch(), "The angles of incidence and scatter",
                   "Polar angles are counted from the normal, in degrees. " + text("azimuth_convention")));
  }

  void pictures() {
    const PlotOptions options;
    const std::span<const Subject> subjects(&table_, 1);
    const std::string bands =
        table_.material().bands().size() > 1
            ? fmt::format(" At {} nm, the first band.", shortest(*table_.material().bands()[0].wavelength_nm))
            : "";
    const auto picture = [&](Plot plot, std::string_view alt, const std::string& caption) {
      body_ += image_html(plot(subjects, options, engine_), alt, caption + bands);
    };
    add("<h2>In the plane of incidence</h2>\n");
    picture(
        in_plane_plot, "BRDF against scatter angle, a curve for each angle of incidence",
        "Curves are the model, dots the nodes of the table. θ<sub>s</sub> is negative on the backward side.");
    picture(polar_plot, "The same in polar form", "The same, with log <i>f</i><sub>r</sub> as the radius.");
    picture(lobes_plot, "BRDF by lobe",
            "The surface, bulk and retro lobes of the model, which add up to all lobes.");
    if (round_) {
      add("<h2>Over the hemisphere</h2>\n");
      picture(hemisphere_plot, "Maps of the BRDF in direction cosines",
              "The table's own samples in direction cosines; forward is to the right.");
    }
    add("<h2>Masking and shadowing</h2>\n");
    picture(shadowing_plot, "V_m against scatter angle and V against the direction cosine",
            "V<sub>m</sub> multiplies the reflectance, V narrows the lobes towards grazing directions.");
    add("<h2>Reflectance</h2>\n");
    picture(
        dhr_plot, "Directional-hemispherical reflectance against the angle of incidence",
        "Dots are the values that the table stores. Nothing in the model bounds the sum of the lobes to 1.");
  }

  void figures() {
    add("<h2>Accuracy, energy and reciprocity</h2>\n");
    add("<p{}>{}.</p>\n", text("energy").starts_with("DHR is at most 1") ? "" : " class=\"warning\"",
        text("energy"));
    const auto row = [&](std::string_view what, const std::string& attribute) {
      if (info_.attribute(attribute)) add("<tr><td>{}</td>{}</tr>\n", what, number_cells(attribute));
    };
    add("<div class=\"scroll\"><table>\n<tr><th>accuracy</th><th class=\"number\">value</th></tr>\n");
    row("nodes compared with the scalar reference while the table was made", "accuracy_nodes");
    row("largest relative error of a sample there", "accuracy_max_relative_error");
    row("root mean square of the relative errors", "accuracy_rms_relative_error");
    row("largest relative error of rounding samples to fewer bits", "keep_bits_relative_error");
    row("largest estimated relative error of N", "normalization_relative_error");
    row("largest estimated relative error of DHR", "dhr_relative_error");
    row("error of linear interpolation between nodes that was asked for", "interpolation_error_asked");
    row("largest error of it that was measured", "interpolation_error_reached");
    add("</table></div>\n<div class=\"scroll\"><table>\n{}</tr>\n", band_heads("reciprocity"));
    row("pairs of directions compared", "reciprocity_pairs");
    row("median defect", "reciprocity_median");
    row("90 % of defects are below", "reciprocity_90_percent");
    row("largest defect", "reciprocity_max");
    row("its θ<sub>i</sub>, degrees", "reciprocity_max_theta_i");
    row("its θ<sub>s</sub>, degrees", "reciprocity_max_theta_s");
    row("its φ, degrees", "reciprocity_max_phi");
    add("</table></div>\n<p class=\"faint\">A defect is {}: 0.1 is a difference of a tenth between "
        "<i>f</i><sub>r</sub> and the same with light and detector exchanged.</p>\n",
        text("reciprocity"));
  }

  void integrals() {
    add("<details><summary>N and DHR at every θ<sub>i</sub> of the table, unpolarised</summary>\n<div "
        "class=\"scroll\"><table>\n<tr>");
    const bool bands = table_.material().has_wavelengths();
    if (bands) add("<th class=\"number\">nm</th>");
    add("<th class=\"number\">θ<sub>i</sub></th>");
    std::vector<std::string> names;
    const auto column = [&](std::string_view head, std::string name) {
      add("<th class=\"number\">{}</th>", head);
      names.push_back(std::move(name));
    };
    for (const auto lobe : lobe_names)
      column(fmt::format("N {}", lobe), fmt::format("normalization_{}", lobe));
    column("DHR", "dhr");
    for (const auto lobe : lobe_names) column(fmt::format("DHR {}", lobe), fmt::format("dhr_{}", lobe));
    add("</tr>\n");
    const auto theta_i = table_.table().grid.theta_i.nodes();
    for (std::size_t band = 0; band < table_.material().bands().size(); ++band)
      for (std::size_t i = 0; i < theta_i.size(); ++i) {
        add("<tr>");
        if (bands)
          add("<td class=\"number\">{}</td>", shortest(*table_.material().bands()[band].wavelength_nm));
        add("<td class=\"number\">{}°</td>", shortest(theta_i[i]));
        for (const auto& name : names) {
          const std::size_t k = band * theta_i.size() + i;
          add("<td class=\"number\">{}</td>",
              number_html(fmt::format("variables/{}/values/{}", name, k), info_.variable(name)->values[k]));
        }
        add("</tr>\n");
      }
    add("</table></div></details>\n");
  }

  void command() {
    add("<h2>How the table was made</h2>\n<pre class=\"command\">{}</pre>\n<p>{}{}.</p>\n<details "
        "open><summary>The material file</summary>\n<pre>{}</pre></details>\n{}",
        text("history"), text("source"),
        text("build_options").empty()
            ? ""
            : fmt::format(", kernels built with <code>{}</code>", text("build_options")),
        text("material"), scripts_);
  }

  const Subject& table_;
  const TableInfo& info_;
  const LazyEngine& engine_;
  std::string origin_;
  bool round_ = false;
  std::string body_;
  std::string scripts_;
};

}  // namespace

std::string report(const Subject& table, const LazyEngine& engine, const std::string& origin) {
  return Page(table, engine, origin).html();
}

}  // namespace brdftab
