// Everything that a table says of itself beside its samples, as named values that any format can hold.
#pragma once

#include <string>
#include <vector>

#include "host/table/table_content.hpp"

namespace brdftab {

/// What follows from the material's text: a table whose attributes say anything else has been edited.
std::vector<AttributeInfo> material_attributes(const Material& material);

/// Conventions, the material and how the table was made, in the order in which files show them; no empty
/// text.
std::vector<AttributeInfo> content_attributes(const TableContent& content);

/// To how many bits samples are rounded, and the relative error of that; none where they are not.
std::vector<AttributeInfo> rounding_attributes(const TableContent& content);

/// What is known only when all samples are: accuracy, energy and reciprocity.
std::vector<AttributeInfo> findings_attributes(const TableFindings& findings);

/// A variable over [wavelength,] theta_i.
struct IntegralVariable {
  std::string name;
  std::string long_name;
  std::vector<double> values;
};

/// N and DHR by lobe, dimensionless.
std::vector<IntegralVariable> integral_variables(const std::vector<Integrals>& bands);

/// Of a brdf variable.
std::string brdf_long_name(Polarization polarization);

}  // namespace brdftab
