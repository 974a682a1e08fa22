#include <patchproof/language/net_file.hpp>
#include <patchproof/net/net_fault.hpp>
#include <patchproof/net/net_reader.hpp>

namespace patchproof {

NetFile net_file(const std::string& path, const Loader& load) {
  std::optional<std::string> text = load ? load(path) : std::nullopt;
  if (!text) return {};
  NetLimits limits;
  limits.points = most_points_of_case;
  limits.help = "'patchproof segments' is for larger nets";
  try {
    return {std::make_shared<const PointNet>(net_from_file(path, whole_text(*text), limits)),
            std::nullopt};
  } catch (const NetFault& fault) {
    auto source = std::make_shared<const SourceText>(SourceText{path, std::move(*text)});
    return {nullptr,
            Diagnostic{{std::move(source), fault.begin, fault.end}, fault.message, fault.help}};
  }
}

std::string path_of(const syntax::FileName& file) {
  return path_beside(file.span.source->name, file.path);
}

}  // namespace patchproof
