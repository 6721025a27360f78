/// The tags of an XML text, and what is no XML.

#include "scene/XmlReader.hpp"

#include <gtest/gtest.h>

using Rhegma::XmlError;
using Rhegma::XmlReader;

namespace
{

/// The items one after another: "<a x=1>" "'text'" "</a>".
std::string all(const std::string& text)
{
  XmlReader xml(text);
  std::string found;
  for (auto item = xml.next(); item != XmlReader::Item::End; item = xml.next())
    if (item == XmlReader::Item::Text)
      found += "'" + std::string(xml.content()) + "'";
    else if (item == XmlReader::Item::Closing)
      found += "</" + std::string(xml.tag()) + ">";
    else
    {
      found += "<" + std::string(xml.tag());
      for (std::size_t k = 0; k < xml.numAttributes(); ++k)
        found += " " + std::string(xml.attribute(k).name) + "=" + xml.attribute(k).value;
      found += ">";
    }
  return found;
}

/// The message for a text that is no XML.
std::string refusal(const std::string& text)
{
  try
  {
    all(text);
  }
  catch (const XmlError& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(XmlReader, TagsAttributesAndTexts)
{
  EXPECT_EQ(all("<a/>"), "<a></a>");
  EXPECT_EQ(all("<?xml version=\"1.0\"?>\n<!-- a > b -->\n<a x=\"1\" y = '2\"'>\n <b />  word \n</a >\n<!-- "
                "end -->\n"),
            "<a x=1 y=2\"><b></b>'word'</a>");
  EXPECT_EQ(all("<a.b-c_1:d x=\"a > b/>\"></a.b-c_1:d>"), "<a.b-c_1:d x=a > b/>></a.b-c_1:d>");
}

TEST(XmlReader, DecodesReferencesInValues)
{
  EXPECT_EQ(all("<a x=\"t &lt; 1 &amp;&gt; &quot;&apos;&#65;&#x42;\"/>"), "<a x=t < 1 &> \"'AB></a>");
  EXPECT_EQ(all("<a x=\"&#xe9;&#8364;&#x1F600;\"/>"), "<a x=\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80></a>");
  for (const char* wrong : {"&", "&;", "&nbsp;", "&lt", "&#;", "&#x;", "&#0;", "&#xD800;", "&#x110000;",
                            "&#1a;", "&#1;", "&#x1b;"})
    EXPECT_NE(refusal("<a x=\"" + std::string(wrong) + "\"/>").find("&amp;"), std::string::npos) << wrong;
}

TEST(XmlReader, FindsAttributes)
{
  const std::string text = "<a x=\"1\" y=\"2\"><b y=\"3\"/></a>";
  XmlReader xml(text);
  xml.next();
  ASSERT_NE(xml.find("y"), nullptr);
  EXPECT_EQ(*xml.find("y"), "2");
  EXPECT_EQ(xml.find("z"), nullptr);
  xml.next();
  EXPECT_EQ(xml.find("x"), nullptr);
  EXPECT_EQ(*xml.find("y"), "3");
}

TEST(XmlReader, CountsLines)
{
  const std::string text = "<a>\n\n<b\nx=\"1\"/>\n</a>";
  XmlReader xml(text);
  std::vector<std::size_t> lines;
  while (xml.next() != XmlReader::Item::End)
    lines.push_back(xml.line());
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 3, 3, 5}));
}

TEST(XmlReader, RefusesWhatIsNoXml)
{
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"", "no element"},
      {" \n", "no element"},
      {"<!-- only -->", "no element"},
      {"word <a/>", "line 1: text before the first tag"},
      {"<a/> word", "line 1: text after"},
      {"<a/>\n<b/>", "line 2: another element"},
      {"<a>\n</b>", "line 2: </b> does not close <a> of line 1"},
      {"</a>", "closes nothing"},
      {"<a>\n<b></a>", "line 2: </a> does not close <b> of line 2"},
      {"<a>\n<b>\n", "line 3: the file ended before closing <b> of line 2"},
      {"<a x=\"1\"", "ended before closing <a"},
      {"<a x=\"1", "without its closing quote"},
      {"<a x=\"1<b/>\"/>", "&lt;"},
      {"<a x=\"1\"y=\"2\"/>", "no blank before"},
      {"<a x/>", "has no value"},
      {"<a x=1/>", "not in quotes"},
      {"<a 1=\"x\"/>", "invalid character in <a>"},
      {"< a/>", "begins no tag"},
      {"<1/>", "begins no tag"},
      {"<!DOCTYPE a><a/>", "begins no tag"},
      {"<a><![CDATA[x]]></a>", "begins no tag"},
      {"<!-- a -- b --><a/>", "within a comment"},
      {"<!-- a", "without its end -->"},
      {"<?xml", "without its end ?>"},
      {"<a></a", "not of the form </a>"},
      {std::string("<a x=\"\0\"/>", 10), "invalid character in an attribute value"},
      {std::string("<a>\1</a>"), "an invalid character"},
  };
  for (const auto& [text, part] : wrong)
    EXPECT_NE(refusal(text).find(part), std::string::npos) << text << "\n" << refusal(text);
}
