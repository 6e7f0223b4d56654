// All file formats that the program knows, for writing, for reading tables and for reading measurements.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/format.hpp"

namespace brdftab {

using Formats = std::vector<std::unique_ptr<Format>>;

/// Makes one object of each format, with default options: dense tables first, the others in the order of
/// names.
Formats all_formats();

/// Finds a format by its name; null where there is none.
const Format* find_format(const Formats& formats, std::string_view name);

/// Finds the format whose files alone are called so; null where there is none.
const Format* format_of_extension(const Formats& formats, std::string_view extension);

/// Finds the format that recognises a file by its beginning; null where none does. Throws FileError where the
/// file cannot be read.
const Format* recognised_format(const Formats& formats, const std::filesystem::path& file);

/// These make the formats, each in the source file of its name. A format is added by a maker here and by its
/// row in registry.cpp.
std::unique_ptr<Format> make_alta_format();
std::unique_ptr<Format> make_astm_format();
std::unique_ptr<Format> make_bird_format();
std::unique_ptr<Format> make_csv_format();
std::unique_ptr<Format> make_eradiate_format();
std::unique_ptr<Format> make_exr_format();
std::unique_ptr<Format> make_hdf5_format();
std::unique_ptr<Format> make_merl_format();
std::unique_ptr<Format> make_openmaterial_format();
std::unique_ptr<Format> make_radiance_format();
std::unique_ptr<Format> make_rgl_format();
std::unique_ptr<Format> make_ssdd_format();
std::unique_ptr<Format> make_zemax_format();

}  // namespace brdftab
