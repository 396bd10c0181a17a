// SPDX-License-Identifier: Apache-2.0
#include "core/processing/track_points.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/cooperative/lost_points.h"
#include "core/estimation/rest_alignment.h"
#include "core/live/point_estimators.h"
#include "core/math/rotation.h"
#include "core/processing/cross_clocks.h"
#include "core/processing/cross_ranges.h"
#include "core/processing/point_flights.h"
#include "core/processing/point_reach.h"

namespace noctule {
namespace {

constexpr double kLongestStep_s = 0.02;
constexpr double kDetour_m = 0.08;   ///< a way that is longer by as much is a reflection's
constexpr double kNearest_m = 0.05;  ///< of the second order

/// Where the points of one member stand in the state; anchors are negative (cooperative::anchorPoint).
struct MemberPoints {
    std::vector<int> of_board, of_source;
    std::vector<double> source_variance_m2;  ///< for the way to the housing's microphone
};

class PointTracker {
public:
    PointTracker(Take& take, const ProcessRequest& request, const PointsSink& sink)
        : take_(take),
          sink_(sink),
          setup_(pointSetup(request.tracker.parameters)),
          settings_(filterSettings(request.tracker.estimator, setup_)) {}

    Result<PointsSummary> run(const ProcessRequest& request, std::vector<Ingredients> subjects,
                              TakeClocks clocks, const JobContext& job) {
        subjects_ = std::move(subjects);
        ProcessRequest joint = request;  // what joins subjects does not depend on what makes use of it
        joint.tracker = TrackerSettings{};
        if (subjects_.size() > 1 && request.between == Wanted::kAuto)
            joint.between = Wanted::kOn;  // what is in the way is an error here
        auto joining = joinSubjects(take_, joint, subjects_, clocks, request.tracker.spool_folder,
                                    summary.warnings, job);
        if (!joining)
            return joining.error();
        joining_ = std::move(*joining);
        if (!joining_.joins())
            return unusableTake(take_, "it holds no ranges between its suits or to a room",
                                "Points need them: take one that was recorded with anchors");
        if (settings_.method == cooperative::PointMethod::kEnvironment && !joining_.room)
            return unusableTake(take_, "estimator environment needs anchors in the room, the take has none",
                                "Take --estimator comocap");
        if (Status placed = place(); !placed)
            return placed.error();
        auto flights = pointFlights(take_, subjects_, joining_, alignment_, clocks, summary.warnings);
        if (!flights)
            return flights.error();
        flights_ = std::move(*flights);
        if (Status filtered = filter(job); !filtered)
            return filtered.error();
        return std::move(summary);
    }

    PointsSummary summary;

private:
    size_t room() const { return subjects_.size(); }

    /// Where everybody stands at rest, and the points there.
    Status place() {
        std::vector<RestingMember> members;
        begin_s_ = 0;
        for (size_t i = 0; i < subjects_.size(); ++i) {
            const Ingredients& in = subjects_[i];
            const KinematicTree tree(in.actor.skeleton, BallCoordinates::kManifold);
            const auto mounted = mountSuit(in.suit, in.calibration, in.actor, tree);
            if (!mounted)
                return mounted.error();
            RestingMember member = restingMember(tree, *mounted, in.actor.restPose());
            const double rate_hz = in.decoder.train.sample_rate_hz;
            const auto rest = in.rest.value_or(std::pair<int64_t, int64_t>{0, std::llround(rate_hz / 2)});
            const ClockLine& clock = joining_.clocks[i];
            member.from_s = clock.common_s(static_cast<double>(rest.first) / rate_hz);
            member.to_s = clock.common_s(static_cast<double>(rest.second) / rate_hz);
            member.clock_known = i == 0 || joining_.clock_known[i] || joining_.clocks_shared;
            begin_s_ = std::max(begin_s_, member.from_s);
            members.push_back(std::move(member));
        }
        SuitModel anchors;
        std::vector<int> housings;
        if (joining_.room) {
            const Actor& any = subjects_.front().actor;
            auto mounted = mountSuit(joining_.room->suit, joining_.room->calibration, any,
                                     KinematicTree(any.skeleton, BallCoordinates::kManifold));
            if (!mounted)
                return mounted.error();
            anchors = std::move(*mounted);
            housings = joining_.room->suit.housings();
        }
        members.push_back(restingRoom(anchors, housings));
        members.back().clock_known = joining_.room && (joining_.clock_known.back() || joining_.clocks_shared);
        alignment_ = alignAtRest(members, joining_.distances, joining_.clocks, joining_.room.has_value());
        std::vector<Vector3d> places_m;
        std::vector<int> user_of_point;
        for (size_t i = 0; i < subjects_.size(); ++i) {
            if (!alignment_.places[i].placed)
                return unusableTake(take_,
                                    "nothing tells where " + subjects_[i].subject.name +
                                        " stands: while the rest pose was held, too few ranges fit",
                                    "Leave this subject out with --subjects, or record again");
            addPoints(i, members[i], places_m);
            user_of_point.resize(places_m.size(), static_cast<int>(i));
        }
        addAnchors(members.back());
        filter_.emplace(settings_, cooperative::startPoints(places_m, setup_.start_m, setup_.start_m_per_s),
                        user_of_point, anchors_m_);
        if (!setup_.letter)
            lost_.emplace(places_m, user_of_point, reaches(places_m.size()));
        warnOfPlaces();
        return Done{};
    }

    /// Of all points to all; those of two performers are bound by nothing.
    std::vector<std::vector<cooperative::Reach>> reaches(size_t count) const {
        std::vector<std::vector<cooperative::Reach>> all(count, std::vector<cooperative::Reach>(count));
        size_t first = 0;
        for (size_t member = 0; member < subjects_.size(); ++member) {
            const std::vector<std::vector<cooperative::Reach>> own =
                pointReaches(subjects_[member].actor, worn_[member]);
            for (size_t a = 0; a < own.size(); ++a)
                std::ranges::copy(own[a], all[first + a].begin() + static_cast<std::ptrdiff_t>(first));
            first += own.size();
        }
        return all;
    }

    void warnOfPlaces() {
        if (!joining_.room)
            summary.warnings.push_back(
                "There are no anchors: the common place and turn of all points is that of the start, "
                "and drifts.");
        if (alignment_.room_contradicts)
            summary.warnings.push_back(kRoomContradicts);
        else
            for (const int anchor : alignment_.moved_anchors)
                summary.warnings.push_back(anchorContradicts(joining_.room->suit, anchor));
    }

    void addPoints(size_t member, const RestingMember& at_rest, std::vector<Vector3d>& places_m) {
        const Ingredients& in = subjects_[member];
        const RestPlace& place = alignment_.places[member];
        const auto inWorld = [&](const Vector3d& p) -> Vector3d {
            return place.p_m + axisAngle(Vector3d::UnitY(), place.heading_rad) * p;
        };
        MemberPoints points;
        std::vector<WornPoint>& worn = worn_.emplace_back();
        for (size_t b = 0; b < in.suit.boards.size(); ++b) {
            points.of_board.push_back(static_cast<int>(places_m.size()));
            places_m.push_back(inWorld(at_rest.microphones_m[b]));
            worn.push_back({in.suit.boards[b].segment, at_rest.microphones_m[b]});
            summary.points.push_back({in.subject.name, in.suit.boards[b].id, in.subject.suit(), false});
        }
        const std::vector<int> housings = in.suit.housings();
        for (size_t s = 0; s < in.suit.sources.size(); ++s) {
            const Source& source = in.suit.sources[s];
            const int board = housings[s];
            points.of_source.push_back(board >= 0 ? points.of_board[static_cast<size_t>(board)]
                                                  : static_cast<int>(places_m.size()));
            points.source_variance_m2.push_back(
                board >= 0 ? (at_rest.sources_m[s] - at_rest.microphones_m[static_cast<size_t>(board)])
                                     .squaredNorm() /
                                 3
                           : 0);
            if (board >= 0)
                continue;
            places_m.push_back(inWorld(at_rest.sources_m[s]));
            worn.push_back({source.segment, at_rest.sources_m[s]});
            summary.points.push_back({in.subject.name, source.id, in.subject.suit(), true});
        }
        points_.push_back(std::move(points));
    }

    void addAnchors(const RestingMember& anchors) {
        MemberPoints points;
        const auto add = [&](const Vector3d& p) {
            anchors_m_.push_back(p);
            return cooperative::anchorPoint(static_cast<int>(anchors_m_.size()) - 1);
        };
        for (const Vector3d& p : anchors.microphones_m)
            points.of_board.push_back(add(p));
        for (const Vector3d& p : anchors.sources_m)
            points.of_source.push_back(add(p));
        points.source_variance_m2.assign(anchors.sources_m.size(), 0);
        points_.push_back(std::move(points));
    }

    Status filter(const JobContext& job) {
        sink_.begin(summary.points);
        next_row_s_ = std::ceil(begin_s_ * setup_.rows_per_s) / setup_.rows_per_s;
        now_s_ = begin_s_;
        const double end_s = flights_.empty() ? begin_s_ : flights_.back().emission_s;
        for (auto flight = flights_.begin(); flight != flights_.end();) {
            auto after = flight;
            while (after != flights_.end() && after->emission_s == flight->emission_s &&
                   after->from == flight->from)
                ++after;
            if (flight->emission_s >= begin_s_) {
                advanceTo(flight->emission_s);
                correct({flight, after});
            }
            flight = after;
            if (job.cancelled())
                return JobContext::cancelledError();
            job.progress(std::clamp((now_s_ - begin_s_) / std::max(end_s - begin_s_, 1e-9), 0.0, 1.0),
                         "Tracking points");
        }
        if (const int64_t losses = lost_ ? lost_->losses() : 0; losses > 0)
            summary.warnings.push_back("Points that too few devices heard were lost " +
                                       std::to_string(losses) +
                                       " times; while one is lost, its sigma tells how far off it may be.");
        if (summary.frames == 0)
            return unusableTake(take_, "no point came out: its ranges end before the rest pose does",
                                "`noctule --batch inspect` shows what is in it");
        return Done{};
    }

    void advanceTo(double time_s) {
        while (now_s_ < time_s) {
            const double to_s = std::min({time_s, next_row_s_, now_s_ + kLongestStep_s});
            filter_->predict(to_s - now_s_);
            now_s_ = to_s;
            if (lost_)
                lost_->look(filter_->points(), now_s_);
            if (now_s_ >= next_row_s_) {
                show();
                ++rows_;
                next_row_s_ =
                    std::ceil(begin_s_ * setup_.rows_per_s + static_cast<double>(rows_)) / setup_.rows_per_s;
            }
        }
    }

    void show() {
        const cooperative::FreePoints& points = filter_->points();
        PointsFrame frame{now_s_, {}, {}};
        for (int i = 0; i < points.count(); ++i) {
            frame.p_m.push_back(points.place(i));
            frame.sigma_m.push_back(
                std::sqrt(std::max(0.0, points.cov_pp.block<3, 3>(3 * i, 3 * i).trace() / 3)));
        }
        summary.frames += 1;
        sink_.add(frame);
    }

    Vector3d velocity(int point) const {
        return point < 0 ? Vector3d::Zero() : Vector3d(filter_->points().v_m_per_s.segment<3>(3 * point));
    }
    Vector3d placeOf(int point) const {
        return point < 0 ? anchors_m_[static_cast<size_t>(-1 - point)] : filter_->points().place(point);
    }
    /// What the places' covariance says of a distance: u'Pu along the line of sight, and across it the second
    /// order, by which a distance to an unsure place is longer than that to its mean.
    struct ExpectedDistance {
        double variance_m2 = 0, longer_m = 0;
    };
    ExpectedDistance expected(int a, int b, const Vector3d& u, double distance_m) const {
        const Eigen::MatrixXd& P = filter_->points().cov_pp;
        Matrix3d between = Matrix3d::Zero();
        if (a >= 0)
            between += P.block<3, 3>(3 * a, 3 * a);
        if (b >= 0)
            between += P.block<3, 3>(3 * b, 3 * b);
        if (a >= 0 && b >= 0)
            between -= P.block<3, 3>(3 * a, 3 * b) + P.block<3, 3>(3 * b, 3 * a);
        const double along = u.dot(between * u);
        if (setup_.letter)
            return {along, 0};
        const Matrix3d across = Matrix3d::Identity() - u * u.transpose();
        const Matrix3d curved = across * between * across / std::max(distance_m, kNearest_m);
        return {along, curved.trace() / 2};
    }

    /// All that was heard of one pulse.
    void correct(std::span<const PointFlight> flights) {
        std::vector<cooperative::PointRange> ranges;
        for (const PointFlight& flight : flights)
            if (const auto range = rangeOf(flight))
                ranges.push_back(*range);
        const size_t target = static_cast<size_t>(flights.front().from) == room()
                                  ? 0
                                  : static_cast<size_t>(flights.front().from);
        summary.used += static_cast<int64_t>(filter_->correct(ranges, static_cast<int>(target)));
    }

    bool isLost(int point) const { return point >= 0 && lost_ && lost_->isLost(point); }

    /// None: it is not for the filter.
    std::optional<cooperative::PointRange> rangeOf(const PointFlight& flight) {
        const auto from = static_cast<size_t>(flight.from), to = static_cast<size_t>(flight.to);
        const auto source = static_cast<size_t>(flight.source);
        const int sent = points_[from].of_source[source],
                  heard = points_[to].of_board[static_cast<size_t>(flight.board)];
        summary.heard += 1;
        (from == room() || to == room() ? summary.of_room : from == to ? summary.own : summary.between) += 1;
        if (sent == heard)
            return std::nullopt;  // a housing's own pulse
        const double variance = flight.sigma_m * flight.sigma_m + setup_.floor_m * setup_.floor_m +
                                points_[from].source_variance_m2[source];
        if (isLost(sent) || isLost(heard)) {
            noteLost(flight, sent, heard, variance);
            return std::nullopt;
        }
        const Vector3d way = placeOf(heard) - placeOf(sent);
        const Vector3d u = way.normalized();
        const double moved_m = u.dot(velocity(heard)) * flight.duration_s;
        const ExpectedDistance belief = expected(sent, heard, u, way.norm());
        const double curved = 2 * belief.longer_m * belief.longer_m;  // variance of the second order
        const double innovation = flight.distance_m - moved_m - way.norm() - belief.longer_m;
        const double sigma = std::sqrt(belief.variance_m2 + curved + variance);
        const double most = setup_.gate_sigma * sigma;
        // Where a body is in the way, what is heard came by a reflection: it is late, never early.
        const double latest =
            lost_ ? std::min(most, std::max(kDetour_m, setup_.gate_sigma * std::sqrt(variance))) : most;
        const bool gated = innovation < -most || innovation > latest;
        for (const int point : {sent, heard})
            if (lost_ && point >= 0 && isOfMethod(sent, heard))
                lost_->judged(point, gated);
        if (gated) {
            summary.gated += 1;
            return std::nullopt;
        }
        const bool heard_by_anchor = heard < 0;
        return cooperative::PointRange{heard_by_anchor ? sent : heard, heard_by_anchor ? heard : sent,
                                       flight.distance_m - moved_m - belief.longer_m, variance + curved};
    }

    bool isOfMethod(int a, int b) const {
        return settings_.method != cooperative::PointMethod::kEnvironment || a < 0 || b < 0;
    }

    /// A range of a lost point to one that is known, at the instant when the lost one sent or heard.
    void noteLost(const PointFlight& flight, int sent, int heard, double variance_m2) {
        if (!isOfMethod(sent, heard) || (isLost(sent) && isLost(heard)))
            return;
        const bool heard_it = isLost(heard);
        const int known = heard_it ? sent : heard;
        const double later_s = heard_it ? 0 : flight.duration_s;
        if (known >= 0)
            variance_m2 += filter_->points().cov_pp.block<3, 3>(3 * known, 3 * known).trace() / 3;
        lost_->note(heard_it ? heard : sent,
                    {flight.emission_s + flight.duration_s - later_s, flight.distance_m, variance_m2,
                     placeOf(known) + later_s * velocity(known), known});
    }

    Take& take_;
    const PointsSink& sink_;
    const PointSetup setup_;
    const cooperative::PointFilterSettings settings_;
    std::vector<Ingredients> subjects_;
    Joining joining_;
    RestAlignment alignment_;
    std::vector<MemberPoints> points_;          ///< per subject, then of the room
    std::vector<std::vector<WornPoint>> worn_;  ///< per subject
    std::vector<Vector3d> anchors_m_;
    std::vector<PointFlight> flights_;
    std::optional<cooperative::PointFilter> filter_;
    std::optional<cooperative::LostPoints> lost_;  ///< none: the paper to the letter
    double begin_s_ = 0, now_s_ = 0, next_row_s_ = 0;
    int64_t rows_ = 0;
};

Result<std::vector<Ingredients>> ingredientsOf(Take& take, const ProcessRequest& request,
                                               std::vector<std::string>& warnings) {
    const auto subjects = take.subjects();
    if (!subjects)
        return subjects.error();
    std::vector<Ingredients> all;
    for (const TakeSubject& subject : *subjects) {
        if (subject.room ||
            (!request.subjects.empty() && std::ranges::count(request.subjects, subject.name) == 0))
            continue;
        take.view(subject.suit());
        auto in = gatherIngredients(take, request, warnings);
        if (!in)
            return in.error();
        in->subject = subject;
        all.push_back(std::move(*in));
    }
    if (all.size() < std::max<size_t>(1, request.subjects.size()))
        return Error{ErrorKind::kUsage, take.path() + ": has no subject of that name",
                     "`noctule --batch inspect` lists its subjects"};
    return all;
}

}  // namespace

Result<PointsSummary> trackPoints(const ProcessRequest& request, const PointsSink& sink,
                                  const JobContext& job) {
    auto take = Take::open(request.take_path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    PointTracker tracker(*take, request, sink);
    auto subjects = ingredientsOf(*take, request, tracker.summary.warnings);
    if (!subjects)
        return subjects.error();
    const auto clocks = joinClocks(*take, job);
    if (!clocks)
        return clocks.error();
    return tracker.run(request, std::move(*subjects), *clocks, job);
}

}  // namespace noctule
