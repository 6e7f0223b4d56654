#include "host/pictures/plot.hpp"

#include <algorithm>
#include <filesystem>

#include "host/base/numbers.hpp"
#include "host/base/partial_file.hpp"
#include "host/commands/command.hpp"
#include "host/commands/options/measurement_option.hpp"
#include "host/formats/read_measurement.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/pictures/drawing/picture_file.hpp"

namespace brdftab {
namespace {

struct Options {
  std::vector<std::string> subjects;
  std::string output;
  std::string kind = "inplane";
  std::string theta_i;
  std::string polarization;
  std::optional<double> wavelength_nm;
  std::string data;
  std::string channel;
  MeasurementOption reading;
  int width = 0;
  std::optional<std::string> device;
  bool force = false;
};

const PlotRow& row_of(const std::string& kind) {
  return *std::find_if(std::begin(plot_table), std::end(plot_table),
                       [&](const auto& row) { return row.name == kind; });
}

Measurement read_data(const std::string& file, const std::string& channel,
                      const MeasurementOptions& options) {
  const Measurement all = read_measurement(file, options);
  if (channel.empty() && all.channels.size() == 1) return all;
  const auto index = all.find_channel(channel);
  if (!index)
    throw BadInput("{}: has the channels {}: choose one by --channel", file, fmt::join(all.channels, ", "));
  Measurement one = all.channel(*index);
  // What was said of the file holds for its channels.
  one.notes = all.notes;
  one.warnings = all.warnings;
  return one;
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  const PlotRow& row = row_of(options.kind);
  drawing::PictureFile file(options.output, options.width, options.force);
  PlotOptions drawn;
  if (!options.theta_i.empty()) {
    const Axis axis = parse_axis_option(AxisKind::theta_i, options.theta_i);
    drawn.theta_i.emplace(axis.nodes().begin(), axis.nodes().end());
  }
  if (!options.polarization.empty()) drawn.polarization = light_named(options.polarization).front();
  drawn.wavelength_nm = options.wavelength_nm;
  std::vector<std::string> of_data = options.reading.given();
  if (!options.channel.empty()) of_data.emplace_back("--channel");
  if (options.data.empty() && !of_data.empty())
    throw BadInput("{}: is of --data, which is not given", of_data.front());
  std::vector<Subject> subjects;
  for (const auto& subject : options.subjects) subjects.push_back(Subject::open(subject));
  for (const Subject& subject : subjects) {
    const auto& bands = subject.material().bands();
    if (options.wavelength_nm && !subject.material().has_wavelengths())
      throw BadInput("--wavelength {}: {} has no bands", shortest(*options.wavelength_nm), subject.file());
    if (!options.wavelength_nm && bands.size() > 1)
      say(common, fmt::format("{}: drawn at {} nm, the first of {} bands; --wavelength chooses another",
                              subject.file(), shortest(*bands.front().wavelength_nm), bands.size()));
    if (subject.is_table())
      for (const auto& fault : subject.table().faults)
        say(common, fmt::format("{}: warning: {}", subject.file(), fault));
  }
  if (!options.data.empty()) {
    MeasurementOptions reading = options.reading.options();
    reading.light = {drawn_polarization(subjects, drawn)};
    drawn.data = read_data(options.data, options.channel, reading);
  }
  std::optional<Engine> engine;
  const auto engine_source = [&]() -> const Engine& {
    if (!engine) {
      const Device device = select_device(options.device);
      engine.emplace(device, Engine::widest(device), Precision::float32, common.watch);
    }
    return *engine;
  };
  const auto picture = plot(row, subjects, drawn, engine_source);
  if (drawn.data) {
    for (const auto& note : drawn.data->notes) say(common, fmt::format("{}: {}", options.data, note));
    for (const auto& warning : drawn.data->warnings)
      say(common, fmt::format("{}: warning: {}", options.data, warning));
  }
  file.write(picture);
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> plot_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  std::vector<std::string> kinds;
  std::string help = "Kind of picture";
  for (const PlotRow& row : plot_table) {
    kinds.emplace_back(row.name);
    help += fmt::format("; {}: {}", row.name, row.summary);
  }
  parser.add_option("MATERIAL_OR_TABLE", options->subjects, "Material files or tables")->required();
  parser.add_option("-o,--output", options->output, "Picture to write: .svg or .png")->required();
  parser.add_option("--kind", options->kind, help)->check(CLI::IsMember(kinds));
  parser.add_option("--theta-i", options->theta_i,
                    "Angles of incidence, degrees: start:stop:step or numbers with commas, at most 9");
  parser
      .add_option("--polarization", options->polarization,
                  "Of the light, and of --data as in fit; default: unpolarized, or what a table has")
      ->check(CLI::IsMember({"unpolarized", "s", "p"}));
  parser.add_option("--wavelength", options->wavelength_nm, "Band of a material with bands, nm");
  parser.add_option("--data", options->data,
                    "Measured BRDF, drawn as points in the plane of incidence; read as by fit");
  parser.add_option("--channel", options->channel, "Channel of --data");
  options->reading.add(parser);
  parser
      .add_option("--width", options->width,
                  "Width of a PNG in pixels; default: 2.5 for each unit of the SVG")
      ->check(CLI::Range(100, 20000));
  parser.add_flag("--force", options->force, "Overwrite an existing output");
  add_device_option(parser, options->device);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab
