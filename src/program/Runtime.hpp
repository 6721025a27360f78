#pragma once
/// Settings that must be made before Kokkos starts.

#include <string>
#include <vector>

namespace Rhegma::program
{

/// Binds OpenMP threads to cores unless the user has set it. The OpenMP library reads its environment when
/// the program is loaded, so the program restarts itself with the setting; under mpirun, which binds ranks
/// itself, nothing is changed.
void bindThreads(char** argv);

/// Lets a program that was not started by mpirun do without the helper process that Open MPI would start for
/// it, and without its search for networks: each takes longer than to read a scene. Settings in the
/// environment stay. Without effect on other kinds of MPI. Call before MPI_Init.
void startWithoutNetwork();

/// Keeps hwloc, by which MPI looks at the machine, from asking X servers for graphics cards: it ends the
/// program if such a server goes away at that moment. A setting in the environment stays. Call before
/// MPI_Init.
void startWithoutDisplay();

/// Ignores SIGPIPE: a reader of the output that ends early (such as head) does not end the run.
void outliveReaders();

/// The first line of a message.
std::string firstLine(const std::string& message);

/// Arguments in the form that Kokkos::initialize takes.
class KokkosArguments
{
public:
  KokkosArguments(const std::string& program, const std::vector<std::string>& arguments);
  int& count() const { return count_; }
  char** values() const { return pointers_.data(); }

private:
  std::vector<std::string> texts_;
  mutable std::vector<char*> pointers_;
  mutable int count_;
};

} // namespace Rhegma::program
