// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/sound_source.h"

#include <algorithm>
#include <cmath>

#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

/// Enough that the overview still has a column per pixel when samples take over.
constexpr double kColumnsPerSecond = 400;
constexpr int kMostColumns = 400'000;

/// Every column as two values, so that drawing finds both.
SoundSource::Sound soundOf(const SoundEnvelope& envelope, double duration_s) {
    Series series;
    const size_t columns = envelope.min.size();
    const double step_s = duration_s / static_cast<double>(std::max<size_t>(1, columns));
    for (size_t c = 0; c < columns; ++c) {
        series.t_s.push_back((static_cast<double>(c) + 0.25) * step_s);
        series.t_s.push_back((static_cast<double>(c) + 0.75) * step_s);
        series.value.push_back(envelope.min[c]);
        series.value.push_back(envelope.max[c]);
    }
    return {std::make_shared<SeriesPyramid>(std::move(series)), {}, 0, duration_s, false};
}

SoundSource::Sound soundOf(SoundWindow window) {
    Series series;
    series.value = std::move(window.value);
    series.t_s.resize(series.value.size());
    for (size_t i = 0; i < series.t_s.size(); ++i)
        series.t_s[i] = window.from_s + static_cast<double>(i) / window.sample_rate_hz;
    const double to_s = series.t_s.empty() ? window.from_s : series.t_s.back();
    return {std::make_shared<SeriesPyramid>(std::move(series)), std::move(window.pulses), window.from_s, to_s,
            true};
}

}  // namespace

SoundSource::SoundSource(ReviewContext& review, QObject* parent) : QObject(parent), review_(review) {
    connect(&review.take(), &TakeDocument::opened, this, &SoundSource::forget);
    connect(&review.take(), &TakeDocument::runsChanged, this, &SoundSource::forget);
}

void SoundSource::forget() {
    ++generation_;
    for (const auto& [number, board] : boards_)
        for (const auto& job : {board.envelope_job, board.window_job})
            if (job)
                job->cancel();
    boards_.clear();
    problem_.clear();
    emit changed();
}

std::shared_ptr<const SoundSource::Sound> SoundSource::sound(int number, double from_s, double to_s) {
    Board& board = boards_[number];
    if (board.failed)
        return nullptr;
    if (!board.envelope && !board.envelope_job)
        readEnvelope(number);
    if (to_s - from_s > kSamples_s)
        return board.envelope;
    const bool covered = board.window && board.window->from_s <= from_s + 1e-3 &&
                         board.window->to_s >= std::min(to_s, review_.time().duration()) - 1e-3;
    if (covered)
        return board.window;
    if (!board.window_job)
        readWindow(number, from_s, to_s);
    return board.envelope;
}

void SoundSource::readEnvelope(int number) {
    const double duration_s = review_.time().duration();
    const int columns = std::clamp(static_cast<int>(duration_s * kColumnsPerSecond), 64, kMostColumns);
    boards_[number].envelope_job = review_.shared().jobs().start<Sound>(
        tr("Reading the sound of board %1").arg(number + 1),
        [view = review_.take().view(), number, columns, duration_s](const JobContext& job) -> Result<Sound> {
            auto envelope = loadSoundEnvelope(view, number, columns, job);
            if (!envelope)
                return envelope.error();
            return soundOf(*envelope, duration_s);
        },
        [this, self = QPointer<SoundSource>(this), number, generation = generation_](Result<Sound> sound) {
            if (!self || generation != generation_)
                return QString();
            if (sound)
                boards_[number].envelope = std::make_shared<const Sound>(std::move(*sound));
            else if (sound.error().kind != ErrorKind::kCancelled) {
                boards_[number].failed = true;
                problem_ = coreWords(sound.error());
            }
            emit changed();
            return QString();
        },
        Jobs::Loudness::kQuiet);
}

void SoundSource::readWindow(int number, double from_s, double to_s) {
    const auto overview = review_.take().overview();
    const int shown = review_.take().shownRun();
    std::optional<int64_t> range_run;
    if (overview && shown >= 0)
        range_run = overview->runs[static_cast<size_t>(shown)].settings.range_run;
    const double margin_s = (to_s - from_s) / 2;  // so that panning does not read at every step
    const double first_s = std::max(0.0, from_s - margin_s);
    const double last_s = std::min(review_.time().duration(), to_s + margin_s);
    boards_[number].window_job = review_.shared().jobs().start<Sound>(
        tr("Reading the sound of board %1").arg(number + 1),
        [view = review_.take().view(), number, first_s, last_s,
         range_run](const JobContext& job) -> Result<Sound> {
            auto window = loadSound(view, number, first_s, last_s, range_run, job);
            if (!window)
                return window.error();
            Sound sound = soundOf(std::move(*window));
            sound.from_s = first_s, sound.to_s = last_s;
            return sound;
        },
        [this, self = QPointer<SoundSource>(this), number, generation = generation_](Result<Sound> sound) {
            if (!self || generation != generation_)
                return QString();
            boards_[number].window_job.clear();
            if (sound)
                boards_[number].window = std::make_shared<const Sound>(std::move(*sound));
            else if (sound.error().kind != ErrorKind::kCancelled) {
                boards_[number].failed = true;
                problem_ = coreWords(sound.error());
            }
            emit changed();
            return QString();
        },
        Jobs::Loudness::kQuiet);
}

}  // namespace noctule::ui
