// The registry of formats: what each row promises, and what its settings take and refuse.
#include "host/formats/registry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "host/base/error.hpp"
#include "host/formats/read_measurement.hpp"

namespace brdftab {
namespace {

// The value of a setting as text.
std::string text_of(const FormatOption& option) {
  return std::visit(
      [](auto* member) -> std::string {
        using Member = std::remove_pointer_t<decltype(member)>;
        if constexpr (std::is_same_v<Member, std::optional<double>>)
          return member->has_value() ? fmt::format("{}", **member) : "none";
        else
          return fmt::format("{}", *member);
      },
      option.value);
}

std::string refused(const FormatOption& option, const std::string& text) {
  const std::string before = text_of(option);
  try {
    option.set(text);
  } catch (const BadInput& error) {
    EXPECT_EQ(error.field(), option.name);
    EXPECT_EQ(error.value(), text);
    EXPECT_EQ(text_of(option), before);
    return error.allowed();
  }
  ADD_FAILURE() << option.name << " takes " << text;
  return "";
}

TEST(Registry, NamesAndExtensionsTellFormatsApart) {
  const Formats formats = all_formats();
  std::set<std::string_view> names, extensions, measured;
  for (const auto& format : formats) {
    const FormatTraits& traits = format->traits();
    EXPECT_TRUE(names.insert(traits.name).second) << traits.name;
    EXPECT_FALSE(traits.consumer.empty()) << traits.name;
    for (const auto extension : traits.extensions) {
      EXPECT_TRUE(extensions.insert(extension).second) << extension;
      EXPECT_EQ(format_of_extension(formats, extension), format.get());
    }
    if (traits.measurement) {
      for (const auto extension : traits.measurement->extensions)
        EXPECT_TRUE(measured.insert(extension).second) << extension;
    }
    EXPECT_EQ(find_format(formats, traits.name), format.get());
    EXPECT_EQ(format->as_dense() || format->as_export(), !traits.suffix.empty()) << traits.name;
  }
  EXPECT_EQ(find_format(formats, "mitsuba"), nullptr);
  EXPECT_EQ(format_of_extension(formats, ".toml"), nullptr);
  EXPECT_EQ(measurement_formats(), (std::vector<std::string>{"alta", "astm", "csv", "merl", "zemax"}));
}

TEST(Registry, SettingsTakeWhatTheyAllow) {
  std::set<std::string> names;
  for (const auto& format : all_formats())
    for (const FormatOption& option : format->options()) {
      EXPECT_TRUE(names.insert(option.name).second) << option.name;
      EXPECT_FALSE(option.help.empty()) << option.name;
      for (const auto word : option.words) {
        option.set(word);
        EXPECT_EQ(text_of(option), word);
      }
      if (!option.words.empty()) {
        EXPECT_NE(refused(option, "nonsense").find(option.words.back()), std::string::npos);
      }
      if (!option.range) continue;
      for (const double value : {option.range->low, option.range->high}) {
        option.set(fmt::format("{}", value));
        EXPECT_EQ(text_of(option), fmt::format("{}", value));
      }
      for (const double value : {option.range->low / 2 - 1, option.range->high + 1.})
        EXPECT_NE(refused(option, fmt::format("{}", value)).find(fmt::format("{}", option.range->high)),
                  std::string::npos);
      refused(option, "nan");
      refused(option, "ten");
    }
  EXPECT_GT(names.size(), 20u);
}

TEST(Registry, AWholeNumberIsNoFraction) {
  int steps = 3;
  double share = 0.5;
  const FormatOption whole{.name = "steps", .help = "", .value = &steps};
  const FormatOption any{.name = "share", .help = "", .value = &share};
  EXPECT_EQ(refused(whole, "2.5"), "must be a whole number");
  whole.set("7");
  any.set("2.5");
  EXPECT_EQ(steps, 7);
  EXPECT_EQ(share, 2.5);
}

}  // namespace
}  // namespace brdftab
