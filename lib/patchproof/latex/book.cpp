#include <array>
#include <map>

#include <patchproof/latex/claim_text.hpp>
#include <patchproof/latex/given_text.hpp>
#include <patchproof/latex/document.hpp>
#include <patchproof/latex/freshness.hpp>
#include <patchproof/latex/prose.hpp>
#include <patchproof/latex/verdict_text.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

std::string path_of(const Page& page) { return page.result.verified.span.source->name; }

std::string folder_of(const Page& page) {
  const std::string path = path_of(page);
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

// "cases/coons_to_bezier" -> "Coons to bezier"
std::string chapter_title(const std::string& folder, Language language) {
  std::string title = folder.substr(folder.rfind('/') + 1);
  for (char& c : title)
    if (c == '_') c = ' ';
  if (!title.empty() && title.front() >= 'a' && title.front() <= 'z')
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
  return title.empty() || title == "." ? word(Word::count, language) : latex_escaped(title);
}

std::string erratum_text(const Page& page, const ClaimDerivation& item, bool goes_on,
                         const Wording& wording) {
  const ClaimResult& result = page.result.claims.at(item.claim);
  const Claim& claim = result.claim;
  const Case& given = page.result.verified;
  std::string text;
  const bool printed = claim.verb == "printed";
  if (!goes_on)
    text += "\\ppclaim{" + title_text(given, wording.language) + ", " +
            wording(Word::page) + "~\\pageref{case:" + given.name + "}}{" +
            latex_escaped(common_label(claim)) + "}\n";
  text += "\\pptext{" + wording(printed ? Word::printed : Word::corrected) + ":}\n";
  const std::string statement = statement_text(claim, wording);
  text += printed ? "\\begin{ppstruck}\n" + statement + "\\end{ppstruck}\n" : statement;
  if (printed && result.decision.verdict == Verdict::refuted)
    text += refutation_text(result.decision, {}, wording);
  if (result.outcome != Outcome::as_expected) text += verdict_text(result, wording);
  if (!printed && !claim.note.empty())
    text += "\\pptext{" + wording(Word::note) + ": " + prose(claim.note) + "}\n";
  return text;
}

std::string errata_text(const std::vector<Page>& pages, Language language) {
  std::string text;
  for (const Page& page : pages) {
    const Wording wording{page.derivation.names, language};
    std::string label;
    for (const ClaimDerivation& item : page.derivation.claims) {
      const Claim& claim = page.result.claims.at(item.claim).claim;
      if (claim.verb != "printed" && claim.verb != "corrected") continue;
      text += erratum_text(page, item, claim.verb == "corrected" && label == common_label(claim),
                           wording);
      label = claim.verb == "printed" ? common_label(claim) : "";
    }
  }
  return text.empty() ? "" : "\n\\chapter{" + word(Word::errata, language) + "}\n" + text;
}

constexpr std::array<Verdict, 9> all_verdicts{
    Verdict::proved,       Verdict::proved_if, Verdict::refuted,
    Verdict::inconsistent, Verdict::vacuous,   Verdict::underdetermined,
    Verdict::unknown,      Verdict::error,     Verdict::internal};

using Counts = std::map<Verdict, std::size_t>;

std::string row(const std::string& title, const Counts& counts,
                const std::vector<Verdict>& columns) {
  std::string text = title;
  std::size_t sum = 0;
  for (const Verdict verdict : columns) {
    const auto found = counts.find(verdict);
    const std::size_t count = found == counts.end() ? 0 : found->second;
    sum += count;
    text += " & " + (count == 0 ? std::string{"--"} : std::to_string(count));
  }
  return text + " & " + std::to_string(sum) + " \\\\\n";
}

std::string table_text(const std::vector<Page>& pages, Language language) {
  Counts all;
  std::vector<std::pair<std::string, Counts>> folders;
  for (const Page& page : pages) {
    if (folders.empty() || folders.back().first != folder_of(page))
      folders.emplace_back(folder_of(page), Counts{});
    for (const ClaimResult& result : page.result.claims) {
      ++folders.back().second[result.decision.verdict];
      ++all[result.decision.verdict];
    }
  }
  std::vector<Verdict> columns;
  for (const Verdict verdict : all_verdicts)
    if (all.contains(verdict)) columns.push_back(verdict);
  std::string text = "\n\\chapter{" + word(Word::verdicts, language) + "}\n\\begin{pptable}{l*{" +
                     std::to_string(columns.size() + 1) + "}{r}}\n" + word(Word::subject, language);
  for (const Verdict verdict : columns) text += " & " + word(word_of(verdict), language);
  text += " & " + word(Word::total, language) + " \\\\\\hline\n";
  for (const auto& [folder, counts] : folders)
    text += row(chapter_title(folder, language), counts, columns);
  return text + "\\hline\n" + row(word(Word::total, language), all, columns) + "\\end{pptable}\n";
}

}  // namespace

std::string book(const std::vector<Page>& pages, const DocumentOptions& options) {
  std::vector<Origin> origins;
  std::vector<std::string> digests;
  for (const Page& page : pages) {
    origins.emplace_back(page.result.verified.name, path_of(page));
    digests.push_back(page.digest);
  }
  const Language language = options.language;
  std::string text = header_text(origins, book_digest(digests), options) + "\\def\\ppbook{}\n" +
                     preamble("book", language) + "\\begin{document}\n\\pptitle{" +
                     word(Word::book_title, language) + "}{" + word(Word::by_machine, language) +
                     " \\texttt{patchproof}.}\n\\tableofcontents\n";
  std::string folder;
  for (const Page& page : pages) {
    if (&page == &pages.front() || folder_of(page) != folder)
      text += "\n\\chapter{" + chapter_title(folder_of(page), language) + "}\n";
    folder = folder_of(page);
    text += "\\input{" + file_name(page.result.verified) + "}\n";
  }
  return text + errata_text(pages, language) + table_text(pages, language) + "\\end{document}\n";
}

}  // namespace patchproof
