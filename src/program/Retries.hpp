#pragma once
/// Whether a run in failure should go back and take shorter steps.

#include <string>

namespace Rhegma::program
{

/// Counts the attempts of a run that meets failure. Steps that are too long for what happens (an impact, a
/// contact, a material that stiffens) are cured by shorter ones; a body that leaves the domain is not, and
/// meets its end at the same time again. The second time that shorter steps change nothing is the last.
class Retries
{
public:
  explicit Retries(int most) : most_(most) {}

  /// \param failure why the run can't go on, a sentence
  /// \param from    time of the state that there is to go back to [s]
  /// \param at      time of the failure [s]
  /// \return whether to go back to it and halve the step; counts that as done
  bool mayHelp(const std::string& failure, double from, double at);

  /// Takes note of how steps are from there on. \param fraction of the stable step
  void goesOnWith(double share) { fraction_ = share; }

  /// The last attempt, for the warnings of the run.
  std::string asText() const;

  /// What to add to the failure that ends the run, if there have been attempts; begins with "; ".
  std::string inVain() const;

private:
  int most_, taken_ = 0, unchanged_ = 0;
  double from_ = 0.0, at_ = -1.0, fraction_ = 1.0;
  std::string failure_;
};

} // namespace Rhegma::program
