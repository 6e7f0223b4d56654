// The simulators' formats, one row each; each is made in the source file of its name.
#pragma once

#include <memory>

#include "host/formats/format.hpp"

namespace brdftab {

std::unique_ptr<ExportFormat> make_astm_format();
std::unique_ptr<ExportFormat> make_bird_format();
std::unique_ptr<ExportFormat> make_csv_format();
std::unique_ptr<ExportFormat> make_eradiate_format();
std::unique_ptr<ExportFormat> make_merl_format();
std::unique_ptr<ExportFormat> make_openmaterial_format();
std::unique_ptr<ExportFormat> make_radiance_format();
std::unique_ptr<ExportFormat> make_rgl_format();
std::unique_ptr<ExportFormat> make_ssdd_format();
std::unique_ptr<ExportFormat> make_zemax_format();

}  // namespace brdftab
