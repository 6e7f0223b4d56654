#include "host/formats/rgl/rgl_design.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "host/base/angle.hpp"
#include "host/base/parallel.hpp"
#include "host/formats/export/export_reader.hpp"
#include "host/formats/rgl/rgl_ndf.hpp"

namespace brdftab {
namespace {

constexpr double last_theta_i = 89.9;
// f at this polar angle stands for its limit at the horizon, where the model ends.
constexpr double largest_theta = 89.99;
constexpr std::size_t ndf_nodes = 1024, sigma_nodes = 256;
constexpr float grey_wavelength_nm = 550;

// These were chosen by the error of f at random directions over the shipped materials. A share of the nodes
// is even over the hemisphere: at 64 x 64 x 64 nodes the 95th percentile of the error is 6 to 20 % without
// it, 3 to 5 % with as many as the light's own, and hardly less with twice as many. More of them lie above
// the horizon, which halves the error for cos(theta_o) < 0.05. More lie about the mirror direction, as 1 /
// theta of the half vector, so that s grows with theta there and not with its square: at 0.03 radians from it
// the median error falls from 0.2 to 1 % to 0.1 to 0.3 %. The light's density is blurred to what the nodes of
// s can follow, which takes the error of a retro-reflecting lobe narrower than that from 9 to 5 %.
constexpr double even_share = 1;
constexpr double horizon_share = 2, horizon_height = 0.03;  // the height a cosine
constexpr double mirror_share = 20, nearest_mirror = 0.1;   // degrees
constexpr double blur_width = 0.8;                          // nodes of s
// No cell has less than this share of the average density, so that every place has one s and float32 can tell
// them apart.
constexpr double smallest_density = 1e-4;

double place_of(std::size_t node, std::size_t nodes) {
  return static_cast<double>(node) / static_cast<double>(nodes - 1);
}

/// Pairs of a viewer and the light that a half vector mirrors to it.
struct MirroredPairs {
  explicit MirroredPairs(const SurfaceVector& seen_from = {0, 0, 1}) : viewer(seen_from) {}

  SurfaceVector viewer;
  Directions directions;
  std::vector<double> cosine;   // of the viewer and the half vector
  std::vector<double> light_z;  // below 0: the pair stands for its mirror image above the horizon
  std::vector<SquarePoint> place;

  void add(SquarePoint half_vector_place) {
    place.push_back(half_vector_place);
    const SurfaceVector half = RglPlace::direction(half_vector_place);
    cosine.push_back(viewer.dot(half));
    const SurfaceVector light = half * (2 * cosine.back()) + viewer * -1;
    light_z.push_back(light.z);
    brdftab::add(directions, {light.x, light.y, std::abs(light.z)}, viewer);
    for (double* theta : {&directions.theta_i.back(), &directions.theta_s.back()})
      *theta = std::min(*theta, largest_theta);
  }

  bool lit(std::size_t k) const { return cosine[k] > 0 && light_z[k] > 0; }
};

using Bands = std::vector<std::vector<double>>;  // [band][pair]

std::vector<float> two_rows(const std::vector<double>& row) {
  std::vector<float> values(row.begin(), row.end());
  values.insert(values.end(), row.begin(), row.end());
  return values;
}

/// Blurs rows of values, each of them `count` values `stride` apart, by a Gaussian of `width` values. The
/// rows are taken as even about the first value, and about the last.
std::vector<double> blurred(const std::vector<double>& values, std::size_t count, std::size_t stride,
                            double width) {
  const auto reach = std::min(static_cast<std::size_t>(std::ceil(3 * width)), count - 1);
  std::vector<double> weights;
  for (std::size_t k = 0; k <= reach; ++k)
    weights.push_back(std::exp(-0.5 * std::pow(static_cast<double>(k) / width, 2)));
  std::vector<double> result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t at = k / stride % count, first = k - at * stride;
    double sum = weights[0] * values[k];
    for (std::size_t j = 1; j <= reach; ++j) {
      const std::size_t below = at >= j ? at - j : j - at, above = std::min(at + j, 2 * (count - 1) - at - j);
      sum += weights[j] * (values[first + below * stride] + values[first + above * stride]);
    }
    result[k] = sum;
  }
  return result;
}

class Designer {
 public:
  Designer(const ExportModel& source, const RglResolution& resolution, RglChannels channels)
      : source_(source), rgb_(channels == RglChannels::rgb) {
    content_.samples = resolution.samples;
    content_.vndf_rows = resolution.warp_phi;
    content_.vndf_columns = resolution.warp_theta;
    for (std::size_t i = 0; i < resolution.theta_i; ++i)
      content_.theta_i.push_back(
          static_cast<float>(last_theta_i / degrees_per_radian * place_of(i, resolution.theta_i)));
    if (!rgb_)
      for (const double wavelength : source_.wavelengths_nm())
        content_.wavelengths_nm.push_back(static_cast<float>(wavelength));
    if (!rgb_ && content_.wavelengths_nm.empty()) content_.wavelengths_nm.push_back(grey_wavelength_nm);
    content_.channels = rgb_ ? 3 : content_.wavelengths_nm.size();
  }

  Designer(const ExportModel& source, RglContent layout)
      : source_(source), rgb_(layout.wavelengths_nm.empty()) {
    if (!rgb_) check_channels(layout.channels, source.bands());
    content_ = std::move(layout);
  }

  RglDesign resampled() {
    sample();
    return std::move(result_);
  }

  RglDesign design() {
    const auto density = half_vector_density(source_, ndf_nodes);
    content_.ndf = two_rows(density);
    content_.sigma = two_rows(projected_area(density, sigma_nodes));
    lay_out_vndf();
    sample();
    result_.negative_colours = negative_colours_;
    return std::move(result_);
  }

 private:
  std::size_t angles() const { return content_.theta_i.size(); }
  SurfaceVector viewer(std::size_t i) const {
    return SurfaceVector::from_degrees(degrees(content_.theta_i[i]), 0);
  }

  /// Calls `pairs_of` for every theta_i, and then `use` with f at its pairs.
  void for_theta_i(const std::function<MirroredPairs(std::size_t)>& pairs_of,
                   const std::function<void(std::size_t, const MirroredPairs&, const Bands&)>& use) const {
    constexpr std::size_t at_once = 8;
    for (std::size_t begin = 0; begin < angles(); begin += at_once) {
      std::vector<MirroredPairs> pairs(std::min(at_once, angles() - begin));
      parallel_for(pairs.size(), [&](std::size_t k) { pairs[k] = pairs_of(begin + k); });
      Directions all;
      for (const auto& some : pairs)
        for (const auto angle : {&Directions::theta_i, &Directions::theta_s, &Directions::phi})
          (all.*angle)
              .insert((all.*angle).end(), (some.directions.*angle).begin(), (some.directions.*angle).end());
      const Bands f = source_.evaluate(all);
      parallel_for(pairs.size(), [&](std::size_t k) {
        const auto count = static_cast<std::ptrdiff_t>(pairs[k].place.size()),
                   first = static_cast<std::ptrdiff_t>(k) * count;
        Bands part;
        for (const auto& band : f) part.emplace_back(band.begin() + first, band.begin() + first + count);
        use(begin + k, pairs[k], part);
      });
    }
  }

  /// Gives the density of half vectors by solid angle, in rows over half the azimuth: the other half is its
  /// mirror image.
  std::vector<double> light_density(const MirroredPairs& pairs, const std::vector<double>& f) const {
    const std::size_t columns = content_.vndf_columns, rows = f.size() / columns;
    std::vector<double> lit(f.size()), light(f.size());
    for (std::size_t k = 0; k < f.size(); ++k)
      if (pairs.lit(k)) {
        lit[k] = 1;
        light[k] = f[k];
      }
    const auto blur = [&](const std::vector<double>& values) {
      const double width = blur_width / static_cast<double>(content_.samples);
      return blurred(blurred(values, rows, columns, width * static_cast<double>(content_.vndf_rows)), columns,
                     1, width * static_cast<double>(columns));
    };
    light = blur(light);
    const auto share = blur(lit);
    double sum = 0, weight = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      if (lit[k] == 0) continue;
      light[k] /= share[k];
      const double solid_angle = pairs.cosine[k] * RglPlace::solid_angle(pairs.place[k].x);
      sum += light[k] * solid_angle;
      weight += solid_angle;
    }
    std::vector<double> density(f.size(), smallest_density);
    for (std::size_t k = 0; k < f.size(); ++k) {
      if (lit[k] == 0) continue;
      // The last node above the horizon stands for the part of its cell that lies above it.
      const double next = (k + 1) % columns != 0 ? pairs.light_z[k + 1] : 0;
      const double above = next < 0 ? pairs.light_z[k] / (pairs.light_z[k] - next) : 1;
      const double even = even_share * (1 + horizon_share * std::exp(-pairs.light_z[k] / horizon_height) +
                                        mirror_share / (nearest_mirror + RglPlace::theta(pairs.place[k].x)));
      density[k] += 4 * pairs.cosine[k] * above * (even + (sum > 0 ? light[k] * weight / sum : 0));
    }
    return density;
  }

  void lay_out_vndf() {
    const std::size_t rows = content_.vndf_rows, columns = content_.vndf_columns;
    content_.vndf.resize(angles() * rows * columns);
    const auto pairs_of = [&](std::size_t i) {
      MirroredPairs pairs(viewer(i));
      for (std::size_t k = 0; k < (rows / 2 + 1) * columns; ++k)
        pairs.add({place_of(k % columns, columns), place_of(k / columns, rows)});
      return pairs;
    };
    for_theta_i(pairs_of, [&](std::size_t i, const MirroredPairs& pairs, const Bands& by_band) {
      const auto density = light_density(pairs, mean_of_bands(by_band));
      for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c)
          content_.vndf[(i * rows + r) * columns + c] = static_cast<float>(
              density[std::min(r, rows - 1 - r) * columns + c] * RglPlace::solid_angle(place_of(c, columns)));
    });
  }

  void sample() {
    const std::size_t n = content_.samples;
    content_.luminance.resize(angles() * n * n);
    content_.spectra.resize(angles() * content_.channels * n * n);
    result_.scale.resize(angles() * n * n);
    const AdaptiveWarp warp = content_.vndf_warp();
    const auto pairs_of = [&](std::size_t i) {
      MirroredPairs pairs(viewer(i));
      for (std::size_t k = 0; k < (n + 1) / 2 * n; ++k)
        pairs.add(warp.sample(i, {place_of(k % n, n), place_of(k / n, n)}).point);
      return pairs;
    };
    for_theta_i(pairs_of, [&](std::size_t i, const MirroredPairs& pairs, const Bands& by_band) {
      sample_luminance(i, pairs, mean_of_bands(by_band), warp);
      sample_spectra(i, pairs, rgb_ ? source_.rgb(by_band) : by_band);
    });
  }

  /// Gives the pair of a node of s: the azimuth's second half is the mirror image of its first.
  std::size_t pair_of(std::size_t k) const {
    const std::size_t n = content_.samples;
    return std::min(k / n, n - 1 - k / n) * n + k % n;
  }

  /// The density of s is what f cos(theta_o) leaves to follow beside the density of the half vector.
  void sample_luminance(std::size_t i, const MirroredPairs& pairs, const std::vector<double>& f,
                        const AdaptiveWarp& warp) {
    // Along the normal both densities are 0, and their ratio is that nearby.
    const double nearest = 0.5 / static_cast<double>(content_.vndf_columns);
    std::vector<double> luminance(f.size());
    double mean = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      if (!pairs.lit(k)) continue;
      const SquarePoint place{std::max(pairs.place[k].x, nearest), pairs.place[k].y};
      luminance[k] = f[k] * pairs.light_z[k] * 4 * pairs.cosine[k] * RglPlace::solid_angle(place.x) /
                     warp.density(i, place);
      mean += luminance[k] / static_cast<double>(f.size());
    }
    const std::size_t square = content_.samples * content_.samples;
    for (std::size_t k = 0; k < square; ++k)
      content_.luminance[i * square + k] =
          static_cast<float>(mean > 0 ? luminance[pair_of(k)] / mean + smallest_density : 1);
  }

  void sample_spectra(std::size_t i, const MirroredPairs& pairs, const Bands& by_channel) {
    const SquareTable ndf = content_.ndf_table();
    const double area = content_.sigma_table().at(0, {RglPlace::of_theta(degrees(content_.theta_i[i])), 0.5});
    const std::size_t square = content_.samples * content_.samples;
    for (std::size_t k = 0; k < square; ++k) {
      const std::size_t pair = pair_of(k);
      const double scale = std::max(pairs.light_z[pair], 0.0) * 4 * area / ndf.at(0, pairs.place[pair]);
      result_.scale[i * square + k] = scale;
      for (std::size_t c = 0; c < by_channel.size(); ++c) {
        if (by_channel[c][pair] < 0) ++negative_colours_;
        content_.spectra[(i * by_channel.size() + c) * square + k] =
            static_cast<float>(std::max(by_channel[c][pair], 0.0) * scale);
      }
    }
  }

  const ExportModel& source_;
  bool rgb_;
  RglDesign result_;
  RglContent& content_ = result_.content;
  std::atomic<std::size_t> negative_colours_ = 0;
};

}  // namespace

RglDesign design_rgl(const ExportModel& source, const RglResolution& resolution, RglChannels channels) {
  return Designer(source, resolution, channels).design();
}

RglDesign resampled_rgl(const ExportModel& source, RglContent layout) {
  return Designer(source, std::move(layout)).resampled();
}

}  // namespace brdftab
