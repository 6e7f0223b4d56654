// What is written of a material reads back as the same material, what a fit says about itself included.
#include "host/model/material/material_toml.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "host/base/error.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

const std::filesystem::path materials(BRDFTAB_MATERIALS_DIR),
    written_before(std::filesystem::path(BRDFTAB_TESTS_DIR) / "data" / "fitted");

bool are_equal(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

void expect_equal(const std::optional<FitRange>& a, const std::optional<FitRange>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->low, b->low);
  EXPECT_EQ(a->high, b->high);
}

void expect_equal(const FittedParameters& a, const FittedParameters& b) {
  for (std::size_t p = 0; p < a.size(); ++p) {
    SCOPED_TRACE(parameter_table[p].name);
    ASSERT_EQ(a[p].has_value(), b[p].has_value());
    if (!a[p]) continue;
    expect_equal(a[p]->interval, b[p]->interval);
    expect_equal(a[p]->bounds, b[p]->bounds);
    EXPECT_EQ(a[p]->open_below, b[p]->open_below);
    EXPECT_EQ(a[p]->open_above, b[p]->open_above);
    EXPECT_EQ(a[p]->at_bound, b[p]->at_bound);
  }
}

template <class Value>
void expect_equal(const Value& a, const Value& b) {
  EXPECT_EQ(a, b);
}

void expect_equal(const FitRecord& a, const FitRecord& b) {
  for (const FitKey& key : fit_keys()) {
    SCOPED_TRACE(key.name);
    std::visit([&](auto member) { expect_equal(a.*member, b.*member); }, key.member);
  }
  ASSERT_EQ(a.incidences.size(), b.incidences.size());
  for (std::size_t k = 0; k < a.incidences.size(); ++k) {
    EXPECT_EQ(a.incidences[k].theta_i, b.incidences[k].theta_i);
    EXPECT_EQ(a.incidences[k].samples, b.incidences[k].samples);
    EXPECT_EQ(a.incidences[k].rms, b.incidences[k].rms);
    EXPECT_EQ(a.incidences[k].dhr, b.incidences[k].dhr);
    expect_equal(a.incidences[k].settings, b.incidences[k].settings);
  }
  expect_equal(a.parameters, b.parameters);
  ASSERT_EQ(a.bands.size(), b.bands.size());
  for (std::size_t k = 0; k < a.bands.size(); ++k) expect_equal(a.bands[k], b.bands[k]);
}

void expect_equal(const MaterialContent& a, const MaterialContent& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.license, b.license);
  EXPECT_EQ(text_of(a.variant), text_of(b.variant));
  ASSERT_EQ(a.bands.size(), b.bands.size());
  for (std::size_t k = 0; k < a.bands.size(); ++k) {
    EXPECT_EQ(a.bands[k].wavelength_nm, b.bands[k].wavelength_nm);
    for (const ParameterRow& row : parameter_table)
      EXPECT_EQ(a.bands[k].parameters.*row.member, b.bands[k].parameters.*row.member) << row.name;
  }
  for (const AxisRow& row : axis_table)
    EXPECT_TRUE(are_equal(a.grid[row.kind].nodes(), b.grid[row.kind].nodes())) << row.name;
  ASSERT_EQ(a.fit.has_value(), b.fit.has_value());
  if (a.fit) expect_equal(*a.fit, *b.fit);
}

// Gives each key of [fit] a value that it may have and that no other key has.
class FilledRecord {
 public:
  explicit FilledRecord(unsigned seed) : random_(seed) {}

  FitRecord operator()(std::size_t bands) {
    FitRecord record;
    for (const FitKey& key : fit_keys())
      std::visit([&](auto member) { fill(record.*member, key); }, key.member);
    record.incidences = {{15.25, {}, 19, random_.uniform(0, 1), random_.uniform(0, 2)},
                         {random_.uniform(0, 90), FitRange{20, 30}, 7, 1e-7, 0}};
    record.parameters = parameters();
    for (std::size_t b = 0; b < bands; ++b)
      record.bands.push_back(bands > 1 ? parameters() : FittedParameters{});
    return record;
  }

 private:
  void fill(std::string& text, const FitKey& key) {
    text = key.choices.empty() ? fmt::format("\"{}\", Å, back\\slash {}", key.name, random_.uniform(0, 1))
                               : std::string(key.choices[static_cast<std::size_t>(
                                     random_.uniform(0, static_cast<double>(key.choices.size())))]);
  }
  void fill(bool& is_so, const FitKey&) { is_so = true; }
  void fill(std::optional<double>& number, const FitKey& key) {
    number = random_.uniform(std::max(key.minimum, -1e6), std::min(key.maximum, 1e6));
  }
  void fill(std::optional<std::size_t>& count, const FitKey&) {
    count = static_cast<std::size_t>(random_.uniform(0, 1e9));
  }
  void fill(std::optional<FitRange>& range, const FitKey& key) {
    std::optional<double> a, b;
    fill(a, key);
    fill(b, key);
    range = {std::min(*a, *b), std::max(*a, *b)};
  }
  void fill(std::vector<std::string>& list, const FitKey& key) {
    fill(list.emplace_back(), key);
    fill(list.emplace_back(), key);
  }

  FittedParameters parameters() {
    FittedParameters result;
    for (std::size_t p = 0; p < result.size(); ++p) {
      if (random_.chance(0.2)) continue;
      const ParameterRow& row = parameter_table[p];
      const auto within = [&] { return random_.uniform(row.minimum, row.maximum); };
      const auto range = [&] {
        const double a = within(), b = within();
        return FitRange{std::min(a, b), std::max(a, b)};
      };
      result[p] = FittedParameter{.interval = {},
                                  .open_below = random_.chance(0.5),
                                  .open_above = random_.chance(0.5),
                                  .at_bound = random_.chance(0.5),
                                  .bounds = {}};
      if (random_.chance(0.8)) result[p]->interval = range();
      if (random_.chance(0.8)) result[p]->bounds = range();
    }
    return result;
  }

  RandomMaterials random_;
};

TEST(MaterialToml, ShippedMaterialsAreTextThatIsWritten) {
  std::size_t fitted = 0;
  for (const auto& entry : std::filesystem::directory_iterator(materials)) {
    const Material material = Material::read(entry.path());
    EXPECT_EQ(material_toml(material.content()), material.text()) << entry.path();
    fitted += material.fit().has_value();
  }
  EXPECT_GE(fitted, 4u);
}

TEST(MaterialToml, RandomMaterialsKeepEveryDigit) {
  RandomMaterials random(11);
  for (unsigned k = 0; k < 60; ++k) {
    MaterialContent content{.name = fmt::format("m \"{}\" \\", k),
                            .description = k % 2 ? "σ and ρ" : "",
                            .source = k % 3 ? "made up" : "",
                            .license = k % 5 ? "" : "CC0-1.0",
                            .variant = random.variant(),
                            .bands = {},
                            .grid = {},
                            .fit = {}};
    const std::size_t bands = 1 + k % 3;
    for (std::size_t b = 0; b < bands; ++b)
      content.bands.push_back({bands > 1
                                   ? std::optional(400 + 100 * static_cast<double>(b) + random.uniform(0, 99))
                                   : std::nullopt,
                               random.parameters()});
    if (k % 2) content.grid.theta_i = Axis(AxisKind::theta_i, {0, random.uniform(1, 50), 60.5, 89.999});
    if (k % 4 == 0) content.grid.phi_s = Axis(AxisKind::phi_s, {-180, 1. / 3, 180});
    if (k % 3 != 1) content.fit = FilledRecord(k)(bands);
    const Material written = Material::of(content);
    expect_equal(written.content(), content);
    EXPECT_EQ(material_toml(written.content()), written.text());
  }
}

TEST(MaterialToml, TextsBecomeOneReadableLine) {
  MaterialContent content = Material::read(materials / "brown-vinyl.toml").content();
  content.description = "two\nlines\tand a bell\a";
  content.source = "T\xfcrk";
  const Material written = Material::of(content);
  EXPECT_EQ(written.description(), "two lines and a bell ");
  EXPECT_EQ(written.source(), "T?rk");
}

TEST(MaterialToml, WhatIsNoMaterialIsRefused) {
  MaterialContent content = Material::read(materials / "brown-vinyl.toml").content();
  content.bands.front().parameters.n_eff = 21;
  EXPECT_THROW(Material::of(content), BadInput);
}

// The same fits, as version 0.1 wrote them and as they are written now.
TEST(FitRecord, CommentsOfEarlierFilesAreReadAsTheDataThatTheyAreNow) {
  for (const auto& [before, now] : {std::pair{"comments.toml", "brown-vinyl.toml"},
                                    {"comments-spectrum.toml", "garnet-red-spectrum.toml"}}) {
    SCOPED_TRACE(before);
    const Material from_comments = Material::read(written_before / before),
                   from_data = Material::read(materials / now);
    ASSERT_TRUE(from_comments.fit() && from_data.fit());
    for (std::size_t b = 0; b < from_data.bands().size(); ++b)
      expect_equal(from_comments.fit()->at_band(b), from_data.fit()->at_band(b));
    EXPECT_EQ(from_comments.fit()->condition, from_data.fit()->condition);
    EXPECT_EQ(from_comments.fit()->intervals, from_data.fit()->intervals);
    EXPECT_EQ(from_comments.fit()->level, from_data.fit()->level);
  }
}

TEST(FitRecord, ABandHasItsOwnIntervalsAndOtherwiseThoseOfAll) {
  const Material material = Material::read(materials / "garnet-red-spectrum.toml");
  const auto index = [](std::string_view name) {
    return static_cast<std::size_t>(std::find_if(parameter_table.begin(), parameter_table.end(),
                                                 [&](const auto& row) { return row.name == name; }) -
                                    parameter_table.begin());
  };
  const std::size_t n_eff = index("n_eff"), rho_surface = index("rho_surface"), w_a = index("w_a");
  const FittedParameters fitted = material.at_wavelength(550).fit()->at_band(0);
  EXPECT_EQ(fitted[n_eff]->interval->low, 0.332);
  EXPECT_EQ(fitted[rho_surface]->interval->high, 0.14);
  EXPECT_FALSE(fitted[w_a]);
  EXPECT_EQ(material.fit()->fixed.front(), "sigma_retro");
}

TEST(FitRecord, IsReadAsPeopleSayIt) {
  const FitRecord fit = *Material::read(materials / "brown-vinyl.toml").fit();
  const auto said = [&](std::size_t p) { return text_of(*fit.parameters[p], *fit.level); };
  EXPECT_EQ(said(0), "95 %: 0.7649 to 0.8532; bounds 0.05 to 20");
  EXPECT_EQ(said(6), "95 %: 0 to 0.06242; bounds 0 to 100; no lower limit");
  EXPECT_EQ(said(7), "95 %: 0.0001 to 100; bounds 0.0001 to 100; unidentifiable");
  EXPECT_EQ(said(11), "95 %: 0 to 0.01873; bounds 0 to 1000; at bound");
}

}  // namespace
}  // namespace brdftab
