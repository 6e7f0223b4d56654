// An HDF5 virtual dataset is a table of four angles that shows a stored one of theta_i, theta_s and
// phi = phi_s - phi_i.
#pragma once

#include <hdf5.h>

#include <span>
#include <string>
#include <vector>

#include "host/model/relative_azimuth.hpp"

namespace brdftab {

/// Sets the properties of a dataset of shape [wavelength,] theta_i, phi_i, theta_s, phi_s so that it shows
/// the dataset `stored`, [wavelength,] theta_i, theta_s, phi, of the same file, whatever the file is called.
/// Throws FileError.
void set_view(hid_t creation, const std::vector<hsize_t>& shape, const std::string& stored,
              const std::vector<hsize_t>& stored_shape, std::span<const AzimuthPiece> pieces);

}  // namespace brdftab
