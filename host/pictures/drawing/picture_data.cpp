#include "host/pictures/drawing/picture_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/base/numbers.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab::drawing {

double nine_digits(double value) { return *parse_number(fmt::format("{:.9g}", value)); }

double hundredths(double place) { return *parse_number(fmt::format("{:.2f}", place)); }

nlohmann::ordered_json text_data(std::string_view text) { return plain_text(text); }

nlohmann::ordered_json axis_data(const ChartAxis& axis) {
  return {{"label", text_data(axis.label)},
          {"low", nine_digits(axis.low)},
          {"high", nine_digits(axis.high)},
          {"logarithmic", axis.logarithmic}};
}

std::string json_text(const nlohmann::ordered_json& data) {
  return data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace brdftab::drawing
