// SPDX-License-Identifier: Apache-2.0
// Turns the text of a BVH file into a BvhDocument; every step returns the first Error or goes on.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/formats/bvh.h"
#include "core/formats/bvh_scanner.h"

namespace noctule {

class BvhReader {
public:
    BvhReader(std::string_view text, const std::string& where) : scan_(text), where_(where) {}
    Result<BvhDocument> read();

private:
    Error error(const std::string& what, const std::string& remedy) const {
        return errorAt(scan_.line(), what, remedy);
    }
    Error errorAt(size_t line, const std::string& what, const std::string& remedy) const;
    void warn(size_t line, const std::string& text) { document_.warnings.push_back({line, text}); }
    Status expect(std::string_view word);

    // bvh_hierarchy.cpp
    Status readHierarchy();
    Status openJoint(const char* keyword);
    Status readJointLine(std::string_view keyword);
    Status closeJoint();
    Status readVector(const std::string& owner, Vector3d& v);
    Status readChannels(BvhJoint& joint);
    Status readEndSite(BvhJoint& joint);
    std::string uniqueName(std::string_view name);
    BvhJoint& innermost() { return document_.joints[static_cast<size_t>(open_.back())]; }

    // bvh_motion.cpp
    Status readMotionHeader();
    Status readRows();
    Status readRow(bool& cut_short);
    Error badNumber(size_t index, std::string_view word) const;
    void reserveRows();
    Status judgeFrameCount();

    static constexpr const char* kExportAgain = "Export the motion again; the file is damaged";

    /// Numbers beyond this are damage, and sums of them would overflow.
    static bool isPlausible(double value) { return value >= -1e9 && value <= 1e9; }

    BvhScanner scan_;
    const std::string& where_;
    BvhDocument document_;
    std::vector<int> open_;         ///< joints whose brace is open, outermost first
    std::vector<bool> has_offset_;  ///< per joint
    std::unordered_set<std::string> names_;
    size_t frames_line_ = 0;
};

}  // namespace noctule
