// Which material goes into which file, refused before any is begun.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/material.hpp"

namespace brdftab {

struct MaterialOutput {
  std::string input;  // as the user names it
  Material material;
  std::filesystem::path target;
};

/// Whether -o names a folder: several materials, a name that ends with '/', or a folder that exists.
bool names_folder(const std::vector<std::string>& materials, const std::string& output);

/// Reads the materials, each from whatever file holds it. In a folder a file is called as
/// the material's, with `suffix`. Throws BadInput where two would have one name, FileError where one exists
/// and `force` is not set, or where the folder is missing.
std::vector<MaterialOutput> plan_outputs(const std::vector<std::string>& materials, const std::string& output,
                                         std::string_view suffix, bool force);

}  // namespace brdftab
