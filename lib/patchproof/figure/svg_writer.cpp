#include <patchproof/figure/svg_writer.hpp>

#include <set>

#include <patchproof/figure/decimal.hpp>
#include <patchproof/figure/labels.hpp>

namespace patchproof {

namespace {

constexpr int margin = 2;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
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

int sideways(Side side) {
  if (side == Side::left || side == Side::above_left || side == Side::below_left) return -1;
  return side == Side::above || side == Side::below ? 0 : 1;
}

int upwards(Side side) {
  if (side == Side::below || side == Side::below_left || side == Side::below_right) return -1;
  return side == Side::left || side == Side::right ? 0 : 1;
}

// Where the base line of the text begins, ends or has its middle.
Place text_place(const Label& label) {
  const int up = upwards(label.side);
  const Rational dy = up == 0 ? Rational{-1} : up > 0 ? Rational{6, 5} : Rational{-16, 5};
  return {Rational{label.at.x + sideways(label.side) * Rational{6, 5}}, Rational{label.at.y + dy}};
}

/// What is drawn lies between these, labels too.
struct Frame {
  Rational left;
  Rational right;
  Rational bottom;
  Rational top;
};

Frame frame_of(const Figure& figure) {
  Frame frame{-margin, figure.width + margin, -margin, figure.height + margin};
  for (const Shape& shape : figure.shapes) {
    const auto* label = std::get_if<Label>(&shape);
    if (label == nullptr) continue;
    // Letters are about 2 mm wide and 3 mm high.
    const Place at = text_place(*label);
    const int width = 2 * static_cast<int>(label->name.size());
    const int direction = sideways(label->side);
    frame.left = std::min(frame.left, Rational{at.x - Rational{width * (1 - direction), 2}});
    frame.right = std::max(frame.right, Rational{at.x + Rational{width * (1 + direction), 2}});
    frame.bottom = std::min(frame.bottom, Rational{at.y - 1});
    frame.top = std::max(frame.top, Rational{at.y + 3});
  }
  return frame;
}

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
    const Place at = text_place(l);
    const int direction = sideways(l.side);
    std::string text = "<text x=\"" + x(at) + "\" y=\"" + y(at) + "\" text-anchor=\"" +
                       (direction < 0   ? "end"
                        : direction > 0 ? "start"
                                        : "middle") +
                       "\">" + escaped(parts.letters);
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
      "text { font: italic 3.6px 'Latin Modern Math', 'STIX Two Text', 'Times New Roman', serif "
      "}\n";
  for (const Ink ink : of_lines)
    text += "." + std::string{style_of(ink).name} +
            " { stroke: " + colour(style_of(ink).colour, 100) +
            "; stroke-width: " + length(style_of(ink).width) + " }\n";
  return text + "</style>\n" + tips + "</defs>\n";
}

}  // namespace

std::string svg(const Figure& figure) {
  const Frame frame = frame_of(figure);
  const std::string width = decimal(frame.right - frame.left, 2);
  const std::string height = decimal(frame.top - frame.bottom, 2);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
                     "mm\" height=\"" + height + "mm\" viewBox=\"" + decimal(frame.left, 2) + " " +
                     decimal(figure.height - frame.top, 2) + " " + width + " " + height + "\">\n";
  for (const std::string& note : figure.notes) text += "<desc>" + escaped(note) + "</desc>\n";
  text += styles(figure);
  const Writer writer{figure.height};
  for (const Shape& shape : figure.shapes) text += std::visit(writer, shape);
  return text + "</svg>\n";
}

}  // namespace patchproof
