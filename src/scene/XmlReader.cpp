#include "scene/XmlReader.hpp"

#include "scene/Utf8.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace Rhegma
{

namespace
{

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// A character that no XML text may hold.
bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 && !isBlank(c); }

bool startsName(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool isInName(char c) { return startsName(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; }

/// What a reference stands for, without its & and ; (empty: nothing known).
std::string meaningOf(std::string_view reference)
{
  constexpr std::array<std::pair<std::string_view, char>, 5> known{
      {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
  for (const auto& [name, letter] : known)
    if (reference == name)
      return std::string(1, letter);
  if (reference.size() < 2 || reference[0] != '#')
    return {};
  const bool hexadecimal = reference[1] == 'x';
  const std::string digits(reference.substr(hexadecimal ? 2 : 1));
  if (digits.empty() || digits.size() > 8 ||
      digits.find_first_not_of(hexadecimal ? "0123456789abcdefABCDEF" : "0123456789") != std::string::npos)
    return {};
  const std::string character = utf8(std::stoul(digits, nullptr, hexadecimal ? 16 : 10));
  return character.size() == 1 && isControl(character[0]) ? std::string() : character;
}

} // namespace

std::size_t XmlReader::lineOf(std::size_t at) const
{
  return 1 + std::count(text_.begin(), text_.begin() + std::min(at, text_.size()), '\n');
}

void XmlReader::fail(std::size_t at, const std::string& reason) const
{
  throw XmlError("line " + std::to_string(lineOf(at)) + ": " + reason);
}

const std::string* XmlReader::find(std::string_view attribute) const
{
  for (std::size_t k = numAttributes_; k-- > 0;)
    if (attributes_[k].name == attribute)
      return &attributes_[k].value;
  return nullptr;
}

XmlReader::Item XmlReader::next()
{
  if (closes_)
  {
    closes_ = false;
    tag_ = open_.back().tag;
    open_.pop_back();
    ended_ = open_.empty();
    return Item::Closing;
  }
  while (at_ < text_.size())
  {
    start_ = at_;
    if (text_[at_] != '<')
    {
      if (readText())
        return Item::Text;
    }
    else if (startsWith("<!--"))
      skipComment();
    else if (startsWith("<?"))
      skipDeclaration();
    else
      return startsWith("</") ? readClosing() : readOpening();
  }
  start_ = at_;
  if (!open_.empty())
    fail(at_, "the file ended before closing <" + std::string(open_.back().tag) + "> of line " +
                  std::to_string(lineOf(open_.back().at)));
  if (!ended_)
    throw XmlError("the file holds no element");
  return Item::End;
}

/// \return whether the text up to the next tag is more than blanks
bool XmlReader::readText()
{
  const std::size_t end = std::min(text_.find('<', at_), text_.size());
  std::size_t from = at_, to = end;
  while (from < to && isBlank(text_[from]))
    ++from;
  at_ = end;
  if (from == to)
    return false;
  start_ = from;
  if (const auto control = std::find_if(text_.begin() + from, text_.begin() + to, isControl);
      control != text_.begin() + to)
    fail(control - text_.begin(), "an invalid character");
  if (open_.empty())
    fail(from, ended_ ? "text after the end of the first element" : "text before the first tag");
  while (isBlank(text_[to - 1]))
    --to;
  content_ = std::string_view(text_).substr(from, to - from);
  return true;
}

void XmlReader::skipComment()
{
  const std::size_t dashes = text_.find("--", at_ + 4);
  if (dashes == std::string::npos)
    fail(at_, "a comment without its end -->");
  if (at(dashes + 2) != '>')
    fail(dashes, "-- within a comment; only its end has it: -->");
  at_ = dashes + 3;
}

void XmlReader::skipDeclaration()
{
  const std::size_t end = text_.find("?>", at_);
  if (end == std::string::npos)
    fail(at_, "a declaration <? without its end ?>");
  at_ = end + 2;
}

bool XmlReader::skipBlanks()
{
  const std::size_t before = at_;
  while (at_ < text_.size() && isBlank(text_[at_]))
    ++at_;
  return at_ > before;
}

std::string_view XmlReader::readName()
{
  const std::size_t begin = at_;
  if (startsName(at(at_)))
    while (isInName(at(at_)))
      ++at_;
  return std::string_view(text_).substr(begin, at_ - begin);
}

XmlReader::Item XmlReader::readOpening()
{
  ++at_;
  tag_ = readName();
  if (tag_.empty())
    fail(start_, "a < that begins no tag (write &lt; for <)");
  if (ended_)
    fail(start_, "another element after the end of the first one");
  numAttributes_ = 0;
  for (;;)
  {
    const bool apart = skipBlanks();
    if (at_ >= text_.size())
      fail(at_, "the file ended before closing <" + std::string(tag_));
    if (text_[at_] == '>' || (text_[at_] == '/' && at(at_ + 1) == '>'))
      break;
    if (!apart)
      fail(at_, "an invalid character in <" + std::string(tag_) + ">, or no blank before an attribute");
    readAttribute();
  }
  closes_ = text_[at_] == '/';
  at_ += closes_ ? 2 : 1;
  open_.push_back({tag_, start_});
  return Item::Opening;
}

void XmlReader::readAttribute()
{
  const std::size_t begin = at_;
  if (attributes_.size() == numAttributes_)
    attributes_.emplace_back();
  Attribute& attribute = attributes_[numAttributes_];
  attribute.name = readName();
  const std::string name(attribute.name);
  if (name.empty())
    fail(begin, "an invalid character in <" + std::string(tag_) + ">");
  skipBlanks();
  if (at(at_) != '=')
    fail(at_, "the attribute " + name + " has no value; write " + name + "=\"...\"");
  ++at_;
  skipBlanks();
  const char quote = at(at_);
  if (quote != '"' && quote != '\'')
    fail(at_, "the value of the attribute " + name + " is not in quotes; write " + name + "=\"...\"");
  ++at_;
  readValue(quote, attribute.value);
  ++numAttributes_;
}

void XmlReader::readValue(char quote, std::string& value)
{
  const std::size_t begin = at_;
  value.clear();
  for (std::size_t from = at_;; ++at_)
  {
    const char c = at(at_);
    const bool special = c == quote || c == '<' || c == '&' || isControl(c);
    if (!special)
      continue;
    value.append(text_, from, at_ - from);
    if (c == quote)
      break;
    if (at_ >= text_.size())
      fail(begin, "a value without its closing quote");
    if (c == '<')
      fail(at_, "an invalid character in an attribute value (write &lt; for < and &amp; for &), or a value "
                "without its closing quote");
    if (c != '&')
      fail(at_, "an invalid character in an attribute value");
    readReference(value);
    from = at_ + 1;
  }
  ++at_;
}

/// Ends at the ; of the reference.
void XmlReader::readReference(std::string& value)
{
  constexpr std::size_t longest = 12;
  const std::size_t end = text_.find(';', at_);
  const std::string meaning = end != std::string::npos && end - at_ <= longest
                                  ? meaningOf(std::string_view(text_).substr(at_ + 1, end - at_ - 1))
                                  : std::string();
  if (meaning.empty())
    fail(at_, at(at_ + 1) == '#' ? "a &# that gives no character which XML allows (write &amp; for &)"
                                 : "a & that begins no known reference (write &amp; for &)");
  value += meaning;
  at_ = end;
}

XmlReader::Item XmlReader::readClosing()
{
  at_ += 2;
  tag_ = readName();
  skipBlanks();
  if (at(at_) != '>')
    fail(start_, "a closing tag is not of the form </" +
                     (open_.empty() ? std::string("...") : std::string(open_.back().tag)) + ">");
  ++at_;
  if (open_.empty())
    fail(start_, "</" + std::string(tag_) + "> closes nothing");
  if (open_.back().tag != tag_)
    fail(start_, "</" + std::string(tag_) + "> does not close <" + std::string(open_.back().tag) +
                     "> of line " + std::to_string(lineOf(open_.back().at)));
  open_.pop_back();
  ended_ = open_.empty();
  return Item::Closing;
}

} // namespace Rhegma
