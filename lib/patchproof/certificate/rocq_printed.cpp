#include <patchproof/certificate/rocq_printed.hpp>

#include <patchproof/certificate/rocq_reader.hpp>

namespace patchproof {

namespace {

constexpr std::size_t nowhere = std::string_view::npos;

// Where it goes on behind "NAME =" at the start of a line.
std::size_t behind_heading(std::string_view output, const std::string& name, std::string_view sign,
                           std::size_t from) {
  for (std::size_t at = from; at < output.size();) {
    const bool at_line_start = at == 0 || output[at - 1] == '\n';
    if (at_line_start && output.substr(at, name.size()) == name) {
      const RocqToken next = rocq_token(output, at + name.size());
      const bool whole = rocq_token(output, at).text == name;
      if (whole && next.text == sign) return next.position + next.text.size();
    }
    const std::size_t line_end = output.find('\n', at);
    if (line_end == nowhere) break;
    at = line_end + 1;
  }
  return nowhere;
}

// Where the lines end that are indented, the first one included whatever it is.
std::size_t end_of_paragraph(std::string_view output, std::size_t from) {
  std::size_t at = output.find('\n', from);
  while (at != nowhere && at + 1 < output.size() && output[at + 1] == ' ')
    at = output.find('\n', at + 1);
  return at == nowhere ? output.size() : at;
}

RocqPrinted definition(std::string_view output, const std::string& name, std::size_t& at) {
  RocqPrinted result{name, nullptr, "", ""};
  const std::size_t begin = behind_heading(output, name, "=", at);
  if (begin == nowhere) {
    result.problem = "Rocq has not printed " + name;
    return result;
  }
  at = begin;
  try {
    const RocqReading body = rocq_term_at_front(output.substr(begin));
    const RocqToken colon = rocq_token(output, begin + body.end);
    if (colon.text != ":")
      throw RocqUnreadable{"expected the type, found '" + std::string{colon.text.substr(0, 40)} + "'"};
    const std::size_t type_begin = colon.position + 1;
    const auto [type, length] = rocq_type_at_front(output.substr(type_begin));
    result.term = body.term;
    result.type = type;
    at = type_begin + length;
  } catch (const RocqUnreadable& error) {
    result.problem = "what Rocq printed of " + name + " cannot be read: " + error.what();
  }
  return result;
}

RocqPrinted theorem(std::string_view output, const std::string& name, std::size_t& at) {
  RocqPrinted result{name, nullptr, "", ""};
  const std::size_t begin = behind_heading(output, name, ":", at);
  if (begin == nowhere) {
    result.problem = "Rocq has not printed " + name;
    return result;
  }
  at = end_of_paragraph(output, begin);
  try {
    result.term = rocq_term(output.substr(begin, at - begin));
  } catch (const RocqUnreadable& error) {
    result.problem = "what Rocq printed of " + name + " cannot be read: " + error.what();
  }
  if (at < output.size()) ++at;
  return result;
}

}  // namespace

std::vector<RocqPrinted> rocq_printed(std::string_view output,
                                      const std::vector<std::string>& definitions,
                                      const std::vector<std::string>& theorems) {
  std::vector<RocqPrinted> result;
  std::size_t at = 0;
  for (const std::string& name : definitions) result.push_back(definition(output, name, at));
  for (const std::string& name : theorems) result.push_back(theorem(output, name, at));
  return result;
}

}  // namespace patchproof
