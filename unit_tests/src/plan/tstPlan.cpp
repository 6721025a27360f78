#include "plan/Plan.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using namespace Rhegma;

constexpr Quantity heat("heat"), push("push"), pushAgain("push");

Call<2> call(const char* label, std::vector<Read> reads, Quantities writes, Quantities addsTo = {})
{
  return {Stage::Scatter, label, std::move(reads), std::move(writes), std::move(addsTo), [](State<2>&) {}};
}

Effect<2> effectOf(std::vector<Call<2>> calls)
{
  Effect<2> effect;
  effect.name = "Test";
  effect.calls = std::move(calls);
  return effect;
}

std::string refusal(std::vector<Call<2>> calls)
{
  try
  {
    makePlan<2>({effectOf(std::move(calls))});
  }
  catch (const std::logic_error& error)
  {
    return error.what();
  }
  return "";
}

TEST(Plan, ReadWithoutWriterIsRefused)
{
  EXPECT_EQ(refusal({call("reader", {heat}, {})}),
            "effect Test, stage Scatter, call \"reader\", quantity \"heat\": it is read and no call of the "
            "plan writes it");
  EXPECT_EQ(refusal({call("reader", {ifWritten(heat)}, {})}), "");
  EXPECT_EQ(refusal({call("reader", {heat}, {}), call("writer", {}, {}, {heat})}), "");
}

TEST(Plan, WhatAnEffectProvidesMayBeRead)
{
  Effect<2> effect = effectOf({call("reader", {heat}, {})});
  effect.provides = {heat};
  EXPECT_NO_THROW(makePlan<2>({effect}));
}

TEST(Plan, DuplicatesAreRefused)
{
  EXPECT_NE(refusal({call("one", {}, {push}), call("other", {}, {pushAgain})}).find("has this name"),
            std::string::npos);
  EXPECT_NE(refusal({call("writer", {}, {push, push})}).find("lists it twice"), std::string::npos);
  EXPECT_NE(refusal({call("one", {}, {push}), call("other", {}, {push})}).find("in which order"),
            std::string::npos);
}

TEST(Plan, WritersComeBeforeReaders)
{
  const auto plan = makePlan<2>(
      {effectOf({call("c", {heat, push}, {}), call("b", {push}, {heat}), call("a", {}, {push})})});
  std::string order;
  for (const Call<2>& c : plan.calls[static_cast<int>(Stage::Scatter)])
    order += c.label;
  EXPECT_EQ(order, "abc");
}

TEST(Plan, PrintsWhatCallsReadAndWrite)
{
  const auto plan = makePlan<2>({effectOf({call("a", {}, {push}), call("b", {push}, {heat}, {push})})});
  const std::string text = printPlan(plan, State<2>());
  EXPECT_NE(text.find("    a: writes push\n    b: reads push; writes heat; adds to push\n"),
            std::string::npos)
      << text;
}

} // namespace
