// SPDX-License-Identifier: Apache-2.0
#include "ui/views/job_words.h"

namespace noctule::ui {

QString JobWords::timeLeft(const Job& job) {
    const auto seconds = job.secondsLeft();
    if (!seconds)
        return {};
    return *seconds < 100 ? tr("%n s left", "seconds", *seconds)
                          : tr("%n min left", "minutes", (*seconds + 30) / 60);
}

QString JobWords::progress(const Job& job) {
    const QString left = timeLeft(job);
    if (job.stage().isEmpty() && left.isEmpty())
        return job.title();
    if (job.stage().isEmpty())
        return tr("%1: %2", "title of a job: time left").arg(job.title(), left);
    if (left.isEmpty())
        return tr("%1: %2", "title of a job: its stage").arg(job.title(), job.stage());
    return tr("%1: %2, %3", "title of a job: its stage, time left").arg(job.title(), job.stage(), left);
}

}  // namespace noctule::ui
