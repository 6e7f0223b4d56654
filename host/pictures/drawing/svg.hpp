// An SVG document in the making: marks in inks that follow the reader's light or dark page.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "host/base/xml_text.hpp"
#include "host/pictures/drawing/palette.hpp"

namespace brdftab {

/// In user units, x to the right and y down.
struct Box {
  double left, top, right, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  double middle_x() const { return 0.5 * (left + right); }
  double middle_y() const { return 0.5 * (top + bottom); }
};

struct TextStyle {
  const char* anchor = "middle";  // start, middle, end
  double size = 13;
  Ink ink = inks::text;
  bool bold = false;
  double turned = 0;  // degrees, clockwise
  bool halo = false;  // edged by the page, to stand on curves
};

class Svg {
 public:
  Svg(double width, double height) : width_(width), height_(height) {}

  /// Attributes `stroke` or `fill`, with the class that the style for dark pages names.
  std::string stroke(const Ink& ink) { return coloured("stroke", ink); }
  std::string fill(const Ink& ink) { return coloured("fill", ink); }

  void line(double x1, double y1, double x2, double y2, const Ink& ink, double width = 1,
            std::string_view dash = "");
  /// `attributes`: more of them, as SVG spells them.
  void path(std::string_view d, const Ink& ink, double width, std::string_view dash = "",
            std::string_view attributes = "");
  void disc(double x, double y, double radius, const Ink& ink);
  /// In the colour of the group around it.
  void dot(double x, double y, double radius);
  void ring(double x, double y, double radius, const Ink& ink, double width = 1);
  void rectangle(const Box& box, const Ink& ink, double width = 1);
  void fill_box(const Box& box, const Ink& ink);
  /// `_x` and `_{...}` in the text lower what follows, `^` raises it, `\\` takes the next character as it is.
  void text(double x, double y, std::string_view text, const TextStyle& style = {});
  /// A PNG, stretched over a box.
  void image(const Box& box, std::span<const std::byte> png, std::string_view attributes = "");
  /// What follows, until `end_group`, is cut off at the shape.
  void clip_to(const Box& box) { clip(box, 0); }
  void clip_to_disc(double x, double y, double radius) {
    clip({x - radius, y - radius, x + radius, y + radius}, radius);
  }
  void begin_group(std::string_view attributes);
  void end_group() { body_ += "</g>\n"; }

  /// The whole file. `title` is plain text for readers who hear pictures; `data` is JSON, kept in the file's
  /// metadata.
  std::string document(std::string_view title, std::string_view data = "") const;

 private:
  std::string coloured(const char* property, const Ink& ink);
  void clip(const Box& box, double radius);

  double width_, height_;
  std::string body_;
  std::set<std::string> dark_rules_;
  std::size_t clips_ = 0;
};

/// Text that Svg::text shows as it is.
std::string literal(std::string_view text);

/// A symbol such as σ_surface as Svg::text takes it, all behind the line lowered.
std::string subscripted(std::string_view symbol);

/// Without the marks of `Svg::text`, for places that show plain text.
std::string plain_text(std::string_view text);

/// About the width of a text in user units, in the widest of common sans-serif fonts.
double text_width(std::string_view text, double size, bool bold = false);

std::string base64(std::span<const std::byte> bytes);

}  // namespace brdftab
