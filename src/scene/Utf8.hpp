#pragma once
/// UTF-8 and control characters in scenes. Names of bodies, cracks and boundaries become columns, keys, file
/// names and lines on a terminal.

#include <cstddef>
#include <string>
#include <string_view>

namespace Rhegma
{

/// The UTF-8 code of a character; empty where there is no such character.
std::string utf8(unsigned long code);

/// Position of the first byte that is not UTF-8 (The Unicode Standard, table 3-7); npos: there is none.
std::size_t firstNotUtf8(std::string_view text);

/// A byte that is not UTF-8, as text: "the byte 0xE9 is not UTF-8 (in ISO-8859-1 it is ...)".
std::string foreignByteText(char byte);

/// What is wrong with a name, for an error after its path, with what to write; empty: nothing.
std::string mistakeInName(std::string_view name);

/// A name with its control characters and bytes that are not UTF-8 written as <U+001B> or <0xE9>, for
/// messages.
std::string printable(std::string_view name);

} // namespace Rhegma
