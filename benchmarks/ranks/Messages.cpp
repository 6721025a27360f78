#include "ranks/Messages.hpp"

#include <mpi.h>

#include <set>

// A program may replace functions of MPI, which stay available as PMPI_....

namespace
{

Rhegma::benchmarks::Messages messages;
std::set<int> receivers;

double bytesOf(int count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  return static_cast<double>(count) * size;
}

void note(int count, MPI_Datatype type, int to)
{
  ++messages.sent;
  messages.bytes += bytesOf(count, type);
  receivers.insert(to);
}

} // namespace

extern "C"
{

  int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
  {
    note(count, type, to);
    return PMPI_Send(data, count, type, to, tag, comm);
  }

  int MPI_Rsend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
  {
    note(count, type, to);
    return PMPI_Rsend(data, count, type, to, tag, comm);
  }

  int MPI_Ssend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm)
  {
    note(count, type, to);
    return PMPI_Ssend(data, count, type, to, tag, comm);
  }

  int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
                MPI_Request* request)
  {
    note(count, type, to);
    return PMPI_Isend(data, count, type, to, tag, comm, request);
  }

  int MPI_Allreduce(const void* data, void* result, int count, MPI_Datatype type, MPI_Op operation,
                    MPI_Comm comm)
  {
    ++messages.reductions;
    messages.reducedBytes += bytesOf(count, type);
    return PMPI_Allreduce(data, result, count, type, operation, comm);
  }

} // extern "C"

namespace Rhegma::benchmarks
{

void beginCount()
{
  messages = Messages();
  receivers.clear();
}

Messages counted()
{
  Messages now = messages;
  now.receivers = static_cast<double>(receivers.size());
  return now;
}

} // namespace Rhegma::benchmarks
