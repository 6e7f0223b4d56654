#include "host/table/generate.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "host/base/numbers.hpp"
#include "host/commands/command.hpp"
#include "host/commands/export_option.hpp"
#include "host/commands/interpolation_option.hpp"
#include "host/commands/outputs.hpp"
#include "host/compute/rounding.hpp"
#include "host/formats/exr/exr_writer.hpp"
#include "host/formats/hdf5/hdf5_writer.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> materials;
  std::string output;
  std::string format;
  std::optional<std::string> axes[4];
  std::string polarization = "unpolarized";
  std::string precision = "float32";
  std::optional<std::string> compress;
  std::optional<int> keep_bits;
  std::string layout = "contiguous";
  std::optional<std::string> device;
  std::optional<std::string> exr_layout;
  std::optional<std::string> exr_compression;
  InterpolationOption interpolation;
  ExportOption exported;
  bool force = false;
};

std::unique_ptr<TableWriter> create_hdf5(const fs::path& file, const TableContent& content, const Options&) {
  return create_hdf5_writer(file, content);
}

std::unique_ptr<TableWriter> create_exr(const fs::path& file, const TableContent& content,
                                        const Options& options) {
  ExrOptions exr;
  for (std::size_t k = 0; k < exr_layout_names.size(); ++k)
    if (options.exr_layout == exr_layout_names[k]) exr.layout = static_cast<ExrLayout>(k);
  if (options.exr_compression == "zip") exr.compression = ExrCompression::zip;
  return create_exr_writer(file, content, exr);
}

/// A format that generate writes: dense tables from slabs, or a simulator's file.
struct FormatRow {
  std::string_view name;
  std::vector<std::string_view> extensions;
  std::string_view suffix;  // of a file in a folder
  std::unique_ptr<TableWriter> (*create)(const fs::path&, const TableContent&, const Options&) = nullptr;
  const ExportFormat* exported = nullptr;
};

std::vector<FormatRow> format_table(const ExportFormats& exported) {
  std::vector<FormatRow> table{{"hdf5", {".h5", ".hdf5", ".nc"}, ".h5", create_hdf5},
                               {"exr", {".exr"}, ".exr", create_exr}};
  for (const auto& format : exported)
    table.push_back(
        {format->traits().name, format->traits().extensions, format->traits().suffix, nullptr, format.get()});
  return table;
}

std::string known_formats(const std::vector<FormatRow>& table) {
  std::vector<std::string> rows;
  for (const auto& row : table)
    rows.push_back(row.extensions.empty()
                       ? std::string(row.name)
                       : fmt::format("{} ({})", row.name, fmt::join(row.extensions, ", ")));
  return fmt::format("{}", fmt::join(rows, "; "));
}

const FormatRow& find_format(const std::vector<FormatRow>& table, const Options& options, bool folder) {
  const auto named = [&](std::string_view name) {
    return std::find_if(table.begin(), table.end(), [&](const FormatRow& row) { return row.name == name; });
  };
  if (!options.format.empty()) {
    const auto row = named(options.format);
    if (row == table.end())
      throw BadInput("--format {}: unknown; there is {}", excerpt(options.format), known_formats(table));
    return *row;
  }
  if (folder) return *named(options.exr_layout ? "exr" : "hdf5");
  const std::string extension = fs::path(options.output).extension().string();
  for (const auto& row : table)
    if (std::find(row.extensions.begin(), row.extensions.end(), extension) != row.extensions.end())
      return row;
  if (options.exr_layout == "files") return *named("exr");  // a folder's name needs no extension
  throw BadInput("-o {}: the extension names no format; --format has {}", excerpt(options.output),
                 known_formats(table));
}

std::vector<Polarization> polarizations(const std::string& name) {
  if (name == "s") return {Polarization::s};
  if (name == "p") return {Polarization::p};
  if (name == "all") return {Polarization::unpolarized, Polarization::s, Polarization::p};
  return {Polarization::unpolarized};
}

Grid grid_for(const Material& material, const Options& options) {
  Grid grid = material.grid();
  for (const auto& row : axis_table)
    if (const auto& text = options.axes[static_cast<std::size_t>(row.kind)])
      grid[row.kind] = parse_axis_option(row.kind, *text);
  return grid;
}

std::string history(const CommonOptions& common) {
  // A fixed epoch, as reproducible builds set it, makes the same table byte for byte.
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = parse_number(epoch ? epoch : "0");
  if (!seconds || !(*seconds >= 0 && *seconds <= 253402300799.0))
    throw BadInput("SOURCE_DATE_EPOCH={}: must be seconds since 1970, before the year 10000", excerpt(epoch));
  const std::time_t now = epoch ? static_cast<std::time_t>(*seconds) : std::time(nullptr);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ} {}", fmt::gmtime(now), common.command_line);
}

// How a table that is not plain came out.
std::string size_text(const TableStorage& storage, const Grid& grid, Precision precision,
                      const GenerateSummary& summary) {
  const std::string notes = storage_text(storage, grid, precision);
  if (notes.empty()) return {};
  return fmt::format(" as {:.3g} MB (ratio {:.2f}: {})", static_cast<double>(summary.file_bytes) / 1e6,
                     static_cast<double>(summary.bytes) / static_cast<double>(summary.file_bytes), notes);
}

ExitStatus export_materials(const Options& options, const ExportFormat& format,
                            const std::vector<MaterialOutput>& outputs, const CommonOptions& common) {
  // What a material can be refused for is refused before the first file is begun.
  std::vector<Grid> grids;
  std::vector<Material> materials;
  for (const MaterialOutput& output : outputs) {
    grids.push_back(grid_for(output.material, options));
    materials.push_back(options.exported.material_for(format, output, grids.back()));
  }
  const Device device = select_device(options.device);
  const Engine engine(device, Engine::widest(device), Precision::float32, common.watch);
  for (std::size_t k = 0; k < outputs.size(); ++k)
    options.exported.write(engine, format, materials[k], grids[k], outputs[k].target, history(common),
                           options.force, common);
  return ExitStatus::done;
}

ExitStatus run(const Options& options, const CLI::App& parser, const CommonOptions& common) {
  TableStorage storage;
  if (options.compress) storage.deflate_level = parse_compression(*options.compress);
  const Precision precision = options.precision == "float64" ? Precision::float64 : Precision::float32;
  if (options.keep_bits) check_keep_bits(*options.keep_bits, precision);
  storage.keep_bits = options.keep_bits;
  if (options.layout == "virtual") storage.layout = Layout::virtual_view;
  options.interpolation.check();
  const auto formats = format_table(options.exported.formats());
  const FormatRow& format = find_format(formats, options, names_folder(options.materials, options.output));
  options.exported.check(parser, format.exported);
  if (format.name != "exr" && (options.exr_layout || options.exr_compression))
    throw BadInput("--exr-layout and --exr-compression are for OpenEXR; the table is {}", format.name);
  if (format.name != "hdf5" && (options.compress || storage.layout == Layout::virtual_view))
    throw BadInput("--compress and --layout virtual are for HDF5; the table is {}", format.name);
  auto outputs = plan_outputs(options.materials, options.output,
                              options.exr_layout == "files" ? "" : format.suffix, options.force);
  if (format.exported) return export_materials(options, *format.exported, outputs, common);
  // What grids can be refused for is refused before the first table is begun.
  std::vector<Grid> grids;
  for (const MaterialOutput& output : outputs) {
    grids.push_back(grid_for(output.material, options));
    try {
      stored_grid(grids.back(), storage);
    } catch (const BadInput& refusal) {
      throw BadInput("{}: {}", output.input, refusal.what());
    }
  }
  std::vector<std::unique_ptr<Engine>> owned;
  std::vector<const Engine*> engines;
  for (const Device& device : select_devices(options.device)) {
    owned.push_back(std::make_unique<Engine>(device, Engine::widest(device), precision, common.watch));
    engines.push_back(owned.back().get());
  }
  GenerateOptions generate_options;
  generate_options.polarizations = polarizations(options.polarization);
  generate_options.storage = storage;
  generate_options.force = options.force;
  generate_options.history = history(common);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const MaterialOutput& output = outputs[k];
    Grid& grid = grids[k];
    if (options.interpolation.asked())
      generate_options.grid_choice = options.interpolation.choose(*engines.front(), output.material,
                                                                  generate_options.polarizations, grid);
    if (options.interpolation.dry_run()) continue;
    const auto summary = generate(
        engines, output.material, grid, output.target,
        [&](const fs::path& file, const TableContent& content) {
          return format.create(file, content, options);
        },
        generate_options);
    const Accuracy& accuracy = summary.findings.accuracy;
    say(common,
        fmt::format(
            "{}: {} samples, {:.3g} MB{} in {:.2f} s; {}", output.target.string(), summary.samples,
            static_cast<double>(summary.bytes) / 1e6, size_text(storage, grid, precision, summary),
            summary.seconds,
            accuracy.nodes == 0
                ? "no node large enough to be checked against the scalar reference"
                : fmt::format(
                      "largest relative error at {} nodes checked against the scalar reference {:.1e}",
                      accuracy.nodes, accuracy.max_relative_error)));
    for (const auto& warning : summary.findings.energy_warnings) say(common, "warning: " + warning);
  }
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> generate_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser
      .add_option("MATERIAL", options->materials,
                  "Material files (TOML), or tables, for the material inside; several need -o FOLDER/")
      ->required();
  parser.add_option("-o,--output", options->output, "Table file, or a folder")->required();
  parser.add_option("--format", options->format,
                    fmt::format("Format, where the extension does not tell: {}",
                                known_formats(format_table(options->exported.formats()))));
  parser.option_defaults()->group(axes_group);
  for (const auto& row : axis_table)
    parser.add_option(axis_option(row), options->axes[static_cast<std::size_t>(row.kind)],
                      fmt::format("{}, degrees: start:stop:step, both ends included, or angles separated by "
                                  "commas; default: the material's, or {}",
                                  row.long_name, row.default_text));
  parser.option_defaults()->group(dense_group);
  parser
      .add_option("--polarization", options->polarization, "unpolarized (default), s, p, or all: the three")
      ->check(CLI::IsMember({"unpolarized", "s", "p", "all"}));
  parser.add_option("--precision", options->precision, "Samples as float32 (default) or float64")
      ->check(CLI::IsMember({"float32", "float64"}));
  parser
      .add_option("--compress", options->compress,
                  "deflate or deflate:LEVEL, 1 (default, fastest) to 12: HDF5 chunks, shuffled and deflated, "
                  "that any reader opens without a plug-in")
      ->type_name("deflate[:LEVEL]");
  parser.add_option(
      "--keep-bits", options->keep_bits,
      "Round each sample to so many explicit mantissa bits, to nearest even: 1 to 23 for float32, to 52 for "
      "float64. Relative error at most 2^-(N+1); 12 bits (1.2e-4) compress about three times as well");
  parser
      .add_option("--layout", options->layout,
                  "contiguous (default), or virtual: store f over theta_i, theta_s and phi_s - phi_i, and "
                  "show the table of four angles as a view of it, smaller by about the number of phi_i; "
                  "takes even steps of phi_i and phi_s; readers take HDF5 1.10 or later")
      ->check(CLI::IsMember({"contiguous", "virtual"}));
  options->interpolation.add(parser);
  parser
      .add_option("--exr-layout", options->exr_layout,
                  "OpenEXR: parts (default; a part for each slice), tiles (one image, a tile for each slice) "
                  "or files (a folder with a file for each slice)")
      ->check(CLI::IsMember(std::vector<std::string>(exr_layout_names.begin(), exr_layout_names.end())));
  parser
      .add_option("--exr-compression", options->exr_compression,
                  "OpenEXR: none (default) or zip, both lossless")
      ->check(CLI::IsMember({"none", "zip"}));
  options->exported.add(parser);
  parser.option_defaults()->group("Options");
  parser.add_flag("--force", options->force, "Overwrite an existing table");
  add_device_option(parser, options->device, true);
  return [options, &parser, &common] { return run(*options, parser, common); };
}

}  // namespace brdftab
