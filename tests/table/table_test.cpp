// Rung 4: the device's buffers against the file read back; and files that must not appear.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "host/base/error.hpp"
#include "host/compute/plan.hpp"
#include "host/formats/hdf5/hdf5_handle.hpp"
#include "host/formats/hdf5/hdf5_writer.hpp"
#include "host/table/generate.hpp"
#include "tests/table/two_bands.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

class Table : public testing::Test {
 protected:
  void SetUp() override {
    if (!device_.has_fp64) GTEST_SKIP() << "the device has no fp64";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  const Device device_ = select_device(std::nullopt);
  const fs::path folder_ = fs::temp_directory_path() / fmt::format("brdftab-table-test-{}", getpid());
};

Grid small_grid() {
  Grid grid;
  grid.theta_i = Axis::parse(AxisKind::theta_i, "0:80:16");
  grid.phi_i = Axis::parse(AxisKind::phi_i, "0,45,100");
  grid.theta_s = Axis::parse(AxisKind::theta_s, "0:88:11");
  grid.phi_s = Axis::parse(AxisKind::phi_s, "0:360:24");
  return grid;
}

TEST_F(Table, FileHoldsTheDevicesBytes) {
  const Material material = Material::parse(two_bands, "two bands");
  const Grid grid = small_grid();
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const Engine engine(device_, Precision::float64, precision);
    const fs::path file = folder_ / fmt::format("{}.h5", name_of(precision));
    GenerateOptions options;
    options.polarizations = {Polarization::unpolarized, Polarization::s, Polarization::p};
    // Slabs have a few rows only, so that every way of cutting is taken.
    options.slab_bytes = 50 * bytes_of(precision);
    generate(engine, material, grid, file, create_hdf5_writer, options);

    const Slab whole{
        {0, grid.theta_i.size()}, {0, grid.phi_i.size()}, {0, grid.theta_s.size()}, grid.phi_s.size()};
    const std::size_t bytes = whole.nodes() * bytes_of(precision);
    const Hdf5Handle read(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), file.string());
    for (std::size_t band = 0; band < 2; ++band) {
      Plan plan(engine, material, material.bands()[band], grid,
                integrals(engine, material.bands()[band], material.variant(), grid.theta_i.nodes()));
      for (const Polarization polarization : options.polarizations) {
        const cl::Buffer samples = engine.buffer(bytes);
        plan.tabulate(whole, polarization, samples);
        std::vector<std::byte> expected(bytes);
        engine.queue().enqueueReadBuffer(samples, CL_TRUE, 0, bytes, expected.data());

        const Hdf5Handle dataset(H5Dopen2(read, std::string(brdf_name(polarization)).c_str(), H5P_DEFAULT),
                                 "brdf");
        const Hdf5Handle space(H5Dget_space(dataset), "brdf");
        ASSERT_EQ(H5Sget_simple_extent_ndims(space), 5);
        const hsize_t start[] = {band, 0, 0, 0, 0};
        const hsize_t count[] = {1, grid.theta_i.size(), grid.phi_i.size(), grid.theta_s.size(),
                                 grid.phi_s.size()};
        H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr);
        const Hdf5Handle memory(H5Screate_simple(5, count, nullptr), "brdf");
        std::vector<std::byte> stored(bytes);
        hdf5_check(H5Dread(dataset, precision == Precision::float64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT,
                           memory, space, H5P_DEFAULT, stored.data()),
                   "brdf");
        EXPECT_EQ(std::memcmp(stored.data(), expected.data(), bytes), 0)
            << name_of(precision) << " band " << band << " " << brdf_name(polarization);
      }
    }
  }
}

TEST_F(Table, SpotCheckFindsAWrongTable) {
  // The same samples under another material's name must not pass as accurate.
  const Material material = Material::parse(two_bands, "two bands");
  const Engine engine(device_, Precision::float64, Precision::float32);
  GenerateOptions options;
  const auto summary =
      generate(engine, material, small_grid(), folder_ / "t.h5", create_hdf5_writer, options);
  EXPECT_GT(summary.findings.accuracy.nodes, 50u);
  EXPECT_LE(summary.findings.accuracy.max_relative_error, 1e-6);
  EXPECT_GT(summary.findings.accuracy.max_relative_error, 1e-9) << "float32 cannot be that close";
}

TEST_F(Table, RefusesToOverwrite) {
  const Material material = Material::parse(two_bands, "two bands");
  const Engine engine(device_, Precision::float64, Precision::float32);
  const fs::path file = folder_ / "t.h5";
  GenerateOptions options;
  generate(engine, material, small_grid(), file, create_hdf5_writer, options);
  const auto written = fs::last_write_time(file);
  EXPECT_THROW(generate(engine, material, small_grid(), file, create_hdf5_writer, options), FileError);
  EXPECT_EQ(fs::last_write_time(file), written);
  options.force = true;
  EXPECT_NO_THROW(generate(engine, material, small_grid(), file, create_hdf5_writer, options));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
      << "a partial file was left";
}

// rho = 1e-4 and V(chi) = exp(-chi^2/w^2) with w = 0.05 leave no width: the centre of the lobe is singular.
TEST_F(Table, NamesTheNodeThatIsNotFinite) {
  std::string text = two_bands;
  text.replace(text.find("w = 2.0"), 7, "w = 0.05");
  const Material material = Material::parse(text, "narrow");
  Grid grid = small_grid();
  grid.theta_i = Axis::parse(AxisKind::theta_i, "0,80");
  grid.theta_s = Axis::parse(AxisKind::theta_s, "0,80");
  grid.phi_i = Axis::parse(AxisKind::phi_i, "0");
  const Engine engine(device_, Precision::float64, Precision::float32);
  GenerateOptions options;
  try {
    generate(engine, material, grid, folder_ / "t.h5", create_hdf5_writer, options);
    FAIL() << "a singular node was written";
  } catch (const BadInput& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("theta_i = 80, theta_s = 80, phi_i = 0, phi_s = 0 degrees"), std::string::npos)
        << message;
    EXPECT_NE(message.find("rho_surface = 0.45"), std::string::npos) << message;
    EXPECT_NE(message.find("w = 0.05"), std::string::npos) << message;
  }
  EXPECT_TRUE(fs::is_empty(folder_)) << "a file was left";
}

TEST(Slabs, CoverTheGridOnceAndInOrder) {
  const Grid grid = small_grid();
  for (const std::size_t most : {1u, 17u, 160u, 500u, 100000u}) {
    std::size_t next = 0;
    for (const Slab& slab : slabs(grid, most)) {
      const std::size_t begin =
          ((slab.theta_i.begin * grid.phi_i.size() + slab.phi_i.begin) * grid.theta_s.size() +
           slab.theta_s.begin) *
          grid.phi_s.size();
      EXPECT_EQ(begin, next) << most;
      EXPECT_LE(slab.nodes(), std::max<std::size_t>(most, grid.phi_s.size()));
      next += slab.nodes();
    }
    EXPECT_EQ(next, grid.directions());
  }
}

}  // namespace
}  // namespace brdftab
