#include <patchproof/latex/document.hpp>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/latex/claim_text.hpp>
#include <patchproof/latex/freshness.hpp>
#include <patchproof/latex/given_text.hpp>
#include <patchproof/latex/prose.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

std::string sources_text(const Case& given, const Wording& wording) {
  std::string text;
  for (const Source& source : given.sources) {
    text += "\\ppsource{" + wording(Word::source) + ": " + prose(source.work);
    if (!source.section.empty())
      text += ", " + wording(Word::section) + " " + prose(source.section);
    if (!source.page.empty()) text += ", " + wording(Word::page) + "~" + prose(source.page);
    text += "}";
  }
  return text;
}

std::string place_comment(const Claim& claim) {
  if (!claim.span.source) return "";
  std::string name = claim.span.source->name;
  for (char& c : name)
    if (c == '\n' || c == '\r') c = ' ';
  return "\n% case " + name + ":" +
         std::to_string(position_of(*claim.span.source, claim.span.begin).line) + "\n";
}

std::string body(const Page& page, const DocumentOptions& options) {
  const Case& given = page.result.verified;
  const Wording wording{page.derivation.names, options.language};
  std::string text = "\\ppcase{" + title_text(given, options.language) + "}{" +
                     latex_escaped(given.name) + "}{" + sources_text(given, wording) + "}\n" +
                     "\\label{case:" + given.name + "}\n";
  if (!given.quote.empty()) text += "\\ppquote{" + prose(given.quote) + "}\n";
  text += given_text(given, wording);
  std::string definitions;
  for (const std::string& written : given.written)
    definitions += "\\pptext{\\ppname{" + latex_escaped(written) + "}}\n";
  definitions += definitions_text(page.derivation.definitions, wording);
  if (!definitions.empty())
    text += "\\ppheading{" + wording(Word::definitions) + "}\n" + definitions;
  text += assumptions_text(given, wording);
  text += page.figure;
  std::string erratum;
  for (const ClaimDerivation& item : page.derivation.claims) {
    const ClaimResult& result = page.result.claims.at(item.claim);
    const Claim& claim = result.claim;
    const bool goes_on = claim.verb == "corrected" && erratum == common_label(claim);
    erratum = claim.verb == "printed" ? common_label(claim) : "";
    text += place_comment(claim) + claim_text(result, item, goes_on, wording,
                                              later_assumptions_text(given, claim, wording));
  }
  return text;
}

}  // namespace

std::string file_name(const Case& given) { return given.name + ".tex"; }

std::string preamble(const std::string& document_class, Language language) {
  return "\\documentclass[11pt,a4paper" + std::string{document_class == "book" ? ",openany" : ""} +
         "]{" + document_class + "}\n\\usepackage[" + babel_name(language) +
         "]{babel}\n\\usepackage{patchproof}\n";
}

std::string document(const Page& page, const DocumentOptions& options) {
  const std::string header = header_text(
      {{page.result.verified.name, page.result.verified.span.source->name}}, page.digest, options);
  if (options.fragment) return header + body(page, options);
  return header + "\\ifdefined\\ppbook\\else\n" + preamble("article", options.language) +
         "\\begin{document}\n\\fi\n" + body(page, options) +
         "\n\\ifdefined\\ppbook\\expandafter\\endinput\\fi\n\\end{document}\n";
}

}  // namespace patchproof
