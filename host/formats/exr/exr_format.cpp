// OpenEXR tables have a slice for each incidence, with x = phi_s and y = theta_s, and a pixel for each node.
#include <algorithm>

#include "host/formats/exr/exr_reader.hpp"
#include "host/formats/exr/exr_writer.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_reader.hpp"
#include "host/table/table_writer.hpp"

namespace brdftab {
namespace {

constexpr std::string_view signature = "\x76\x2f\x31\x01";

class ExrFormat : public DenseFormat {
 public:
  ExrFormat()
      : DenseFormat({.name = "exr",
                     .consumer = "OpenEXR's tools and viewers",
                     .extensions = {".exr"},
                     .suffix = ".exr"}) {}

  std::vector<FormatOption> options() override {
    return {
        {.name = "exr_layout",
         .help = "OpenEXR: parts (default; a part for each slice), tiles (one image, a tile for each slice) "
                 "or files (a folder with a file for each slice)",
         .value = &layout_,
         .words = {exr_layout_names.begin(), exr_layout_names.end()}},
        {.name = "exr_compression",
         .help = "OpenEXR: none (default) or zip, both lossless",
         .value = &compression_,
         .words = {"none", "zip"}}};
  }

  bool writes_folder() const override { return layout() == ExrLayout::files; }

  bool recognises(const std::filesystem::path& file, std::string_view beginning) const override {
    std::error_code error;
    return beginning.starts_with(signature) || std::filesystem::is_directory(file, error);
  }
  std::unique_ptr<TableWriter> create(const std::filesystem::path& file,
                                      const TableContent& content) const override {
    return create_exr_writer(
        file, content,
        {.layout = layout(),
         .compression = compression_ == "zip" ? ExrCompression::zip : ExrCompression::none});
  }
  std::unique_ptr<TableReader> open(const std::filesystem::path& file) const override {
    return open_exr_reader(file);
  }

 private:
  ExrLayout layout() const {
    const auto name = std::find(exr_layout_names.begin(), exr_layout_names.end(), layout_);
    return static_cast<ExrLayout>(name - exr_layout_names.begin());
  }

  std::string layout_{exr_layout_names.front()};
  std::string compression_ = "none";
};

}  // namespace

std::unique_ptr<Format> make_exr_format() { return std::make_unique<ExrFormat>(); }

}  // namespace brdftab
