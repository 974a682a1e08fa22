#include <patchproof/certificate/rocq_names.hpp>

#include <catch2/catch.hpp>

namespace patchproof {

namespace {

SymbolPointer symbol(const std::string& name, unsigned ordinal, const Type& type = Type::scalar()) {
  return std::make_shared<const Symbol>(Symbol{name, Symbol::Role::scalar, type, 0, ordinal});
}

}  // namespace

TEST_CASE("the entries of an array are one variable with indices") {
  RocqNames names;
  const SymbolPointer first = symbol("V[0,1]", 1);
  const SymbolPointer second = symbol("V[2,3]", 2);
  names.add(first);
  names.add(second);
  CHECK(names.text({first, 0}) == "V 0%nat 1%nat");
  CHECK(names.text({second, 0}) == "V 2%nat 3%nat");
  CHECK(names.variable(first).type() == "nat -> nat -> R");
}

TEST_CASE("coordinates are numbered after the indices") {
  RocqNames names;
  const SymbolPointer point = symbol("P[4]", 1, Type::point(3));
  names.add(point);
  CHECK(names.text({point, 2}) == "P 4%nat 2%nat");
}

TEST_CASE("two symbols of one name are two variables") {
  RocqNames names;
  const SymbolPointer a = symbol("a", 1);
  const SymbolPointer other = symbol("a", 2);
  const SymbolPointer entry = symbol("V[0]", 3);
  const SymbolPointer other_entry = symbol("V[0]", 4);
  for (const SymbolPointer& s : {a, other, entry, other_entry}) names.add(s);
  CHECK(names.text({a, 0}) == "a");
  CHECK(names.text({other, 0}) == "a_2");
  CHECK(names.text({entry, 0}) == "V 0%nat");
  CHECK(names.text({other_entry, 0}) == "V_0");
}

TEST_CASE("arrays of other shapes are other variables") {
  RocqNames names;
  const SymbolPointer list = symbol("V[0]", 1);
  const SymbolPointer net = symbol("V[0,0]", 2);
  names.add(list);
  names.add(net);
  CHECK(names.text({list, 0}) == "V 0%nat");
  CHECK(names.text({net, 0}) == "V_2 0%nat 0%nat");
}

TEST_CASE("words of Rocq and of the library are no names") {
  RocqNames names;
  CHECK(names.fresh("forall") == "forall_2");
  CHECK(names.fresh("Var") == "Var_2");
  CHECK(names.fresh("I") == "I_2");
  CHECK(names.fresh("Hyp1") == "xHyp1");
}

TEST_CASE("only letters, digits, underscore and prime are in names") {
  CHECK(rocq_identifier("ext.g1.exact") == "ext_g1_exact");
  CHECK(rocq_identifier("r'") == "r'");
  CHECK(rocq_identifier("0a") == "x0a");
  CHECK(rocq_identifier("") == "x");
  CHECK(rocq_identifier("a[i=0,j=1]") == "a_i_0_j_1");
  CHECK(rocq_identifier("\xce\xb1") == "xcexb1");
}

}  // namespace patchproof
