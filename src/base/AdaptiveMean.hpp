#pragma once
/// Mean of a function over an interval.

#include <algorithm>
#include <cmath>

namespace Rhegma
{

/// Mean of a function over an interval by Simpson's rule on pieces that are halved where this changes their
/// part by more than rounding can matter: 1e-10 of the largest value for smooth functions and for those with
/// corners, 1e-8 of the size of a jump. What is shorter than a 512th of the interval may be missed.
/// Source: adaptive quadrature of Kuncir, Commun. ACM 5 (1962) 347.
/// \param of function of a real number that is finite in the interval \param from, to its ends, from < to
template <class Function>
class AdaptiveMean
{
public:
  AdaptiveMean(const Function& of, double from, double to) : of_(of)
  {
    constexpr int pieces = 256;
    const double length = (to - from) / pieces;
    double left = value(from);
    for (int k = 0; k < pieces; ++k)
    {
      const double begin = from + k * length, end = k + 1 < pieces ? begin + length : to;
      const Piece piece{begin, end, left, value(0.5 * (begin + end)), value(end)};
      sum_ += meanOf(piece, 0) / pieces;
      left = piece.right;
    }
  }

  double result() const { return sum_; }

private:
  struct Piece
  {
    double begin, end, left, middle, right;
    double mean() const { return (left + 4.0 * middle + right) / 6.0; }
  };

  double value(double at)
  {
    const double f = of_(at);
    largest_ = std::max(largest_, std::fabs(f));
    ++count_;
    return f;
  }

  double meanOf(const Piece& piece, int depth)
  {
    constexpr double tolerance = 1e-10;
    constexpr int deepest = 20, most = 200000; // values of a function that is rough everywhere
    const double middle = 0.5 * (piece.begin + piece.end);
    const Piece first{piece.begin, middle, piece.left, value(0.5 * (piece.begin + middle)), piece.middle};
    const Piece second{middle, piece.end, piece.middle, value(0.5 * (middle + piece.end)), piece.right};
    const double whole = piece.mean(), halves = 0.5 * (first.mean() + second.mean());
    const double part = std::ldexp(1.0, -depth); // of the first piece
    if (std::fabs(halves - whole) * part <= tolerance * largest_ || depth >= deepest || count_ > most)
      return halves + (halves - whole) / 15.0;
    return 0.5 * (meanOf(first, depth + 1) + meanOf(second, depth + 1));
  }

  const Function& of_;
  double sum_ = 0.0, largest_ = 0.0;
  int count_ = 0;
};

/// As AdaptiveMean::result().
template <class Function>
double adaptiveMean(const Function& of, double from, double to)
{
  return AdaptiveMean<Function>(of, from, to).result();
}

} // namespace Rhegma
