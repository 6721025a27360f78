#include "material/InChild.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Rhegma
{

namespace
{

constexpr char answers = '=';
constexpr int secondsAtStart = 60;

void put(int file, const std::string& bytes)
{
  std::size_t done = 0;
  while (file >= 0 && done < bytes.size())
  {
    const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR)
      return;
    done += written > 0 ? written : 0;
  }
}

/// Output goes to a file, if there is one, else to nowhere.
void redirect(std::FILE* output)
{
  const int nowhere = open("/dev/null", O_RDWR);
  const int to = output != nullptr ? fileno(output) : nowhere;
  dup2(nowhere, STDIN_FILENO);
  dup2(to, STDOUT_FILENO);
  dup2(to, STDERR_FILENO);
}

[[noreturn]] void runChild(const std::function<void(ChildTalk&)>& function, int file, std::FILE* output)
{
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGALRM})
    std::signal(signal, SIG_DFL);
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  redirect(output);
  // Whatever calls exit(): the ends of MPI and of open files belong to the other process.
  std::atexit([] { _exit(1); });
  // The threads of OpenMP are those of the other process, too; waiting for them would never end.
  if (void* threads = dlsym(RTLD_DEFAULT, "omp_set_num_threads"))
    reinterpret_cast<void (*)(int)>(threads)(1);
  ChildTalk talk(file);
  function(talk);
  _exit(0);
}

/// Listens to the other process until it ends or is late.
class Listener
{
public:
  Listener(int file, pid_t child) : file_(file), child_(child) { allow(secondsAtStart); }

  void listen()
  {
    bool open = true;
    while (!ended_ && Clock::now() < until_)
    {
      // Something else may hold the other end of the pipe, so that its end is not waited for.
      pollfd wait = {file_, POLLIN, 0};
      if (open)
        poll(&wait, 1, 50);
      else
        usleep(500);
      if (const pid_t answer = waitpid(child_, &status_, WNOHANG); answer == child_ || answer < 0)
        ended_ = true;
      if (open)
        open = read();
    }
    if (ended_)
      return;
    kill(child_, SIGKILL);
    waitpid(child_, &status_, 0);
  }

  ChildEnd end() const
  {
    ChildEnd end;
    end.stage = stage_;
    if (next_ < text_.size() && text_[next_] == answers)
    {
      end.how = ChildEnd::How::Answered;
      end.answer = text_.substr(next_ + 1);
      return end;
    }
    end.how = !ended_                ? ChildEnd::How::Late
              : WIFSIGNALED(status_) ? ChildEnd::How::Killed
                                     : ChildEnd::How::Exited;
    end.signal = ended_ && WIFSIGNALED(status_) ? WTERMSIG(status_) : 0;
    return end;
  }

private:
  using Clock = std::chrono::steady_clock;

  void allow(int seconds) { until_ = Clock::now() + std::chrono::seconds(seconds); }

  /// \return whether more may come
  bool read()
  {
    char bytes[512];
    for (;;)
    {
      const ssize_t length = ::read(file_, bytes, sizeof bytes);
      if (length < 0 && errno == EINTR)
        continue;
      if (length <= 0)
        return length < 0 && errno == EAGAIN;
      text_.append(bytes, length);
      for (; next_ + 1 < text_.size() && text_[next_] != answers; next_ += 2)
      {
        stage_ = text_[next_];
        allow(static_cast<unsigned char>(text_[next_ + 1]));
      }
    }
  }

  int file_;
  pid_t child_;
  int status_ = 0;
  bool ended_ = false;
  Clock::time_point until_;
  std::string text_;
  std::size_t next_ = 0; ///< of text_, behind the stages that were read
  char stage_ = '\0';
};

/// The first line of a file that is not empty, without what can't be printed.
std::string firstLineOf(std::FILE* file)
{
  constexpr std::size_t longest = 160;
  std::string line;
  if (file == nullptr)
    return line;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF && line.size() < longest; c = std::fgetc(file))
    if (c == '\n' && !line.empty())
      break;
    else if (c >= ' ' && c < 127 && !(line.empty() && c == ' '))
      line += static_cast<char>(c);
  return line;
}

} // namespace

void ChildTalk::stage(char name, int seconds) { put(file_, {name, static_cast<char>(seconds)}); }

void ChildTalk::answer(const std::string& text) { put(file_, answers + text); }

ChildEnd inChild(const std::function<void(ChildTalk&)>& function)
{
  ChildEnd none;
  int ends[2];
  if (pipe(ends) != 0)
    return none;
  std::FILE* const output = std::tmpfile();
  const pid_t child = fork();
  if (child == 0)
    runChild(function, ends[1], output);
  close(ends[1]);
  ChildEnd end;
  if (child > 0)
  {
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    Listener listener(ends[0], child);
    listener.listen();
    end = listener.end();
    end.said = firstLineOf(output);
  }
  close(ends[0]);
  if (output != nullptr)
    std::fclose(output);
  return end;
}

} // namespace Rhegma
