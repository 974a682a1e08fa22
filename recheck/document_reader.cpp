#include <recheck/document_reader.hpp>

#include <recheck/proof_reader.hpp>

namespace recheck {

namespace {

constexpr std::size_t known_version = 1;

Certificate certificate_of(const Place& place, const Limits& limits) {
  place.require_members({"claim", "statement", "symbols", "nodes", "?proofs", "?refutation"});
  Certificate result;
  result.claim = place["claim"].text();
  place["statement"].text();
  result.symbols = symbols_of(place["symbols"], limits);
  result.nodes = nodes_of(place["nodes"], result.symbols, limits);
  result.free_symbols = free_symbols_of(result.nodes, place["nodes"], limits);
  if (place.has("proofs") == place.has("refutation"))
    place.fail("a certificate has either 'proofs' or a 'refutation'");
  if (place.has("refutation")) {
    result.refutation = refutation_of(place["refutation"], result, limits);
    return result;
  }
  const std::vector<Place> proofs = place["proofs"].items();
  if (proofs.empty()) place["proofs"].fail("there is nothing shown");
  for (const Place& proof : proofs) result.proofs.push_back(proof_of(proof, result, limits));
  return result;
}

}  // namespace

Document document_of(const std::string& text, const Limits& limits) {
  const nlohmann::json json = json_of(text, limits);
  const Place place{json, ""};
  place.require_members({"format", "version", "program", "case", "certificates"});
  place["format"].one_of({"patchproof certificate"});
  const std::size_t version = place["version"].whole(limits.extent);
  if (version != known_version)
    place["version"].fail("version " + std::to_string(version) + " is not known, only version 1");
  place["program"].text();
  Document document{place["case"].text(), {}};
  for (const Place& certificate : place["certificates"].items())
    document.certificates.push_back(certificate_of(certificate, limits));
  return document;
}

}  // namespace recheck
