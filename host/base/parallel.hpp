// A loop whose steps are shared by all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace brdftab {

/// How many threads the machine runs at once; at least 1.
std::size_t hardware_threads();

/// Calls `work(k)` for every k below `count`, on all cores at once; this thread works, too. Nobody begins a
/// further step once one has thrown or `stop` is requested. The function returns when no step runs any more;
/// then it throws the first exception, or Error (Fault::stopped).
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work, std::stop_token stop = {});

}  // namespace brdftab
