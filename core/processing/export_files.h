// SPDX-License-Identifier: Apache-2.0
// The files' side of export_take.h: which writers a request needs. A new format is one line here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/processing/export_motion.h"

namespace noctule {

struct ExportWriter {
    std::string path;
    std::function<Status(const JobContext&)> write;
};

/// In the order of outputsOf(). Request and motion must outlive them.
std::vector<ExportWriter> exportWriters(const ExportRequest& request, const ExportedMotion& motion);

/// What FBX and GLB files hold of the motion.
Result<Figure> figureOf(const ExportRequest& request, const ExportedMotion& motion);

/// The default body in the measures of a skeleton whose feet lie flat as told; two seconds the first time.
SkinnedMesh bodyFor(const Skeleton& skeleton, const FeetAtRest& feet);

}  // namespace noctule
