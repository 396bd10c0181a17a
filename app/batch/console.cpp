// SPDX-License-Identifier: Apache-2.0
#include "app/batch/console.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "core/job/outside_text.h"

namespace noctule::batch {
namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{100};
constexpr size_t kLongest = 8000, kLongestStage = 200;  ///< bytes of a message and of a line of progress

/// A reader that has closed the pipe (`| head`) has what it wanted.
bool writeAll(const std::string& text) {
    return (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) ||
           errno == EPIPE;
}

}  // namespace

Console::Console(bool quiet, bool json, std::string program)
    : program_(std::move(program)),
      quiet_(quiet),
      json_(json),
      shows_progress_(!quiet && isatty(STDERR_FILENO) == 1) {}

void Console::eraseProgress() {
    if (line_open_)
        std::fputs("\r\033[K", stderr);
    line_open_ = false;
}

void Console::tell(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    eraseProgress();
    if (!quiet_)
        std::fprintf(stderr, "%s\n", sentence.c_str());
}

void Console::warn(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    eraseProgress();
    if (!quiet_)
        std::fprintf(stderr, "warning: %s\n", visibleText(shortText(sentence, kLongest)).c_str());
}

void Console::error(const Error& error) {
    const std::lock_guard lock(mutex_);
    eraseProgress();
    std::string text = error.text();
    if (!text.ends_with('.') && !text.ends_with('?'))
        text += '.';
    std::fprintf(stderr, "%s: %s\n", program_.c_str(), visibleText(shortText(text, kLongest)).c_str());
}

bool Console::print(const std::string& text) {
    const std::lock_guard lock(mutex_);
    eraseProgress();
    return quiet_ || json_ || writeAll(visibleText(text, Lines::kMany));
}

bool Console::printJson(const std::string& json) {
    const std::lock_guard lock(mutex_);
    eraseProgress();
    return writeAll(visibleJson(json) + "\n");
}

void Console::progress(double fraction, const std::string& stage) {
    if (!shows_progress_)
        return;
    const std::lock_guard lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_)
        return;
    next_ = now + kBetweenUpdates;
    line_open_ = true;
    std::fprintf(stderr, "\r\033[K%3.0f %%  %s", 100 * std::clamp(fraction, 0.0, 1.0),
                 visibleText(shortText(stage, kLongestStage)).c_str());
    std::fflush(stderr);
}

void Console::endProgress() {
    const std::lock_guard lock(mutex_);
    eraseProgress();
    std::fflush(stderr);
}

}  // namespace noctule::batch
