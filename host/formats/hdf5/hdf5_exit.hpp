// What HDF5 does when the process ends.
#pragma once

namespace brdftab {

/// HDF5 would flush open files once more at the end, and crash where that has failed before. This keeps it
/// from that, for the whole process: a program calls it before anything else of HDF5.
void keep_hdf5_from_exit();

}  // namespace brdftab
