#include <patchproof/language/builtin_splines.hpp>

namespace patchproof {

Term net_of(const syntax::Expression& value, const std::vector<syntax::Binder>& binders,
            const Span& span, const Scope& scope, Elaborator& elaborator) {
  if (binders.empty() || binders.size() > 2)
    throw Fault{span, "a net needs one or two running indices"};
  std::vector<int> extents;
  for (const syntax::Binder& binder : binders) {
    const auto [first, last] = elaborator.interval(binder.interval, scope);
    if (first != 0)
      throw Fault{binder.name.span,
                  "the indices of a net start at 0, not at " + std::to_string(first)};
    extents.push_back(last + 1);
  }
  std::vector<Term> entries;
  for (const std::vector<int>& values : elaborator.combinations(binders, scope)) {
    elaborator.workshop().count_term(span);
    const Scope inner = Elaborator::bound(scope, binders, values);
    entries.push_back(
        decayed(elaborator.construct().value(inner, elaborator.expression(value, inner))));
  }
  if (binders.size() == 1) return elaborator.construct().list(std::move(entries), span);
  std::vector<std::vector<Term>> rows(static_cast<std::size_t>(extents[0]));
  for (std::size_t k = 0; k < entries.size(); ++k)
    rows[k / static_cast<std::size_t>(extents[1])].push_back(entries[k]);
  return elaborator.construct().matrix(scope, std::move(rows), span);
}

Term net_from(const syntax::FileName& file, const Scope& scope, Elaborator& elaborator) {
  if (file.path.empty()) throw Fault{file.span, "the path of a net is empty"};
  const NetFile* read = elaborator.library().net(path_of(file));
  if (read != nullptr && read->mistake)
    throw Fault{read->mistake->span, read->mistake->message, read->mistake->help};
  if (read == nullptr || !read->net)
    throw Fault{file.span, "cannot read '" + path_of(file) + "'",
                "the path is taken from the folder of the file of the case"};
  const PointNet& net = *read->net;
  std::vector<std::vector<Term>> rows(net.rows);
  for (std::size_t i = 0; i < net.rows; ++i) {
    for (std::size_t j = 0; j < net.columns; ++j) {
      std::vector<Term> coordinates;
      for (std::size_t k = 0; k < net.dimension; ++k)
        coordinates.push_back(number_term(net.coordinate(i, j, k), file.span));
      elaborator.workshop().count_term(file.span);
      rows[i].push_back(net.dimension == 1 ? coordinates[0]
                                           : elaborator.construct().tuple(
                                                 scope, std::move(coordinates), file.span));
    }
  }
  if (net.rows == 1) return elaborator.construct().list(std::move(rows[0]), file.span);
  return elaborator.construct().matrix(scope, std::move(rows), file.span);
}

}  // namespace patchproof
