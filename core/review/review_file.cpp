// SPDX-License-Identifier: Apache-2.0
#include "core/review/review_file.h"

namespace noctule {

Result<ReviewFile> ReviewFile::open(const std::string& path) {
    auto take = Take::open(path);
    if (!take)
        return take.error();
    const auto rate_hz = take->sampleRate_hz();
    if (!rate_hz)
        return rate_hz.error();
    return ReviewFile{std::move(*take), static_cast<double>(*rate_hz)};
}

}  // namespace noctule
