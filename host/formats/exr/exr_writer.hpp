// The OpenEXR table that host/FORMATS.md describes: a slice for each incidence, x = phi_s, y = theta_s, a
// pixel for each node.
#pragma once

#include <filesystem>
#include <memory>

#include "host/formats/exr/exr_names.hpp"

namespace brdftab {

class TableWriter;
struct TableContent;

/// Both are lossless.
enum class ExrCompression { none, zip };

struct ExrOptions {
  ExrLayout layout = ExrLayout::parts;
  ExrCompression compression = ExrCompression::none;
};

/// A file has no more parts than this, since viewers load every one.
inline constexpr std::size_t most_exr_parts = 1024;

/// A pixel needs all its channels at once, and a header needs what is known at the end. So samples wait in a
/// scratch file beside `file`, and `finish` writes the table over `file`, or a folder in its place for
/// ExrLayout::files. Throws BadInput for what OpenEXR cannot hold, and FileError.
std::unique_ptr<TableWriter> create_exr_writer(const std::filesystem::path& file, const TableContent& content,
                                               const ExrOptions& options);

}  // namespace brdftab
