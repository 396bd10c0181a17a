// SPDX-License-Identifier: Apache-2.0
// One stage of a longer work: its 0..1 becomes a part of the whole, so that the whole never falls. With words
// of its own it is always told under these.
#pragma once

#include <string>

#include "core/job/job.h"

namespace noctule {

class StagedProgress : ProgressSink {
public:
    StagedProgress(const JobContext& whole, double from, double to, std::string words = {})
        : whole_(whole), from_(from), to_(to), words_(std::move(words)) {}

    JobContext job() { return {this, whole_.cancel}; }

private:
    void progress(double fraction, const std::string& stage) override {
        whole_.progress(from_ + (to_ - from_) * fraction, words_.empty() ? stage : words_);
    }

    JobContext whole_;
    double from_, to_;
    std::string words_;
};

}  // namespace noctule
