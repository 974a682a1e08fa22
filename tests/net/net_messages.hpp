#pragma once

#include <memory>
#include <string>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_reader.hpp>

namespace patchproof {

/// What is shown of the first mistake in a file of points; "" when there is none. Blocks have so
/// many bytes, so that tokens go over their ends.
inline std::string net_message(const std::string& name, const std::string& text,
                               const NetLimits& limits = {}, std::size_t block = 3) {
  std::size_t at = 0;
  const ByteSource blocks = [&text, at, block]() mutable {
    const std::string_view next = std::string_view{text}.substr(std::min(at, text.size()), block);
    at += block;
    return next;
  };
  try {
    net_from_file(name, blocks, limits);
    return "";
  } catch (const NetFault& fault) {
    const auto source = std::make_shared<const SourceText>(SourceText{name, text});
    return to_text(Diagnostic{{source, fault.begin, fault.end}, fault.message, fault.help});
  }
}

}  // namespace patchproof
