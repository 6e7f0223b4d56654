// What a picture shows, as JSON in the metadata of its SVG file: programs read the values from there.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

#include "host/pictures/drawing/chart_axis.hpp"

namespace brdftab::drawing {

/// A value of the data is rounded to nine significant digits.
double nine_digits(double value);

/// A place on the page is rounded to hundredths of a user unit, as marks are.
double hundredths(double place);

/// A text of the picture without its marks for lowered and raised characters.
nlohmann::ordered_json text_data(std::string_view text);

/// An object with the axis's `label`, `low`, `high` and `logarithmic`.
nlohmann::ordered_json axis_data(const ChartAxis& axis);

/// The text of the JSON on one line. Bytes that are no UTF-8 become the replacement character.
std::string json_text(const nlohmann::ordered_json& data);

}  // namespace brdftab::drawing
