#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patchproof {

/// The words that begin a statement of a case, and `end`: "title", ..., "show", "end".
const std::vector<std::string>& statement_keywords();

/// The words that begin something at file level: "case", "define", "include".
const std::vector<std::string>& file_keywords();

/// The words that stand inside statements and are therefore never names: "using", "from", ...
///
/// Labels are the exception, they may be any word.
const std::vector<std::string>& inner_keywords();

/// Whether the word, as the first of its line, ends the statement before it.
bool begins_statement(std::string_view word);

/// Whether the word begins something at file level.
bool begins_file_item(std::string_view word);

/// Whether the word is one of `inner_keywords`.
bool is_inner_keyword(std::string_view word);

}  // namespace patchproof
