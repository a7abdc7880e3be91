#include "cli/progress_bar.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "cli/options.h"
#include "cli/terminal.h"

namespace mdbd {
namespace {

constexpr std::chrono::milliseconds redraw_interval{100};
constexpr int longest_bar = 30;
constexpr int shortest_bar = 5;

std::string draw_bar(double fraction, int length) {
  const int filled = static_cast<int>(fraction * length);
  return fmt::format("[{}{}] ", std::string(filled, '#'), std::string(length - filled, '.'));
}

/// The rate is that of the whole run: single models differ too much for anything shorter.
std::string describe_speed(const ProgressState& state) {
  if (state.done == 0 || state.elapsed.count() <= 0.0) return "";
  const double rate = static_cast<double>(state.done) / state.elapsed.count();
  const std::chrono::duration<double> left(static_cast<double>(state.total - state.done) / rate);
  return fmt::format(", {:.3g}/s, {} left", rate, format_duration(left));
}

}  // namespace

std::string progress_line(const ProgressState& state, int width) {
  std::string text = fmt::format("{}/{} models", state.done, state.total);
  text += describe_speed(state);
  if (state.failed > 0) text += fmt::format(", {} failed", state.failed);
  const double fraction =
      state.total == 0 ? 1.0 : static_cast<double>(state.done) / static_cast<double>(state.total);
  const int room = std::min(longest_bar, width - static_cast<int>(text.size()) - 3);
  if (room >= shortest_bar) text = draw_bar(fraction, room) + text;
  return text.substr(0, static_cast<std::size_t>(std::max(width, 0)));
}

ProgressBar::ProgressBar(std::FILE* stream, bool is_wanted) : stream_(stream) {
  const char* terminal = std::getenv("TERM");
  const bool can_erase = terminal != nullptr && std::string_view(terminal) != "dumb";
  is_enabled_ = is_wanted && can_erase && is_terminal(stream);
}

ProgressBar::~ProgressBar() { erase(); }

void ProgressBar::start(std::size_t total) {
  state_ = {.total = total};
  started_ = Clock::now();
  last_drawn_ = {};
  refresh();
}

void ProgressBar::advance(bool has_failed) {
  ++state_.done;
  if (has_failed) ++state_.failed;
  refresh();
}

void ProgressBar::refresh() {
  if (!is_enabled_ || state_.total == 0 || Clock::now() - last_drawn_ < redraw_interval) return;
  draw();
}

void ProgressBar::draw() {
  last_drawn_ = Clock::now();
  state_.elapsed = last_drawn_ - started_;
  // The last column stays free: a terminal may wrap after it.
  const std::string line = progress_line(state_, terminal_width(stream_) - 1);
  std::fputs(("\r" + line + "\x1b[K").c_str(), stream_);
  std::fflush(stream_);
  is_drawn_ = true;
}

void ProgressBar::print_above(std::string_view line) {
  const bool was_drawn = is_drawn_;
  erase();
  std::fwrite(line.data(), 1, line.size(), stream_);
  std::fputc('\n', stream_);
  if (was_drawn) draw();
}

void ProgressBar::erase() {
  if (!is_drawn_) return;
  std::fputs("\r\x1b[K", stream_);
  std::fflush(stream_);
  is_drawn_ = false;
}

}  // namespace mdbd
