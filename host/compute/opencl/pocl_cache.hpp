// PoCL's compiler cache, its weak spot: a folder that cannot be made leaves a platform without devices and no
// message, a read-only one fails every build, a full disk and a damaged file kill the process. So PoCL works
// in a folder of this run alone, filled with what earlier runs have compiled once that is checked: see
// kernel_store.hpp.
#pragma once

#include <string>

namespace brdftab {

/// Sets POCL_CACHE_DIR to such a folder, in POCL_CACHE_DIR where the user has set it, otherwise in a writable
/// place with room; to be called before the first OpenCL call. Calls after the first do nothing; at the end
/// of the process what PoCL has compiled is kept and the folder removed. Throws Error (exit status 3) that
/// names the places and the causes if there is none.
void choose_pocl_cache();

/// What choose_pocl_cache found damaged, in one line; empty if nothing.
const std::string& damaged_pocl_cache();

/// The folder that choose_pocl_cache has chosen.
std::string pocl_cache_folder();

/// Why PoCL may fail to compile by now: too little space in that folder. Empty if there is enough.
std::string pocl_cache_shortage();

}  // namespace brdftab
