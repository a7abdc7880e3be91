#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace mdbd {

/// How far a run is.
struct ProgressState {
  std::size_t total = 0;
  std::size_t done = 0;    ///< including the failed ones
  std::size_t failed = 0;  ///< so far
  std::chrono::duration<double> elapsed{0.0};
};

/// One line for people, of at most `width` columns: a bar, models done, rate, time left, failures.
std::string progress_line(const ProgressState& state, int width);

/// A progress bar on one line of a terminal; on anything else it draws nothing. It is redrawn at
/// most ten times a second, and its destructor erases it.
class ProgressBar {
 public:
  /// @param stream where to draw; must outlive this object
  /// @param is_wanted false draws nothing, even on a terminal
  explicit ProgressBar(std::FILE* stream, bool is_wanted = true);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Starts the clock of a run of so many models.
  void start(std::size_t total);
  /// Notes that there are so many models more.
  void extend(std::size_t models) { state_.total += models; }
  /// Notes that one more model is done.
  void advance(bool has_failed);
  /// Draws the bar if it is due; call it now and then, so that the clock moves during slow models.
  void refresh();
  /// Writes a line above the bar, or just writes it where there is no bar.
  void print_above(std::string_view line);
  /// Takes the bar off the terminal until the next refresh.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;

  void draw();

  std::FILE* stream_;
  bool is_enabled_;
  bool is_drawn_ = false;
  ProgressState state_;
  Clock::time_point started_;
  Clock::time_point last_drawn_;
};

}  // namespace mdbd
