// An SVG document is built mark by mark. Its inks follow the light or dark page of the reader.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "host/base/xml_text.hpp"
#include "host/pictures/drawing/palette.hpp"

namespace brdftab::drawing {

/// A rectangle in user units: x points to the right and y down.
struct Box {
  double left, top, right, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  double middle_x() const { return 0.5 * (left + right); }
  double middle_y() const { return 0.5 * (top + bottom); }
};

struct TextStyle {
  const char* anchor = "middle";  // start, middle or end: the part of the text that is at its place
  double size = 13;
  Ink ink = inks::text;
  bool bold = false;
  double turned = 0;  // degrees clockwise
  bool halo = false;  // an edge in the page's colour keeps the text readable on curves
};

class Svg {
 public:
  Svg(double width, double height) : width_(width), height_(height) {}

  /// The attribute `stroke` or `fill` for an ink, with a class to which the style gives the ink's dark
  /// colour.
  std::string stroke(const Ink& ink) { return coloured("stroke", ink); }
  std::string fill(const Ink& ink) { return coloured("fill", ink); }

  void line(double x1, double y1, double x2, double y2, const Ink& ink, double width = 1,
            std::string_view dash = "");
  /// `attributes` are further ones in the words of SVG.
  void path(std::string_view d, const Ink& ink, double width, std::string_view dash = "",
            std::string_view attributes = "");
  void disc(double x, double y, double radius, const Ink& ink);
  /// The dot has the colour of the group around it.
  void dot(double x, double y, double radius);
  void ring(double x, double y, double radius, const Ink& ink, double width = 1);
  void rectangle(const Box& box, const Ink& ink, double width = 1);
  void fill_box(const Box& box, const Ink& ink);
  /// `_` lowers the next character, or the text in braces after it; `^` raises it; `\` takes the next
  /// character as it is.
  void text(double x, double y, std::string_view text, const TextStyle& style = {});
  /// Stretches a PNG over a box.
  void image(const Box& box, std::span<const std::byte> png, std::string_view attributes = "");
  /// Cuts off at the shape whatever follows until `end_group`.
  void clip_to(const Box& box) { clip(box, 0); }
  void clip_to_disc(double x, double y, double radius) {
    clip({x - radius, y - radius, x + radius, y + radius}, radius);
  }
  void begin_group(std::string_view attributes);
  void end_group() { body_ += "</g>\n"; }

  /// The text of the whole file. `title` is plain text for people who hear pictures. `data` is JSON, which
  /// the file keeps as its metadata.
  std::string document(std::string_view title, std::string_view data = "") const;

 private:
  std::string coloured(const char* property, const Ink& ink);
  void clip(const Box& box, double radius);

  double width_, height_;
  std::string body_;
  std::set<std::string> dark_rules_;
  std::size_t clips_ = 0;
};

/// Escapes a text so that Svg::text shows it as it is.
std::string literal(std::string_view text);

/// Writes a symbol such as σ_surface for Svg::text, which then lowers all that follows the underscore.
std::string subscripted(std::string_view symbol);

/// Removes the marks of Svg::text, for places that show plain text.
std::string plain_text(std::string_view text);

/// The approximate width of a text in user units, in the widest of the common sans-serif fonts.
double text_width(std::string_view text, double size, bool bold = false);

std::string base64(std::span<const std::byte> bytes);

}  // namespace brdftab::drawing
