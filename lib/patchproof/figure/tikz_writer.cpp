#include <patchproof/figure/tikz_writer.hpp>

#include <map>
#include <set>

#include <patchproof/figure/decimal.hpp>

namespace patchproof {

namespace {

std::string place_text(const Place& place) {
  return "(" + decimal(place.x, 2) + "," + decimal(place.y, 2) + ")";
}

std::string colour_name(Ink ink) { return "patchproof-" + std::string{style_of(ink).name}; }

std::string path(const std::vector<Place>& places) {
  std::string text;
  for (const Place& place : places) text += (text.empty() ? "" : "--") + place_text(place);
  return text;
}

std::string width_of(Ink ink) { return decimal(Rational{style_of(ink).width, 100}, 2) + "mm"; }

// The anchor is the side of the text that is turned to the place.
std::string anchor_of(Side side) {
  switch (side) {
    case Side::right:
      return "west";
    case Side::above_right:
      return "south west";
    case Side::above:
      return "south";
    case Side::above_left:
      return "south east";
    case Side::left:
      return "east";
    case Side::below_left:
      return "north east";
    case Side::below:
      return "north";
    default:
      return "north west";
  }
}

struct Writer {
  const LabelText& label_text;

  // The thin line of the same colour closes the seams between neighbours.
  std::string operator()(const Polygon& p) const {
    return "\\filldraw[" + colour_name(p.ink) + "!" + std::to_string(p.strength) + "!white]" +
           path(p.corners) + "--cycle;\n";
  }
  std::string operator()(const Polyline& p) const {
    return "\\draw[" + colour_name(p.ink) + ",line width=" + width_of(p.ink) + "]" +
           path(p.places) + ";\n";
  }
  std::string operator()(const Arrow& a) const {
    return "\\draw[" + colour_name(a.ink) + ",line width=" + width_of(a.ink) + ",->]" +
           path({a.from, a.to}) + ";\n";
  }
  std::string operator()(const Dot& d) const {
    return "\\fill[" + colour_name(d.ink) + "]" + place_text(d.at) +
           " circle[radius=" + width_of(d.ink) + "];\n";
  }
  std::string operator()(const Label& l) const {
    return "\\node[anchor=" + anchor_of(l.side) + "] at " + place_text(l.at) + " {$" +
           label_text(l.name) + "$};\n";
  }
};

Ink ink_of(const Shape& shape) {
  return std::visit(
      [](const auto& p) {
        if constexpr (std::is_same_v<std::decay_t<decltype(p)>, Label>)
          return Ink::axis;
        else
          return p.ink;
      },
      shape);
}

}  // namespace

std::string tikz(const Figure& figure, const LabelText& label_text) {
  std::set<Ink> used;
  for (const Shape& shape : figure.shapes)
    if (!std::holds_alternative<Label>(shape)) used.insert(ink_of(shape));
  std::string text;
  for (const std::string& note : figure.notes) text += "% " + note + "\n";
  text +=
      "\\begin{tikzpicture}[x=1mm,y=1mm,line width=0.12mm,line cap=round,line join=round,\n"
      "  inner sep=0.8mm,>=stealth]\n";
  for (const Ink ink : used) {
    const std::array<int, 3>& c = style_of(ink).colour;
    text += "\\definecolor{" + colour_name(ink) + "}{RGB}{" + std::to_string(c[0]) + "," +
            std::to_string(c[1]) + "," + std::to_string(c[2]) + "}\n";
  }
  for (const Shape& shape : figure.shapes) text += std::visit(Writer{label_text}, shape);
  return text + "\\end{tikzpicture}\n";
}

}  // namespace patchproof
