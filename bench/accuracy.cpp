// Largest errors of the device's f, N and DHR against the scalar reference, over random materials from the
// whole valid ranges and their ends (half of them plausible fits), each at ten angles of incidence from 0
// to 89.9 degrees.
//
// usage: accuracy [MATERIALS [SEED]]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "host/base/error.hpp"
#include "host/base/parallel.hpp"
#include "host/commands/exit_status.hpp"
#include "host/compute/evaluate.hpp"
#include "host/compute/integrals.hpp"
#include "host/reference/model.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

constexpr double smallest_f = 1e-30;
constexpr double smallest_dhr = 1e-12;

struct Worst {
  const char* quantity;
  double error = 0;
  std::size_t compared = 0;
  std::string where;
  std::vector<double> all;

  void add(double value, double expected, double smallest, const std::string& at) {
    // An infinite value is refused by the program, which names the node.
    if (!(expected > smallest) || std::isinf(expected) || std::isinf(value)) return;
    const double relative = std::abs(value / expected - 1);
    ++compared;
    all.push_back(relative);
    if (!(relative <= error)) {
      error = relative;
      where = at;
    }
  }

  void print() {
    if (all.empty()) return;
    std::sort(all.begin(), all.end());
    fmt::print("{:<22} {:>8} compared  median {:.1e}  99 % {:.1e}  max {:.1e}  at {}\n", quantity, compared,
               all[all.size() / 2], all[all.size() * 99 / 100], error, where);
  }
};

struct Case {
  Parameters parameters;
  std::vector<double> theta;
  std::vector<DirectionPair> pairs;
  Integrals reference;
  std::vector<PolarizedBrdf> f;
};

std::vector<Case> draw(std::size_t count, unsigned seed) {
  RandomMaterials random(seed);
  std::vector<Case> cases(count);
  for (std::size_t k = 0; k < count; ++k) {
    cases[k].parameters = k % 2 ? random.plausible() : random.parameters();
    cases[k].theta = {0, 89.9};
    while (cases[k].theta.size() < 10) cases[k].theta.push_back(random.uniform(0, 89.9));
    // Angles that float holds, so that the float build sees the same directions.
    const auto exact = [](double angle) { return std::floor(angle * 64) / 64; };
    for (const double theta_i : cases[k].theta)
      for (int s = 0; s < 20; ++s)
        cases[k].pairs.push_back(
            {exact(theta_i), s == 0 ? exact(theta_i) : exact(random.theta()), exact(random.phi()), 0});
  }
  return cases;
}

// The reference is slow; all cores share it.
void fill_reference(std::vector<Case>& cases) {
  parallel_for(cases.size(), [&](std::size_t c) {
    const Band band{std::nullopt, cases[c].parameters};
    cases[c].reference = reference_integrals(band, {}, cases[c].theta);
    cases[c].f = evaluate_reference(band, {}, cases[c].pairs);
  });
}

void compare(const Engine& engine, const std::vector<Case>& cases) {
  const bool wide = engine.working() == Precision::float64;
  Worst n{wide ? "N, float64" : "N, float32"};
  Worst dhr{wide ? "DHR of a lobe, float64" : "DHR of a lobe, float32"};
  Worst f{wide ? "f, float64" : "f, float32"};
  std::size_t refused = 0;
  for (const Case& c : cases) {
    const Band band{std::nullopt, c.parameters};
    try {
      const Integrals at = integrals(engine, band, {}, c.theta);
      for (std::size_t lobe = 0; lobe < 3; ++lobe)
        for (std::size_t k = 0; k < c.theta.size(); ++k) {
          const std::string where =
              fmt::format("theta_i = {}, {} lobe of {}", c.theta[k], lobe_names[lobe], text_of(c.parameters));
          n.add(at.normalization.value[lobe][k], c.reference.normalization.value[lobe][k], 0, where);
          dhr.add(at.dhr.s[lobe][k], c.reference.dhr.s[lobe][k], smallest_dhr, where);
          dhr.add(at.dhr.p[lobe][k], c.reference.dhr.p[lobe][k], smallest_dhr, where);
        }
      const auto values = evaluate(engine, band, {}, c.pairs);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const auto& pair = c.pairs[k];
        const std::string where = fmt::format("theta_i = {}, theta_s = {}, phi = {} of {}", pair.theta_i,
                                              pair.theta_s, pair.phi, text_of(c.parameters));
        f.add(values[k].s, c.f[k].s, wide ? smallest_f : 1e-20, where);
        f.add(values[k].p, c.f[k].p, wide ? smallest_f : 1e-20, where);
      }
    } catch (const BadInput&) {
      ++refused;
    }
  }
  f.print();
  n.print();
  dhr.print();
  if (refused > 0)
    fmt::print("{} materials refused: N leaves the range of {}\n", refused, name_of(engine.working()));
}

}  // namespace
}  // namespace brdftab

int main(int argc, char** argv) {
  using namespace brdftab;
  const std::size_t materials = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1;
  try {
    const Device device = select_device(std::nullopt);
    fmt::print("{} materials, seed {}, on {}\n", materials, seed, device.description());
    auto cases = draw(materials, seed);
    fill_reference(cases);
    if (device.has_fp64) compare(Engine(device, Precision::float64, Precision::float32), cases);
    compare(Engine(device, Precision::float32, Precision::float32), cases);
  } catch (const Error& error) {
    fmt::print(stderr, "accuracy: {}\n", error.what());
    return static_cast<int>(exit_status(error.fault()));
  }
}
