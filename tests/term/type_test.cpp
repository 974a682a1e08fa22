#include <patchproof/term/type.hpp>

#include <catch2/catch.hpp>

using patchproof::to_text;
using patchproof::Type;

TEST_CASE("types are named as in a textbook") {
  const Type any = Type::point(Type::any_dimension);
  const Type space = Type::point(3);
  CHECK(to_text(Type::scalar()) == "scalar");
  CHECK(to_text(any) == "point");
  CHECK(to_text(space) == "point in R^3");
  CHECK(to_text(Type::matrix(4, 4, space)) == "4 x 4 matrix of points in R^3");
  CHECK(to_text(Type::matrix(2, 3, Type::scalar())) == "2 x 3 matrix of scalars");
  CHECK(to_text(Type::matrix(1, 1, Type::scalar())) == "1 x 1 matrix of scalar");
  CHECK(to_text(Type::matrix(4, 1, any, true)) == "list of 4 points");
  CHECK(to_text(Type::matrix(1, 1, space, true)) == "list of 1 point in R^3");
  CHECK(to_text(Type::function({"u"}, any)) == "curve(u)");
  CHECK(to_text(Type::function({"u", "v"}, space)) == "patch(u, v)");
  CHECK(to_text(Type::function({"t"}, Type::scalar())) == "scalar function(t)");
  CHECK(to_text(Type::function({"u", "v"}, Type::scalar())) == "scalar function(u, v)");
  CHECK(to_text(Type::function({"u", "v", "w"}, any)) == "volume(u, v, w)");
  CHECK(to_text(Type::function({"t"}, Type::matrix(2, 2, any))) == "matrix function(t)");
}

TEST_CASE("types are equal when their shapes are") {
  const Type any = Type::point(Type::any_dimension);
  CHECK(Type::scalar() == Type::scalar());
  CHECK(Type::point(3) == Type::point(3));
  CHECK_FALSE(Type::point(3) == Type::point(2));
  CHECK_FALSE(Type::point(3) == any);
  CHECK_FALSE(Type::scalar() == any);
  CHECK(Type::matrix(2, 1, any) == Type::matrix(2, 1, any, true));
  CHECK_FALSE(Type::matrix(2, 3, any) == Type::matrix(3, 2, any));
  CHECK_FALSE(Type::matrix(2, 3, any) == Type::matrix(2, 2, any));
  CHECK_FALSE(Type::matrix(2, 3, any) == Type::matrix(2, 3, Type::point(3)));
  CHECK(Type::function({"u", "v"}, any) == Type::function({"s", "t"}, any));
  CHECK_FALSE(Type::function({"u", "v"}, any) == Type::function({"u"}, any));
  CHECK_FALSE(Type::function({"u"}, any) == Type::function({"u"}, Type::scalar()));
}

TEST_CASE("a type has as many components as scalars make up a value") {
  const Type any = Type::point(Type::any_dimension);
  CHECK(Type::scalar().component_count() == 1);
  CHECK(any.component_count() == 1);
  CHECK(Type::point(3).component_count() == 3);
  CHECK(Type::matrix(4, 5, Type::point(3)).component_count() == 60);
  CHECK(Type::matrix(4, 5, any).component_count() == 20);
  CHECK(Type::function({"u", "v"}, Type::point(2)).component_count() == 2);
}
