#include <algorithm>
#include <stdexcept>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/net_builder.hpp>
#include <patchproof/report/json_parts.hpp>
#include <patchproof/report/segments_report.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

std::string pair(std::size_t a, std::size_t b) {
  return "(" + std::to_string(a) + ", " + std::to_string(b) + ")";
}

std::string coordinate_name(std::size_t coordinate) {
  return std::string(1, "xyzw"[std::min<std::size_t>(coordinate, 3)]);
}

std::string times(std::size_t a, std::size_t b) {
  return std::to_string(a) + " x " + std::to_string(b);
}

SegmentsClaim surface_claim(const SegmentsReport& report) {
  const SegmentFindings& found = report.findings;
  SegmentsClaim claim{"segments",
                      "the " + times(found.u_spans, found.v_spans) +
                          " Bézier segments are the B-spline surface of the net",
                      found.are_the_surface,
                      "",
                      {}};
  if (!found.from_numbers) claim.remark = "as for every net";
  if (found.unused_points > 0)
    claim.remark += (claim.remark.empty() ? "" : "; ") + counted(found.unused_points, "point") +
                    " of the net without influence";
  return claim;
}

SegmentsClaim every_net_claim(const SegmentsReport& report) {
  const SegmentFindings& found = report.findings;
  const auto order = [](const SeamFindings& seams) {
    return seams.given_order < 0 ? std::string{"no continuity"}
                                 : "C^" + std::to_string(std::min(seams.order, seams.given_order));
  };
  return {"every net",
          "whatever the points, over these knots the segments are the surface, with " +
              order(found.u) + " in u and " + order(found.v) + " in v",
          found.for_every_net,
          order(found.u) + " in u, " + order(found.v) + " in v",
          {}};
}

SegmentsClaim seam_claim(const SegmentsReport& report, bool in_u) {
  const SeamFindings& found = in_u ? report.findings.u : report.findings.v;
  const KnotVector& knots = in_u ? report.u : report.v;
  const std::string letter = in_u ? "u" : "v";
  const std::string order = "C^" + std::to_string(found.order);
  SegmentsClaim claim{order + " in " + letter,
                      "the segments join with " + order + " at " + counted(found.seams, "knot") +
                          " in " + letter + ", " + counted(found.edges, "edge"),
                      !found.first_break,
                      "",
                      {}};
  const bool all_splines = found.order <= found.given_order || found.given_order == knots.degree();
  if (claim.proved) {
    if (found.seams == 0)
      claim.remark = "there is no seam";
    else if (all_splines && !report.findings.from_numbers)
      claim.remark = "as for every net";
    else if (!all_splines && found.given_order < 0)
      claim.remark = "for these points; the knots alone give no continuity";
    else if (!all_splines)
      claim.remark =
          "for these points; the knots alone give C^" + std::to_string(found.given_order);
    return claim;
  }
  const SeamBreak& broken = *found.first_break;
  const std::size_t span = in_u ? broken.u_span : broken.v_span;
  const std::string knot = to_text(knots.end_of(span));
  const int multiplicity = knots.multiplicity_behind(span);
  claim.witness = {
      {"seam", letter + " = " + knot + ", between the segments " +
                   pair(broken.u_span, broken.v_span) + " and " +
                   pair(broken.u_span + (in_u ? 1 : 0), broken.v_span + (in_u ? 0 : 1))},
      {"derivative", "of order " + std::to_string(broken.order) + " in " + letter +
                         ", Bézier coefficient " + std::to_string(broken.coefficient) +
                         " along the seam, coordinate " + coordinate_name(broken.coordinate)},
      {"before", to_text(broken.before)},
      {"behind", to_text(broken.behind)},
      {"edges", std::to_string(found.broken_edges) + " of " + counted(found.edges, "edge") +
                    " are not " + order}};
  const int given = knots.degree() - multiplicity;
  claim.witness.emplace_back(
      "knot",
      knot + " occurs " + (multiplicity == 1 ? "once" : std::to_string(multiplicity) + " times") +
          ": splines of degree " + std::to_string(knots.degree()) +
          (given < 0 ? " may have a gap there" : " are C^" + std::to_string(given) + " there"));
  return claim;
}

SegmentsClaim comparison_claim(const SegmentsReport& report) {
  SegmentsClaim claim{"against",
                      "the segments of " + report.against + " are these segments",
                      !report.first_difference,
                      "",
                      {}};
  if (claim.proved) return claim;
  const SegmentDifference& first = *report.first_difference;
  claim.witness = {
      {"segment", pair(first.u_span, first.v_span)},
      {"point", pair(first.k, first.l) + ", coordinate " + coordinate_name(first.coordinate)},
      {"exact", to_text(first.exact)},
      {"found", to_text(first.found)},
      {"points", std::to_string(report.different_points) + " of " +
                     counted(report.shape.points(), "point") +
                     (report.different_points == 1 ? " is different" : " are different")}};
  return claim;
}

std::string verdict_of(const SegmentsClaim& claim) { return claim.proved ? "PROVED" : "REFUTED"; }

std::string text_of(const SegmentsReport& report) {
  const std::vector<SegmentsClaim> claims = claims_of(report);
  std::string text = report.net + ": " + times(report.rows, report.columns) + " points in R^" +
                     std::to_string(report.shape.dimension) + ", degrees " +
                     pair(report.shape.u_degree, report.shape.v_degree) + ", " +
                     times(report.shape.u_spans, report.shape.v_spans) + " segments\n";
  std::size_t width = 0;
  for (const SegmentsClaim& claim : claims) width = std::max(width, claim.id.size());
  for (const SegmentsClaim& claim : claims)
    text += (claim.proved ? "  " : "! ") + claim.id +
            std::string(width - claim.id.size() + 2, ' ') + verdict_of(claim) +
            (claim.remark.empty() ? "" : "  (" + claim.remark + ")") + "\n";
  std::size_t refuted = 0;
  for (const SegmentsClaim& claim : claims) {
    if (claim.proved) continue;
    ++refuted;
    text += "\n" + claim.id + ": REFUTED: " + claim.statement + "\n";
    for (const auto& [name, value] : claim.witness)
      text += "       = " + name + ": " + value + "\n";
  }
  text += "\n" + counted(claims.size(), "claim") + ": " + std::to_string(claims.size() - refuted) +
          " proved" + (refuted > 0 ? ", " + std::to_string(refuted) + " refuted" : "") + "\n";
  return text;
}

std::string json_of(const SegmentsReport& report) {
  Json document;
  document["version"] = version;
  document["net"] = {{"file", report.net},
                     {"points", {report.rows, report.columns}},
                     {"dimension", report.shape.dimension},
                     {"degrees", {report.shape.u_degree, report.shape.v_degree}},
                     {"segments", {report.shape.u_spans, report.shape.v_spans}}};
  document["arithmetic"] = to_text(report.findings.arithmetic);
  document["bits"] = report.findings.bits;
  document["from_numbers"] = report.findings.from_numbers;
  document["claims"] = Json::array();
  for (const SegmentsClaim& claim : claims_of(report)) {
    Json witness = nullptr;
    for (const auto& [name, value] : claim.witness) witness[name] = value;
    document["claims"].push_back({{"id", claim.id},
                                  {"statement", claim.statement},
                                  {"verdict", verdict_of(claim)},
                                  {"remark", text_or_null(claim.remark)},
                                  {"witness", witness}});
  }
  document["exit"] = static_cast<int>(exit_code(report));
  return in_lines(document);
}

}  // namespace

std::vector<SegmentsClaim> claims_of(const SegmentsReport& report) {
  std::vector<SegmentsClaim> claims{every_net_claim(report), surface_claim(report),
                                    seam_claim(report, true), seam_claim(report, false)};
  if (!report.against.empty()) claims.push_back(comparison_claim(report));
  return claims;
}

ExitCode exit_code(const SegmentsReport& report) {
  if (!report.findings.are_the_surface || !report.findings.for_every_net) return ExitCode::internal;
  const std::vector<SegmentsClaim> claims = claims_of(report);
  const bool all = std::all_of(claims.begin(), claims.end(),
                               [](const SegmentsClaim& claim) { return claim.proved; });
  return all ? ExitCode::as_expected : ExitCode::wrong;
}

std::string written(const SegmentsReport& report, std::string_view format) {
  if (format == "json") return json_of(report);
  if (format == "text") return text_of(report);
  throw std::invalid_argument{"there is no format '" + std::string{format} + "'"};
}

}  // namespace patchproof
