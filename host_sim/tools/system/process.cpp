#include <host_sim/tools/system/process.hpp>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace host_sim {

namespace {

/// Carries errno of a failed exec from child to parent; closes by itself when exec succeeds.
struct ErrorPipe {
  int ends[2] = {-1, -1};
  ErrorPipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to be had");
  }
  ~ErrorPipe() {
    ::close(ends[0]);
    if (ends[1] >= 0) ::close(ends[1]);
  }
  int read_error() {
    ::close(ends[1]);
    ends[1] = -1;
    int error = 0;
    return ::read(ends[0], &error, sizeof error) == sizeof error ? error : 0;
  }
};

[[noreturn]] void become(const std::vector<std::string>& command, const std::string& output_file, int error_end) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  const int input = ::open("/dev/null", O_RDONLY),
            output = ::open(output_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(input, 0);
  ::dup2(output, 1);
  ::dup2(output, 2);
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  const int error = errno;
  const ssize_t written = ::write(error_end, &error, sizeof error);
  ::_exit(written == sizeof error ? 127 : 126);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const std::string& output_file) {
  ErrorPipe pipe;
  id_ = ::fork();
  if (id_ < 0) throw std::runtime_error("cannot fork");
  if (id_ == 0) become(command, output_file, pipe.ends[1]);
  const int error = pipe.read_error();
  if (error == 0) return;
  ::waitpid(id_, nullptr, 0);
  throw std::runtime_error("cannot start " + command[0] + ": " + std::strerror(error));
}

Process::~Process() {
  if (exit_status()) return;
  ::kill(id_, SIGTERM);
  if (wait(std::chrono::milliseconds(500))) return;
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

std::optional<int> Process::exit_status() {
  int status = 0;
  if (!status_ && ::waitpid(id_, &status, WNOHANG) == id_)
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return status_;
}

std::optional<int> Process::wait(std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!exit_status() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return exit_status();
}

}  // namespace host_sim
