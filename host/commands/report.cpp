#include "host/pictures/report/report.hpp"

#include <filesystem>

#include "host/base/whole_file.hpp"
#include "host/commands/command.hpp"
#include "host/formats/hdf5/hdf5_writer.hpp"
#include "host/formats/open_table.hpp"
#include "host/pictures/report/embedded_table.hpp"
#include "host/table/generate.hpp"

namespace brdftab {
namespace {

struct Options {
  std::string subject;
  std::string output;
  std::optional<std::string> device;
  bool force = false;
};

// A folder of its own that goes with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "brdftab-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw FileError("{}: cannot be made: {}", name, std::generic_category().message(errno));
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// The table of a material's own grid at its first phi_i, on which f does not depend, and of no more nodes
// than a page holds.
Subject table_of(const Subject& subject, const Engine& engine, const TemporaryFolder& folder,
                 const CommonOptions& common, std::string& origin) {
  const Material& material = subject.material();
  Grid grid = material.grid();
  grid.phi_i = Axis(AxisKind::phi_i, {grid.phi_i[0]});
  const NodeSubset nodes = spread_nodes(grid, most_embedded / material.bands().size());
  origin = "It was made for this page, at the material's own grid; brdftab generate makes it as a file.";
  if (nodes.size() < grid.directions()) {
    origin = fmt::format(
        "It was made for this page, at {} of the {} directions of the material's own grid, spread evenly; "
        "brdftab generate makes the whole as a file.",
        nodes.size(), grid.directions());
    say(common, fmt::format("{}: its grid has {} directions; the page has {} of them", subject.file(),
                            grid.directions(), nodes.size()));
  }
  const auto file = folder.path() / "table.h5";
  GenerateOptions options;
  options.history = common.command_line;
  generate(engine, material, subset_grid(grid, nodes), file, create_hdf5_writer, options);
  return Subject::of_table(subject.file(), open_table(file));
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  const std::filesystem::path target = options.output;
  if (target.extension() != ".html") throw BadInput("{}: a report's name must end in .html", options.output);
  PartialFile file(target, options.force);
  const Subject subject = Subject::open(options.subject);
  if (subject.is_table())
    for (const auto& fault : subject.table().faults)
      say(common, fmt::format("{}: warning: {}", subject.file(), fault));
  const Device device = select_device(options.device);
  const Engine engine(device, Engine::widest(device), Precision::float32, common.watch);
  std::optional<TemporaryFolder> folder;
  std::string origin = fmt::format("The file is {}.", options.subject);
  const Subject table =
      subject.is_table() ? subject : table_of(subject, engine, folder.emplace(), common, origin);
  write_whole(file, report(
                        table, [&]() -> const Engine& { return engine; }, origin));
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> report_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser
      .add_option("MATERIAL_OR_TABLE", options->subject,
                  "Table, or material file, whose grid is then tabulated for the page")
      ->required();
  parser.add_option("-o,--output", options->output, "Page to write: .html")->required();
  parser.add_flag("--force", options->force, "Overwrite an existing output");
  add_device_option(parser, options->device);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab
