#include <verify/certified.hpp>
#include <verify/files.hpp>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <patchproof/certificate/certificates.hpp>
#include <patchproof/certificate/rocq_library.hpp>
#include <patchproof/latex/sha256.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* record_name = "certified.json";
constexpr const char* format_name = "patchproof certified";

bool contains(const std::vector<std::string>& list, const std::string& entry) {
  return std::find(list.begin(), list.end(), entry) != list.end();
}

std::vector<std::string> strings(const Json& object, const char* member) {
  return object.at(member).get<std::vector<std::string>>();
}

// The words of the statements mean what the support library says: another one makes them others.
std::string library_digest() {
  std::string all;
  for (const auto& [name, text] : rocq_library_files())
    all += std::string{name} + "\n" + std::string{text};
  return sha256(all);
}

CheckedFolder from_json(const Json& record) {
  CheckedFolder result;
  if (record.at("format") != format_name || record.at("version") != 1)
    throw std::invalid_argument{"another format or version"};
  if (record.at("library") != library_digest())
    throw std::invalid_argument{"it was checked with another support library; certify anew"};
  result.coqc = record.at("coqc").get<std::string>();
  for (const Json& file : record.at("files"))
    result.files.push_back({file.at("case").get<std::string>(), file.at("file").get<std::string>(),
                            file.at("digest").get<std::string>(), strings(file, "claims"),
                            strings(file, "left_out"), strings(file, "axioms")});
  return result;
}

}  // namespace

CaseCertificates certificates_of(const CaseResult& result) {
  CaseCertificates all;
  for (const ClaimResult& claim : result.claims) {
    auto found = certificate(claim, result.verified.name, result.verified.limits);
    if (auto* one = std::get_if<Certificate>(&found))
      all.certificates.push_back(std::move(*one));
    else
      all.missing.emplace_back(claim_id(result.verified, claim.claim),
                               std::get<NotCertified>(found).why);
  }
  return all;
}

std::string check_in_words(const std::string& coqc, const std::vector<std::string>& axioms) {
  std::string list;
  for (const std::string& axiom : axioms) list += (list.empty() ? "" : ", ") + axiom;
  return "coqc " + coqc + ", axioms: " + (list.empty() ? "none" : list);
}

std::vector<Certificate> without(const std::vector<Certificate>& certificates,
                                 const std::vector<std::string>& claims) {
  std::vector<Certificate> result;
  for (const Certificate& one : certificates)
    if (!contains(claims, one.claim)) result.push_back(one);
  return result;
}

std::string write_checked(const std::string& folder, const CheckedFolder& checked) {
  Json files = Json::array();
  for (const CheckedFile& file : checked.files)
    files.push_back({{"case", file.case_name},
                     {"file", file.file},
                     {"digest", file.digest},
                     {"claims", file.claims},
                     {"left_out", file.left_out},
                     {"axioms", file.axioms}});
  const Json record{{"format", format_name},           {"version", 1},
                    {"program", std::string{version}}, {"coqc", checked.coqc},
                    {"library", library_digest()},     {"files", std::move(files)}};
  const std::string path = (std::filesystem::path{folder} / record_name).string();
  const std::string problem = replace_file(path, record.dump(2) + "\n");
  return problem.empty() ? "" : "cannot write '" + path + "': " + problem;
}

std::string read_checked(const std::string& folder, CheckedFolder& checked) {
  const std::string path = (std::filesystem::path{folder} / record_name).string();
  const FileText text = file_text(path);
  if (!text.text) return "cannot read '" + path + "': " + text.problem;
  try {
    checked = from_json(Json::parse(*text.text));
  } catch (const std::exception& error) {
    return "'" + path + "' is no record of checked certificates: " + error.what();
  }
  return "";
}

CertifiedClaims certified_claims(const CheckedFolder& checked, const CaseResult& result) {
  const auto record =
      std::find_if(checked.files.begin(), checked.files.end(),
                   [&](const CheckedFile& one) { return one.case_name == result.verified.name; });
  if (record == checked.files.end()) return {};
  const CaseCertificates own = certificates_of(result);
  const std::string now =
      rocq_file(result.verified, without(own.certificates, record->left_out)).text;
  if (sha256(now) != record->digest) return {};
  return {record->claims, check_in_words(checked.coqc, record->axioms)};
}

void raise_evidence(const CheckedFolder& checked, Report& report) {
  for (FileReport& file : report.files)
    for (CaseResult& result : file.cases) {
      const CertifiedClaims certified = certified_claims(checked, result);
      for (ClaimResult& claim : result.claims)
        if (contains(certified.ids, claim_id(result.verified, claim.claim))) {
          claim.decision.evidence = Evidence::certified;
          claim.decision.certificate = certified.by;
        }
    }
}

}  // namespace patchproof
