// HDF5 tables are root-level datasets with dimension scales and CF attributes, as h5py, xarray, ncdump,
// MATLAB and Octave read them without a plug-in.
#include "host/formats/hdf5/hdf5_reader.hpp"
#include "host/formats/hdf5/hdf5_writer.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_reader.hpp"
#include "host/table/table_writer.hpp"

namespace brdftab {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view signature = "\x89HDF\r\n\x1a\n"sv;

class Hdf5Format : public DenseFormat {
 public:
  Hdf5Format()
      : DenseFormat({.name = "hdf5",
                     .consumer = "h5py, xarray, netCDF's tools, MATLAB, Octave",
                     .extensions = {".h5", ".hdf5", ".nc"},
                     .suffix = ".h5"}) {}

  std::vector<FormatOption> options() override {
    return {
        {.name = "compress",
         .help = "deflate or deflate:LEVEL, 1 (default, fastest) to 12: HDF5 chunks, shuffled and deflated, "
                 "that any reader opens without a plug-in",
         .value = &compress_,
         .shape = "deflate[:LEVEL]"},
        {.name = "layout",
         .help = "contiguous (default), or virtual: store f over theta_i, theta_s and phi_s - phi_i, and "
                 "show the table of four angles as a view of it, smaller by about the number of phi_i; "
                 "takes even steps of phi_i and phi_s; readers take HDF5 1.10 or later",
         .value = &layout_,
         .words = {"contiguous", "virtual"}}};
  }

  TableStorage storage() const override {
    return {.deflate_level = compress_.empty() ? 0 : parse_compression(compress_),
            .layout = layout_ == "virtual" ? Layout::virtual_view : Layout::contiguous};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.starts_with(signature);
  }
  std::unique_ptr<TableWriter> create(const std::filesystem::path& file,
                                      const TableContent& content) const override {
    return create_hdf5_writer(file, content);
  }
  std::unique_ptr<TableReader> open(const std::filesystem::path& file) const override {
    return open_hdf5_reader(file);
  }

 private:
  std::string compress_;
  std::string layout_ = "contiguous";
};

}  // namespace

std::unique_ptr<Format> make_hdf5_format() { return std::make_unique<Hdf5Format>(); }

}  // namespace brdftab
