// SPDX-License-Identifier: Apache-2.0
// The files' side of export_take.h: which writers a request needs. A new format is one line here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/processing/export_take.h"

namespace noctule {

struct ExportedMotion {
    MotionClip clip;
    std::vector<std::vector<float>> confidence;  ///< per frame and joint; empty: not known
    MotionClip filmed;                           ///< at the film's rate; empty without pictures
};

struct ExportWriter {
    std::string path;
    std::function<Status(const JobContext&)> write;
};

/// In the order of outputsOf(). Request and motion must outlive them.
std::vector<ExportWriter> exportWriters(const ExportRequest& request, const ExportedMotion& motion);

/// The default body in the measures of a skeleton; two seconds the first time.
SkinnedMesh bodyFor(const Skeleton& skeleton);

}  // namespace noctule
