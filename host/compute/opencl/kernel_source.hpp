// The kernels, flattened into the binary at build time.
#pragma once

namespace brdftab {

extern const char kernel_source[];

}  // namespace brdftab
