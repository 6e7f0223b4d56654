// The style and the script of a report.
#pragma once

#include <string_view>

namespace brdftab {

extern const std::string_view report_style;   // CSS
extern const std::string_view report_script;  // JavaScript; reads the elements `axes`, `samples` and `scale`

}  // namespace brdftab
