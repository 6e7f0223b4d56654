// `generate --interpolation-error`, and the options that go with it.
#pragma once

#include "host/commands/command.hpp"
#include "host/table/grid_choice.hpp"

namespace brdftab {

class InterpolationOption {
 public:
  void add(CLI::App& parser);

  /// Throws BadInput where the options' values are none, or do not go together.
  void check() const;

  bool asked() const { return error_text_.has_value(); }
  bool dry_run() const { return dry_run_; }

  /// Chooses a grid within the ranges of `grid`, and sets it; in a dry run, prints size against error
  /// instead. Returns what the table says of the choice.
  std::vector<AttributeInfo> choose(const Engine& engine, const Material& material,
                                    const std::vector<Polarization>& polarizations, Grid& grid) const;

 private:
  double error() const;
  double most_nodes() const;

  std::optional<std::string> error_text_;
  std::optional<std::string> most_nodes_text_;
  bool dry_run_ = false;
};

}  // namespace brdftab
