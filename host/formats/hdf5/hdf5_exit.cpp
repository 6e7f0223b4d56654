#include "host/formats/hdf5/hdf5_exit.hpp"

#include <hdf5.h>

namespace brdftab {

void keep_hdf5_from_exit() { H5dont_atexit(); }

}  // namespace brdftab
