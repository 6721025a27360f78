#include "throughput/Worker.hpp"

#include "common/Program.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace Rhegma::benchmarks
{

namespace
{

[[noreturn]] void becomeWorker(const std::vector<std::string>& arguments, int threads, int output)
{
  dup2(output, STDOUT_FILENO);
  setenv("OMP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  placeThreads();
  std::vector<std::string> texts(arguments);
  std::vector<char*> pointers;
  for (std::string& text : texts)
    pointers.push_back(text.data());
  pointers.push_back(nullptr);
  execv("/proc/self/exe", pointers.data());
  _exit(127);
}

std::string readAll(int input)
{
  std::string text;
  std::array<char, 4096> buffer;
  for (;;)
  {
    const ssize_t got = read(input, buffer.data(), buffer.size());
    if (got > 0)
      text.append(buffer.data(), static_cast<std::size_t>(got));
    else if (got == 0 || errno != EINTR)
      return text;
  }
}

} // namespace

std::string runAgain(const std::vector<std::string>& arguments, int threads)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("can't make a pipe to another process");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("can't start another process");
  if (child == 0)
    becomeWorker(arguments, threads, ends[1]);
  close(ends[1]);
  const std::string text = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("the measurement with " + std::to_string(threads) + " threads failed");
  return text;
}

} // namespace Rhegma::benchmarks
