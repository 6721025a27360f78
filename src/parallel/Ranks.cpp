#include "parallel/Ranks.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_RCP.hpp>

#include <stdexcept>
#include <vector>

namespace Rhegma
{

namespace
{

/// Teuchos has no gather of doubles with different counts.
template <class T>
std::vector<T> gathered(const Teuchos::Comm<int>& comm, MPI_Datatype type, const std::vector<T>& own)
{
  const MPI_Comm raw = *dynamic_cast<const Teuchos::MpiComm<int>&>(comm).getRawMpiComm();
  const int count = static_cast<int>(own.size());
  std::vector<int> counts(comm.getSize()), begins(comm.getSize(), 0);
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, raw);
  for (std::size_t r = 1; r < begins.size(); ++r)
    begins[r] = begins[r - 1] + counts[r - 1];
  std::vector<T> all(comm.getRank() == 0 ? begins.back() + counts.back() : 0);
  MPI_Gatherv(own.data(), count, type, all.data(), counts.data(), begins.data(), type, 0, raw);
  return all;
}

} // namespace

struct Ranks::Holder
{
  Teuchos::RCP<const Teuchos::Comm<int>> comm;
};

Ranks::Ranks(const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : holder_(std::make_shared<Holder>(Holder{comm})), rank_(comm->getRank()), size_(comm->getSize())
{
  if (!many())
    return;
  MPI_Comm machine;
  MPI_Comm_split_type(*dynamic_cast<const Teuchos::MpiComm<int>&>(*comm).getRawMpiComm(),
                      MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &onThisMachine_);
  MPI_Comm_free(&machine);
}

const Teuchos::RCP<const Teuchos::Comm<int>>& Ranks::comm() const
{
  if (!holder_)
    throw std::logic_error("a rank alone has no communicator");
  return holder_->comm;
}

void Ranks::sum(double* values, int count) const
{
  if (!many())
    return;
  const std::vector<double> own(values, values + count);
  Teuchos::reduceAll(*holder_->comm, Teuchos::REDUCE_SUM, count, own.data(), values);
}

double Ranks::sum(double value) const
{
  sum(&value, 1);
  return value;
}

void Ranks::max(double* values, int count) const
{
  if (!many())
    return;
  const std::vector<double> own(values, values + count);
  Teuchos::reduceAll(*holder_->comm, Teuchos::REDUCE_MAX, count, own.data(), values);
}

double Ranks::max(double value) const
{
  max(&value, 1);
  return value;
}

std::vector<double> Ranks::gather(const std::vector<double>& own) const
{
  return many() ? gathered(*holder_->comm, MPI_DOUBLE, own) : own;
}

std::vector<int> Ranks::gather(const std::vector<int>& own) const
{
  return many() ? gathered(*holder_->comm, MPI_INT, own) : own;
}

std::vector<double> Ranks::scatter(const std::vector<double>& all, int own) const
{
  if (!many())
    return all;
  const std::vector<int> counts = gather(std::vector<int>{own});
  std::vector<int> begins(counts.size(), 0);
  for (std::size_t r = 1; r < begins.size(); ++r)
    begins[r] = begins[r - 1] + counts[r - 1];
  std::vector<double> part(own);
  const MPI_Comm raw = *dynamic_cast<const Teuchos::MpiComm<int>&>(*holder_->comm).getRawMpiComm();
  MPI_Scatterv(all.data(), counts.data(), begins.data(), MPI_DOUBLE, part.data(), own, MPI_DOUBLE, 0, raw);
  return part;
}

std::vector<double> Ranks::gatherOnAll(const std::vector<double>& own) const
{
  if (!many())
    return own;
  std::vector<double> all = gather(own);
  int count = static_cast<int>(all.size());
  Teuchos::broadcast(*holder_->comm, 0, 1, &count);
  all.resize(count);
  Teuchos::broadcast(*holder_->comm, 0, count, all.data());
  return all;
}

std::string Ranks::firstText(const std::string& text) const
{
  if (!many())
    return text;
  const int mine = text.empty() ? size_ : rank_;
  int first = size_;
  Teuchos::reduceAll(*holder_->comm, Teuchos::REDUCE_MIN, 1, &mine, &first);
  if (first == size_)
    return {};
  int length = static_cast<int>(text.size());
  Teuchos::broadcast(*holder_->comm, first, 1, &length);
  std::string reported = rank_ == first ? text : std::string(length, ' ');
  Teuchos::broadcast(*holder_->comm, first, length, &reported[0]);
  return reported;
}

} // namespace Rhegma
