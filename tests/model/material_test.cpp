// Material files: what they become, and the one line that each fault gives.
#include "host/model/material.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

const std::string head = "name = \"m\"\n";
const std::string parameters =
    "[parameters]\nn_eff = 1.24\nk_eff = 0\nsigma_surface = 1.9\nrho_surface = 0.45\nsigma_bulk = "
    "0.073\nrho_bulk = 0.88\n"
    "sigma_retro = 0.061\nrho_retro = 1.9\nw_a = 0.21\nw_b = 0.12\ngamma = 0.9\ndelta = 0.0\nw = 2.0\nn = "
    "0.0\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    Material::parse(text, "m.toml");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Material, ReadsParametersBandsSwitchesAndGrid) {
  const auto m = Material::parse(
      head + "license = \"CC0\"\n" + parameters +
          "[model]\nnormalization = \"reciprocal\"\nforeshortening = false\n"
          "[[band]]\nwavelength_nm = 450\nn_eff = 1.25\n[[band]]\nwavelength_nm = 650.5\nsigma_bulk = 0.21\n"
          "[grid]\ntheta_i = \"0:80:10\"\nphi_i = [0, 90]\n",
      "m.toml");
  EXPECT_EQ(m.name(), "m");
  ASSERT_EQ(m.bands().size(), 2u);
  EXPECT_EQ(*m.bands()[0].wavelength_nm, 450);
  EXPECT_EQ(m.bands()[0].parameters.n_eff, 1.25);
  EXPECT_EQ(m.bands()[1].parameters.n_eff, 1.24);
  EXPECT_EQ(m.bands()[1].parameters.sigma_bulk, 0.21);
  EXPECT_EQ(m.variant().normalization, Normalization::reciprocal);
  EXPECT_FALSE(m.variant().foreshortening);
  EXPECT_TRUE(m.variant().width_shadowing);
  EXPECT_EQ(m.grid().theta_i.size(), 9u);
  EXPECT_EQ(m.grid().phi_i[1], 90);
  EXPECT_EQ(m.grid().phi_s.size(), 181u);
}

TEST(Material, EveryFaultGivesOneLineWithItsPlace) {
  struct Case {
    std::string text;
    std::string message;  // a part of it
  };
  const std::string good = head + parameters;
  std::string deep = "a";
  for (int k = 0; k < 100000; ++k) deep += ".a";
  const Case cases[] = {
      {with(good, "k_eff", "keff"), "m.toml:4:1: parameters.keff = 0: unknown key; did you mean k_eff?"},
      {good + "colour = 1\n", "unknown key"},
      {with(good, "w_a = 0.21\n", ""), "parameters.w_a is missing"},
      {parameters, "name is missing"},
      {head, "[parameters] is missing"},
      {with(good, "k_eff = 0", "k_eff = \"zero\""),
       "m.toml:4:9: parameters.k_eff = \"zero\": must be a number"},
      {with(good, "\"m\"", "3"), "m.toml:1:8: name = 3: must be a string"},
      {with(good, "n_eff = 1.24", "n_eff = 21"), "m.toml:3:9: parameters.n_eff = 21: must lie in 0.05 to 20"},
      {with(good, "n_eff = 1.24", "n_eff = 0.049"), "must lie in 0.05 to 20"},
      {with(good, "n_eff = 1.24", "n_eff = nan"), "parameters.n_eff = nan: must be finite"},
      {with(good, "n_eff = 1.24", "n_eff = -inf"), "must be finite"},
      {with(good, "n_eff = 1.24", "n_eff = true"), "must be a number"},
      {with(good, "n_eff = 1.24", "n_eff = 1.24\nn_eff = 1.25"), "m.toml:4"},
      {"", "empty"},
      {" \n\t\n", "empty"},
      {std::string("name = \"m\"\n\0\1", 12), "m.toml:2:1: byte 0x00"},
      {good + "[model]\nnormalization = \"none\"\n",
       "one of the strings hemispherical, reciprocal, closed-form"},
      {good + "[model]\nforeshortening = \"true\"\n", "must be true, false"},
      {good + "[model]\nnormalization = \"closed-form\"\nautocovariance = \"gaussian\"\n", "Eq. (8)"},
      {good + "[modle]\n", "unknown key; did you mean model?"},
      {good + "[[band]]\nn_eff = 1.2\n", "band.wavelength_nm is missing"},
      {good + "[[band]]\nwavelength_nm = -5\n", "band.wavelength_nm = -5: must be in nm, above 0"},
      {good + "[[band]]\nwavelength_nm = 500\n[[band]]\nwavelength_nm = 500\n", "above the band before it"},
      {good + "[[band]]\nwavelength_nm = 500\nrho_bulk = 1000\n",
       "band.rho_bulk = 1000: must lie in 0.0001 to 100"},
      {good + "[band]\nwavelength_nm = 500\n", "each headed [[band]]"},
      {good + "[grid]\ntheta_i = \"0:90:5\"\n",
       "m.toml:18:11: grid.theta_i = \"0:90:5\": theta_i must lie in"},
      {good + "[grid]\ntheta_s = [0, 10, 5]\n", "5 follows 10"},
      {good + "[grid]\ntheta_s = [0, \"x\"]\n", "grid.theta_s = \"x\": must be a number"},
      {good + "[grid]\nphi = [0]\n", "unknown key"},
      {good + "[grid]\nphi_s = []\n", "no node"},
      {"name = \"m\"\nparameters = 3\n", "must be a table"},
      {good + "[fit]\nrsm = 0.1\n", "m.toml:18:1: fit.rsm = 0.1: unknown key; did you mean rms?"},
      {good + "[fit]\nrms = \"small\"\n", "m.toml:18:7: fit.rms = \"small\": must be a number"},
      {good + "[fit]\nrms = -1\n", "fit.rms = -1: must lie in 0 to"},
      {good + "[fit]\nsamples = 1.5\n", "fit.samples = 1.5: must be a whole number"},
      {good + "[fit]\nlevel = 2\n", "fit.level = 2: must lie in 0 to 1"},
      {good + "[fit]\nlight = \"blue\"\n", "fit.light = \"blue\": must be one of the strings unpolarized"},
      {good + "[fit]\nfixed = [\"k_ef\"]\n", "fit.fixed = \"k_ef\": must be one of the strings n_eff"},
      {good + "[fit]\ntheta_i = [80, 0]\n", "fit.theta_i = [80, 0]: must be an array of two numbers"},
      {good + "[fit]\nincidences = [{ theta_i = 1 }]\n", "fit.incidences.samples is missing"},
      {good + "[fit.n_eff]\nlow = 1.2\n", "fit.n_eff.high is missing"},
      {good + "[fit.n_eff]\nlow = 1.2\nhigh = 1.1\n",
       "m.toml:19:8: fit.n_eff.high = 1.1: must not be below low"},
      {good + "[fit.n_eff]\nlow = 0.01\nhigh = 1.1\n", "fit.n_eff.low = 0.01: must lie in 0.05 to 20"},
      {good + "[fit.n_eff]\nopen = \"up\"\n", "fit.n_eff.open = \"up\": must be one of the strings below"},
      {good + "[fit.n_eff]\nopne = \"above\"\n", "unknown key; did you mean open?"},
      {good + "[fit]\nn_eff = 1.2\n", "fit.n_eff = 1.2: must be a table"},
      {good + "[[band]]\nwavelength_nm = 500\n[band.fit]\nrms = 1\n", "band.fit.rms = 1: unknown key"},
      {"this is not TOML\n", "m.toml:1"},
      {"name = \"a\\nb\"\n" + parameters, "one line without control characters"},
      {good + "\"σσσ\" = 12345\n", "parameters.σσσ = 12345: unknown key"},
      {head + deep + " = 1\n", "at most 64 dots"},
  };
  for (const auto& [text, message] : cases) {
    const std::string told = refusal(text);
    EXPECT_NE(told.find(message), std::string::npos) << told << "\n  expected: " << message;
    EXPECT_TRUE(told.starts_with("m.toml:")) << told;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 0) << told;
  }
}

TEST(Material, ShippedMaterialsAreValid) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BRDFTAB_MATERIALS_DIR)) {
    EXPECT_NO_THROW(Material::read(entry.path())) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 4);
}

TEST(Material, MissingFilesAreFileErrors) {
  EXPECT_THROW(Material::read("/nonexistent/m.toml"), FileError);
  EXPECT_THROW(Material::read("/"), FileError);
}

}  // namespace
}  // namespace brdftab
