/// A copper film on silicon: the application conducts heat in the silicon, Rhegma stretches the film until it
/// flows, and what the film's heat and the silicon's temperatures make of each other goes both ways.
///
///     film film.xml
///
/// Exit status 1 where more than 1e-10 of the heat that was exchanged is missing from the energy balance of
/// one of the two.

#include "Substrate.hpp"

#include <Simulation.hpp>

#include <Kokkos_Core.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>

namespace
{

constexpr double interval = 1.0e-8;         // between exchanges [s]
constexpr double boundaryConductance = 1e8; // of the bond [W/(m2 K)], as measured between metals and silicon
constexpr double filmThickness = 2.0e-6;    // [m], as Domain > Thickness
constexpr double allowed = 1.0e-10;         // fraction of the heat exchanged that may be missing

using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;
using Rhegma::Simulation;

double overRanks(const Comm& comm, double own)
{
  double all = 0.0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_SUM, 1, &own, &all);
  return all;
}

/// Heat in the film, with the energy of straining that particles hold next to it [J].
double heldByFilm(const Comm& comm, const Simulation& film)
{
  const std::vector<double> density = film.particleField("internal energy").values;
  const std::vector<double> volume = film.particleField("initial volume").values;
  double own = 0.0;
  for (std::size_t p = 0; p < volume.size(); ++p)
    own += density[p] * volume[p];
  return overRanks(comm, own);
}

/// Sums of all exchanges, of all ranks [J].
struct Exchanged
{
  double intoFilm = 0.0, outOfFilm = 0.0;
  double heldMore = 0.0; ///< change of what the film's particles hold, by exchanges alone
};

/// What flows through the bond in an interval.
void exchange(const Comm& comm, Simulation& film, Substrate& silicon, Exchanged& sums)
{
  const std::vector<double> position = film.particleField("position").values;
  const std::vector<double> volume = film.particleField("initial volume").values;
  const std::vector<double> warmth = film.particleField("temperature").values;
  std::vector<Substrate::Cell> cells(volume.size());
  for (std::size_t p = 0; p < volume.size(); ++p)
    cells[p] = silicon.cellAt(position[2 * p], position[2 * p + 1]);
  const std::vector<double> below = silicon.temperatures(cells);

  std::vector<double> intoFilm(volume.size()), intoSilicon(volume.size());
  double in = 0.0, out = 0.0;
  for (std::size_t p = 0; p < volume.size(); ++p)
  {
    const double area = volume[p] / filmThickness;
    intoFilm[p] = interval * boundaryConductance * area * (below[p] - warmth[p]);
    intoSilicon[p] = -intoFilm[p];
    (intoFilm[p] > 0.0 ? in : out) += std::fabs(intoFilm[p]);
  }
  sums.intoFilm += overRanks(comm, in);
  sums.outOfFilm += overRanks(comm, out);
  const double before = heldByFilm(comm, film);
  film.giveHeat(intoFilm);
  sums.heldMore += heldByFilm(comm, film) - before;
  silicon.addHeat(cells, intoSilicon);
}

double sampled(const Simulation& film, const std::string& name)
{
  for (const auto& [key, value] : film.observe())
    if (key == name)
      return value;
  throw std::invalid_argument("the scene has no " + name);
}

bool balance(const char* what, double missing, double turnover, bool speaks)
{
  if (speaks)
    std::printf("%s: %.1e of the heat exchanged is missing\n", what, std::fabs(missing) / turnover);
  return std::fabs(missing) <= allowed * turnover;
}

int run(const std::string& file)
{
  const Comm comm = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  const bool speaks = comm->getRank() == 0;
  const auto scene = Rhegma::Simulation::readScene(file);
  const double end = scene->sublist("Time").get<double>("Final Time");

  const Plate plate = {-4.0e-5, -4.0e-5, 1.0e-5, 48, 18, 2.0e-5, 148.0, 1.66e6};
  Substrate silicon(comm, plate, interval, [](double x, double) { return x < 1.0e-4 ? 340.0 : 300.0; });
  Simulation film(comm, scene);
  film.initialize();
  film.sampleEvery(end, [](double, const Simulation::Row&) {});

  Exchanged sums;
  for (long n = 0; n * interval < end * (1.0 - 1e-9); ++n)
  {
    exchange(comm, film, silicon, sums);
    silicon.conduct();
    film.advance(std::min(end, (n + 1) * interval));
  }

  const double turnover = sums.intoFilm + sums.outOfFilm, heat = sampled(film, "heat");
  const double hottest = silicon.hottest();
  const double gained = silicon.gained();
  if (speaks)
    std::printf(
        "heat made by stretching %.6e J, from silicon into film %.6e J, back %.6e J, hottest %.6f K\n",
        sampled(film, "thermal") - heat, sums.intoFilm, sums.outOfFilm, hottest);
  const bool silent = !balance("silicon against Rhegma's energy balance", gained + heat, turnover, speaks);
  return !balance("Rhegma's particles against its energy balance", sums.heldMore - heat, turnover, speaks) ||
         silent;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: film SCENE.xml\n";
    return 1;
  }
  int code = 1;
  MPI_Init(&argc, &argv);
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    try
    {
      code = run(argv[1]);
    }
    catch (const std::exception& error)
    {
      std::cerr << error.what() << "\n";
      MPI_Abort(MPI_COMM_WORLD, 1); // other ranks may wait for this one
    }
  }
  MPI_Finalize();
  return code;
}
