// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_markers.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/recording/take_edit.h"

namespace noctule {
namespace {

Error outside(const std::string& path, double t_s, double duration_s) {
    std::ostringstream message;
    message << path << ": a marker at " << t_s << " s lies outside the take of " << duration_s << " s";
    return {ErrorKind::kUsage, message.str(), "Set it between the take's start and end"};
}

}  // namespace

double MarkerClock::seconds(int64_t sample) const {
    return rate_hz > 0 ? clock.takeTime_s(static_cast<double>(sample) / rate_hz) : 0;
}

int64_t MarkerClock::sampleAt(double t_s) const {
    return std::llround(clock.suitTime_s(t_s) * rate_hz);
}

Result<MarkerClock> markerClock(Take& take) {
    const auto subjects = take.subjects();
    if (!subjects)
        return subjects.error();
    const auto wearer = std::ranges::find(*subjects, false, &TakeSubject::room);
    const int suit = (wearer != subjects->end() ? *wearer : subjects->front()).suit();
    take.view(suit);
    return MarkerClock{suit, take.suitClock(), static_cast<double>(take.header().sample_rate_hz)};
}

Status changeMarker(const std::string& path, const MarkerChange& change, const JobContext& job) {
    auto take = Take::open(path, Access::kReadWrite, {job.cancel});
    if (!take)
        return take.error();
    const auto clock = markerClock(*take);
    if (!clock)
        return clock.error();
    if (const auto rate_hz = take->sampleRate_hz(); !rate_hz)
        return rate_hz.error();
    const auto samples = take->sampleCount();
    if (!samples)
        return samples.error();
    const double end_s = clock->seconds(*samples);
    if (change.after &&
        !(change.after->t_s >= std::max(0.0, clock->seconds(0)) && change.after->t_s <= end_s))
        return outside(path, change.after->t_s, end_s);
    const auto row = [&clock](const UserMarker& marker) {
        return MarkerRow{clock->sampleAt(marker.t_s), "user", marker.label};
    };
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    if (change.before)
        if (Status removed = edit->removeMarker(row(*change.before)); !removed)
            return removed;
    if (change.after)
        if (Status added = edit->addMarker(row(*change.after)); !added)
            return added;
    if (job.cancelled())
        return JobContext::cancelledError();
    return edit->commit();
}

}  // namespace noctule
