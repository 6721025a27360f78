#include "Substrate.hpp"

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Export.hpp>
#include <Tpetra_Import.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{

/// The cells of a list, each once.
Teuchos::RCP<const Tpetra::Map<>> mapOf(const std::vector<Substrate::Cell>& cells,
                                        const Substrate::Comm& comm)
{
  std::vector<Substrate::Cell> once = cells;
  std::sort(once.begin(), once.end());
  once.erase(std::unique(once.begin(), once.end()), once.end());
  const auto count = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new Tpetra::Map<>(count, Teuchos::ArrayView<const Substrate::Cell>(once), 0, comm));
}

} // namespace

Substrate::Substrate(const Comm& comm, const Plate& plate, double step,
                     const std::function<double(double x, double y)>& start)
    : comm_(comm),
      plate_(plate),
      step_(step),
      heatPerKelvin_(plate.capacity * plate.cell * plate.cell * plate.thickness)
{
  map_ = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(plate.columns) * plate.rows, 0, comm));
  temperature_ = Teuchos::rcp(new Vector(map_));
  start_ = Teuchos::rcp(new Vector(map_));
  added_ = Teuchos::rcp(new Vector(map_));
  for (Cell cell = map_->getMinGlobalIndex(); cell <= map_->getMaxGlobalIndex(); ++cell)
  {
    const double x = plate.x + (static_cast<double>(cell % plate.columns) + 0.5) * plate.cell;
    const double y = plate.y + (static_cast<double>(cell / plate.columns) + 0.5) * plate.cell;
    start_->replaceGlobalValue(cell, start(x, y));
  }
  temperature_->assign(*start_);
  assemble();
}

std::vector<Substrate::Cell> Substrate::neighbours(Cell cell) const
{
  const Cell column = cell % plate_.columns, row = cell / plate_.columns;
  std::vector<Cell> all;
  if (column > 0)
    all.push_back(cell - 1);
  if (column + 1 < plate_.columns)
    all.push_back(cell + 1);
  if (row > 0)
    all.push_back(cell - plate_.columns);
  if (row + 1 < plate_.rows)
    all.push_back(cell + plate_.columns);
  return all;
}

/// Flows out of each cell [W/K], and with the heat that cells hold the matrix of an implicit step.
void Substrate::assemble()
{
  flows_ = Teuchos::rcp(new Matrix(map_, 5));
  implicit_ = Teuchos::rcp(new Matrix(map_, 5));
  const double conductance = plate_.conductivity * plate_.thickness;
  for (Cell cell = map_->getMinGlobalIndex(); cell <= map_->getMaxGlobalIndex(); ++cell)
  {
    std::vector<Cell> columns = neighbours(cell);
    std::vector<double> values(columns.size(), -conductance);
    columns.push_back(cell);
    values.push_back(conductance * static_cast<double>(values.size()));
    const Teuchos::ArrayView<const Cell> where(columns);
    flows_->insertGlobalValues(cell, where, Teuchos::ArrayView<const double>(values));
    values.back() += heatPerKelvin_ / step_;
    implicit_->insertGlobalValues(cell, where, Teuchos::ArrayView<const double>(values));
  }
  flows_->fillComplete();
  implicit_->fillComplete();
}

Substrate::Cell Substrate::cellAt(double x, double y) const
{
  const double column = std::floor((x - plate_.x) / plate_.cell),
               row = std::floor((y - plate_.y) / plate_.cell);
  if (!(column >= 0.0 && column < plate_.columns && row >= 0.0 && row < plate_.rows))
    throw std::out_of_range("the film has left the plate");
  return static_cast<Cell>(row) * plate_.columns + static_cast<Cell>(column);
}

std::vector<double> Substrate::temperatures(const std::vector<Cell>& cells) const
{
  const Teuchos::RCP<const Map> wanted = mapOf(cells, comm_);
  Vector found(wanted);
  found.doImport(*temperature_, Tpetra::Import<>(map_, wanted), Tpetra::INSERT);
  const auto values = found.getData();
  std::vector<double> all;
  all.reserve(cells.size());
  for (const Cell cell : cells)
    all.push_back(values[wanted->getLocalElement(cell)]);
  return all;
}

void Substrate::addHeat(const std::vector<Cell>& cells, const std::vector<double>& joules)
{
  const Teuchos::RCP<const Map> touched = mapOf(cells, comm_);
  Vector sums(touched);
  for (std::size_t k = 0; k < cells.size(); ++k)
    sums.sumIntoGlobalValue(cells[k], joules[k]);
  added_->doExport(sums, Tpetra::Export<>(touched, map_), Tpetra::ADD);
}

void Substrate::conduct()
{
  using Many = Tpetra::MultiVector<>;
  using Operator = Tpetra::Operator<>;
  // C T / dt + added / dt = (C / dt + flows) T at the end.
  const auto right = Teuchos::rcp(new Vector(map_));
  right->update(heatPerKelvin_ / step_, *temperature_, 1.0 / step_, *added_, 0.0);
  const auto end = Teuchos::rcp(new Vector(*temperature_, Teuchos::Copy));
  const auto problem = Teuchos::rcp(new Belos::LinearProblem<double, Many, Operator>(implicit_, end, right));
  problem->setProblem();
  const auto options = Teuchos::parameterList();
  options->set("Convergence Tolerance", 1e-10);
  options->set("Maximum Iterations", 1000);
  Belos::PseudoBlockCGSolMgr<double, Many, Operator> solver(problem, options);
  if (solver.solve() != Belos::Converged)
    throw std::runtime_error("the plate's temperatures were not found");
  Vector out(map_);
  flows_->apply(*end, out);
  temperature_->update(1.0 / heatPerKelvin_, *added_, -step_ / heatPerKelvin_, out, 1.0);
  added_->putScalar(0.0);
}

double Substrate::gained() const
{
  Vector rise(*temperature_, Teuchos::Copy);
  rise.update(-1.0, *start_, 1.0);
  double own = 0.0, all = 0.0;
  for (const double kelvin : rise.getData())
    own += heatPerKelvin_ * kelvin;
  Teuchos::reduceAll(*comm_, Teuchos::REDUCE_SUM, 1, &own, &all);
  return all;
}

double Substrate::hottest() const { return temperature_->normInf(); }
