// Rung 4 for tables that are not stored plainly: compressed, of fewer mantissa bits, or shown as a view.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/base/error.hpp"
#include "host/compute/rounding.hpp"
#include "host/formats/hdf5/hdf5_handle.hpp"
#include "host/formats/hdf5/hdf5_reader.hpp"
#include "host/formats/hdf5/hdf5_writer.hpp"
#include "host/model/relative_azimuth.hpp"
#include "host/table/chunk.hpp"
#include "host/table/generate.hpp"
#include "host/table/table_reader.hpp"
#include "host/table/table_writer.hpp"
#include "tests/table/two_bands.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

Grid grid_of(const char* theta_i, const char* phi_i, const char* theta_s, const char* phi_s) {
  return {Axis::parse(AxisKind::theta_i, theta_i), Axis::parse(AxisKind::phi_i, phi_i),
          Axis::parse(AxisKind::theta_s, theta_s), Axis::parse(AxisKind::phi_s, phi_s)};
}

class Storage : public testing::Test {
 protected:
  void SetUp() override {
    if (!device_.has_fp64) GTEST_SKIP() << "the device has no fp64";
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  GenerateSummary make(const std::string& name, const Grid& grid, const TableStorage& storage,
                       Precision precision = Precision::float32, std::size_t slab_bytes = 32 << 20) {
    GenerateOptions options;
    options.force = true;
    options.storage = storage;
    options.slab_bytes = slab_bytes;
    options.polarizations = {Polarization::unpolarized, Polarization::s};
    static const Engine narrow(device_, Precision::float64, Precision::float32);
    static const Engine wide(device_, Precision::float64, Precision::float64);
    return generate(precision == Precision::float64 ? wide : narrow, material_, grid, folder_ / name,
                    create_hdf5_writer, options);
  }

  // Returns every sample of both datasets as it is stored.
  std::vector<std::byte> samples(const std::string& name, Precision precision) {
    const Hdf5Handle file(H5Fopen((folder_ / name).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), name);
    std::vector<std::byte> all;
    for (const char* const brdf : {"brdf", "brdf_s"}) {
      const Hdf5Handle dataset(H5Dopen2(file, brdf, H5P_DEFAULT), brdf);
      const Hdf5Handle space(H5Dget_space(dataset), brdf);
      const std::size_t before = all.size();
      all.resize(before +
                 static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * bytes_of(precision));
      hdf5_check(H5Dread(dataset, precision == Precision::float64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT,
                         H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data() + before),
                 brdf);
    }
    return all;
  }

  std::vector<char> file_bytes(const std::string& name) {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  StorageInfo stored(const std::string& name, const std::string& variable) {
    return open_hdf5_reader(folder_ / name)->info().variable(variable)->storage.value();
  }

  const Device device_ = select_device(std::nullopt);
  const Material material_ = Material::parse(two_bands, "two bands");
  const fs::path folder_ = fs::temp_directory_path() / fmt::format("brdftab-storage-test-{}", getpid());
};

// Chunks of several theta_i, of several phi_i, of one hemisphere, and of rows; most with an end to be padded.
const Grid chunked_grids[] = {
    grid_of("0:84:7", "0,45,100", "0:88:11", "0:360:1"),
    grid_of("30", "0:40:1", "0:88:8", "0:360:0.5"),
    grid_of("30", "0,1,2", "0:89:1", "0:360:0.25"),
    grid_of("30", "0,100", "0:88:8", "0:360:0.015625"),
};

TEST_F(Storage, CompressedSamplesAreTheContiguousOnes) {
  const std::vector<std::size_t> shapes[] = {
      {1, 5, 3, 9, 361}, {1, 1, 7, 12, 721}, {1, 1, 1, 90, 1441}, {1, 1, 1, 6, 23041}};
  for (std::size_t k = 0; k < std::size(chunked_grids); ++k) {
    make("plain.h5", chunked_grids[k], {});
    make("small.h5", chunked_grids[k], {.deflate_level = 1});
    EXPECT_EQ(stored("small.h5", "brdf").chunk, shapes[k]);
    EXPECT_EQ(stored("small.h5", "brdf").filters, (std::vector<std::string>{"shuffle", "deflate 1"}));
    EXPECT_TRUE(samples("small.h5", Precision::float32) == samples("plain.h5", Precision::float32))
        << "grid " << k;
    EXPECT_GT(stored("small.h5", "brdf").ratio, 1.1) << "grid " << k;
  }
  make("plain.h5", chunked_grids[0], {}, Precision::float64);
  for (const int level : {1, 6, 12}) {
    make("small.h5", chunked_grids[0], {.deflate_level = level}, Precision::float64);
    EXPECT_TRUE(samples("small.h5", Precision::float64) == samples("plain.h5", Precision::float64))
        << "level " << level;
  }
}

TEST_F(Storage, TheFileDoesNotDependOnTheSlabs) {
  for (const Grid& grid : chunked_grids)
    for (const Layout layout : {Layout::contiguous, Layout::virtual_view}) {
      const TableStorage storage{.deflate_level = 1, .keep_bits = 12, .layout = layout};
      make("one.h5", grid, storage);
      const auto expected = file_bytes("one.h5");
      for (const std::size_t slab_bytes : {std::size_t{1}, std::size_t{300'000}, std::size_t{2'000'000}}) {
        make("other.h5", grid, storage, Precision::float32, slab_bytes);
        EXPECT_TRUE(file_bytes("other.h5") == expected) << "slabs of " << slab_bytes << " bytes";
      }
    }
}

TEST(Chunks, HoldWholeHemispheresOrRowsOfModestSize) {
  for (const char* const phi_i : {"0", "0:355:5", "0:359.5:0.5"})
    for (const char* const theta_s : {"0", "0:89:1", "0:89.9:0.1"})
      for (const char* const phi_s : {"0", "0:360:5", "0:360:0.5", "0:360:0.005"})
        for (const std::size_t node_bytes : {4u, 8u}) {
          const Grid grid = grid_of("0:80:20", phi_i, theta_s, phi_s);
          const Chunk chunk = chunk_shape(grid, node_bytes);
          const std::size_t bytes =
              chunk.theta_i * chunk.phi_i * chunk.theta_s * grid.phi_s.size() * node_bytes;
          EXPECT_LE(bytes, 1u << 20);
          EXPECT_GE(bytes, std::min<std::size_t>(64 << 10, grid.directions() * node_bytes));
          EXPECT_TRUE(chunk.theta_s == grid.theta_s.size() || (chunk.phi_i == 1 && chunk.theta_i == 1));
          EXPECT_TRUE(chunk.phi_i == grid.phi_i.size() || chunk.theta_i == 1);
          std::size_t odd = 0;
          for (const Slab& slab : slabs(grid, 3'000'000, chunk)) {
            odd += slab.theta_i.begin % chunk.theta_i + slab.phi_i.begin % chunk.phi_i +
                   slab.theta_s.begin % chunk.theta_s;
            odd += slab.nodes() > 3'000'000;
          }
          EXPECT_EQ(odd, 0u);
        }
}

TEST_F(Storage, RoundedSamplesKeepTheirBound) {
  const Grid grid = grid_of("0:80:16", "0,45,100", "0:88:11", "0:360:24");
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    make("plain.h5", grid, {}, precision);
    const auto exact = samples("plain.h5", precision);
    for (const int keep_bits : {1, 2, 12, 22, mantissa_bits(precision)}) {
      const auto summary = make("rounded.h5", grid, {.keep_bits = keep_bits}, precision);
      const auto rounded = samples("rounded.h5", precision);
      double largest = 0;
      const auto compare = [&]<class Real, class Bits>(Real, Bits) {
        for (std::size_t at = 0; at < exact.size(); at += sizeof(Real)) {
          Real before, after;
          std::memcpy(&before, &exact[at], sizeof before);
          std::memcpy(&after, &rounded[at], sizeof after);
          // The floating-point unit rounds an integer to the nearest, ties to even; it serves as the truth
          // here.
          int exponent;
          const double mantissa = std::frexp(static_cast<double>(before), &exponent);
          EXPECT_EQ(
              static_cast<double>(after),
              std::ldexp(std::nearbyint(std::ldexp(mantissa, keep_bits + 1)), exponent - keep_bits - 1));
          largest = std::max(largest, std::abs(static_cast<double>(after) / static_cast<double>(before) - 1));
        }
      };
      precision == Precision::float64 ? compare(double{}, std::uint64_t{})
                                      : compare(float{}, std::uint32_t{});
      EXPECT_LE(largest, rounding_error(keep_bits));
      if (keep_bits == mantissa_bits(precision)) {
        EXPECT_EQ(largest, 0);
      }
      if (keep_bits <= 12) {
        EXPECT_GT(largest, 0.5 * rounding_error(keep_bits));
        EXPECT_GT(summary.findings.accuracy.max_relative_error, 0.1 * rounding_error(keep_bits))
            << "accuracy is of other samples";
      }
      EXPECT_LE(summary.findings.accuracy.max_relative_error, rounding_error(keep_bits) + 1e-6);
    }
  }
}

TEST_F(Storage, RoundingLeavesWhatHasNoBound) {
  const Engine engine(device_, Precision::float64, Precision::float32);
  const float kept[] = {
      0.0f,     1e-40f, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(),
      INFINITY, NAN};
  const float moved[] = {1.25f, 1.75f, 1.2500001f, 3.3e38f};
  const float expected[] = {1.0f, 2.0f, 1.5f, 2.5521178e38f};
  std::vector<float> values(std::begin(kept), std::end(kept));
  values.insert(values.end(), std::begin(moved), std::end(moved));
  const cl::Buffer buffer = engine.buffer(values.size() * sizeof(float));
  engine.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(float), values.data());
  round_mantissas(engine, {{0, 1}, {0, 1}, {0, 2}, values.size() / 2}, buffer, 1);
  engine.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, values.size() * sizeof(float), values.data());
  EXPECT_EQ(std::memcmp(values.data(), kept, sizeof kept), 0);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(values[std::size(kept) + k], expected[k]) << moved[k];
  EXPECT_EQ(values.back(), 3.3e38f) << "would round to infinity";
}

TEST_F(Storage, ViewsShowTheContiguousSamples) {
  const Grid grids[] = {
      grid_of("0,30", "0:355:5", "0:80:20", "0:360:5"),      // closed, one step
      grid_of("0,30", "0:355:5", "0:80:20", "0:355:5"),      // half open
      grid_of("0,30", "-180:180:2", "0:80:20", "-360:0:5"),  // strided
      grid_of("0,30", "0:90:2.5", "0:80:20", "10:190:7.5"),  // not all round
      grid_of("0,30", "0,90,180", "0:80:20",
              "0,1,7,90,91,97,180,181,187,270,271,277"),  // uneven, but the same from each phi_i
      grid_of("0,30", "7.3", "0:80:20", "0:360:0.1"),     // one phi_i
  };
  for (const Grid& grid : grids)
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      make("plain.h5", grid, {}, precision);
      const auto summary = make("view.h5", grid, {.layout = Layout::virtual_view}, precision);
      fs::rename(folder_ / "view.h5", folder_ / "renamed.h5");
      EXPECT_TRUE(samples("renamed.h5", precision) == samples("plain.h5", precision));
      EXPECT_EQ(stored("renamed.h5", "brdf").view_of, "brdf_relative");
      EXPECT_EQ(summary.samples, 2 * 2 * grid.directions());
    }
  make("plain.h5", grids[0], {});
  make("view.h5", grids[0], {.layout = Layout::virtual_view});
  EXPECT_LT(40 * stored("view.h5", "brdf_relative").bytes, stored("plain.h5", "brdf").bytes);
}

TEST(RelativeAzimuth, CoversEachRowInAtMostTwoPieces) {
  const Grid grid = grid_of("0", "0:355:5", "0", "0:360:5");
  const auto relative = relative_azimuth(grid.phi_i, grid.phi_s);
  ASSERT_EQ(relative.phi.size(), 72u);
  EXPECT_EQ(relative.phi[0], -175);
  EXPECT_EQ(relative.phi[71], 180);
  std::vector<int> seen(72 * 73);
  for (const auto& piece : relative.pieces)
    for (std::size_t k = 0; k < piece.count; ++k) {
      ++seen[piece.phi_i * 73 + piece.phi_s + k];
      const double difference = grid.phi_s[piece.phi_s + k] - grid.phi_i[piece.phi_i];
      EXPECT_EQ(std::remainder(relative.phi[piece.phi + k * piece.step] - difference, 360), 0);
    }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 72 * 73);
  EXPECT_LE(relative.pieces.size(), 2u * 72);
}

TEST(RelativeAzimuth, RefusesWhatIsNoView) {
  for (const auto& [phi_i, phi_s] : {std::pair{"0,10", "0:360:0.1"},
                                     {"0,7,19,60", "0,1,3,10,30,90,91,97,115,118,203"},
                                     {"0:359:1", "0:360:0.01"}}) {
    const Grid grid = grid_of("0", phi_i, "0", phi_s);
    try {
      relative_azimuth(grid.phi_i, grid.phi_s);
      FAIL() << phi_i << " and " << phi_s << " were taken";
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("--layout virtual: phi_s - phi_i takes"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace brdftab
