#include "host/formats/hdf5/hdf5_view.hpp"

#include "host/formats/hdf5/hdf5_handle.hpp"

namespace brdftab {

void set_view(hid_t creation, const std::vector<hsize_t>& shape, const std::string& stored,
              const std::vector<hsize_t>& stored_shape, std::span<const AzimuthPiece> pieces) {
  const Hdf5Handle view_space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                              stored);
  const Hdf5Handle stored_space(
      H5Screate_simple(static_cast<int>(stored_shape.size()), stored_shape.data(), nullptr), stored);
  const std::size_t phi_i = shape.size() - 3;
  const std::size_t phi_s = shape.size() - 1;
  const std::size_t phi = stored_shape.size() - 1;
  for (const AzimuthPiece& piece : pieces) {
    std::vector<hsize_t> start(shape.size(), 0);
    std::vector<hsize_t> count = shape;
    start[phi_i] = piece.phi_i;
    count[phi_i] = 1;
    start[phi_s] = piece.phi_s;
    count[phi_s] = piece.count;
    hdf5_check(H5Sselect_hyperslab(view_space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
               stored);
    std::vector<hsize_t> stored_start(stored_shape.size(), 0);
    std::vector<hsize_t> stride(stored_shape.size(), 1);
    std::vector<hsize_t> stored_count = stored_shape;
    stored_start[phi] = piece.phi;
    stride[phi] = piece.step;
    stored_count[phi] = piece.count;
    hdf5_check(H5Sselect_hyperslab(stored_space, H5S_SELECT_SET, stored_start.data(), stride.data(),
                                   stored_count.data(), nullptr),
               stored);
    // The name "." stands for the file itself.
    hdf5_check(H5Pset_virtual(creation, view_space, ".", ("/" + stored).c_str(), stored_space), stored);
  }
}

}  // namespace brdftab
