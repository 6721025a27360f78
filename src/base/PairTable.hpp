#pragma once
/// Tables that a user writes as a text, and checks of expressions.

#include <string>
#include <vector>

namespace Rhegma
{

/// A table "0:0, 1e-3:5" of pairs with straight lines between them, held constant outside of them.
class PairTable
{
public:
  /// Names of the two numbers of a pair, for messages.
  struct Labels
  {
    const char* pair;   ///< "a time and a value"
    const char* first;  ///< "times"
    const char* unit;   ///< " s"
    std::string advice; ///< how to write a table, beginning with the punctuation before it
    const char* stop;   ///< ends a message without advice
  };

  /// Whether a text is a table: an expression has a colon only behind a question mark.
  static bool isMeant(const std::string& text);

  PairTable() = default;
  /// Throws std::invalid_argument where the text is no table, or the first numbers do not increase.
  PairTable(const std::string& text, const Labels& labels);

  bool empty() const { return at_.empty(); }
  double operator()(double x) const;

  /// First numbers of the pairs, in order.
  const std::vector<double>& corners() const { return at_; }

  /// Mean between two numbers, the first below the second: exact.
  double mean(double from, double to) const;

private:
  std::vector<double> at_, values_;
};

/// Whether an expression assigns to a name, which the parser would accept, instead of comparing.
bool assigns(const std::string& expression);

/// A parser's message without its full stop.
std::string withoutStop(std::string reason);

} // namespace Rhegma
