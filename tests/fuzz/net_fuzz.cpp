// Fuzz target of the readers of nets. The first byte chooses one of them and the size of blocks.
// Whatever the text, reading ends with a net or with a mistake inside of the text; the size of
// blocks does not matter; a net that was read is the same after it was written, as lines and as
// JSON.

#include <algorithm>
#include <cstdint>
#include <string>

#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_reader.hpp>
#include <patchproof/net/net_writer.hpp>
#include <tests/fuzz/law.hpp>

namespace {

using namespace patchproof;

/// The net as JSON, or the mistake.
std::string found_in(const std::string& text, bool json, std::size_t block) {
  std::size_t at = 0;
  const ByteSource source = [&text, at, block]() mutable {
    const std::string_view next = std::string_view{text}.substr(std::min(at, text.size()), block);
    at += block;
    return next;
  };
  try {
    return net_as_json(json ? net_from_json(source) : net_from_csv(source));
  } catch (const NetFault& fault) {
    if (fault.begin > fault.end || fault.begin > text.size())
      fuzz::violated("a mistake is inside of the text", text);
    return "mistake at " + std::to_string(fault.begin) + ": " + fault.message;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool json = (data[0] & 1U) != 0;
  const std::size_t block = 1 + (data[0] >> 1U);
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string found = found_in(text, json, text.size() + 1);
  if (found_in(text, json, block) != found) fuzz::violated("blocks do not matter", text);
  if (found.starts_with("mistake")) return 0;
  // A long decimal is two long numbers as a fraction, which may be more than is read.
  const std::string read_again = found_in(found, true, block);
  if (read_again.find("characters") != std::string::npos) return 0;
  if (read_again != found) fuzz::violated("JSON is read as it was written", text);
  PointNet net = net_from_json(whole_text(found));
  const PointNet again = net_from_csv(whole_text(net_as_csv(net)));
  if (again.coordinates != net.coordinates || again.rows != net.rows)
    fuzz::violated("lines are read as they were written", text);
  return 0;
}
