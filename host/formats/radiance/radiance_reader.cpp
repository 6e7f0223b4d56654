#include "host/formats/radiance/radiance_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "host/base/error.hpp"
#include "host/base/statistics.hpp"
#include "host/formats/radiance/klems_basis.hpp"

namespace brdftab {
namespace {

using Channels = std::vector<std::vector<double>>;

class RadianceReader : public ExportReader {
 public:
  explicit RadianceReader(Description description, std::size_t channels)
      : description_(std::move(description)), colour_(channels == 3) {}

  ExportChannels channels() const override { return colour_ ? ExportChannels::xyz : ExportChannels::bands; }
  Illuminant illuminant() const override { return description_.illuminant; }
  std::vector<double> wavelengths_nm() const override { return description_.wavelengths_nm; }
  std::string material_text() const override { return description_.material_text; }

 protected:
  const Description& description() const { return description_; }

 private:
  Description description_;
  bool colour_;
};

// A file does not say what its values are of a cell: they are taken for what they are nearer to in the
// median.
template <class Right>
PatchValue nearer(const std::vector<double>& held, const Right& right) {
  const auto off = [&](PatchValue value) {
    std::vector<double> errors;
    const auto wanted = right(value);
    for (std::size_t k = 0; k < held.size(); ++k)
      errors.push_back(std::abs(held[k] - wanted[k]) / std::max(wanted[k], error_floor));
    return median(errors);
  };
  return off(PatchValue::average) <= off(PatchValue::centre) ? PatchValue::average : PatchValue::centre;
}

class KlemsReader : public RadianceReader {
 public:
  KlemsReader(Description description, Channels matrices)
      : RadianceReader(std::move(description), matrices.size()), matrices_(std::move(matrices)) {}

  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override {
    std::map<PatchValue, Channels> matrices;
    for (const auto value : {PatchValue::average, PatchValue::centre})
      matrices[value] = radiance_colours(source, klems_matrix(source, value));
    const auto value = nearer(matrices_.front(), [&](PatchValue of) { return matrices.at(of).front(); });
    Channels& right = matrices.at(value);
    check_channels(matrices_.size(), right.size());
    for (std::size_t c = 0; c < right.size(); ++c)
      for (std::size_t k = 0; k < right[c].size(); ++k) {
        right[c][k] = std::max(right[c][k], 0.);
        errors.compare(matrices_[c][k], right[c][k], [&] {
          return fmt::format("{} of the patches {} (incidence) and {} (scatter)", radiance_wavelengths[c],
                             k % klems_patches, k / klems_patches);
        });
      }
    return std::make_unique<KlemsReader>(description(), std::move(right));
  }

  Channels evaluate(const Directions& directions) const override {
    Channels f;
    for (const auto& matrix : matrices_) {
      auto& values = f.emplace_back();
      for (std::size_t k = 0; k < directions.size(); ++k)
        values.push_back(matrix[klems_patch(directions.theta_s[k], directions.phi[k]) * klems_patches +
                                klems_patch(directions.theta_i[k], 0)]);
    }
    if (f.size() == 3) std::swap(f[0], f[1]);
    return f;
  }
  std::string interpolation() const override { return "the nearest pair of Klems patches"; }

 private:
  Channels matrices_;
};

class TreeReader : public RadianceReader {
 public:
  TreeReader(Description description, TensorTree tree)
      : RadianceReader(std::move(description), 1), tree_(std::move(tree)) {}

  Channels evaluate(const Directions& directions) const override {
    Channels f(1);
    for (std::size_t k = 0; k < directions.size(); ++k) f[0].push_back(tree_.at(tree_point(directions, k)));
    return f;
  }
  std::string interpolation() const override { return "the nearest cell of the tree"; }

  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override {
    check_channels(1, source.bands());
    std::vector<TreeCell> cells;
    for (const TreeCell& cell : tree_.cells()) {
      if (cell.corner[0] >= half_used) continue;
      if (cell.corner[0] + cell.size > half_used)
        throw BadInput("the file's tree is not cut at a theta_i of 90 degrees");
      cells.push_back(cell);
    }
    TensorTree right = tree_;
    const auto value = value_of_cells(source, cells);
    for (std::size_t begin = 0; begin < cells.size(); begin += cells_at_once) {
      const std::span<const TreeCell> some(cells.begin() + static_cast<std::ptrdiff_t>(begin),
                                           std::min(cells_at_once, cells.size() - begin));
      const auto f = right_values(source, some, value);
      for (std::size_t k = 0; k < some.size(); ++k) {
        right.set_value(some[k].node, static_cast<float>(f[k]));
        errors.compare(tree_.value(some[k].node), f[k], [&] {
          Directions centre;
          add(centre, some[k].centres().back());
          return fmt::format("the cell of the tree about {}", angles_text(centre, 0));
        });
      }
    }
    return std::make_unique<TreeReader>(description(), std::move(right));
  }

 private:
  static constexpr std::size_t cells_at_once = 1 << 15;
  // An isotropic surface needs the first coordinate up to here only.
  static constexpr double half_used = 0.5;

  static std::vector<double> right_values(const ExportModel& source, std::span<const TreeCell> cells,
                                          PatchValue value) {
    Directions directions;
    std::size_t points = 0;
    for (const TreeCell& cell : cells) {
      const auto centres = cell.centres();
      const std::span<const TreePoint> eighths(centres.begin(), centres.size() - 1);
      const auto used = value == PatchValue::average ? eighths : std::span<const TreePoint>(centres).last(1);
      for (const TreePoint& point : used) add(directions, point);
      points = used.size();
    }
    const auto f = source.evaluate(directions).front();
    std::vector<double> result(cells.size());
    for (std::size_t k = 0; k < f.size(); ++k) result[k / points] += f[k] / static_cast<double>(points);
    return result;
  }

  // Judges by some cells all over the cube.
  PatchValue value_of_cells(const ExportModel& source, const std::vector<TreeCell>& cells) const {
    constexpr std::size_t enough = 2000;
    std::vector<TreeCell> some;
    std::vector<double> held;
    for (std::size_t k = 0; k < cells.size(); k += cells.size() / enough + 1) {
      some.push_back(cells[k]);
      held.push_back(tree_.value(cells[k].node));
    }
    return nearer(held, [&](PatchValue value) { return right_values(source, some, value); });
  }

  TensorTree tree_;
};

}  // namespace

Channels radiance_colours(const ExportModel& source, const Channels& by_band) {
  if (by_band.size() == 1) return by_band;
  auto xyz = source.xyz(by_band);
  std::swap(xyz[0], xyz[1]);
  return xyz;
}

std::unique_ptr<ExportReader> klems_reader(Description description, Channels matrices) {
  return std::make_unique<KlemsReader>(std::move(description), std::move(matrices));
}

std::unique_ptr<ExportReader> tree_reader(Description description, TensorTree tree) {
  return std::make_unique<TreeReader>(std::move(description), std::move(tree));
}

}  // namespace brdftab
