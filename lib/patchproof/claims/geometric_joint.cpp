#include <patchproof/claims/geometric_joint.hpp>

namespace patchproof {

namespace {

// The terms a joint is written in, all at one place of the text.
struct Terms {
  Span span;

  Term sum(std::vector<Term> terms) const {
    const Type type = terms.front().type();
    return terms.size() == 1 ? terms.front()
                             : make_term(Operation::sum, type, std::move(terms), {}, span);
  }
  Term times(std::vector<Term> scalars, const Term& last) const {
    const Type type = last.type();
    scalars.push_back(last);
    return make_term(Operation::product, type, std::move(scalars), {}, span);
  }
  Term minus(const Term& a, const Term& b) const {
    return sum({a, make_term(Operation::negation, b.type(), {b}, {}, span)});
  }
  Term dot(const Term& a, const Term& b) const {
    return make_term(Operation::dot, Type::scalar(), {a, b}, {}, span);
  }
  Term cross(const Term& a, const Term& b) const {
    return make_term(Operation::cross, a.type(), {a, b}, {}, span);
  }
  // Zero exactly when the two are linearly dependent: a vector in space, a number in the plane.
  Term parallel(const Term& a, const Term& b) const {
    if (a.type().dimension == 3) return cross(a, b);
    const auto part = [&](const Term& t, int k) {
      return make_term(Operation::component, Type::scalar(), {t}, Indices{k}, span);
    };
    return minus(times({part(a, 0)}, part(b, 1)), times({part(a, 1)}, part(b, 0)));
  }
  Term zero(const Type& type) const {
    if (type.is_scalar()) return number_term(0, span);
    std::vector<Term> zeros(type.component_count(), number_term(0, span));
    return make_term(Operation::tuple, type, std::move(zeros), {}, span);
  }
  Statement vanishes(const Term& term) const {
    return {term, Relation::equal, zero(term.type()), span};
  }
  Statement positive(const Term& term) const {
    return {term, Relation::greater, number_term(0, span), span};
  }
};

class Joint {
 public:
  Joint(const JointEdge& first, const JointEdge& second, const std::vector<Term>& along,
        const Span& span)
      : first_{first}, second_{second}, along_{along}, terms_{span} {}

  Statement meet() const { return {p(0, 0), Relation::equal, r(0), terms_.span}; }

  // With the connecting functions given.
  void curve(const std::vector<Term>& f, std::vector<Statement>& result) const {
    result.push_back({r(1), Relation::equal, terms_.times({f[0]}, p(1, 0)), terms_.span});
    result.push_back(terms_.positive(f[0]));
    if (f.size() == 1) return;
    result.push_back(
        {r(2), Relation::equal,
         terms_.sum({terms_.times({f[0], f[0]}, p(2, 0)), terms_.times({f[1]}, p(1, 0))}),
         terms_.span});
  }
  void patch(const std::vector<Term>& f, std::vector<Statement>& result) const {
    const Term &alpha = f[0], &gamma = f[1];
    result.push_back({r(1), Relation::equal,
                      terms_.sum({terms_.times({alpha}, p(1, 0)), terms_.times({gamma}, p(0, 1))}),
                      terms_.span});
    result.push_back(terms_.positive(alpha));
    if (f.size() == 2) return;
    result.push_back({r(2), Relation::equal,
                      terms_.sum({second_order(alpha, gamma), terms_.times({f[2]}, p(1, 0)),
                                  terms_.times({f[3]}, p(0, 1))}),
                      terms_.span});
  }

  // Without them.
  void curve(int order, std::vector<Statement>& result) const {
    const Term length = terms_.dot(p(1, 0), p(1, 0));
    const Term alpha = terms_.dot(p(1, 0), r(1));  // times `length`
    result.push_back(terms_.vanishes(terms_.parallel(p(1, 0), r(1))));
    result.push_back(terms_.positive(alpha));
    if (order == 1) return;
    const Term rest =
        terms_.minus(terms_.times({length, length}, r(2)), terms_.times({alpha, alpha}, p(2, 0)));
    result.push_back(terms_.vanishes(terms_.parallel(p(1, 0), rest)));
  }
  void patch(int order, std::vector<Statement>& result) const {
    if (first_.function.type().inner->dimension == 2) {
      // In the plane every vector is a combination: only regularity and the side are left.
      result.push_back(terms_.positive(
          terms_.times({terms_.parallel(p(0, 1), p(1, 0))}, terms_.parallel(p(0, 1), r(1)))));
      return;
    }
    const Term normal = terms_.cross(p(0, 1), p(1, 0));
    const Term alpha = terms_.dot(normal, terms_.cross(p(0, 1), r(1)));  // times normal^2
    const Term gamma = terms_.dot(normal, terms_.cross(r(1), p(1, 0)));  // times normal^2
    result.push_back(terms_.vanishes(terms_.dot(normal, r(1))));
    result.push_back(terms_.positive(alpha));
    if (order == 1) return;
    const Term square = terms_.dot(normal, normal);
    const Term rest =
        terms_.minus(terms_.times({square, square}, r(2)), second_order(alpha, gamma));
    result.push_back(terms_.vanishes(terms_.dot(normal, rest)));
  }

 private:
  // P across and along, R across the edge, both in the direction from P to R.
  Term p(int across, int beside) const {
    return edge_derivative(first_, across, beside, !first_.at_end, along_, terms_.span);
  }
  Term r(int across) const {
    return edge_derivative(second_, across, 0, second_.at_end, along_, terms_.span);
  }
  // alpha^2*P_vv + 2*alpha*gamma*P_uv + gamma^2*P_uu
  Term second_order(const Term& alpha, const Term& gamma) const {
    return terms_.sum({terms_.times({alpha, alpha}, p(2, 0)),
                       terms_.times({number_term(2, terms_.span), alpha, gamma}, p(1, 1)),
                       terms_.times({gamma, gamma}, p(0, 2))});
  }

  const JointEdge& first_;
  const JointEdge& second_;
  const std::vector<Term>& along_;
  Terms terms_;
};

}  // namespace

std::size_t connecting_function_count(const JointEdge& edge, int order) {
  return static_cast<std::size_t>(order) * edge.function.type().parameters.size();
}

std::optional<std::string> why_not_geometric(const JointEdge& edge) {
  const Type& type = edge.function.type();
  const Type& value = *type.inner;
  const bool fits = value.is_point() && (value.dimension == 2 || value.dimension == 3);
  if (fits && type.parameters.size() <= 2) return std::nullopt;
  return "a G^k joint without its connecting functions needs curves or patches in R^2 or R^3, and "
         "the values here are a " +
         to_text(value);
}

std::vector<Statement> geometric_joint(const JointEdge& first, const JointEdge& second, int order,
                                       const std::vector<Term>& along,
                                       const std::vector<Term>& functions, const Span& span) {
  const Joint joint{first, second, along, span};
  std::vector<Statement> result{joint.meet()};
  if (order == 0) return result;
  const bool curve = first.function.type().parameters.size() == 1;
  if (!functions.empty() && curve) joint.curve(functions, result);
  if (!functions.empty() && !curve) joint.patch(functions, result);
  if (functions.empty() && curve) joint.curve(order, result);
  if (functions.empty() && !curve) joint.patch(order, result);
  return result;
}

}  // namespace patchproof
