#include "host/formats/zemax/zemax_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

// Cuts a text into words and keeps the line that each stands in; `#` begins a comment.
class Words {
 public:
  Words(std::istream& in, const std::string& source) : source_(source) {
    std::size_t line = 0;
    for (std::string text; std::getline(in, text);) {
      ++line;
      const auto mark = text.find('#');
      if (mark != text.npos) comments_.push_back(text.substr(mark + 1));
      std::istringstream words(text.substr(0, mark));
      for (std::string word; words >> word;) words_.push_back({word, line});
    }
  }

  bool ended() const { return at_ == words_.size(); }
  std::string where() const {
    return fmt::format("{}:{}", source_,
                       words_.empty() ? 1 : words_[std::min(at_, words_.size() - 1)].second);
  }
  std::string word() {
    if (ended()) throw BadInput("{}: ends too early", where());
    return words_[at_++].first;
  }
  double number() {
    const std::string place = where();
    const std::string text = word();
    const auto value = parse_number(text);
    if (!value || !std::isfinite(*value)) throw BadInput("{}: {}: must be a number", place, excerpt(text));
    return *value;
  }
  void expect(std::string_view wanted) {
    const std::string place = where();
    const std::string text = word();
    if (text != wanted) throw BadInput("{}: {}: must be {}", place, excerpt(text), wanted);
  }
  std::vector<std::string> take_comments() { return std::move(comments_); }

 private:
  const std::string& source_;
  std::vector<std::pair<std::string, std::size_t>> words_;
  std::vector<std::string> comments_;
  std::size_t at_ = 0;
};

}  // namespace

ZemaxFile ZemaxFile::read(std::istream& in, const std::string& source) {
  Words words(in, source);
  ZemaxFile file;
  file.comments = words.take_comments();
  const std::array<std::pair<std::string_view, std::vector<double>*>, 4> axes{
      {{"SampleRotation", &file.rotation},
       {"AngleOfIncidence", &file.incidence},
       {"ScatterAzimuth", &file.azimuth},
       {"ScatterRadial", &file.radial}}};
  while (!words.ended()) {
    const std::string place = words.where();
    const std::string key = words.word();
    const auto axis = std::find_if(axes.begin(), axes.end(), [&](const auto& a) { return a.first == key; });
    if (axis != axes.end()) {
      const double count = words.number();
      if (!(count >= 1 && count <= 1e6))
        throw BadInput("{}: {} {}: must be a count", place, key, shortest(count));
      for (int k = 0; k < static_cast<int>(count); ++k) axis->second->push_back(words.number());
    } else if (key == "ScatterType") {
      words.expect("BRDF");
    } else if (key == "Symmetry") {
      file.symmetry = words.word();
    } else if (key == "Source" || key == "SpectralContent") {
      words.word();
    } else if (key == "Monochrome" || key.starts_with("Tristimulus")) {
      for (const auto& [name, list] : axes)
        if (list->empty()) throw BadInput("{}: {} is missing before the data", place, name);
      for (const double theta_i : file.incidence)
        if (!(theta_i >= 0 && theta_i < 90))
          throw BadInput("{}: AngleOfIncidence {}: must be a number from 0 to below 90 degrees", place,
                         shortest(theta_i));
      ZemaxBlock& block = file.blocks.emplace_back();
      block.content = key;
      words.expect("DataBegin");
      const std::size_t slices = file.rotation.size() * file.incidence.size();
      const std::size_t samples = file.azimuth.size() * file.radial.size();
      for (std::size_t slice = 0; slice < slices; ++slice) {
        words.expect("TIS");
        block.tis.push_back(words.number());
        for (std::size_t k = 0; k < samples; ++k) block.values.push_back(words.number());
      }
      words.expect("DataEnd");
    } else {
      throw BadInput("{}: {}: is no keyword of a Zemax tabular BSDF", place, excerpt(key));
    }
  }
  return file;
}

std::string ZemaxFile::text() const {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const auto& line : comments) fmt::format_to(out, "# {}\n", line);
  fmt::format_to(out, "Source\tMeasured\nSymmetry\t{}\nSpectralContent\t{}\nScatterType\tBRDF\n", symmetry,
                 blocks.size() == 3 ? "XYZ" : "Monochrome");
  for (const auto& [name, values] : {std::pair{"SampleRotation", &rotation},
                                     {"AngleOfIncidence", &incidence},
                                     {"ScatterAzimuth", &azimuth},
                                     {"ScatterRadial", &radial}})
    fmt::format_to(out, "{}\t{}\n{}\n", name, values->size(), fmt::join(*values, "\t"));
  fmt::format_to(out, "\n");
  for (const ZemaxBlock& block : blocks) {
    fmt::format_to(out, "{}\nDataBegin\n", block.content);
    auto row = block.values.begin();
    for (const double tis : block.tis) {
      fmt::format_to(out, "TIS\t{:.9g}\n", tis);
      for (std::size_t a = 0; a < azimuth.size(); ++a, row += std::ssize(radial))
        fmt::format_to(out, "{:.7g}\n", fmt::join(row, row + std::ssize(radial), "\t"));
    }
    fmt::format_to(out, "DataEnd\n");
  }
  return fmt::to_string(text);
}

}  // namespace brdftab
