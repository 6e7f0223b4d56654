// The style and the script of the page that `report` writes.
#pragma once

#include <string_view>

namespace brdftab {

/// CSS.
extern const std::string_view report_style;

/// JavaScript, which draws the map and its cut from the elements `axes`, `samples` and `scale` of the page.
extern const std::string_view report_script;

}  // namespace brdftab
