// Measured BRDFs in comma-separated values.
#pragma once

#include <istream>
#include <string>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// CSV with the columns of `read_directions`, of brdf, brdf_s and brdf_p those that are there (1/sr;
/// brdf_per_sr and the like are taken too), and optionally channel, wavelength_nm or wavelength_um, and
/// sigma, or sigma_s and sigma_p (1/sr). Of the options it takes `angles`. Throws BadInput `SOURCE:LINE: ...`
/// where the content is none of this.
Measurement read_csv_measurement(std::istream& in, const std::string& source,
                                 const MeasurementOptions& options = {});

}  // namespace brdftab
