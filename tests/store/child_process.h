#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mdbd::test {

inline void write_text(int output, const std::string& text) {
  if (write(output, text.data(), text.size()) < 0) _exit(1);
}

/// Runs `work` in a process of its own, which writes to a pipe. The process is killed at the end of
/// the scope. The parent must have no connection to a database open.
class ChildProcess {
 public:
  /// @param work gets the end of the pipe to write to; an exception of it is written there
  explicit ChildProcess(const std::function<void(int)>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no process");
    if (process_ == 0) {
      close(ends[0]);
      run(work, ends[1]);
    }
    close(ends[1]);
    output_ = ends[0];
  }
  ~ChildProcess() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    close(output_);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for so many bytes of the pipe. @returns fewer if the process ended
  std::string read_bytes(std::size_t count) {
    std::string text;
    char c = 0;
    while (text.size() < count && read(output_, &c, 1) == 1) text += c;
    return text;
  }
  /// Waits for the end of the process. @returns all it wrote
  std::string read_all() { return read_bytes(std::string::npos); }

 private:
  [[noreturn]] static void run(const std::function<void(int)>& work, int output) {
    try {
      work(output);
    } catch (const std::exception& error) {
      write_text(output, error.what());
    }
    _exit(0);
  }

  pid_t process_ = -1;
  int output_ = -1;
};

/// What `work` returns when it is run by a user whom permissions bind; root becomes nobody.
inline std::string run_unprivileged(const std::function<std::string()>& work) {
  constexpr uid_t nobody = 65534;
  ChildProcess child([&](int output) {
    if (geteuid() == 0 && (setegid(nobody) != 0 || seteuid(nobody) != 0)) {
      throw std::runtime_error("cannot become nobody");
    }
    write_text(output, work());
  });
  return child.read_all();
}

/// Gives a file or a folder to everyone to read, as a test's own folder is closed to others.
inline void open_to_all(const std::filesystem::path& path, std::filesystem::perms own) {
  using std::filesystem::perms;
  std::filesystem::permissions(
      path, own | perms::group_read | perms::others_read | perms::group_exec | perms::others_exec);
}

}  // namespace mdbd::test
