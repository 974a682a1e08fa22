#include <nlohmann/json.hpp>
#include <string_view>

#include <patchproof/language/dump.hpp>
#include <patchproof/language/kind_words.hpp>
#include <patchproof/language/position_table.hpp>

namespace patchproof {
namespace {

using namespace syntax;
using Json = nlohmann::ordered_json;

class Dumper {
 public:
  explicit Dumper(const SourceText& source) : positions_(source) {}

  Json json(const File& file) const {
    Json result = node("file", {});
    result["name"] = file.source->name;
    for (const Include& include : file.includes) {
      Json item = node("include", include.span);
      item["path"] = include.path;
      result["includes"].push_back(std::move(item));
    }
    add(result, "definitions", file.definitions);
    add(result, "cases", file.cases);
    return result;
  }

 private:
  Json node(std::string_view kind, const Span& span) const {
    const Position position = positions_.at(span.begin);
    Json result = Json::object();
    result["kind"] = kind;
    result["line"] = position.line;
    result["column"] = position.column;
    return result;
  }

  /// Nodes under a key; nothing when there are none.
  template <typename Value>
  void add(Json& object, const char* key, const std::vector<Value>& values) const {
    if (values.empty()) return;
    Json array = Json::array();
    for (const Value& value : values) array.push_back(json(value));
    object[key] = std::move(array);
  }
  template <typename Value>
  void add(Json& object, const char* key, const std::optional<Value>& value) const {
    if (value) object[key] = json(*value);
  }
  void add(Json& object, const char* key, const ExpressionPointer& value) const {
    if (value) object[key] = json(value);
  }

  Json json(const std::string& text) const { return text; }
  Json json(int number) const { return number; }
  Json json(const Rational& number) const { return to_text(number); }

  Json json(const Name& name) const {
    Json result = node("name", name.span);
    result["text"] = name.text;
    return result;
  }

  Json json(const Interval& interval) const {
    Json result = node("interval", interval.first->span);
    add(result, "first", interval.first);
    add(result, "last", interval.last);
    return result;
  }

  Json json(const Binder& binder) const {
    Json result = node("binder", binder.name.span);
    result["name"] = binder.name.text;
    result["interval"] = json(binder.interval);
    return result;
  }

  Json json(const RangeBinder& binder) const {
    Json result = json(binder.name);
    result["range"] = json(binder.range);
    return result;
  }
  Json json(const Argument& argument) const {
    if (argument.binder) return json(*argument.binder);
    if (argument.interval) return json(*argument.interval);
    return argument.range ? json(*argument.range) : json(argument.value);
  }

  Json json(const ExpressionPointer& pointer) const {
    const Expression& expression = *pointer;
    Json result = node(text_of(expression.kind), expression.span);
    if (expression.parenthesised) result["parenthesised"] = true;
    if (expression.kind == Expression::Kind::number) result["value"] = json(expression.number);
    if (!expression.text.empty()) result["text"] = expression.text;
    if (!expression.signs.empty()) result["signs"] = expression.signs;
    add(result, "operands", expression.operands);
    add(result, "arguments", expression.arguments);
    add(result, "rows", expression.rows);
    return result;
  }

  Json json(const std::vector<ExpressionPointer>& row) const {
    Json result = node("row", row.front()->span);
    add(result, "entries", row);
    return result;
  }

  Json json(const Comparison& comparison) const {
    Json result = node("comparison", comparison.span);
    add(result, "operators", comparison.operators);
    if (comparison.on_boundary) result["on_boundary"] = true;
    add(result, "operands", comparison.operands);
    return result;
  }

  Json json(const Edge& edge) const {
    Json result = node("edge", edge.patch.span);
    result["patch"] = edge.patch.text;
    result["parameter"] = edge.parameter.text;
    add(result, "value", edge.value);
    return result;
  }

  Json json(const Joint& joint) const {
    Json result = node("joint", joint.span);
    if (joint.geometric) result["geometric"] = true;
    result["order"] = joint.order;
    result["first"] = json(joint.first);
    result["second"] = json(joint.second);
    add(result, "with", joint.functions);
    return result;
  }

  Json json(const Minimum& minimum) const {
    Json result = node("minimum", minimum.span);
    add(result, "candidate", minimum.candidate);
    add(result, "functional", minimum.functional);
    result["competitor"] = minimum.competitor.text;
    add(result, "where", minimum.constraints);
    return result;
  }

  Json json(const Proposition& proposition) const {
    Json result = node("proposition", proposition.span);
    add(result, "comparisons", proposition.comparisons);
    add(result, "joint", proposition.joint);
    add(result, "further_joints", proposition.further_joints);
    add(result, "minimum", proposition.minimum);
    return result;
  }

  /// A proposition under a key; nothing when there is none.
  void add_stated(Json& object, const char* key, const Proposition& proposition) const {
    if (proposition.span.source) object[key] = json(proposition);
  }

  Json json(const Smoothness& smoothness) const {
    Json result = node("smoothness", smoothness.span);
    result["order"] = smoothness.order;
    return result;
  }

  Json json(const Notation& notation) const {
    Json result = node("notation", notation.span);
    result["name"] = notation.name.text;
    result["latex"] = notation.latex;
    return result;
  }

  Json json(const Range& range) const {
    Json result = node("range", range.span);
    add(result, "lower", range.lower);
    add(result, "upper", range.upper);
    return result;
  }

  Json json(const ParameterGroup& group) const {
    Json result = node("parameters", group.names.front().span);
    add(result, "names", group.names);
    result["range"] = json(group.range);
    return result;
  }

  Json json(const Declarator& declarator) const {
    Json result = node("declarator", declarator.name.span);
    result["name"] = declarator.name.text;
    add(result, "extents", declarator.extents);
    add(result, "parameters", declarator.parameters);
    add(result, "value", declarator.value);
    if (declarator.file) result["file"] = declarator.file->path;
    return result;
  }

  Json json(const SplineData& spline) const {
    Json result = node(spline.merged ? "merged" : "bspline", spline.control_points->span);
    add(result, spline.merged ? "bezier_points" : "control_points", spline.control_points);
    add(result, "degrees", spline.degrees);
    add(result, "weights", spline.weights);
    add(result, "knots", spline.knots);
    if (spline.knots.empty()) result["clamped_uniform"] = true;
    return result;
  }

  Json json(const Statement& statement) const {
    using Kind = Statement::Kind;
    Json result = node(text_of(statement.kind), statement.span);
    const bool has_text = statement.kind == Kind::title || statement.kind == Kind::quote ||
                          statement.kind == Kind::source;
    if (has_text) result["text"] = statement.text;
    add(result, "language", statement.language);
    add(result, "section", statement.section);
    add(result, "page", statement.page);
    add(result, "tags", statement.tags);
    add(result, "limit", statement.limit_kind);
    add(result, "value", statement.limit_value);
    add(result, "unit", statement.limit_unit);
    add(result, "notations", statement.notations);
    add(result, "derivatives", statement.derivative_style);
    add(result, "parameters", statement.parameters);
    add(result, "declarators", statement.declarators);
    add(result, "smoothness", statement.smoothness);
    if (statement.space) {
      result["space"] = json(*statement.space);
      result["dimension"] = statement.dimension;
    }
    add(result, "degrees", statement.degrees);
    add(result, "spline", statement.spline);
    add(result, "binders", statement.binders);
    add(result, "label", statement.label);
    add(result, "unknowns", statement.unknowns);
    const char* stated = statement.kind == Kind::derive ? "from" : "proposition";
    add_stated(result, stated, statement.proposition);
    add_stated(result, "printed", statement.printed);
    add_stated(result, "corrected", statement.corrected);
    add(result, "gives", statement.gives);
    add(result, "leaves", statement.leaves);
    if (statement.inconsistent) result["inconsistent"] = true;
    add(result, "using", statement.clauses.using_labels);
    add(result, "for", statement.clauses.binders);
    add(result, "note", statement.note);
    add(result, "shown", statement.shown);
    add(result, "shown", statement.shown_joint);
    return result;
  }

  Json json(const FormalType& type) const {
    Json result = node("type", type.span);
    result["name"] = text_of(type.kind);
    add(result, "parameters", type.parameters);
    return result;
  }

  Json json(const Formal& formal) const {
    Json result = node("formal", formal.name.span);
    result["name"] = formal.name.text;
    result["type"] = json(formal.type);
    return result;
  }

  Json json(const Definition& definition) const {
    Json result = node("definition", definition.span);
    result["name"] = definition.name.text;
    add(result, "formals", definition.formals);
    if (definition.result.span.source) result["type"] = json(definition.result);
    add(result, "statements", definition.statements);
    add(result, "value", definition.value);
    return result;
  }

  Json json(const Case& item) const {
    Json result = node("case", item.span);
    result["name"] = item.name.text;
    add(result, "statements", item.statements);
    return result;
  }

  PositionTable positions_;
};

}  // namespace

std::string dump(const syntax::File& file) {
  // Invalid UTF-8 would make nlohmann's dump throw; it is replaced instead.
  return Dumper(*file.source).json(file).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace patchproof
