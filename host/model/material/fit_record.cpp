#include "host/model/material/fit_record.hpp"

#include <fmt/ranges.h>

namespace brdftab {

const std::vector<FitKey>& fit_keys() {
  static const std::vector<FitKey> keys{
      {"command", &FitRecord::command, "command that made the file"},
      {"data", &FitRecord::data, "file of the measurement"},
      {"channel", &FitRecord::channel, "channel that was fitted, where the file has several"},
      {"light",
       &FitRecord::light,
       "polarisation of the light; all: s and p, fitted together",
       {"unpolarized", "s", "p", "all"}},
      {"samples", &FitRecord::samples, "number of samples that were fitted"},
      {"theta_i", &FitRecord::theta_i, "smallest and largest theta_i of the samples, degrees", {}, 0, 90},
      {"theta_s", &FitRecord::theta_s, "smallest and largest theta_s of the samples, degrees", {}, 0, 90},
      {"brdf", &FitRecord::brdf, "lowest and highest f of the samples, 1/sr", {}, -1e300},
      {"max_theta",
       &FitRecord::max_theta,
       "largest theta_i and theta_s that the fit takes, degrees",
       {},
       0,
       90},
      {"beyond_max_theta", &FitRecord::beyond_max_theta,
       "number of samples left out because they lie beyond max_theta"},
      {"floor",
       &FitRecord::floor,
       "f, 1/sr, from which on ln(model/data) is taken; samples at or below it are left out of rms and, "
       "where residuals are ln(model/data), of the fit",
       {},
       -1e300},
      {"below_floor", &FitRecord::below_floor, "number of samples left out of the fit because of floor"},
      {"residuals",
       &FitRecord::residuals,
       "what the fit makes small",
       {"ln(model/data)", "(model - data)/sigma"}},
      {"weights",
       &FitRecord::weights,
       "aoi: each angle of incidence counts alike; uniform: each sample does; sigma: residuals are divided "
       "by the data's sigma; noise: by sigma of a noise model",
       {"aoi", "uniform", "sigma", "noise"}},
      {"loss", &FitRecord::loss, "loss that is applied to a residual", {"linear", "cauchy"}},
      {"noise_relative", &FitRecord::noise_relative,
       "a of the noise model sigma^2 = (a f)^2 + b^2, with f of the model"},
      {"noise_floor", &FitRecord::noise_floor, "b of the noise model, 1/sr"},
      {"noise_estimated",
       &FitRecord::noise_estimated,
       "parts of the noise model that the fit estimated",
       {"relative", "floor"}},
      {"rms", &FitRecord::rms, "rms of ln(model/data), all samples alike"},
      {"rms_by_incidence", &FitRecord::rms_by_incidence,
       "rms of ln(model/data), each angle of incidence alike"},
      {"rms_samples", &FitRecord::rms_samples, "number of samples above floor, where not all are"},
      {"reduced_chi_square", &FitRecord::reduced_chi_square,
       "reduced chi-square, where residuals are divided by sigma"},
      {"degrees_of_freedom", &FitRecord::degrees_of_freedom, "degrees of freedom of reduced_chi_square"},
      {"starts", &FitRecord::starts, "number of starting points"},
      {"converged", &FitRecord::converged, "number of starts from which the search converged"},
      {"reached", &FitRecord::reached, "number of starts that ended within 1 % of the best rms"},
      {"is_descending", &FitRecord::is_descending,
       "true where the best was still descending along a flat valley"},
      {"condition", &FitRecord::condition, "condition number of J^T J, columns of unit length"},
      {"intervals",
       &FitRecord::intervals,
       "how intervals were found: by profile likelihood or from standard errors",
       {"profile", "linear"}},
      {"level", &FitRecord::level, "probability of the intervals", {}, 0, 1},
      {"fixed", &FitRecord::fixed, "parameters that were held", parameter_names()},
      {"warnings", &FitRecord::warnings, "what speaks against the fit, in words"},
  };
  return keys;
}

FittedParameters FitRecord::at_band(std::size_t band) const {
  FittedParameters result = bands[band];
  for (std::size_t p = 0; p < result.size(); ++p)
    if (!result[p]) result[p] = parameters[p];
  return result;
}

std::string text_of(const FittedParameter& fitted, double level) {
  const auto range = [](const FitRange& r) { return fmt::format("{:.4g} to {:.4g}", r.low, r.high); };
  std::string text =
      fmt::format("{:.4g} %: {}", 100 * level, fitted.interval ? range(*fitted.interval) : "-");
  if (fitted.bounds) text += "; bounds " + range(*fitted.bounds);
  std::vector<std::string_view> flags;
  if (fitted.at_bound) flags.push_back("at bound");
  if (fitted.open_below && fitted.open_above)
    flags.push_back("unidentifiable");
  else if (fitted.open_below)
    flags.push_back("no lower limit");
  else if (fitted.open_above)
    flags.push_back("no upper limit");
  if (!flags.empty()) text += fmt::format("; {}", fmt::join(flags, ", "));
  return text;
}

}  // namespace brdftab
