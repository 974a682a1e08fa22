#include <recheck/node_reader.hpp>

#include <recheck/types.hpp>

namespace recheck {

namespace {

const std::vector<std::string_view>& operation_names() {
  static const std::vector<std::string_view> names{
      "number",      "pi",          "symbol",        "tuple",          "matrix",      "sum",
      "negation",    "product",     "quotient",      "power",          "sine",        "cosine",
      "exponential", "square_root", "lambda",        "apply",          "derivative",  "component",
      "entry",       "slice",       "transpose",     "matrix_product", "determinant", "dot",
      "cross",       "bernstein",   "bspline_basis", "integral",       "definition"};
  return names;
}

/// Reads the nodes one by one; each sees those before it.
class NodeReader {
 public:
  NodeReader(const std::vector<Symbol>& symbols, const Limits& limits)
      : symbols_{symbols}, limits_{limits} {}

  void read(const Place& place) {
    Node node;
    node.operation = static_cast<Operation>(place["operation"].one_of(operation_names()));
    payload(place, node);
    if (place.has("children"))
      for (const Place& child : place["children"].items()) {
        const std::size_t index = child.whole(limits_.nodes);
        if (index >= nodes_.size()) child.fail("a child has to stand before its parent");
        node.children.push_back(index);
      }
    try {
      node.type = type_of(node, nodes_, symbols_, limits_);
    } catch (const WrongType& error) {
      place.fail(error.what());
    }
    note_any_coordinate(node);
    nodes_.push_back(std::move(node));
  }

  std::vector<Node> nodes() && { return std::move(nodes_); }

 private:
  // What an operation has beside its children.
  void payload(const Place& place, Node& node) {
    const auto members = [&](std::vector<std::string_view> names) {
      names.push_back("operation");
      place.require_members(names);
    };
    switch (node.operation) {
      case Operation::number:
        members({"value"});
        node.number = place["value"].number();
        return;
      case Operation::pi:
        return members({});
      case Operation::symbol:
        members({"symbol"});
        node.symbol = place["symbol"].whole(symbols_.size());
        return;
      case Operation::tuple:
        members({"children", "?any_dimension"});
        node.type.any = place.has("any_dimension") && place["any_dimension"].truth();
        return;
      case Operation::matrix:
        members({"children", "rows", "columns"});
        node.type.rows = place["rows"].whole(limits_.extent + 1);
        node.type.columns = place["columns"].whole(limits_.extent + 1);
        return;
      case Operation::power:
        members({"children", "exponent"});
        node.exponent = place["exponent"].integer(limits_.exponent);
        return;
      case Operation::lambda:
        members({"children", "formals"});
        for (const Place& formal : place["formals"].items())
          node.formals.push_back(formal.whole(symbols_.size()));
        return;
      case Operation::derivative:
        members({"children", "orders"});
        return indices(place["orders"], node);
      case Operation::component:
      case Operation::entry:
      case Operation::slice:
        members({"children", "indices"});
        return indices(place["indices"], node);
      case Operation::bernstein:
        members({"children", "degree", "index"});
        node.indices = {place["degree"].whole(limits_.extent),
                        place["index"].whole(limits_.extent)};
        return;
      case Operation::bspline_basis:
        members({"children", "degree", "index", "span", "knots"});
        for (const std::string_view name : {"degree", "index", "span"})
          node.indices.push_back(place[name].whole(limits_.extent));
        for (const Place& knot : place["knots"].items()) node.knots.push_back(knot.number());
        return;
      case Operation::definition:
        members({"children", "name"});
        place["name"].text();
        return;
      default:
        return members({"children"});
    }
  }

  void note_any_coordinate(Node& node) const {
    for (const NodeIndex child : node.children) {
      const bool here = node.operation == Operation::component && nodes_[child].type.any;
      node.has_any_coordinate = node.has_any_coordinate || here || nodes_[child].has_any_coordinate;
    }
  }

  void indices(const Place& place, Node& node) const {
    for (const Place& index : place.items()) node.indices.push_back(index.whole(limits_.extent));
  }

  const std::vector<Symbol>& symbols_;
  const Limits& limits_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<Node> nodes_of(const Place& table, const std::vector<Symbol>& symbols,
                           const Limits& limits) {
  const std::vector<Place> places = table.items();
  if (places.size() > limits.nodes) table.fail("there are too many nodes");
  NodeReader reader{symbols, limits};
  for (const Place& place : places) reader.read(place);
  return std::move(reader).nodes();
}

std::vector<std::set<SymbolIndex>> free_symbols_of(const std::vector<Node>& nodes,
                                                   const Place& table, const Limits& limits) {
  std::vector<std::set<SymbolIndex>> result;
  std::size_t kept = 0;
  for (const Node& node : nodes) {
    std::set<SymbolIndex> free;
    if (node.operation == Operation::symbol) free.insert(node.symbol);
    for (const NodeIndex child : node.children) {
      free.insert(result[child].begin(), result[child].end());
      if (node.operation == Operation::definition) break;
    }
    for (const SymbolIndex formal : node.formals) free.erase(formal);
    kept += free.size();
    if (kept > limits.kept) table.fail("there are too many symbols in too many nodes");
    result.push_back(std::move(free));
  }
  return result;
}

}  // namespace recheck
