// SPDX-License-Identifier: Apache-2.0
// A made take with a result, and a request for a part of it in the middle.
#pragma once

#include "core/processing/export_take.h"
#include "tests/core/processing/made_take.h"

namespace noctule::test {

class MadeExport : public MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        addRuns("AGD manifold");
        request_.take_path = path();
        request_.frames_per_second = 45;
        request_.from_s = 0.4;
        request_.to_s = 1.6;
    }
    ExportRequest request_;
};

}  // namespace noctule::test
