#pragma once
/// Many messages of one kind as a few and a count.

#include <string>
#include <vector>

namespace Rhegma
{

/// The messages in their order, of each kind no more than ten; where there are more, "and N more like: ..."
/// stands behind the last of them. Two messages are of one kind where they differ in numbers, texts in quotes
/// and names of what a scene lists ("Bodies > Ball 3"). Lines of an earlier fold are added to, so that a list
/// that grows can be folded again and again.
std::vector<std::string> foldMessages(const std::vector<std::string>& messages);

} // namespace Rhegma
