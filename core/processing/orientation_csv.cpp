// SPDX-License-Identifier: Apache-2.0
#include "core/processing/orientation_csv.h"

#include <algorithm>
#include <cstdio>

#include "core/body/actor.h"
#include "core/job/atomic_file.h"
#include "core/job/csv_cell.h"
#include "core/math/rotation.h"
#include "core/recording/take.h"

namespace noctule {

namespace {

constexpr int64_t kBridgedGap_ns = 100'000'000;
constexpr const char* kNoCells = ",,,,,,,";

/// ",qw,qx,qy,qz,a,b,c"; angles follow those of the row before.
std::string attitudeCells(const Quaterniond& q, const EulerSequence& sequence, Vector3d& angles_rad) {
    angles_rad = anglesFromRotation(sequence, q, angles_rad);
    char text[200];
    std::snprintf(text, sizeof text, ",%.7f,%.7f,%.7f,%.7f,%.4f,%.4f,%.4f", q.w(), q.x(), q.y(), q.z(),
                  degrees(angles_rad[0]), degrees(angles_rad[1]), degrees(angles_rad[2]));
    return text;
}

class OrientationTable {
public:
    OrientationTable(const Suit& suit, const EulerSequence& sequence)
        : suit_(suit), sequence_(sequence), rows_(suit.boards.size()) {}

    Status read(const Take& take, int64_t run) {
        for (size_t b = 0; b < rows_.size(); ++b) {
            auto rows = take.orientations(run, int(b));
            if (!rows)
                return rows.error();
            rows_[b] = std::move(*rows);
        }
        return Done{};
    }

    std::string head() const {
        std::string angles, relative;
        const char* axes = "xyz";
        int n = 0;
        for (const int axis : {sequence_.first, sequence_.second, sequence_.third}) {
            const std::string name = std::to_string(++n) + "_" + axes[axis] + "_deg";
            angles += ",angle" + name;
            relative += ",relative_angle" + name;
        }
        return "time_s,sensor,segment,qw,qx,qy,qz" + angles +
               ",relative_to,relative_qw,relative_qx,relative_qy,relative_qz" + relative + "\n";
    }

    std::string rowsOf(size_t board) const {
        const int before = boardBefore(board);
        const Board& here = suit_.boards[board];
        const std::string names = "," + csvCell(here.id) + "," + csvCell(here.segment);
        const std::string before_name = before < 0 ? "" : csvCell(suit_.boards[size_t(before)].id);
        Vector3d angles = Vector3d::Zero(), relative_angles = Vector3d::Zero();
        std::string text;
        for (const OrientationRow& row : rows_[board]) {
            char time[40];
            std::snprintf(time, sizeof time, "%.6f", double(row.time_ns) * 1e-9);
            text += time + names + attitudeCells(row.q_world_board, sequence_, angles) + "," + before_name;
            const auto q_before = before < 0 ? std::nullopt : at(size_t(before), row.time_ns);
            text += q_before
                        ? attitudeCells(q_before->conjugate() * row.q_world_board, sequence_, relative_angles)
                        : kNoCells;
            text += "\n";
        }
        return text;
    }

private:
    /// The board on the nearest segment between this one and the hips; -1: none.
    int boardBefore(size_t board) const {
        static const Skeleton skeleton = defaultActor().skeleton;
        int joint = skeleton.find(suit_.boards[board].segment);
        while (joint > 0) {
            joint = skeleton.joint(joint).parent;
            for (size_t b = 0; joint >= 0 && b < suit_.boards.size(); ++b)
                if (suit_.boards[b].segment == skeleton.joint(joint).name && !rows_[b].empty())
                    return int(b);
        }
        return -1;
    }

    std::optional<Quaterniond> at(size_t board, int64_t time_ns) const {
        const auto& rows = rows_[board];
        const auto after =
            std::lower_bound(rows.begin(), rows.end(), time_ns,
                             [](const OrientationRow& row, int64_t time) { return row.time_ns < time; });
        if (after == rows.end())
            return std::nullopt;
        if (after->time_ns == time_ns)
            return after->q_world_board;
        if (after == rows.begin() || after->time_ns - (after - 1)->time_ns > kBridgedGap_ns)
            return std::nullopt;
        const auto earlier = after - 1;
        const double share = double(time_ns - earlier->time_ns) / double(after->time_ns - earlier->time_ns);
        return earlier->q_world_board.slerp(share, after->q_world_board);
    }

    const Suit& suit_;
    const EulerSequence sequence_;
    std::vector<std::vector<OrientationRow>> rows_;
};

}  // namespace

Status writeOrientationCsv(const OrientationCsvRequest& request, const JobContext& job) {
    const auto take = Take::open(request.take_path);
    if (!take)
        return take.error();
    const auto runs = take->derivedRuns();
    const auto suit = take->suit();
    if (!runs || !suit)
        return runs ? suit.error() : runs.error();
    const auto run = std::find_if(runs->rbegin(), runs->rend(), [&](const DerivedRun& one) {
        return one.kind == "orientation" && (request.run_name.empty() || one.name == request.run_name);
    });
    if (run == runs->rend())
        return Error{ErrorKind::kUnusable, request.take_path + ": has no such result of orientations",
                     "Make one with: noctule --batch orient"};
    OrientationTable table(*suit, request.sequence);
    if (Status read = table.read(*take, run->run); !read)
        return read;
    std::string text = table.head();
    for (size_t b = 0; b < suit->boards.size(); ++b) {
        if (job.cancelled())
            return JobContext::cancelledError();
        text += table.rowsOf(b);
        job.progress(double(b + 1) / double(suit->boards.size()), "Table of orientations");
    }
    return writeFileAtomically(request.csv_path, text, request.overwrite);
}

}  // namespace noctule
