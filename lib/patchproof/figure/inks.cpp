#include <patchproof/figure/figure.hpp>

namespace patchproof {

const std::vector<InkStyle>& inks() {
  static const std::vector<InkStyle> table{
      {Ink::surface, "surface", {126, 166, 204}, 6},
      {Ink::back, "back", {222, 190, 138}, 6},
      {Ink::stripe, "stripe", {52, 66, 84}, 6},
      {Ink::isoline, "isoline", {96, 108, 122}, 13},
      {Ink::boundary, "boundary", {24, 42, 66}, 40},
      {Ink::common, "common", {190, 40, 40}, 70},
      {Ink::wire, "wire", {60, 92, 132}, 18},
      {Ink::net, "net", {96, 96, 96}, 20},
      {Ink::net_point, "netpoint", {40, 40, 40}, 55},
      {Ink::twist, "twist", {176, 40, 70}, 40},
      {Ink::other, "other", {226, 164, 116}, 6},
      {Ink::other_curve, "othercurve", {176, 92, 24}, 40},
      {Ink::deviation, "deviation", {190, 40, 40}, 22},
      {Ink::axis, "axis", {120, 120, 120}, 15},
  };
  return table;
}

const InkStyle& style_of(Ink ink) { return inks().at(static_cast<std::size_t>(ink)); }

}  // namespace patchproof
