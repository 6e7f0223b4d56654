// Measured files of every format that the program knows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// Gives the names of the formats that are read as measurements.
std::vector<std::string> measurement_formats();

/// Reads a file ("-": standard input, CSV) and cleans what it holds. Values that are nan, and what a format
/// itself repeats, are set aside and counted; zero and negative ones are counted and kept, and so are equal
/// readings of one direction. Throws FileError where the file cannot be read, and BadInput `FILE:LINE: ...`
/// where its content is no measurement.
Measurement read_measurement(const std::filesystem::path& file, const MeasurementOptions& options = {});

}  // namespace brdftab
