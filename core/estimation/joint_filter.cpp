// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/joint_filter.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kSound_m_per_s = 344;      ///< a clock's error in metres
constexpr std::ptrdiff_t kFewestInUse = 3;  ///< anchors that hold a room: two fit nearly everywhere
constexpr int64_t kTriedBefore = 200;       ///< an anchor is judged, and one that seems moved is named
constexpr double kMovedShare = 0.6;         ///< of its ranges contradict the others
constexpr double kOffMemory = 150;  ///< ranges of an anchor over which the share that is off is learnt: 1 s
constexpr double kOffShare = 0.7;   ///< of the ranges of an anchor that seems moved
constexpr double kInPlaceShare = 0.35;  ///< at most, of the ranges of one that is not
constexpr double kOffSigma = 4;         ///< of what is stated
constexpr double kMovedNoise_m = 0.04;  ///< beyond a survey's errors

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

void JointFilter::end(size_t body) {
    bodies_[body].ended = true;
    bodies_[body].filter->end();
}

double JointFilter::now_s(size_t body) const {
    return alignment_.clocks[body].common_s(bodies_[body].filter->seconds());
}

bool JointFilter::isOver(size_t body) const {
    return bodies_[body].ended && !bodies_[body].filter->isDue(bodies_[body].given_s);
}

double JointFilter::reached_s() const {
    double least_s = now_s(0);
    for (size_t i = 1; i < bodies_.size(); ++i)
        least_s = std::min(least_s, now_s(i));
    return least_s;
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
    for (size_t i = 0; ended && i < bodies_.size(); ++i)
        end(i);
    while (true) {
        size_t first = bodies_.size();
        double first_s = 0;
        for (size_t i = 0; i < bodies_.size(); ++i) {
            if (isOver(i))
                continue;
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
            if (!isOver(i))
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

bool JointFilter::isJoined(const JointDistance& distance) const {
    for (const int member : {distance.from, distance.to}) {
        const auto index = static_cast<size_t>(member);
        if (index == room() ? !room_ : !bodies_[index].joined)
            return false;
    }
    return true;
}

/// The board of the room that a range starts or ends at; -1: none.
int JointFilter::anchorOf(const JointDistance& distance) const {
    return static_cast<size_t>(distance.from) == room()
               ? room_->housings[static_cast<size_t>(distance.source)]
           : static_cast<size_t>(distance.to) == room() ? distance.board
                                                        : -1;
}

bool JointFilter::isMoved(int anchor) const {
    const auto tally = anchors_.find(anchor);
    return tally != anchors_.end() && tally->second.moved;
}

/// A moved anchor is off for nearly all who hear it. What stands in the way of sound is in the way of some;
/// where others are as far off, it is the body that is elsewhere than believed. A body that stands between
/// an anchor and most of its own microphones makes it look moved, until the performer turns.
void JointFilter::noteAnchor(int anchor, bool gated, bool is_off) {
    Tally& tally = anchors_[anchor];
    tally.off_share += ((is_off ? 1.0 : 0.0) - tally.off_share) / kOffMemory;
    if (tally.moved) {
        tally.left_out += 1;
        tally.left_out_lately += 1;
        tally.moved = tally.off_share > kInPlaceShare;
        return;
    }
    tally.tried += 1;
    tally.gated += gated ? 1 : 0;
    tally.off += is_off ? 1 : 0;
    if (tally.tried < kTriedBefore || tally.off_share < kOffShare)
        return;
    tally.left_out_lately = 0;
    tally.moved = std::ranges::all_of(anchors_, [&](const auto& entry) {
        return entry.first == anchor || entry.second.moved || entry.second.off_share < kInPlaceShare;
    });
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
        const auto is_away = [&](size_t member, double time_s) {
            return member != room() &&
                   (time_s < bodies_[member].rest.end_s ||
                    (isOver(member) && time_s > filter(member).seconds() + filter(member).stepSeconds()));
        };
        if (!isJoined(distance) || is_away(from, distance.emission_s) || is_away(to, distance.arrival_s)) {
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
        const int anchor = anchorOf(distance);
        if (!isMoved(anchor))
            noise.learn(innovation, expected, before);
        const double ratio = std::abs(row.residual) / std::sqrt(variance);
        const bool gated = ratio > parameters_.gate_sigma;
        decisions[r].fate = gated                             ? RangeFate::kGated
                            : ratio > parameters_.huber_sigma ? RangeFate::kWeighted
                                                              : RangeFate::kUsed;
        row.variance += std::max(0.0, ratio / parameters_.huber_sigma - 1) * variance;
        row.variance += noise.whitenedVariance();
        const double off_m = std::max(kMovedNoise_m, kOffSigma * std::sqrt(expected[0]));
        const bool is_off = std::abs(row.residual) > off_m;
        // A body that is unsure does not tell that an anchor is back.
        if (anchor >= 0 && (is_off || !isMoved(anchor) || off_m < 2 * kMovedNoise_m))
            noteAnchor(anchor, gated, is_off);
        if (isMoved(anchor))
            decisions[r].fate = RangeFate::kNotTried;
        else if (!gated)
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

bool JointFilter::roomContradicts() const {
    const bool is_off = std::ranges::any_of(anchors_, [](const auto& entry) {
        const Tally& tally = entry.second;
        return tally.tried >= kTriedBefore &&
               static_cast<double>(tally.off) > kInPlaceShare * static_cast<double>(tally.tried);
    });
    const bool nobody_stands = std::ranges::none_of(bodies_, &Body::joined);
    // Those that are left out are not judged while the others hardly tell where anybody stands.
    const auto in_use = std::ranges::count_if(anchors_, [](const auto& entry) {
        return !entry.second.moved && entry.second.tried >= kTriedBefore;
    });
    return alignment_.room_contradicts &&
           (is_off || nobody_stands || in_use < kFewestInUse || !movedAnchors().empty());
}

std::vector<int> JointFilter::movedAnchors() const {
    std::vector<int> moved;
    for (const auto& [anchor, tally] : anchors_) {
        const bool seems_moved = tally.moved && tally.left_out_lately >= kTriedBefore;
        const bool seemed_mostly = tally.left_out >= std::max(kTriedBefore, tally.tried);
        const bool contradicts =
            tally.tried >= kTriedBefore &&
            static_cast<double>(tally.gated) > kMovedShare * static_cast<double>(tally.tried);
        if (seems_moved || seemed_mostly || contradicts)
            moved.push_back(anchor);
    }
    return moved;
}

}  // namespace noctule
