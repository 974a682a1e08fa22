#include <patchproof/figure/svg_writer.hpp>

#include <set>

#include <patchproof/figure/decimal.hpp>
#include <patchproof/figure/labels.hpp>

namespace patchproof {

namespace {

constexpr int margin = 8;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string colour(const std::array<int, 3>& rgb, int strength) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const int channel : rgb) {
    const int mixed = (channel * strength + 255 * (100 - strength) + 50) / 100;
    text += digits[static_cast<std::size_t>(mixed / 16)];
    text += digits[static_cast<std::size_t>(mixed % 16)];
  }
  return text;
}

std::string length(int hundredths) { return decimal(Rational{hundredths, 100}, 2); }

/// Writes shapes; y goes down in SVG.
struct Writer {
  Rational height;

  std::string x(const Place& p) const { return decimal(p.x, 2); }
  std::string y(const Place& p) const { return decimal(height - p.y, 2); }

  std::string points(const std::vector<Place>& places) const {
    std::string text;
    for (const Place& p : places) text += (text.empty() ? "" : " ") + x(p) + "," + y(p);
    return text;
  }

  // The thin line of the same colour closes the seams between neighbours.
  std::string operator()(const Polygon& p) const {
    const std::string paint = colour(style_of(p.ink).colour, p.strength);
    return "<polygon class=\"" + std::string{style_of(p.ink).name} + "\" fill=\"" + paint +
           "\" stroke=\"" + paint + "\" points=\"" + points(p.corners) + "\"/>\n";
  }
  std::string operator()(const Polyline& p) const {
    return "<polyline class=\"" + std::string{style_of(p.ink).name} + "\" points=\"" +
           points(p.places) + "\"/>\n";
  }
  std::string operator()(const Arrow& a) const {
    return "<line class=\"" + std::string{style_of(a.ink).name} + "\" x1=\"" + x(a.from) +
           "\" y1=\"" + y(a.from) + "\" x2=\"" + x(a.to) + "\" y2=\"" + y(a.to) +
           "\" marker-end=\"url(#tip-" + std::string{style_of(a.ink).name} + ")\"/>\n";
  }
  std::string operator()(const Dot& d) const {
    return "<circle cx=\"" + x(d.at) + "\" cy=\"" + y(d.at) + "\" r=\"" +
           length(style_of(d.ink).width) + "\" fill=\"" + colour(style_of(d.ink).colour, 100) +
           "\"/>\n";
  }
  std::string operator()(const Label& l) const {
    const LabelParts parts = label_parts(l.name);
    const bool left = l.side == Side::left || l.side == Side::above_left || l.side == Side::below_left;
    const bool right =
        l.side == Side::right || l.side == Side::above_right || l.side == Side::below_right;
    const bool up =
        l.side == Side::above || l.side == Side::above_left || l.side == Side::above_right;
    const bool level = l.side == Side::left || l.side == Side::right;
    const Rational dx = left ? Rational{-6, 5} : right ? Rational{6, 5} : Rational{0};
    const Rational dy = level ? Rational{-1} : up ? Rational{6, 5} : Rational{-16, 5};
    const Place at{Rational{l.at.x + dx}, Rational{l.at.y + dy}};
    std::string text = "<text x=\"" + x(at) + "\" y=\"" + y(at) + "\" text-anchor=\"" +
                       (left ? "end" : right ? "start" : "middle") + "\">" + escaped(parts.letters);
    if (!parts.index.empty())
      text += "<tspan dy=\"0.8\" font-size=\"2.4\">" + escaped(parts.index) + "</tspan>";
    if (!parts.rest.empty())
      text += std::string{"<tspan dy=\""} + (parts.index.empty() ? "0" : "-0.8") + "\">" +
              escaped(parts.rest) + "</tspan>";
    return text + "</text>\n";
  }
};

// Rules for the inks of lines, and tips for those of arrows.
std::string styles(const Figure& figure) {
  std::set<Ink> of_lines;
  std::set<Ink> of_arrows;
  for (const Shape& shape : figure.shapes) {
    if (const auto* line = std::get_if<Polyline>(&shape)) of_lines.insert(line->ink);
    if (const auto* arrow = std::get_if<Arrow>(&shape)) of_arrows.insert(arrow->ink);
  }
  std::string tips;
  for (const Ink ink : of_arrows) {
    tips += "<marker id=\"tip-" + std::string{style_of(ink).name} +
            "\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"6\" markerHeight=\"6\" "
            "orient=\"auto\"><path d=\"M0,1.5 L10,5 L0,8.5 L2.5,5 z\" fill=\"" +
            colour(style_of(ink).colour, 100) + "\"/></marker>\n";
    of_lines.insert(ink);
  }
  std::string text =
      "<defs><style>\n"
      "polygon { stroke-width: 0.12 }\n"
      "polyline, line { fill: none; stroke-linecap: round; stroke-linejoin: round }\n"
      "text { font: italic 3.6px 'Latin Modern Math', 'STIX Two Text', 'Times New Roman', serif }\n";
  for (const Ink ink : of_lines)
    text += "." + std::string{style_of(ink).name} + " { stroke: " +
            colour(style_of(ink).colour, 100) + "; stroke-width: " + length(style_of(ink).width) +
            " }\n";
  return text + "</style>\n" + tips + "</defs>\n";
}

}  // namespace

std::string svg(const Figure& figure) {
  const Rational whole_width = figure.width + 2 * margin;
  const Rational whole_height = figure.height + 2 * margin;
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
                     decimal(whole_width, 2) + "mm\" height=\"" + decimal(whole_height, 2) +
                     "mm\" viewBox=\"-" + std::to_string(margin) + " -" + std::to_string(margin) +
                     " " + decimal(whole_width, 2) + " " + decimal(whole_height, 2) + "\">\n";
  for (const std::string& note : figure.notes) text += "<desc>" + escaped(note) + "</desc>\n";
  text += styles(figure);
  const Writer writer{figure.height};
  for (const Shape& shape : figure.shapes) text += std::visit(writer, shape);
  return text + "</svg>\n";
}

}  // namespace patchproof
