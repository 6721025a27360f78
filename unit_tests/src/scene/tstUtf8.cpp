/// UTF-8 and control characters in names.

#include "scene/Utf8.hpp"

#include <gtest/gtest.h>

#include <string>

using namespace Rhegma;

/// Every character is its own valid text, and every shorter part of its bytes is not.
TEST(Utf8, AcceptsEveryCharacterAndNoPartOfOne)
{
  for (unsigned long code = 1; code <= 0x10ffff; ++code)
  {
    const std::string character = utf8(code);
    ASSERT_EQ(character.empty(), code >= 0xd800 && code < 0xe000) << code;
    ASSERT_EQ(firstNotUtf8(character), std::string::npos) << code;
    for (std::size_t bytes = 1; bytes < character.size(); ++bytes)
      ASSERT_EQ(firstNotUtf8("ab" + character.substr(0, bytes) + "c"), 2U) << code;
  }
  EXPECT_EQ(firstNotUtf8(""), std::string::npos);
}

/// Longer codes than necessary, a surrogate, what is beyond the last character, bytes that follow none.
TEST(Utf8, RefusesWhatIsNoCharacter)
{
  for (const char* wrong : {"\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                            "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\x80", "\xFF"})
    EXPECT_EQ(firstNotUtf8(std::string("a") + wrong), 1U) << wrong;
}

TEST(Utf8, NamesMayHaveLettersOfAllScriptsButNoControlCharacters)
{
  for (const char* name : {"Plate 1", "Tr\u00e4ger \u00b5", "\u88c2\u7f1d", "\U0001F600", "a > b: c/d"})
  {
    EXPECT_EQ(mistakeInName(name), "") << name;
    EXPECT_EQ(printable(name), name);
  }
  for (unsigned long code = 1; code < 0x200; ++code)
    EXPECT_EQ(mistakeInName("a" + utf8(code)).empty(), code >= 0xa0 || (code >= 0x20 && code < 0x7f)) << code;
  EXPECT_NE(mistakeInName("a\nb").find("U+000A (end of a line)"), std::string::npos);
  EXPECT_NE(mistakeInName("a\xE4").find("the byte 0xE4 is not UTF-8 (in ISO-8859-1 it is \"\u00e4\")"),
            std::string::npos);
  EXPECT_EQ(printable("a\x1b[1m\x7f\u009b\xE4z"), "a<U+001B>[1m<U+007F><U+009B><0xE4>z");
}
