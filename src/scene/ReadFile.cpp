#include "scene/ReadFile.hpp"

#include "base/SpecialFile.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace Rhegma
{

namespace
{

/// Larger than any scene, and small enough to read at once: a pipe may be endless.
constexpr std::size_t mostBytes = 256u << 20;

const std::string givePath = "give the path of a scene's XML file.";

/// So that a large file is not moved about while it is read.
void reserveFor(const std::string& file, std::string& text)
{
  std::error_code none;
  const auto size = std::filesystem::file_size(file, none);
  if (!none && size < mostBytes)
    text.reserve(size + 1);
}

/// \return why the file can't be read; empty: it was
std::string readRegular(const std::string& file, std::string& text)
{
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return std::string("can't be read (") + std::strerror(errno) + "); check its permissions.";
  reserveFor(file, text);
  char piece[65536];
  while (text.size() <= mostBytes && (in.read(piece, sizeof piece) || in.gcount() > 0))
    text.append(piece, static_cast<std::size_t>(in.gcount()));
  return in.bad() ? std::string("can't be read (") + std::strerror(errno) + "); check its disk."
                  : std::string();
}

/// Closes a file.
class Descriptor
{
public:
  /// Does not wait for a program that writes.
  explicit Descriptor(const std::string& file) : number_(open(file.c_str(), O_RDONLY | O_NONBLOCK)) {}
  ~Descriptor()
  {
    if (number_ >= 0)
      close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

private:
  int number_;
};

/// How long a program that is to write into a pipe may take to open it.
constexpr std::chrono::milliseconds patience(1000), pause(20);

/// As readRegular. Without data, a read ends at once where no program has the pipe open for writing, and says
/// EAGAIN where one has.
std::string readPipe(const std::string& file, std::string& text)
{
  const Descriptor pipe(file);
  char piece[65536];
  std::chrono::milliseconds waited(0);
  while (text.size() <= mostBytes)
  {
    const ssize_t got = pipe.number() < 0 ? -1 : read(pipe.number(), piece, sizeof piece);
    if (got > 0)
      text.append(piece, static_cast<std::size_t>(got));
    else if (got == 0 && !text.empty())
      return {};
    else if (got == 0 && waited >= patience)
      return "is a pipe into which no program writes; start that program first, or " + givePath;
    else if (got == 0)
    {
      std::this_thread::sleep_for(pause);
      waited += pause;
    }
    else if (errno == EAGAIN)
    {
      pollfd one{pipe.number(), POLLIN, 0};
      poll(&one, 1, -1);
    }
    else if (errno != EINTR)
      return std::string("can't be read (") + std::strerror(errno) + "); check its permissions.";
  }
  return {};
}

/// Why a file of its kind is no scene; empty: it may be one.
std::string mistakeInKind(std::filesystem::file_status status)
{
  if (!std::filesystem::exists(status))
    return "does not exist; " + givePath;
  if (std::filesystem::is_directory(status))
    return "is a folder; " + givePath;
  const std::string kind = kindOfSpecialFile(status);
  return kind.empty() || std::filesystem::is_fifo(status) ? std::string() : "is " + kind + "; " + givePath;
}

} // namespace

bool isPipe(const std::string& file)
{
  std::error_code none;
  return std::filesystem::is_fifo(file, none);
}

std::string readText(const std::string& file, std::vector<SceneError>& errors)
{
  std::error_code ignored;
  std::string text, mistake = mistakeInKind(std::filesystem::status(file, ignored));
  if (mistake.empty())
    mistake = isPipe(file) ? readPipe(file, text) : readRegular(file, text);
  if (mistake.empty() && text.empty())
    mistake = "is empty; a scene starts with <ParameterList name=\"Rhegma\">.";
  if (mistake.empty() && text.size() > mostBytes)
    mistake = "is larger than 256 MB, which no scene is; " + givePath;
  if (mistake.empty())
    return text;
  errors.push_back({"", "\"" + file + "\" " + mistake});
  return {};
}

} // namespace Rhegma
