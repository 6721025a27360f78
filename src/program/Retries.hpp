#pragma once
/// Whether a failed run should go back and use shorter steps.

#include <string>

namespace Rhegma::program
{

/// Counts the attempts of a run that fails. Shorter steps help against an impact, a contact or a stiffening
/// material, but not if a body leaves the domain: then the run fails at the same time again. The second
/// attempt that changes nothing is the last.
class Retries
{
public:
  explicit Retries(int most) : most_(most) {}

  /// \param failure why the run failed
  /// \param from    time of the stored state [s]
  /// \param at      time of the failure [s]
  /// \return whether to go back to it and halve the step; counts that as done
  bool mayHelp(const std::string& failure, double from, double at);

  /// Sets the fraction of the stable step of the following steps.
  void setStepFraction(double fraction) { fraction_ = fraction; }

  /// The last attempt, for the warnings of the run.
  std::string asText() const;

  /// Text to append to the final failure, if there were attempts; begins with "; ".
  std::string inVain() const;

private:
  int most_, attempts_ = 0, unchanged_ = 0;
  double from_ = 0.0, at_ = -1.0, fraction_ = 1.0;
  std::string failure_;
};

} // namespace Rhegma::program
