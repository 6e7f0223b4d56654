#include "host/commands/options/format_choice.hpp"

#include <algorithm>
#include <filesystem>
#include <type_traits>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/commands/command.hpp"

namespace brdftab {
namespace {

// As CLI11 itself describes options with a member of that type and its checks.
std::string kind_of(const FormatOption& row) {
  if (!row.shape.empty()) return std::string(row.shape);
  if (!row.words.empty()) return fmt::format("TEXT:{{{}}}", fmt::join(row.words, ","));
  return std::visit(
      [&](auto* member) -> std::string {
        using Member = std::remove_pointer_t<decltype(member)>;
        if (std::is_same_v<Member, std::string>) return "TEXT";
        const std::string_view numbers = std::is_integral_v<Member> ? "INT" : "FLOAT";
        return fmt::format(
            "{}{}", std::is_unsigned_v<Member> ? "UINT" : numbers,
            row.range ? fmt::format(":{} in [{:g} - {:g}]", numbers, row.range->low, row.range->high) : "");
      },
      row.value);
}

std::string group_of(const Format& format) {
  return fmt::format("--format {}, for {}", format.traits().name, format.traits().consumer);
}

bool is_written(const Format& format) { return format.as_dense() || format.as_export(); }

}  // namespace

CLI::Option* add_format_option(CLI::App& parser, const FormatOption& row) {
  return parser
      .add_option_function<std::string>(
          option_name(row.name), [row](const std::string& text) { row.set(text); }, row.help)
      ->type_name(kind_of(row));
}

std::string FormatChoice::known() const {
  std::vector<std::string> rows;
  for (const auto& format : formats_) {
    if (!is_written(*format)) continue;
    const FormatTraits& traits = format->traits();
    rows.push_back(traits.extensions.empty()
                       ? std::string(traits.name)
                       : fmt::format("{} ({})", traits.name, fmt::join(traits.extensions, ", ")));
  }
  return fmt::format("{}", fmt::join(rows, "; "));
}

void FormatChoice::add_options(CLI::App& parser, Format& format) {
  for (const FormatOption& row : format.options())
    options_.emplace_back(add_format_option(parser, row), &format);
}

void FormatChoice::add_dense_options(CLI::App& parser) {
  for (const auto& format : formats_)
    if (format->as_dense()) add_options(parser, *format);
}

void FormatChoice::add_export_options(CLI::App& parser) {
  for (const auto& format : formats_)
    if (format->as_export()) {
      parser.option_defaults()->group(group_of(*format));
      add_options(parser, *format);
    }
}

const Format* FormatChoice::format_of_given_option() const {
  for (const auto& [option, format] : options_)
    if (option->count() > 0) return format;
  return nullptr;
}

const Format& FormatChoice::find(const std::string& name, const std::string& output, bool is_folder) const {
  if (!name.empty()) {
    const Format* named = find_format(formats_, name);
    if (!named || !is_written(*named))
      throw BadInput("--format {}: unknown; there is {}", excerpt(name), known());
    return *named;
  }
  const Format* given = format_of_given_option();
  if (is_folder) return given ? *given : *find_format(formats_, "hdf5");
  const std::string extension = std::filesystem::path(output).extension().string();
  if (const Format* told = format_of_extension(formats_, extension)) return *told;
  // A folder's name needs no extension.
  if (given && given->as_dense() && given->as_dense()->writes_folder()) return *given;
  throw BadInput("-o {}: the extension names no format; --format has {}", excerpt(output), known());
}

void FormatChoice::check(const Format& chosen) const {
  for (const auto& [option, format] : options_)
    if (option->count() > 0 && format != &chosen)
      throw BadInput("{} is for {}; the file is {}{}", option->get_name(), format->traits().name,
                     chosen.as_dense() ? "a dense table, " : "", chosen.traits().name);
}

}  // namespace brdftab
