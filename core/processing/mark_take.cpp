// SPDX-License-Identifier: Apache-2.0
#include "core/processing/mark_take.h"

#include <cmath>
#include <sstream>

#include "core/recording/take_edit.h"

namespace noctule {

Status markTake(const std::string& path, double t_s, const std::string& label, const JobContext& job) {
    auto take = Take::open(path, Access::kReadWrite);
    if (!take)
        return take.error();
    const auto rate_hz = take->sampleRate_hz();
    if (!rate_hz)
        return rate_hz.error();
    const auto samples = take->sampleCount();
    if (!samples)
        return samples.error();
    const double duration_s = static_cast<double>(*samples) / static_cast<double>(*rate_hz);
    if (!(t_s >= 0 && t_s <= duration_s)) {
        std::ostringstream message;
        message << path << ": a marker at " << t_s << " s lies outside the take of " << duration_s << " s";
        return Error{ErrorKind::kUsage, message.str(), "Set it between the take's start and end"};
    }
    auto edit = TakeEdit::begin(*take);
    if (!edit)
        return edit.error();
    const int64_t sample = std::llround(t_s * static_cast<double>(*rate_hz));
    if (Status added = edit->addMarker({sample, "user", label}); !added)
        return added;
    if (job.cancelled())
        return JobContext::cancelledError();
    return edit->commit();
}

}  // namespace noctule
