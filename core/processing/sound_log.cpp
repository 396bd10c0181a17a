// SPDX-License-Identifier: Apache-2.0
#include "core/processing/sound_log.h"

namespace noctule {

Result<SoundLog> readSoundLog(const Take& take) {
    auto pulses = take.pulses();
    if (!pulses)
        return pulses.error();
    const auto rows = take.statusRows();
    if (!rows)
        return rows.error();
    auto gaps = take.gaps();
    if (!gaps)
        return gaps.error();
    SoundLog log{std::move(*pulses), {}, std::move(*gaps)};
    for (const StatusRow& row : *rows)
        log.statuses.push_back({row.sample, row.temperature_c, row.humidity_percent});
    return log;
}

}  // namespace noctule
