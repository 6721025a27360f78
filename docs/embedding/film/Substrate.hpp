#pragma once
/// The heat solver of the application: a plate of square cells that conducts, on ranks of its own choosing.

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <functional>
#include <vector>

/// What the plate is and how it is divided.
struct Plate
{
  double x, y;         ///< its lower corner [m]
  double cell;         ///< edge of its cells [m]
  int columns, rows;   ///< how many there are
  double thickness;    ///< [m]
  double conductivity; ///< [W/(m K)]
  double capacity;     ///< per volume [J/(m3 K)]
};

/// Heat in an insulated plate. Each rank owns a run of cells that has nothing to do with where Rhegma's
/// particles are; all functions but `cellAt` are collective.
class Substrate
{
public:
  using Cell = Tpetra::Map<>::global_ordinal_type;
  using Comm = Teuchos::RCP<const Teuchos::Comm<int>>;

  /// \param step of time, the same for all calls of conduct [s]
  /// \param start temperature by position [K]
  Substrate(const Comm& comm, const Plate& plate, double step,
            const std::function<double(double x, double y)>& start);

  /// The cell over which a position lies. Throws std::out_of_range beyond the plate.
  Cell cellAt(double x, double y) const;

  /// Temperatures of cells, whichever rank has them [K].
  std::vector<double> temperatures(const std::vector<Cell>& cells) const;

  /// Adds heat to cells, whichever rank has them; it is conducted in the next step [J].
  void addHeat(const std::vector<Cell>& cells, const std::vector<double>& joules);

  /// One implicit step. The heat of the plate changes by what was added, whatever the solver leaves
  /// undone: temperatures change by the flows between cells, and each flow leaves one cell and enters
  /// another.
  void conduct();

  /// Heat that it holds more than at the start [J].
  double gained() const;
  /// Its highest temperature [K].
  double hottest() const;

private:
  using Vector = Tpetra::Vector<>;
  using Matrix = Tpetra::CrsMatrix<>;
  using Map = Tpetra::Map<>;

  void assemble();
  std::vector<Cell> neighbours(Cell cell) const;

  Comm comm_;
  Plate plate_;
  double step_, heatPerKelvin_;
  Teuchos::RCP<const Map> map_;
  Teuchos::RCP<Matrix> flows_, implicit_;
  Teuchos::RCP<Vector> temperature_, start_, added_;
};
