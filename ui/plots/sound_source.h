// SPDX-License-Identifier: Apache-2.0
// The raw sound of boards for drawing: an overview of the whole take, and samples with pulses where the
// window is short enough. Read by quiet jobs on demand and kept while the take is open.
#pragma once

#include <QObject>
#include <QPointer>
#include <map>
#include <memory>

#include "core/review/series.h"
#include "ui/models/review_context.h"

namespace noctule::ui {

class SoundSource : public QObject {
    Q_OBJECT
public:
    explicit SoundSource(ReviewContext& review, QObject* parent = nullptr);

    /// Shorter windows than this show samples.
    static constexpr double kSamples_s = 3;

    struct Sound {
        std::shared_ptr<const SeriesPyramid> curve;
        std::vector<SoundWindow::PulseMark> pulses;
        double from_s = 0, to_s = 0;
        bool samples = false;  ///< false: envelope
    };
    /// The best that has been read for the window; null while nothing has. Asking starts reading.
    std::shared_ptr<const Sound> sound(int board, double from_s, double to_s);
    /// Why there is none; empty when that is not known.
    const QString& problem() const { return problem_; }

signals:
    void changed();

private:
    struct Board {
        std::shared_ptr<const Sound> envelope, window;
        QPointer<Job> envelope_job, window_job;
        bool failed = false;
    };
    void readEnvelope(int board);
    void readWindow(int board, double from_s, double to_s);
    void forget();

    ReviewContext& review_;
    std::map<int, Board> boards_;
    QString problem_;
    int generation_ = 0;  ///< results of an earlier take are dropped
};

}  // namespace noctule::ui
