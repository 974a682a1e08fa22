#pragma once

#include <memory>
#include <optional>
#include <string>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/loader.hpp>
#include <patchproof/language/syntax.hpp>
#include <patchproof/net/point_net.hpp>

namespace patchproof {

/// How many points a net of a case may have: as many as terms, each of which is looked at many
/// times.
inline constexpr std::size_t most_points_of_case = 10'000;

/// A file that a case takes a net from. Neither when it cannot be read.
struct NetFile {
  std::shared_ptr<const PointNet> net;
  /// What is wrong with it, and where.
  std::optional<Diagnostic> mistake;
};

/// Reads the points of `net d from "file.csv"`.
NetFile net_file(const std::string& path, const Loader& load);

/// The path of a net that a declaration takes from a file, as seen from the current directory.
std::string path_of(const syntax::FileName& file);

}  // namespace patchproof
