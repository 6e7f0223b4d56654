#include "host/commands/outputs.hpp"

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/read_material.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

void require_folder(const std::string& output) {
  std::error_code error;
  if (fs::is_directory(output, error)) return;
  if (fs::exists(fs::path(output.substr(0, output.find_last_not_of('/') + 1)), error))
    throw BadInput("-o {}: is a file; several materials need -o FOLDER/", excerpt(output));
  throw FileError("{}: the folder does not exist{}", output,
                  output.ends_with('/') ? "" : "; several materials need -o FOLDER/");
}

fs::path file_in_folder(const fs::path& folder, const std::string& material, std::string_view suffix) {
  const std::string name = material == "-" ? "material" : fs::path(material).stem().string();
  return folder / (name + std::string(suffix));
}

}  // namespace

bool names_folder(const std::vector<std::string>& materials, const std::string& output) {
  std::error_code error;
  return materials.size() > 1 || output.ends_with('/') || fs::is_directory(output, error);
}

std::vector<MaterialOutput> plan_outputs(const std::vector<std::string>& materials, const std::string& output,
                                         std::string_view suffix, bool force) {
  const bool folder = names_folder(materials, output);
  if (folder) require_folder(output);
  std::vector<MaterialOutput> plan;
  for (const auto& input : materials) {
    Material material = read_material(input);
    const fs::path target = folder ? file_in_folder(output, input, suffix) : fs::path(output);
    for (const MaterialOutput& other : plan)
      if (other.target == target)
        throw BadInput("{}: two materials would both be written to {}", input, target.string());
    std::error_code error;
    if (!force && fs::exists(fs::symlink_status(target, error)))
      throw FileError("{}: exists; --force overwrites it", target.string());
    plan.push_back({input, std::move(material), target});
  }
  return plan;
}

}  // namespace brdftab
