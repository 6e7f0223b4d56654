// PoCL's compiler cache, its weak spot: a folder that cannot be made leaves a platform without devices and no
// message, a read-only one fails every build, and a full disk kills the process.
#pragma once

namespace brdftab {

/// Sets POCL_CACHE_DIR, where the user has not, to a writable folder with room; to be called before the first
/// OpenCL call. Throws Error (exit status 3) that names the folder and the cause if there is none.
void choose_pocl_cache();

}  // namespace brdftab
