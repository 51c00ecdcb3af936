// fork, exec, pipes.
#include "apps/program_run.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace oblast::test {

namespace fs = std::filesystem;

namespace {

// The output of the child goes to files, so it can never block.
enum class Interrupt { never, while_reading, while_working };

ProgramRun start(const std::vector<std::string>& arguments, const std::string& input, Interrupt interrupt,
                 std::chrono::microseconds delay = std::chrono::milliseconds(200)) {
  std::signal(SIGPIPE, SIG_IGN);
  const Folder folder;
  int feed[2];
  if (::pipe(feed) != 0) throw std::runtime_error("pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(feed[0], STDIN_FILENO);
    ::close(feed[0]);
    ::close(feed[1]);
    if (!std::freopen(folder.path("out").c_str(), "w", stdout) ||
        !std::freopen(folder.path("err").c_str(), "w", stderr))
      ::_exit(126);
    std::signal(SIGPIPE, SIG_DFL);
    std::vector<char*> words{const_cast<char*>("oblast")};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    ::execv(OBLAST_PROGRAM, words.data());
    ::_exit(127);
  }
  ::close(feed[0]);
  for (std::size_t at = 0; at < input.size();) {
    const ssize_t written = ::write(feed[1], input.data() + at, input.size() - at);
    if (written <= 0) break;  // the program has stopped reading
    at += static_cast<std::size_t>(written);
  }
  if (interrupt == Interrupt::while_reading) ::kill(child, SIGINT);
  int status = 0;
  if (interrupt == Interrupt::while_reading) ::waitpid(child, &status, 0);
  ::close(feed[1]);
  if (interrupt == Interrupt::while_working) {
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGINT);
  }
  if (interrupt != Interrupt::while_reading) ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder / "out"), read_file(folder / "err")};
}

}  // namespace

Folder::Folder() {
  std::string pattern = (fs::temp_directory_path() / "oblast-test-XXXXXX").string();
  if (!::mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp");
  path_ = pattern;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> result;
  for (const auto& entry : fs::directory_iterator(path_)) result.push_back(entry.path().filename().string());
  std::sort(result.begin(), result.end());
  return result;
}

ProgramRun oblast_program(const std::vector<std::string>& arguments, const std::string& input) {
  return start(arguments, input, Interrupt::never);
}

ProgramRun program_on_terminal(const std::vector<std::string>& arguments) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) throw std::runtime_error("posix_openpt");
  const std::string name = ::ptsname(terminal);
  const pid_t child = ::fork();
  if (child == 0) {
    if (!std::freopen("/dev/null", "r", stdin) || !std::freopen("/dev/null", "w", stdout)) ::_exit(126);
    const int screen = ::open(name.c_str(), O_RDWR | O_NOCTTY);
    ::dup2(screen, STDERR_FILENO);
    std::vector<char*> words{const_cast<char*>("oblast")};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    ::execv(OBLAST_PROGRAM, words.data());
    ::_exit(127);
  }
  ProgramRun run;
  char bytes[4096];
  // The terminal is read until the last program that has it open ends; that is an error (EIO) on Linux.
  const int keep_open = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  std::thread reader([&] {
    for (ssize_t got; (got = ::read(terminal, bytes, sizeof bytes)) > 0;)
      run.err.append(bytes, static_cast<std::size_t>(got));
  });
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(keep_open);
  reader.join();
  ::close(terminal);
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return run;
}

ProgramRun interrupted_program(const std::vector<std::string>& arguments, const std::string& input) {
  return start(arguments, input, Interrupt::while_reading);
}

ProgramRun program_interrupted_at_work(const std::vector<std::string>& arguments, const std::string& input) {
  return start(arguments, input, Interrupt::while_working);
}

ProgramRun program_interrupted_after(std::chrono::microseconds delay, const std::vector<std::string>& arguments) {
  return start(arguments, {}, Interrupt::while_working, delay);
}

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_file(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

}  // namespace oblast::test
