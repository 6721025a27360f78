#pragma once
/// The constant that many tests need: one for all, since a strict build compiles files of tests in groups.

namespace Rhegma::Test
{

constexpr double pi = 3.14159265358979323846;

} // namespace Rhegma::Test
