#include "host/pictures/drawing/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace brdftab::drawing {
namespace {

constexpr double script_size = 0.74;
constexpr double lowered = 0.24;
constexpr double raised = -0.38;

// A piece of a text, and how far it is lowered as a multiple of the font's size.
struct Piece {
  std::string text;
  double shift;
};

std::size_t character_bytes(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces{{"", 0}};
  for (std::size_t k = 0; k < text.size();) {
    if ((text[k] == '_' || text[k] == '^') && k + 1 < text.size()) {
      const double shift = text[k] == '_' ? lowered : raised;
      ++k;
      std::string_view script = text.substr(k, character_bytes(text[k]));
      k += script.size();
      if (script == "{") {
        const std::size_t end = std::min(text.find('}', k), text.size());
        script = text.substr(k, end - k);
        k = std::min(end + 1, text.size());
      }
      pieces.push_back({std::string(script), shift});
      pieces.push_back({"", 0});
    } else {
      if (text[k] == '\\' && k + 1 < text.size()) ++k;
      pieces.back().text += text[k++];
    }
  }
  std::erase_if(pieces, [](const Piece& piece) { return piece.text.empty(); });
  return pieces;
}

}  // namespace

std::string literal(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '_' || c == '^' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string subscripted(std::string_view symbol) {
  const std::size_t line = symbol.find('_');
  if (line == symbol.npos) return std::string(symbol);
  return fmt::format("{}_{{{}}}", symbol.substr(0, line), symbol.substr(line + 1));
}

std::string plain_text(std::string_view text) {
  std::string result;
  for (const Piece& piece : pieces_of(text)) {
    if (piece.shift != 0) result += piece.shift == lowered ? "_" : "^";
    result += piece.text;
  }
  return result;
}

double text_width(std::string_view text, double size, bool bold) {
  double width = 0;
  if (bold) size *= 1.12;
  for (const Piece& piece : pieces_of(text))
    for (std::size_t k = 0; k < piece.text.size(); k += character_bytes(piece.text[k])) {
      const std::string_view narrow = "il.,:;|!'()[] tfrj";
      const double wide = narrow.find(piece.text[k]) != narrow.npos ? 0.38 : 0.635;
      width += wide * size * (piece.shift == 0 ? 1 : script_size);
    }
  return width;
}

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (k + j < bytes.size() ? std::to_integer<unsigned>(bytes[k + j]) : 0);
    for (std::size_t j = 0; j < 4; ++j)
      text += k + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

std::string Svg::coloured(const char* property, const Ink& ink) {
  const std::string dark = ink.dark.hex();
  const std::string name = fmt::format("{}{}", property[0], dark.substr(1));
  dark_rules_.insert(fmt::format(".{}{{{}:{}}}", name, property, dark));
  return fmt::format("{}=\"{}\" class=\"{}\"", property, ink.light.hex(), name);
}

void Svg::line(double x1, double y1, double x2, double y2, const Ink& ink, double width,
               std::string_view dash) {
  path(fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", x1, y1, x2, y2), ink, width, dash);
}

void Svg::path(std::string_view d, const Ink& ink, double width, std::string_view dash,
               std::string_view attributes) {
  body_ += fmt::format("<path d=\"{}\" fill=\"none\" {} stroke-width=\"{}\"{}{}{}/>\n", d, stroke(ink), width,
                       dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash),
                       attributes.empty() ? "" : " ", attributes);
}

void Svg::disc(double x, double y, double radius, const Ink& ink) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" {}/>\n", x, y, radius, fill(ink));
}

void Svg::dot(double x, double y, double radius) {
  body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/>\n", x, y, radius);
}

void Svg::ring(double x, double y, double radius, const Ink& ink, double width) {
  body_ +=
      fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"none\" {} stroke-width=\"{}\"/>\n", x,
                  y, radius, stroke(ink), width);
}

void Svg::rectangle(const Box& box, const Ink& ink, double width) {
  body_ += fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" {} "
      "stroke-width=\"{}\"/>\n",
      box.left, box.top, box.width(), box.height(), stroke(ink), width);
}

void Svg::fill_box(const Box& box, const Ink& ink) {
  body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n", box.left,
                       box.top, box.width(), box.height(), fill(ink));
}

void Svg::text(double x, double y, std::string_view text, const TextStyle& style) {
  if (style.halo)
    begin_group(stroke(inks::page) + " stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"");
  body_ += fmt::format("<text {} text-anchor=\"{}\" font-size=\"{}\" {}{}>",
                       style.turned == 0 ? fmt::format("x=\"{:.2f}\" y=\"{:.2f}\"", x, y)
                                         : fmt::format("transform=\"translate({:.2f} {:.2f}) rotate({})\"", x,
                                                       y, style.turned),
                       style.anchor, style.size, fill(style.ink), style.bold ? " font-weight=\"bold\"" : "");
  double shift = 0;
  for (const Piece& piece : pieces_of(text)) {
    // Renderers drop a space at the start of a tspan.
    const bool spaced = piece.text.starts_with(' ');
    if (piece.shift == shift && shift == 0)
      body_ += xml_escaped(piece.text);
    else
      body_ +=
          fmt::format("<tspan dy=\"{:.2f}\"{}{}>{}</tspan>", (piece.shift - shift) * style.size,
                      spaced ? fmt::format(" dx=\"{:.2f}\"", 0.3 * style.size) : "",
                      piece.shift == 0 ? "" : fmt::format(" font-size=\"{:.2f}\"", script_size * style.size),
                      xml_escaped(piece.text.substr(spaced ? 1 : 0)));
    shift = piece.shift;
  }
  body_ += "</text>\n";
  if (style.halo) end_group();
}

void Svg::image(const Box& box, std::span<const std::byte> png, std::string_view attributes) {
  body_ += fmt::format(
      "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" preserveAspectRatio=\"none\"{}{} "
      "href=\"data:image/png;base64,{}\"/>\n",
      box.left, box.top, box.width(), box.height(), attributes.empty() ? "" : " ", attributes, base64(png));
}

void Svg::clip(const Box& box, double radius) {
  body_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" height=\"{4:.2f}\" "
      "rx=\"{5:.2f}\"/></clipPath><g clip-path=\"url(#clip{0})\">\n",
      clips_++, box.left, box.top, box.width(), box.height(), radius);
}

void Svg::begin_group(std::string_view attributes) { body_ += fmt::format("<g {}>\n", attributes); }

std::string Svg::document(std::string_view title, std::string_view data) const {
  Svg page(width_, height_);
  const std::string background = page.fill(inks::page);
  std::set<std::string> rules = dark_rules_;
  rules.merge(page.dark_rules_);
  std::string style;
  for (const auto& rule : rules) style += rule;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} "
      "{1:g}\" role=\"img\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', "
      "sans-serif\">\n<title>{2}</title>\n{3}<style>@media (prefers-color-scheme:dark){{{4}}}</style>\n<rect "
      "width=\"100%\" height=\"100%\" {5}/>\n{6}</svg>\n",
      width_, height_, xml_escaped(title),
      data.empty() ? "" : fmt::format("<metadata>{}</metadata>\n", xml_escaped(data)), style, background,
      body_);
}

}  // namespace brdftab::drawing
