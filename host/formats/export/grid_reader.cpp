#include "host/formats/export/grid_reader.hpp"

#include <cmath>
#include <cstdlib>
#include <memory>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

// Rounding to so many digits is far below what any file is judged by.
constexpr int many_digits = 9;

double rounded(double value, int digits) {
  return digits < many_digits ? std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr) : value;
}

}  // namespace

std::vector<std::vector<double>> GridReader::evaluate(const Directions& directions) const {
  std::vector<std::vector<double>> f;
  for (const GridSamples& samples : samples_)
    for (auto& channel : samples.evaluate(directions)) f.push_back(std::move(channel));
  return f;
}

std::unique_ptr<ExportReader> GridReader::rebuilt(const ExportModel& source, ValueErrors& errors) const {
  if (digits_ < many_digits) errors.set_rounding(5 * std::pow(10, -digits_));
  auto table = std::make_unique<GridReader>(*this);
  table->samples_ = rebuilt(samples_, Polarization::unpolarized, source, errors);
  for (auto& [polarization, samples] : table->polarized_)
    samples = rebuilt(samples, polarization, source, errors);
  return table;
}

std::vector<GridSamples> GridReader::rebuilt(const std::vector<GridSamples>& held, Polarization polarization,
                                             const ExportModel& source, ValueErrors& errors) const {
  std::size_t count = 0;
  for (const GridSamples& samples : held) count += samples.values().size();
  check_channels(count, source.bands());
  std::vector<GridSamples> result;
  Directions directions;
  std::vector<std::vector<double>> f;
  std::size_t band = 0;
  for (const GridSamples& samples : held) {
    if (result.empty() || samples.axes() != result.back().axes()) {
      directions = samples.directions();
      f = source.evaluate(directions, polarization);
    }
    std::vector<std::vector<double>> values;
    for (const auto& channel : samples.values()) {
      auto& right = values.emplace_back(f[band]);
      for (std::size_t k = 0; k < right.size(); ++k) {
        right[k] = rounded(right[k], digits_);
        errors.compare(channel[k], right[k], [&] {
          const std::string name = channel_name(channels(), source, band);
          return fmt::format("{}{} at {}", brdf_name(polarization), name == "f" ? "" : " of " + name,
                             angles_text(directions, k));
        });
      }
      ++band;
    }
    result.push_back(samples.with_values(std::move(values)));
  }
  return result;
}

}  // namespace brdftab
