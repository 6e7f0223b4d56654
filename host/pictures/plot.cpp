#include "host/pictures/plot.hpp"

#include <algorithm>
#include <filesystem>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab {
namespace {

constexpr std::size_t most_subjects = 4;
constexpr std::size_t most_incidences = 9;

}  // namespace

std::string plot(const PlotRow& row, std::span<const Subject> subjects, const PlotOptions& options,
                 const LazyEngine& engine) {
  if (row.plot == compare_plot && subjects.size() != 2)
    throw BadInput(GivenValue{"kind", row.name}, "takes two tables or materials, not {}", subjects.size());
  if (subjects.size() > most_subjects)
    throw BadInput(GivenValue{"kind", row.name}, "takes at most {} tables or materials, not {}",
                   most_subjects, subjects.size());
  if (options.theta_i && options.theta_i->size() > most_incidences)
    throw BadInput("`theta_i`: {} angles; a picture shows at most {}", options.theta_i->size(),
                   most_incidences);
  if (options.theta_i && row.plot == dhr_plot) throw BadInput("`theta_i`: DHR is drawn against all theta_i");
  if (options.polarization && (row.plot == dhr_plot || row.plot == shadowing_plot))
    throw BadInput("`polarization`: {}",
                   row.plot == dhr_plot ? "DHR is drawn for every one" : "shadowing does not depend on it");
  if (options.data && row.plot != in_plane_plot && row.plot != polar_plot)
    throw BadInput("`data`: is shown by `kind` inplane and polar, not by {}", row.name);
  if (options.data && subjects.size() != 1)
    throw BadInput("`data`: is shown on one material or table, not on {}", subjects.size());
  return row.plot(subjects, options, engine);
}

Polarization drawn_polarization(std::span<const Subject> subjects, const PlotOptions& options) {
  std::vector<Polarization> wanted{Polarization::unpolarized, Polarization::s, Polarization::p};
  if (options.polarization) wanted = {*options.polarization};
  for (const Polarization polarization : wanted) {
    const auto lacks = [&](const Subject& subject) {
      if (!subject.is_table()) return false;
      const auto& held = subject.table().polarizations;
      return std::find(held.begin(), held.end(), polarization) == held.end();
    };
    const auto at = std::find_if(subjects.begin(), subjects.end(), lacks);
    if (at == subjects.end()) return polarization;
    if (options.polarization)
      throw BadInput(
          GivenValue{"polarization", std::string(polarization_names[static_cast<std::size_t>(polarization)])},
          "{} does not hold it", at->file());
  }
  throw BadInput("the tables have no polarisation in common");
}

std::vector<std::string> subject_labels(std::span<const Subject> subjects) {
  std::vector<std::string> labels;
  const auto is_only_one = [&](auto property) {
    return [&subjects, property](const Subject& subject) {
      return std::count_if(subjects.begin(), subjects.end(),
                           [&](const Subject& other) { return property(other) == property(subject); }) == 1;
    };
  };
  const auto file_name = [](const Subject& subject) {
    return std::filesystem::path(subject.file()).filename().string();
  };
  const auto only_name = is_only_one([](const Subject& subject) { return subject.name(); });
  const auto only_file_name = is_only_one(file_name);
  for (const Subject& subject : subjects)
    labels.push_back(drawing::literal(excerpt(
        only_name(subject) ? subject.name()
                           : fmt::format("{} ({})", subject.name(),
                                         only_file_name(subject) ? file_name(subject) : subject.file()),
        70)));
  return labels;
}

std::string picture_title(std::span<const Subject> subjects, std::string_view title) {
  return subjects.size() == 1
             ? fmt::format("{}: {}", drawing::literal(excerpt(subjects[0].name(), 60)), title)
             : std::string(title);
}

std::string light_text(const Subject& subject, const PlotOptions& options,
                       std::optional<Polarization> polarization) {
  std::string text;
  if (polarization) text = fmt::format("{} light", light_word(share_s(*polarization)));
  if (subject.material().has_wavelengths())
    text +=
        fmt::format("{}{} nm", text.empty() ? "" : ", ",
                    shortest(*subject.material().bands()[subject.band(options.wavelength_nm)].wavelength_nm));
  return text;
}

}  // namespace brdftab
