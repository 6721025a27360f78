#include "scene/PositionFunction.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace Rhegma;

namespace
{

void expectRefused(const std::string& text, const std::string& piece)
{
  try
  {
    PositionFunction::parse(text, 2);
    ADD_FAILURE() << "accepted: " << text;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(piece), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

} // namespace

TEST(PositionFunction, HasAnExpressionForEachAxis)
{
  const Vector<2> v = PositionFunction::parse("2*x - y, max(x, y)", 2)(Vector<2>{{3.0, 5.0}});
  EXPECT_EQ(v[0], 1.0);
  EXPECT_EQ(v[1], 5.0);
  const Vector<3> w = PositionFunction::parse("z, x, pi - pi", 3)(Vector<3>{{3.0, 5.0, 7.0}});
  EXPECT_EQ(w[0], 7.0);
  EXPECT_EQ(w[1], 3.0);
  EXPECT_EQ(w[2], 0.0);
}

TEST(PositionFunction, DefinesNamesOneAfterAnother)
{
  const PositionFunction f = PositionFunction::parse("s = x*x + y*y; r = sqrt(s); x / r, r == 5", 2);
  const Vector<2> v = f(Vector<2>{{3.0, 4.0}});
  EXPECT_EQ(v[0], 0.6);
  EXPECT_EQ(v[1], 1.0);
  // Definitions follow the position.
  EXPECT_EQ(f(Vector<2>{{0.0, 2.0}})[0], 0.0);
}

TEST(PositionFunction, RefusesWhatIsNoFunctionOfPosition)
{
  expectRefused("", "empty");
  expectRefused("r = x;", "empty");
  expectRefused("x", "gives 1 value instead of 2");
  expectRefused("x, y, z", "gives 3 values instead of 2");
  expectRefused("t, y", "t");
  expectRefused("x = 2, y", "==");
  expectRefused("x = 2*y; x, y", "no new name");
  expectRefused("r = x; r = y; r, r", "no new name");
  expectRefused("2r = x; y, y", "not a function");
  expectRefused("r = x, y; r, r", "gives 2 values instead of 1");
  expectRefused("sqrt(x; y, y", "no new name");
}
