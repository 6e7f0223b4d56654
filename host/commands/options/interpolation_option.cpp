#include "host/commands/options/interpolation_option.hpp"

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

std::string sizes(std::size_t i, std::size_t p, std::size_t s, std::size_t q) {
  return fmt::format("{} x {} x {} x {}", i, p, s, q);
}

void print_size(const GridAtError& row, std::string_view remark) {
  const Grid& grid = row.grid;
  fmt::print("{:>13} {:>28} {:>10.3g} {:>10.3g} {:>10.3g}  {}\n", grid.directions(),
             sizes(grid.theta_i.size(), grid.phi_i.size(), grid.theta_s.size(), grid.phi_s.size()),
             row.error.maximum, row.error.percentile_95, row.error.uniform_maximum, remark);
}

void print_sizes(GridChooser& chooser, const Material& material, const GridAtError& chosen, double error) {
  fmt::print(
      "{}: error of linear interpolation relative to max(f, {} x the slice's peak), at {} points that the "
      "choice did not use\n",
      material.name(), shortest(interpolation_floor), chosen.error.points);
  fmt::print("{:>13} {:>28} {:>10} {:>10} {:>10}\n", "nodes", "theta_i phi_i theta_s phi_s", "max", "95 %",
             "uniform");
  for (const auto& row : chooser.other_sizes()) print_size(row, "");
  print_size(chosen, fmt::format("chosen for {}", shortest(error)));
  for (const bool uniform_directions : {false, true}) {
    const UniformNeed need = chooser.uniform_need(uniform_directions);
    const auto print_axes = [&](const UniformAxes& axes, std::string_view remark) {
      fmt::print("{:>13.0f} {:>28} {:>32}  uniform axes, {} within {}{}\n", axes.product(),
                 sizes(axes.nodes[0], 1, axes.nodes[1], axes.nodes[2]), "", remark, shortest(error),
                 uniform_directions ? ", at uniform directions only" : "");
    };
    print_axes(need.alone, "each alone");
    print_axes(need.together, "together");
  }
}

}  // namespace

void InterpolationOption::add(CLI::App& parser) {
  parser.add_option(
      "--interpolation-error", error_text_,
      fmt::format("Choose the axes, not uniform, so that linear interpolation stays within this, relative to "
                  "f or {} of the slice's peak: 2%, or 0.02. Each axis keeps its first and last node",
                  interpolation_floor));
  parser.add_option("--max-nodes", most_nodes_text_,
                    "Most nodes that --interpolation-error may take; default 1e9");
  parser.add_flag("--dry-run", dry_run_,
                  "With --interpolation-error: print size against error, write nothing");
}

void InterpolationOption::check() const {
  if (!asked() && (dry_run_ || most_nodes_text_))
    throw BadInput("--dry-run and --max-nodes go with --interpolation-error");
  if (!asked()) return;
  static_cast<void>(error());
  static_cast<void>(most_nodes());
}

double InterpolationOption::error() const {
  std::string_view text = trimmed(*error_text_);
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  const auto number = parse_number(text);
  const double error = number ? (percent ? *number / 100 : *number) : 0;
  if (!(error >= 1e-4 && error <= 1))
    throw BadInput(
        "--interpolation-error {}: must be a share of f from 1e-4 to 1, or a percentage such as 2%",
        excerpt(*error_text_));
  return error;
}

double InterpolationOption::most_nodes() const {
  const auto number = most_nodes_text_ ? parse_number(*most_nodes_text_) : 1e9;
  if (!number || !(*number >= 1 && *number <= 1e13))
    throw BadInput("--max-nodes {}: must be a number from 1 to 1e13", excerpt(*most_nodes_text_));
  return *number;
}

std::vector<AttributeInfo> InterpolationOption::choose(const Engine& engine, const Material& material,
                                                       const std::vector<Polarization>& polarizations,
                                                       Grid& grid) const {
  GridChooser chooser(engine, material, polarizations, grid, error());
  GridAtError chosen = chooser.choose(most_nodes());
  if (dry_run_) print_sizes(chooser, material, chosen, error());
  grid = std::move(chosen.grid);
  return chooser.attributes(chosen.error);
}

}  // namespace brdftab
