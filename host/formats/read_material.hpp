// A material from whatever file holds one.
#pragma once

#include <filesystem>
#include <string>

#include "host/model/material.hpp"

namespace brdftab {

class ExportReader;

/// Reads a material file in TOML ("-": standard input), the table that was made of it, or a simulator's file
/// that carries its text. Throws FileError where the file cannot be read, and BadInput with
/// file and line, or the file, where it holds no material.
Material read_material(const std::filesystem::path& file);

/// Gives the material whose text a simulator's file carries. `file` is its name, for messages. Throws
/// BadInput where the file's format cannot hold a material.
Material material_of(const ExportReader& table, const std::string& file);

/// Gives the material as far as a simulator's file holds it: one band, where the file says that it holds but
/// one.
Material in_bands_of(const ExportReader& table, const Material& material);

}  // namespace brdftab
