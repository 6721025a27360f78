#include "scene/Utf8.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace Rhegma
{

namespace
{

/// Bytes of the character that begins a text; 0: it begins with none.
std::size_t lengthOfFirst(std::string_view text)
{
  const auto byte = [&](std::size_t k)
  { return k < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[k])) : 0u; };
  const auto follows = [&](std::size_t k, unsigned least = 0x80, unsigned most = 0xbf)
  { return byte(k) >= least && byte(k) <= most; };
  const unsigned first = byte(0);
  if (first < 0x80)
    return text.empty() ? 0 : 1;
  if (first >= 0xc2 && first <= 0xdf)
    return follows(1) ? 2 : 0;
  // Neither a longer code than necessary, nor a surrogate, nor beyond U+10FFFF.
  if (first >= 0xe0 && first <= 0xef)
    return follows(1, first == 0xe0 ? 0xa0 : 0x80, first == 0xed ? 0x9f : 0xbf) && follows(2) ? 3 : 0;
  if (first >= 0xf0 && first <= 0xf4)
    return follows(1, first == 0xf0 ? 0x90 : 0x80, first == 0xf4 ? 0x8f : 0xbf) && follows(2) && follows(3)
               ? 4
               : 0;
  return 0;
}

/// The first byte from `at` on that is not ASCII; the text's size where all are. Most scenes are ASCII, and
/// have megabytes where they have many bodies: eight bytes at once.
std::size_t skipAscii(std::string_view text, std::size_t at)
{
  constexpr std::uint64_t highBits = 0x8080808080808080u;
  std::uint64_t word = 0;
  for (; at + sizeof word <= text.size(); at += sizeof word)
  {
    std::memcpy(&word, text.data() + at, sizeof word);
    if ((word & highBits) != 0)
      break;
  }
  while (at < text.size() && static_cast<unsigned char>(text[at]) < 0x80)
    ++at;
  return at;
}

/// Whether a text is of ASCII characters without control characters.
bool isPlain(std::string_view text)
{
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

/// Whether a character is a control character (general category Cc), and its code.
bool isControlCharacter(std::string_view character, unsigned& code)
{
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(character[k]); };
  code = character.size() == 2 ? (byte(0) & 0x1fu) << 6 | (byte(1) & 0x3fu) : byte(0);
  return character.size() <= 2 && (code < 0x20 || (code >= 0x7f && code < 0xa0));
}

std::string hexadecimal(const char* format, unsigned number)
{
  char text[16];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

} // namespace

std::string utf8(unsigned long code)
{
  std::string text;
  const auto add = [&](unsigned long byte) { text += static_cast<char>(byte); };
  const auto more = [&](int shift) { add(0x80 | ((code >> shift) & 0x3f)); };
  if (code == 0 || code > 0x10ffff || (code >= 0xd800 && code < 0xe000))
    return text;
  if (code < 0x80)
    add(code);
  else if (code < 0x800)
    add(0xc0 | (code >> 6));
  else if (code < 0x10000)
    add(0xe0 | (code >> 12)), more(6);
  else
    add(0xf0 | (code >> 18)), more(12), more(6);
  if (code >= 0x80)
    more(0);
  return text;
}

std::size_t firstNotUtf8(std::string_view text)
{
  for (std::size_t at = skipAscii(text, 0); at < text.size(); at = skipAscii(text, at))
  {
    const std::size_t length = lengthOfFirst(text.substr(at, 4));
    if (length == 0)
      return at;
    at += length;
  }
  return std::string_view::npos;
}

std::string foreignByteText(char byte)
{
  const unsigned number = static_cast<unsigned char>(byte);
  return "the byte 0x" + hexadecimal("%02X", number) + " is not UTF-8" +
         (number >= 0xa0 ? " (in ISO-8859-1 it is \"" + utf8(number) + "\")" : std::string());
}

std::string mistakeInName(std::string_view name)
{
  if (isPlain(name))
    return {};
  if (const std::size_t at = firstNotUtf8(name); at != std::string_view::npos)
    return foreignByteText(name[at]) + "; write the name in UTF-8.";
  unsigned code = 0;
  for (std::size_t at = 0, length = 0; at < name.size(); at += length)
    if (length = lengthOfFirst(name.substr(at, 4)); isControlCharacter(name.substr(at, length), code))
      return "the name has the control character U+" + hexadecimal("%04X", code) +
             (code == '\n' || code == '\r' ? " (end of a line)"
              : code == '\t'               ? " (tabulator)"
                                           : "") +
             "; write a name without it.";
  return {};
}

std::string printable(std::string_view name)
{
  if (isPlain(name))
    return std::string(name);
  std::string text;
  unsigned code = 0;
  for (std::size_t at = 0, length = 0; at < name.size(); at += length)
  {
    const std::size_t valid = lengthOfFirst(name.substr(at, 4));
    length = std::max<std::size_t>(valid, 1);
    const std::string_view character = name.substr(at, length);
    if (valid == 0)
      text += "<0x" + hexadecimal("%02X", static_cast<unsigned char>(character[0])) + ">";
    else if (isControlCharacter(character, code))
      text += "<U+" + hexadecimal("%04X", code) + ">";
    else
      text += character;
  }
  return text;
}

} // namespace Rhegma
