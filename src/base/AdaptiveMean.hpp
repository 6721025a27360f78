#pragma once
/// Mean of a function over an interval.

#include <algorithm>
#include <array>
#include <cmath>

namespace Rhegma
{

/// Mean of a function over an interval by Simpson's rule on 2053 pieces, each of which is halved where this
/// changes its part: by more than 1e-10 of the largest value where the function is smooth or has a corner,
/// down to 1e-8 of the interval at a jump. A piece takes at most about two hundred values: of a function that
/// jumps more often than a few times in it the mean is only estimated, and what is shorter than half a piece
/// may be missed.
///
/// Source: adaptive quadrature of Kuncir, Commun. ACM 5 (1962) 347.
///
/// \param of function of a real number that is finite in the interval \param from, to its ends, from < to
template <class Function>
class AdaptiveMean
{
public:
  AdaptiveMean(const Function& of, double from, double to) : of_(of)
  {
    const double half = 0.5 * (to - from) / pieces;
    std::array<double, 2 * pieces + 1> values;
    for (int k = 0; k <= 2 * pieces; ++k)
    {
      values[k] = of_(from + k * half);
      largest_ = std::max(largest_, std::fabs(values[k]));
    }
    for (int k = 0; k < pieces; ++k)
    {
      left_ = most;
      const double begin = from + 2 * k * half;
      sum_ += meanOf({begin, begin + 2.0 * half, values[2 * k], values[2 * k + 1], values[2 * k + 2]}, 0);
    }
  }

  double result() const { return sum_ / pieces; }

private:
  static constexpr int pieces = 2053; ///< a prime number: periodic functions are not met in phase
  static constexpr int most = 200;    ///< values that a piece may take

  struct Piece
  {
    double begin, end, left, middle, right;
    double mean() const { return (left + 4.0 * middle + right) / 6.0; }
  };

  double meanOf(const Piece& piece, int depth)
  {
    constexpr double tolerance = 1e-10;
    constexpr int deepest = 20;
    const double middle = 0.5 * (piece.begin + piece.end);
    left_ -= 2;
    const Piece first{piece.begin, middle, piece.left, of_(0.5 * (piece.begin + middle)), piece.middle};
    const Piece second{middle, piece.end, piece.middle, of_(0.5 * (middle + piece.end)), piece.right};
    const double whole = piece.mean(), halves = 0.5 * (first.mean() + second.mean());
    const double part = std::ldexp(1.0, -depth); // of the first piece
    if (std::fabs(halves - whole) * part <= tolerance * largest_ || depth >= deepest || left_ <= 0)
      return halves + (halves - whole) / 15.0;
    const double mean = meanOf(first, depth + 1);
    return 0.5 * (mean + meanOf(second, depth + 1));
  }

  const Function& of_;
  double sum_ = 0.0, largest_ = 0.0;
  int left_ = most;
};

/// As AdaptiveMean::result().
template <class Function>
double adaptiveMean(const Function& of, double from, double to)
{
  return AdaptiveMean<Function>(of, from, to).result();
}

} // namespace Rhegma
