// Radiance takes f as constant over pairs of Klems patches, or over the cells of a tensor tree.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "host/formats/export/export_reader.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/radiance/tensor_tree.hpp"

namespace brdftab {

/// Radiance looks for these components, luminance first.
inline constexpr std::array<std::string_view, 3> radiance_wavelengths{"Visible", "CIE-X", "CIE-Z"};

/// Makes [component][direction] of [band][direction]: luminance alone, or with X and Z.
std::vector<std::vector<double>> radiance_colours(const ExportModel& source,
                                                  const std::vector<std::vector<double>>& by_band);

/// Takes matrices as klems_matrix has them, of one component or three.
std::unique_ptr<ExportReader> klems_reader(Description description,
                                           std::vector<std::vector<double>> matrices);

std::unique_ptr<ExportReader> tree_reader(Description description, TensorTree tree);

}  // namespace brdftab
