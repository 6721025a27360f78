/// Functions in a process of their own.

#include "material/InChild.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace Rhegma
{
namespace Test
{

namespace
{

TEST(InChild, Answers)
{
  int here = 1;
  const std::string text = "one\ntwo = 3 <" + std::string(100000, 'x');
  const ChildEnd end = inChild(
      [&](ChildTalk& talk)
      {
        here = 2;            // of the copy
        talk.stage('a', 61); // the number of the letter that begins an answer
        talk.stage('b', 60);
        talk.answer(text);
      });
  EXPECT_EQ(end.how, ChildEnd::How::Answered);
  EXPECT_EQ(end.answer, text);
  EXPECT_EQ(end.stage, 'b');
  EXPECT_EQ(here, 1);
}

TEST(InChild, SaysHowTheProcessEnded)
{
  ChildEnd end = inChild(
      [](ChildTalk& talk)
      {
        talk.stage('c', 60);
        std::fprintf(stderr, "\n  no such table\n");
        std::exit(0);
      });
  EXPECT_EQ(end.how, ChildEnd::How::Exited);
  EXPECT_EQ(end.stage, 'c');
  EXPECT_EQ(end.said, "no such table");
  end = inChild([](ChildTalk&) { _exit(0); });
  EXPECT_EQ(end.how, ChildEnd::How::Exited);
  end = inChild([](ChildTalk&) { std::raise(SIGBUS); });
  EXPECT_EQ(end.how, ChildEnd::How::Killed);
  EXPECT_EQ(end.signal, SIGBUS);
}

/// A limit of no time: the process does not end by itself.
TEST(InChild, EndsAProcessThatIsLate)
{
  const ChildEnd end = inChild(
      [](ChildTalk& talk)
      {
        talk.stage('d', 0);
        for (;;)
          pause();
      });
  EXPECT_EQ(end.how, ChildEnd::How::Late);
  EXPECT_EQ(end.stage, 'd');
}

} // namespace

} // namespace Test
} // namespace Rhegma
