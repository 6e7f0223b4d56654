#include "host/formats/hdf5/hdf5_storage.hpp"

#include <fmt/format.h>

#include "host/formats/hdf5/hdf5_handle.hpp"

namespace brdftab {
namespace {

std::vector<std::size_t> chunk_of(hid_t creation) {
  std::vector<hsize_t> sizes(H5S_MAX_RANK);
  const int rank = H5Pget_chunk(creation, H5S_MAX_RANK, sizes.data());
  hdf5_check(rank, "chunks");
  return {sizes.begin(), sizes.begin() + rank};
}

std::vector<std::string> filters_of(hid_t creation) {
  std::vector<std::string> filters;
  for (int k = 0; k < H5Pget_nfilters(creation); ++k) {
    unsigned flags = 0;
    unsigned values[1] = {0};
    std::size_t count = 1;
    char name[64] = "";
    const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(k), &flags, &count, values,
                                               sizeof name, name, nullptr);
    filters.push_back(filter == H5Z_FILTER_SHUFFLE   ? "shuffle"
                      : filter == H5Z_FILTER_DEFLATE ? fmt::format("deflate {}", values[0])
                                                     : std::string(name));
  }
  return filters;
}

std::string view_of(hid_t creation) {
  char name[256] = "";
  hdf5_check(H5Pget_virtual_dsetname(creation, 0, name, sizeof name) < 0 ? -1 : 0, "view");
  return name[0] == '/' ? name + 1 : name;
}

}  // namespace

StorageInfo storage_of(hid_t dataset) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset), "dataset properties");
  const Hdf5Handle space(H5Dget_space(dataset), "dataset shape");
  const Hdf5Handle type(H5Dget_type(dataset), "dataset type");
  StorageInfo storage{.layout = "other",
                      .chunk = {},
                      .filters = {},
                      .view_of = {},
                      .bytes = H5Dget_storage_size(dataset),
                      .ratio = 0};
  const H5D_layout_t layout = H5Pget_layout(creation);
  if (layout == H5D_CONTIGUOUS) storage.layout = "contiguous";
  if (layout == H5D_CHUNKED) {
    storage.layout = "chunked";
    storage.chunk = chunk_of(creation);
    storage.filters = filters_of(creation);
  }
  if (layout == H5D_VIRTUAL) {
    storage.layout = "virtual";
    storage.view_of = view_of(creation);
    storage.bytes = 0;
  }
  const auto samples =
      static_cast<double>(H5Sget_simple_extent_npoints(space)) * static_cast<double>(H5Tget_size(type));
  if (storage.bytes > 0) storage.ratio = samples / static_cast<double>(storage.bytes);
  return storage;
}

}  // namespace brdftab
