// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_markers.h"

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

Status changeMarker(const std::string& path, const MarkerChange& change, const JobContext& job) {
    auto take = Take::open(path, Access::kReadWrite, {job.cancel});
    if (!take)
        return take.error();
    const auto rate_hz = take->sampleRate_hz();
    if (!rate_hz)
        return rate_hz.error();
    const auto samples = take->sampleCount();
    if (!samples)
        return samples.error();
    const auto rate = static_cast<double>(*rate_hz);
    const double duration_s = static_cast<double>(*samples) / rate;
    if (change.after && !(change.after->t_s >= 0 && change.after->t_s <= duration_s))
        return outside(path, change.after->t_s, duration_s);
    const auto row = [rate](const UserMarker& marker) {
        return MarkerRow{std::llround(marker.t_s * rate), "user", marker.label};
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
