// SPDX-License-Identifier: Apache-2.0
// What a range between two members of a joint filter tells: residual, Jacobian and variance.
#include <algorithm>
#include <cmath>

#include "core/estimation/joint_filter.h"

namespace noctule {
namespace {

JointRow emptyRow(size_t members) {
    JointRow row;
    row.of.resize(members);
    for (ObservationBlock& block : row.of)
        block.H.resize(1, 0);
    return row;
}

void addColumn(ObservationBlock& block, int column, double value) {
    const auto found = std::ranges::find(block.columns, column);
    if (found != block.columns.end()) {
        block.H(0, found - block.columns.begin()) += value;
        return;
    }
    block.H.conservativeResize(1, block.H.cols() + 1);
    block.H(0, block.H.cols() - 1) = value;
    block.columns.push_back(column);
}

}  // namespace

Vector3d JointFilter::anchorError(int first) const {
    return common_.segment<3>(first);
}

/// The row's residual and Jacobian; its variance is that of the reading. `offset_s`: of its instant against
/// the common state's time. Nothing where it tells nothing.
/// r = R^T (p_other - p), whose derivative by a turn of R = R exp(d) is [r]x d.
Matrix3d JointFilter::relativeCovariance(size_t body, int joint, size_t other, int other_joint) {
    const BodyState &of = filter(body).state(), &of_other = filter(other).state();
    const Matrix3d R = of.motion.q_parent_link[0].toRotationMatrix();
    const auto end = [&](size_t which, int at, const BodyState& state) {
        return bodies_[which].model->linkEnd(state, filter(which).tree().linkOfJoint(at)).p_world_m;
    };
    std::vector<JointRow> rows(3, emptyRow(bodies_.size() + 1));
    const Vector3d p = end(body, joint, of);
    for (int axis = 0; axis < 3; ++axis)
        bodies_[body].model->addEnd(rows[static_cast<size_t>(axis)].of[body], -R.col(axis));
    const Vector3d p_other = end(other, other_joint, of_other);
    for (int axis = 0; axis < 3; ++axis)
        bodies_[other].model->addEnd(rows[static_cast<size_t>(axis)].of[other], R.col(axis));
    const Matrix3d turned = skew(R.transpose() * (p_other - p));
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 3; ++k)
            addColumn(rows[static_cast<size_t>(axis)].of[body], filter(body).layout().theta(3 + k),
                      turned(axis, k));
    return covariance_.of(rows);
}

std::optional<JointRow> JointFilter::rowOf(const JointDistance& distance, double offset_s,
                                           JointDecision& decision) {
    const auto from = static_cast<size_t>(distance.from), to = static_cast<size_t>(distance.to);
    const auto s = static_cast<size_t>(distance.source), b = static_cast<size_t>(distance.board);
    ObservationModel::End sent, heard;
    if (from == room())
        sent = {room_->suit.sources[s].p_link_source + anchorError(source_at_[s]),
                room_->suit.sources[s].normal_link};
    else
        sent = bodies_[from].model->sourceEnd(filter(from).state(), distance.source,
                                              distance.emission_s - filter(from).seconds());
    if (to == room())
        heard.p_world_m = room_->suit.boards[b].p_link_mic + anchorError(board_at_[b]);
    else
        heard = bodies_[to].model->boardEnd(filter(to).state(), distance.board,
                                            distance.arrival_s - filter(to).seconds());
    const Vector3d between = heard.p_world_m - sent.p_world_m;
    const double geometric = std::max(between.norm(), 1e-6);
    const Vector3d direction = between / geometric;
    decision.w_a = sent.normal_world.dot(direction) >= 0 ? 1 : 0;

    JointRow row = emptyRow(bodies_.size() + 1);
    ObservationBlock& common = row.of.back();
    const size_t of_sound = from == room() ? to : from;  // whose scale of sound counts
    const double stretch = 1 + filter(of_sound).state().sound_scale;
    double expected = geometric * stretch;
    const auto anchor = [&](int first, double sign) {
        for (int axis = 0; axis < 3; ++axis)
            addColumn(common, first + axis, sign * stretch * direction[axis]);
    };
    const auto clock = [&](size_t member, double sign) {
        const int at = clock_at_[member];
        if (at < 0)
            return;
        expected += sign * (common_[at] + offset_s * common_[at + 1]);
        addColumn(common, at, sign);
        addColumn(common, at + 1, sign * offset_s);
    };
    clock(to, 1);
    clock(from, -1);
    if (from == room()) {
        anchor(source_at_[s], -1);
        expected += common_[source_offset_at_[s]];
        addColumn(common, source_offset_at_[s], 1);
    } else {
        bodies_[from].model->addEnd(row.of[from], -stretch * direction);
        expected += filter(from).state().source_offset_m[s];
        if (const int first = filter(from).layout().source_offset; first >= 0)
            addColumn(row.of[from], first + distance.source, 1);
    }
    if (to == room())
        anchor(board_at_[b], 1);
    else
        bodies_[to].model->addEnd(row.of[to], stretch * direction);
    if (const int scale = filter(of_sound).layout().sound_scale; scale >= 0)
        addColumn(row.of[of_sound], scale, geometric);
    row.residual = distance.distance_m(alignment_.clocks) - expected;
    for (size_t member = 0; member < bodies_.size(); ++member)
        if (const auto& apart = filter(member).memory().apart; apart && !row.of[member].columns.empty())
            row.residual -= row.of[member].of(*apart)[0];
    const double sigma = distance.sigma_m / std::max(distance.confidence, kLeastConfidence);
    const ManifoldParameters& parameters = filter(of_sound).parameters();
    row.variance =
        sigma * sigma + std::pow(parameters.distance_floor_m, 2) + std::pow(parameters.echo_pull_m, 2);
    for (const size_t member : {from, to})
        if (member != room())
            row.variance += std::pow(filter(member).fleshShare() * parameters_.flesh_m, 2);
    return row;
}

}  // namespace noctule
