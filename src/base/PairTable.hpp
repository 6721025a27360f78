#pragma once
/// Tables that a user writes as a text, and what texts of expressions have in common.

#include <string>
#include <vector>

namespace Rhegma
{

/// A table "0:0, 1e-3:5" of pairs with straight lines between them, held constant outside of them.
class PairTable
{
public:
  /// How the two numbers of a pair are called where one is wrong.
  struct Words
  {
    const char* pair;   ///< "a time and a value"
    const char* first;  ///< "times"
    const char* unit;   ///< " s"
    std::string advice; ///< how to write a table, from the sign that ends the sentence before it
    const char* stop;   ///< what ends a sentence without advice
  };

  /// Whether a text is a table: an expression has a colon only behind a question mark.
  static bool isMeant(const std::string& text);

  PairTable() = default;
  /// Throws std::invalid_argument where the text is no table, or the first numbers do not increase.
  PairTable(const std::string& text, const Words& words);

  bool empty() const { return at_.empty(); }
  double operator()(double x) const;

private:
  std::vector<double> at_, values_;
};

/// Whether an expression assigns to a name, which a parser would let it do, instead of comparing.
bool assigns(const std::string& expression);

/// A parser's reason without the stop at its end.
std::string withoutStop(std::string reason);

} // namespace Rhegma
