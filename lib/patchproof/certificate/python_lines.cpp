#include <patchproof/certificate/python_lines.hpp>

namespace patchproof {

namespace {

constexpr std::size_t longest = 100;
// What is indented so far stands inside the brackets of a line before.
constexpr std::size_t inside_brackets = 8;

// A value without brackets around it gets them.
std::string with_brackets(const std::string& line) {
  for (const std::string& mark : {std::string{"return "}, std::string{" = "}}) {
    const std::size_t found = line.find(mark);
    // " = " may stand deep inside: not of an assignment.
    if (found == std::string::npos || line.find('(') < found) continue;
    const std::size_t value = found + mark.size();
    return line.substr(0, value) + "(" + line.substr(value) + ")";
  }
  return line;
}

std::string broken(const std::string& line) {
  const std::size_t indentation = line.find_first_not_of(' ');
  const std::string margin(indentation + 4, ' ');
  std::string result;
  std::string current;
  std::size_t depth = indentation >= inside_brackets ? 1 : 0;
  std::size_t last_space = std::string::npos;
  for (const char c : line) {
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
    current += c;
    if (c == ' ' && depth > 0 && current.find_first_not_of(' ') != std::string::npos)
      last_space = current.size() - 1;
    if (current.size() <= longest || last_space == std::string::npos) continue;
    result += current.substr(0, last_space) + "\n";
    current = margin + current.substr(last_space + 1);
    last_space = std::string::npos;
  }
  return result + current;
}

}  // namespace

std::string python_comment(const std::string& text, const std::string& indentation) {
  std::string result = indentation + "# ";
  for (const char c : text) {
    if (c == '\r') continue;
    result += c;
    if (c == '\n') result += indentation + "# ";
  }
  return result + "\n";
}

std::string python_lines(const std::string& code) {
  std::string result;
  for (std::size_t begin = 0; begin < code.size();) {
    const std::size_t end = code.find('\n', begin);
    std::string line = code.substr(begin, end - begin);
    begin = end == std::string::npos ? code.size() : end + 1;
    const std::size_t first = line.find_first_not_of(' ');
    if (line.size() > longest && line[first] != '#') {
      if (const std::size_t remark = line.find("  # "); remark != std::string::npos) {
        result += line.substr(0, first) + line.substr(remark + 2) + "\n";
        line.resize(remark);
      }
      line = broken(first >= inside_brackets ? line : with_brackets(line));
    }
    result += line + "\n";
  }
  return result;
}

}  // namespace patchproof
