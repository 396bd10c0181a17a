// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/joint_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kSound_m_per_s = 344;  ///< a clock's error in metres
constexpr double kLeastConfidence = 0.05;
constexpr double kRoomSourceOffset_m = 0.0008;
constexpr int64_t kTriedBefore = 200;       ///< an anchor is judged
constexpr double kMovedShare = 0.6;         ///< of its ranges contradict the others
constexpr double kFarOff_m = 0.15;          ///< at rest: an echo
constexpr double kDoubtfulAtRest_m = 0.01;  ///< where a rest pose is not quite the one asked for

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

JointFilter::JointFilter(std::vector<JointBody> bodies, std::optional<Room> room,
                         std::vector<ClockLine> clocks, std::vector<JointDistance> distances,
                         const JointParameters& parameters)
    : parameters_(parameters), room_(std::move(room)), distances_(std::move(distances)) {
    alignment_.clocks = std::move(clocks);
    for (JointBody& made_of : bodies) {
        Body body;
        made_of.parameters.among_others = true;
        body.filter = std::make_unique<ManifoldFilter>(made_of.skeleton, made_of.suit, made_of.parameters);
        body.model = std::make_unique<ObservationModel>(body.filter->tree(), body.filter->suit(),
                                                        body.filter->layout());
        body.tree = KinematicTree(made_of.skeleton, BallCoordinates::kManifold);
        body.made_of = std::move(made_of);
        bodies_.push_back(std::move(body));
    }
    layOut();
}

void JointFilter::layOut() {
    int next = 0;
    const auto reserve = [&](int count) { return std::exchange(next, next + count); };
    clock_at_.assign(bodies_.size() + 1, -1);
    for (size_t member = 1; member < clock_at_.size() && !parameters_.clocks_shared; ++member)
        if (member < bodies_.size() || room_)
            clock_at_[member] = reserve(2);
    if (room_) {
        for (size_t board = 0; board < room_->suit.boards.size(); ++board)
            board_at_.push_back(reserve(3));
        for (size_t source = 0; source < room_->suit.sources.size(); ++source) {
            const int housing = room_->housings[source];
            source_at_.push_back(housing >= 0 ? board_at_[static_cast<size_t>(housing)] : reserve(3));
            source_offset_at_.push_back(reserve(1));
        }
    }
    common_ = Eigen::VectorXd::Zero(next);
}

void JointFilter::start(size_t body, const Pose& rest_pose, const RestReadings& rest) {
    bodies_[body].rest_pose = rest_pose;
    bodies_[body].rest = rest;
}

double JointFilter::now_s(size_t body) const {
    return alignment_.clocks[body].common_s(bodies_[body].filter->seconds());
}

std::vector<RestingMember> JointFilter::restingMembers() const {
    constexpr double kAtLeast_s = 0.5;  // nobody moves at once
    std::vector<RestingMember> members;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = bodies_[i];
        const MotionState motion = body.tree.stateFromPose(*body.rest_pose);
        RestingMember member;
        ChainMotion chain;
        const auto at = [&](int link, const Vector3d& p) -> Vector3d {
            if (link < 0)
                return p;
            chain.evaluate(body.tree, motion, link, 0);
            return chain.point(p).p_m;
        };
        for (const MountedSource& source : body.made_of.suit.sources)
            member.sources_m.push_back(at(source.link, source.p_link_source));
        for (const MountedBoard& board : body.made_of.suit.boards)
            member.microphones_m.push_back(at(board.link, placeBoard(board, body.tree, motion, 0).p_mic_m));
        const ClockLine& clock = alignment_.clocks[i];
        member.from_s = clock.common_s(body.rest.begin_s);
        member.to_s = clock.common_s(std::max(body.rest.end_s, body.rest.begin_s + kAtLeast_s));
        member.clock_known = i == 0 || body.made_of.clock_known || parameters_.clocks_shared;
        members.push_back(std::move(member));
    }
    RestingMember room;
    room.is_room = true;
    if (room_) {
        room.clock_known = room_->clock_known || parameters_.clocks_shared;
        for (const MountedSource& source : room_->suit.sources)
            room.sources_m.push_back(source.p_link_source);
        for (const MountedBoard& board : room_->suit.boards)
            room.microphones_m.push_back(board.p_link_mic);
    }
    members.push_back(std::move(room));
    return members;
}

void JointFilter::begin() {
    begun_ = true;
    const std::vector<RestingMember> members = restingMembers();
    alignment_ = alignAtRest(members, distances_, alignment_.clocks, room_.has_value());
    for (size_t i = 0; i < bodies_.size(); ++i)
        bodies_[i].joined = alignment_.places[i].placed;
    order_.resize(distances_.size());
    std::iota(order_.begin(), order_.end(), size_t{0});
    const auto arrives_s = [&](size_t index) {
        const JointDistance& distance = distances_[index];
        return alignment_.clocks[static_cast<size_t>(distance.to)].common_s(distance.arrival_s);
    };
    std::ranges::stable_sort(order_, {}, arrives_s);
    startBodies();
    useRest();
}

void JointFilter::startBodies() {
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(common_.size());
    const auto set = [&](int first, int count, double sigma) {
        if (first >= 0)
            variance.segment(first, count).setConstant(sigma * sigma);
    };
    for (const int at : clock_at_) {
        set(at, 1, parameters_.unknown_clock_m);
        set(at < 0 ? at : at + 1, 1, parameters_.unknown_rate_m_per_s);
    }
    for (const int at : board_at_)
        set(at, 3, parameters_.anchor_m);
    for (const int at : source_at_)
        set(at, 3, parameters_.anchor_m);
    for (const int at : source_offset_at_)
        set(at, 1, kRoomSourceOffset_m);
    std::vector<ManifoldFilter*> filters;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = bodies_[i];
        Pose pose = *body.rest_pose;
        const RestPlace& place = alignment_.places[i];
        const Quaterniond turn(axisAngle(Vector3d::UnitY(), place.heading_rad));
        pose.p_world_root = place.p_m + turn * pose.p_world_root;
        pose.q_parent_joint[0] = turn * pose.q_parent_joint[0];
        body.filter->start(pose, body.rest, nullptr);
        body.poses = body.filter->takePoses();
        if (body.joined && (room_ || i > 0))
            body.filter->loosenRoot(parameters_.unknown_place_m, parameters_.unknown_heading_rad);
        filters.push_back(body.filter.get());
        common_s_ = i == 0 ? now_s(i) : std::min(common_s_, now_s(i));
    }
    covariance_ = JointCovariance(std::move(filters), variance);
}

/// Ranges of the rest pose, one mean per pair and half second.
void JointFilter::useRest() {
    constexpr double kBin_s = 0.5;
    const std::vector<RestingMember> still = restingMembers();
    struct Mean {
        JointDistance distance;
        double error_m = 0, count = 0, time_s = 0;
    };
    std::map<std::array<int, 5>, Mean> means;
    for (const JointDistance& distance : distances_) {
        const auto from = static_cast<size_t>(distance.from), to = static_cast<size_t>(distance.to);
        const double emitted_s = alignment_.clocks[from].common_s(distance.emission_s);
        const auto within = [&](size_t member) {
            return member == room() || (bodies_[member].joined && emitted_s >= still[member].from_s &&
                                        emitted_s <= still[member].to_s);
        };
        if (!within(from) || !within(to) || distance.confidence < kLeastConfidence)
            continue;
        const auto bin = static_cast<int>(std::floor((emitted_s - common_s_) / kBin_s));
        Mean& mean = means[{distance.from, distance.source, distance.to, distance.board, bin}];
        if (mean.count == 0)
            mean.distance = distance;
        mean.count += 1;
        mean.error_m += (distance.distance_m(alignment_.clocks) -
                         mean.distance.distance_m(alignment_.clocks) - mean.error_m) /
                        mean.count;
        mean.time_s += (emitted_s - mean.time_s) / mean.count;
    }
    std::set<int> seen;
    for (const auto& [pair, mean] : means)
        seen.insert(pair[4]);
    const auto bins = static_cast<double>(seen.size());  // the means of a pair share what is lasting
    std::vector<JointRow> rows;
    for (auto& [pair, mean] : means) {
        JointDistance distance = mean.distance;
        distance.beyond_m += mean.error_m;
        JointDecision decision;
        // The bodies are still: sent and heard at the state's time.
        const auto timed = [&](int member) {
            return static_cast<size_t>(member) == room() ? 0 : filter(static_cast<size_t>(member)).seconds();
        };
        const double measured_m = distance.distance_m(alignment_.clocks);
        distance.emission_s = timed(distance.from);
        distance.arrival_s = timed(distance.to);
        distance.beyond_m += measured_m - distance.distance_m(alignment_.clocks);
        auto row = rowOf(distance, mean.time_s - common_s_, decision);
        if (!row || std::abs(row->residual) > kFarOff_m)
            continue;
        row->variance = (row->variance + std::pow(kDoubtfulAtRest_m, 2)) * bins;
        rows.push_back(std::move(*row));
    }
    common_ += covariance_.update(std::move(rows));
}

Vector3d JointFilter::anchorError(int first) const {
    return common_.segment<3>(first);
}

/// The row's residual and Jacobian; its variance is that of the reading. `offset_s`: of its instant against
/// the common state's time. Nothing where it tells nothing.
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
    const double sigma = distance.sigma_m / std::max(distance.confidence, kLeastConfidence);
    const ManifoldParameters& parameters = filter(of_sound).parameters();
    row.variance =
        sigma * sigma + std::pow(parameters.distance_floor_m, 2) + std::pow(parameters.echo_pull_m, 2);
    for (const size_t member : {from, to})
        if (member != room())
            row.variance += std::pow(filter(member).fleshShare() * parameters_.flesh_m, 2);
    return row;
}

void JointFilter::carryCommon(double time_s) {
    const double dt_s = time_s - common_s_;
    if (dt_s <= 0)
        return;
    common_s_ = time_s;
    Eigen::MatrixXd F = Eigen::MatrixXd::Identity(common_.size(), common_.size());
    Eigen::VectorXd noise = Eigen::VectorXd::Zero(common_.size());
    for (const int at : clock_at_)
        if (at >= 0) {
            F(at, at + 1) = dt_s;
            noise[at] = std::pow(parameters_.clock_wander_m, 2) * dt_s;
            noise[at + 1] = std::pow(parameters_.rate_wander_m_per_s, 2) * dt_s;
        }
    common_ = (F * common_).eval();
    covariance_.carryCommon(F, noise);
}

void JointFilter::show(Body& body) {
    if (!body.shown)
        body.poses.push_back(body.filter->poseNow());
    body.shown = true;
}

void JointFilter::stepBody(size_t index) {
    Body& body = bodies_[index];
    show(body);
    tape_.clear();
    body.filter->setTape(&tape_);
    body.filter->step(body.filter->nextInput());
    body.filter->setTape(nullptr);
    if (body.joined)
        covariance_.carry(index, tape_);
    body.shown = !body.filter->isAtFrame();
}

/// This step's corrections have moved the estimates; covariances must fit them before a row is made.
void JointFilter::refit() {
    for (size_t i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].joined)
            continue;
        tape_.clear();
        filter(i).setTape(&tape_);
        filter(i).refit();
        filter(i).setTape(nullptr);
        covariance_.carry(i, tape_);
    }
}

void JointFilter::advance(bool ended) {
    if (std::ranges::any_of(bodies_, [](const Body& body) { return !body.rest_pose; }))
        return;
    if (!begun_)
        begin();
    while (true) {
        size_t first = bodies_.size();
        double first_s = 0;
        for (size_t i = 0; i < bodies_.size(); ++i) {
            if (ended && !bodies_[i].filter->isDue(bodies_[i].given_s))
                continue;  // it has come to its end
            const double next_s =
                alignment_.clocks[i].common_s(filter(i).seconds() + filter(i).stepSeconds());
            if (first == bodies_.size() || next_s < first_s)
                first = i, first_s = next_s;
        }
        if (first == bodies_.size() || !filter(first).isDue(bodies_[first].given_s))
            break;
        stepBody(first);
        double until_s = now_s(first);
        for (size_t i = 0; i < bodies_.size(); ++i)
            until_s = std::min(until_s, now_s(i));
        useDistances(until_s + 0.5 * filter(first).stepSeconds());
    }
    if (!ended)
        return;
    for (Body& body : bodies_)
        show(body);
    for (; next_ < order_.size(); ++next_)
        decisions_.push_back({order_[next_], RangeFate::kNotTried, 1, 0});
}

bool JointFilter::isUsed(const JointDistance& distance) const {
    for (const int member : {distance.from, distance.to}) {
        const auto index = static_cast<size_t>(member);
        if (index == room() ? !room_ : !bodies_[index].joined)
            return false;
    }
    const auto moved = [&](int board) { return std::ranges::count(alignment_.moved_anchors, board) > 0; };
    if (static_cast<size_t>(distance.from) == room() &&
        moved(room_->housings[static_cast<size_t>(distance.source)]))
        return false;
    return static_cast<size_t>(distance.to) != room() || !moved(distance.board);
}

void JointFilter::useDistances(double until_s) {
    std::vector<JointRow> rows;
    std::vector<JointDecision> tried;
    for (; next_ < order_.size(); ++next_) {
        const JointDistance& distance = distances_[order_[next_]];
        const auto from = static_cast<size_t>(distance.from), to = static_cast<size_t>(distance.to);
        const double arrives_s = alignment_.clocks[to].common_s(distance.arrival_s);
        if (arrives_s > until_s)
            break;
        JointDecision decision{order_[next_], RangeFate::kNotTried, 1, 0};
        const auto too_early = [&](size_t member, double time_s) {
            return member != room() && time_s < bodies_[member].rest.end_s;
        };
        if (!isUsed(distance) || too_early(from, distance.emission_s) || too_early(to, distance.arrival_s)) {
            decisions_.push_back(decision);
            continue;
        }
        carryCommon(std::max(common_s_, arrives_s));
        if (tried.empty())
            refit();
        auto row = rowOf(distance, arrives_s - common_s_, decision);
        decision.innovation_m = row->residual;
        decision.fate = decision.w_a == 0                        ? RangeFate::kBehindSource
                        : distance.confidence < kLeastConfidence ? RangeFate::kNoConfidence
                                                                 : RangeFate::kUsed;
        if (decision.fate != RangeFate::kUsed) {
            decisions_.push_back(decision);
            continue;
        }
        rows.push_back(std::move(*row));
        tried.push_back(decision);
    }
    if (!rows.empty())
        observe(std::move(rows), std::move(tried));
}

void JointFilter::observe(std::vector<JointRow> rows, std::vector<JointDecision> decisions) {
    common_ += covariance_.update(
        std::move(rows),
        [&](const Eigen::MatrixXd& HPH, std::vector<JointRow>& of) { return judge(HPH, of, decisions); });
    decisions_.insert(decisions_.end(), decisions.begin(), decisions.end());
}

/// Gate, Huber's weight and the noise that a pair has beyond its data sheet, as for a body's own distances.
std::vector<Eigen::Index> JointFilter::judge(const Eigen::MatrixXd& HPH, std::vector<JointRow>& rows,
                                             std::vector<JointDecision>& decisions) {
    std::vector<Eigen::Index> kept;
    for (size_t r = 0; r < rows.size(); ++r) {
        JointRow& row = rows[r];
        const JointDistance& distance = distances_[decisions[r].distance];
        const auto at = static_cast<Eigen::Index>(r);
        auto& [noise, before] =
            excess_
                .try_emplace({distance.from, distance.source, distance.to, distance.board},
                             ExcessNoise(parameters_.excess), Eigen::VectorXd())
                .first->second;
        const Eigen::VectorXd innovation = Eigen::VectorXd::Constant(1, row.residual);
        const Eigen::VectorXd expected = Eigen::VectorXd::Constant(1, HPH(at, at) + row.variance);
        const double variance = expected[0] + noise.variance();
        noise.learn(innovation, expected, before);
        const double ratio = std::abs(row.residual) / std::sqrt(variance);
        const bool gated = ratio > parameters_.gate_sigma;
        decisions[r].fate = gated                             ? RangeFate::kGated
                            : ratio > parameters_.huber_sigma ? RangeFate::kWeighted
                                                              : RangeFate::kUsed;
        row.variance += std::max(0.0, ratio / parameters_.huber_sigma - 1) * variance;
        row.variance += noise.whitenedVariance();
        const int anchor = static_cast<size_t>(distance.from) == room()
                               ? room_->housings[static_cast<size_t>(distance.source)]
                           : static_cast<size_t>(distance.to) == room() ? distance.board
                                                                        : -1;
        if (anchor >= 0) {
            anchors_[anchor].tried += 1;
            anchors_[anchor].gated += gated ? 1 : 0;
        }
        if (!gated)
            kept.push_back(at);
    }
    if (parameters_.share >= 1)
        return kept;
    const std::vector<Eigen::Index> chosen = mostInformative(HPH, rows, kept);
    for (const Eigen::Index row : kept)
        if (std::ranges::count(chosen, row) == 0)
            decisions[static_cast<size_t>(row)].fate = RangeFate::kNotTried;
    return chosen;
}

/// Greedy by the determinant of the innovation's covariance: the next one is that of the largest variance
/// against its noise, given those chosen before.
std::vector<Eigen::Index> JointFilter::mostInformative(Eigen::MatrixXd HPH, const std::vector<JointRow>& rows,
                                                       std::vector<Eigen::Index> among) {
    owed_ += parameters_.share * static_cast<double>(among.size());
    std::vector<Eigen::Index> chosen;
    while (!among.empty() && owed_ >= 1) {
        const auto gain = [&](Eigen::Index row) {
            return HPH(row, row) / rows[static_cast<size_t>(row)].variance;
        };
        const auto best = std::ranges::max_element(among, {}, gain);
        const Eigen::Index row = *best;
        const Eigen::VectorXd seen = HPH.col(row);
        HPH -= seen * seen.transpose() / (seen[row] + rows[static_cast<size_t>(row)].variance);
        chosen.push_back(row);
        among.erase(best);
        owed_ -= 1;
    }
    std::ranges::sort(chosen);
    return chosen;
}

ClockLine JointFilter::clockNow(size_t member) const {
    ClockLine line = alignment_.clocks[member];
    if (const int at = clock_at_[member]; at >= 0) {
        const double b_s = common_[at] / kSound_m_per_s, rate = common_[at + 1] / kSound_m_per_s;
        line.offset_s -= b_s + rate * (line.offset_s - common_s_);
        line.rate *= 1 - rate;
    }
    return line;
}

double JointFilter::clockSigma_s(size_t member) const {
    const int at = clock_at_[member];
    return at < 0 ? 0 : std::sqrt(covariance_.common()(at, at)) / kSound_m_per_s;
}

std::vector<int> JointFilter::movedAnchors() const {
    std::vector<int> moved = alignment_.moved_anchors;
    for (const auto& [anchor, tally] : anchors_)
        if (tally.tried >= kTriedBefore &&
            static_cast<double>(tally.gated) > kMovedShare * static_cast<double>(tally.tried) &&
            std::ranges::count(moved, anchor) == 0)
            moved.push_back(anchor);
    std::ranges::sort(moved);
    return moved;
}

}  // namespace noctule
