// SPDX-License-Identifier: Apache-2.0
// Three steps. Neighbours: the tree of the body whose joints fit best, by annealing. Legs: a shank swings
// forward faster than back, so that its swing shows; the hips turn forward with the leg that swings. Arms:
// the hips' two joints point from right to left; turning together carries that direction up to the chest, in
// which the shoulders' joints lie left and right.
#include "core/assignment/assign_segments.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/assignment/joint_evidence.h"
#include "core/math/linear_solvers.h"
#include "core/math/rotation_fit.h"

namespace noctule::assignment {

namespace {

constexpr double kShortest_s = 5;
constexpr double kLeastTurning_rad_per_s = 0.2;
constexpr double kMostMissing = 0.2;
constexpr int kRestarts = 12, kAnnealingSteps = 30'000;
constexpr double kHottest = 2, kColdest = 0.02;
constexpr double kGapOfHalf = 0.15;  ///< of the sum of logarithms, at which confidence is a half
constexpr double kClearCorrelation = 0.15, kClearShare = 0.5, kNarrowestHips_m = 0.08;

struct Body {
    std::vector<const char*> segments;
    std::vector<std::pair<int, int>> joints;
    std::vector<std::vector<int>> limbs;  ///< from the body outwards; left then right
};

const std::vector<Body>& bodies() {
    static const std::vector<Body> known = {
        {{"Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"},
         {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {4, 5}, {5, 6}},
         {{1, 2, 3}, {4, 5, 6}}},
        {{"Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot", "Chest"},
         {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {4, 5}, {5, 6}, {0, 7}},
         {{1, 2, 3}, {4, 5, 6}}},
        {{"Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot", "Chest", "Spine",
          "Head", "LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm", "RightHand"},
         {{0, 1},
          {1, 2},
          {2, 3},
          {0, 4},
          {4, 5},
          {5, 6},
          {0, 8},
          {8, 7},
          {7, 9},
          {7, 10},
          {10, 11},
          {11, 12},
          {7, 13},
          {13, 14},
          {14, 15}},
         {{1, 2, 3}, {4, 5, 6}, {10, 11, 12}, {13, 14, 15}}}};
    return known;
}

using Places = std::vector<int>;  ///< segment -> sensor

/// The sum over joints of the logarithm of their misfit.
class TreeSearch {
public:
    TreeSearch(const Body& body, Eigen::MatrixXd log_misfit)
        : body_(body), log_misfit_(std::move(log_misfit)) {}

    double cost(const Places& places) const {
        double sum = 0;
        for (const auto& [a, b] : body_.joints)
            sum += log_misfit_(places[size_t(a)], places[size_t(b)]);
        return sum;
    }

    Places best() const {
        std::mt19937 random(1);
        Places best, places(body_.segments.size());
        for (size_t i = 0; i < places.size(); ++i)
            places[i] = int(i);
        for (int restart = 0; restart < kRestarts; ++restart) {
            std::shuffle(places.begin(), places.end(), random);
            const Places found = annealed(places, random);
            if (best.empty() || cost(found) < cost(best))
                best = found;
        }
        return best;
    }

    /// By how much the sum grows when a sensor goes to another segment with least harm.
    std::vector<double> gaps(const Places& best) const {
        const size_t n = best.size();
        const double least = cost(best);
        std::vector<double> gaps(n, 1e9);
        const auto look = [&](const Places& other) {
            const double gap = cost(other) - least;
            for (size_t s = 0; s < n; ++s)
                if (other[s] != best[s])
                    gaps[size_t(other[s])] = std::min(gaps[size_t(other[s])], gap);
        };
        for (size_t a = 0; a < n; ++a)
            for (size_t b = 0; b < n; ++b)
                for (size_t c = 0; c < n; ++c) {
                    if (a == b || b == c)
                        continue;
                    Places other = best;
                    std::swap(other[a], other[b]);
                    if (c != a)
                        std::swap(other[b], other[c]);
                    look(other);
                }
        // Ends of limbs that change sides; whole limbs are told apart by their sides.
        for (size_t l = 0; l + 1 < body_.limbs.size(); l += 2) {
            Places other = best;
            for (size_t k = 2; k >= 1; --k) {
                std::swap(other[size_t(body_.limbs[l][k])], other[size_t(body_.limbs[l + 1][k])]);
                look(other);
            }
        }
        return gaps;
    }

private:
    Places annealed(Places places, std::mt19937& random) const {
        const size_t n = places.size();
        double now = cost(places), least = now;
        Places best = places;
        std::uniform_real_distribution<double> uniform;
        for (int step = 0; step < kAnnealingSteps; ++step) {
            const double heat = kHottest * std::pow(kColdest / kHottest, double(step) / kAnnealingSteps);
            Places tried = places;
            if (random() % 8 == 0) {
                const auto& a = body_.limbs[random() % body_.limbs.size()];
                const auto& b = body_.limbs[random() % body_.limbs.size()];
                const size_t from = random() % 3;
                for (size_t k = from; k < 3 && &a != &b; ++k)
                    std::swap(tried[size_t(a[k])], tried[size_t(b[k])]);
            } else {
                std::swap(tried[random() % n], tried[random() % n]);
            }
            const double then = cost(tried);
            if (then > now && uniform(random) > std::exp((now - then) / heat))
                continue;
            places = std::move(tried);
            now = then;
            if (now < least - 1e-12) {
                least = now;
                best = places;
            }
        }
        return best;
    }

    const Body& body_;
    Eigen::MatrixXd log_misfit_;
};

/// Rate about the axis about which a sensor turns most, positive where the third moment is: of a shank, in
/// the swing.
std::vector<double> swingOf(const ImuSamples& samples) {
    const auto rates = lowPassed(samples.gyro_rad_per_s, samples.rate_hz, 8);
    Matrix3d scatter = Matrix3d::Zero();
    for (const Vector3d& rate : rates)
        scatter += rate * rate.transpose();
    const Vector3d axis = eigensystemOf(scatter).vectors.col(2);
    std::vector<double> swing;
    double third = 0;
    for (const Vector3d& rate : rates) {
        swing.push_back(rate.dot(axis));
        third += std::pow(swing.back(), 3);
    }
    if (third < 0)
        for (double& value : swing)
            value = -value;
    return swing;
}

/// Rate about the vertical within steps: slower turns are taken off.
std::vector<double> yawWithinSteps(const ImuSamples& samples) {
    const auto up = lowPassed(samples.accel_m_per_s2, samples.rate_hz, 0.5);
    std::vector<double> yaw;
    for (size_t i = 0; i < up.size(); ++i)
        yaw.push_back(samples.gyro_rad_per_s[i].dot(up[i].normalized()));
    yaw = lowPassed(yaw, samples.rate_hz, 6);
    const auto slow = lowPassed(yaw, samples.rate_hz, 0.5);
    for (size_t i = 0; i < yaw.size(); ++i)
        yaw[i] -= slow[i];
    return yaw;
}

double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
    const size_t n = std::min(a.size(), b.size());
    double ma = 0, mb = 0, ab = 0, aa = 0, bb = 0;
    for (size_t i = 0; i < n; ++i) {
        ma += a[i] / double(n);
        mb += b[i] / double(n);
    }
    for (size_t i = 0; i < n; ++i) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return ab / std::max(std::sqrt(aa * bb), 1e-12);
}

/// The turn that takes slow rates of `from` to those of `to`: both turn with the body.
Matrix3d commonTurn(const ImuSamples& to, const ImuSamples& from) {
    const auto a = lowPassed(to.gyro_rad_per_s, to.rate_hz, 2),
               b = lowPassed(from.gyro_rad_per_s, from.rate_hz, 2);
    Matrix3d M = Matrix3d::Zero();
    for (size_t i = 0; i < a.size(); ++i)
        M += a[i] * b[i].transpose();
    return nearestRotation(M);
}

Vector3d upOf(const ImuSamples& samples) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& accel : samples.accel_m_per_s2)
        sum += accel;
    return sum.normalized();
}

class Sides {
public:
    Sides(const Body& body, const std::vector<ImuSamples>& sensors, const std::vector<SmoothMotion>& motions,
          Places& places, Assignment& result)
        : body_(body), sensors_(sensors), motions_(motions), places_(places), result_(result) {}

    void tell() {
        legs();
        if (body_.limbs.size() > 2)
            arms();
    }

private:
    int at(int segment) const { return places_[size_t(segment)]; }
    const ImuSamples& of(int segment) const { return sensors_[size_t(at(segment))]; }
    void mirror(size_t limb) {
        for (size_t k = 0; k < 3; ++k)
            std::swap(places_[size_t(body_.limbs[limb][k])], places_[size_t(body_.limbs[limb + 1][k])]);
    }
    /// From the second limb's joint to the first's, in the frame of the sensor that carries both.
    Vector3d between(int carrier, size_t limb) const {
        const auto& motion = motions_[size_t(at(carrier))];
        const auto a = jointEvidence(motion, motions_[size_t(at(body_.limbs[limb][0]))]);
        const auto b = jointEvidence(motion, motions_[size_t(at(body_.limbs[limb + 1][0]))]);
        // A lever arm points from the joint to the sensor, so the joints' difference has the other sign.
        return b.lever_first_m - a.lever_first_m;
    }

    void legs() {
        const auto yaw = yawWithinSteps(of(0));
        auto left = swingOf(of(2)), right = swingOf(of(5));
        for (size_t i = 0; i < left.size(); ++i)
            right[i] = std::max(right[i], 0.0) - std::max(left[i], 0.0);
        result_.legs_side = correlationOf(yaw, right);
        if (result_.legs_side < 0)
            mirror(0);
    }

    void arms() {
        const Vector3d up = upOf(of(0)), hips = between(0, 0);
        const Vector3d left = hips - up * up.dot(hips);
        const Vector3d left_chest = commonTurn(of(7), of(8)) * commonTurn(of(8), of(0)) * left.normalized();
        const Vector3d up_chest = upOf(of(7)), shoulders = between(7, 2);
        const Vector3d level = shoulders - up_chest * up_chest.dot(shoulders);
        result_.arms_side = left.norm() < kNarrowestHips_m || level.norm() < kNarrowestHips_m
                                ? 0
                                : level.normalized().dot(left_chest);
        if (result_.arms_side < 0)
            mirror(2);
    }

    const Body& body_;
    const std::vector<ImuSamples>& sensors_;
    const std::vector<SmoothMotion>& motions_;
    Places& places_;
    Assignment& result_;
};

Error assignError(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, "Sensors cannot be assigned by movement: " + what, remedy};
}

Status checkSensors(const std::vector<ImuSamples>& sensors) {
    const ImuSamples& first = sensors.front();
    double turning = 0;
    for (size_t s = 0; s < sensors.size(); ++s) {
        const ImuSamples& one = sensors[s];
        if (std::abs(one.rate_hz / first.rate_hz - 1) > 1e-3 || one.size() != first.size())
            return assignError("their rates or lengths differ", "Import sensors of one recording and rate");
        size_t missing = 0;
        double squares = 0;
        for (size_t i = 0; i < one.size(); ++i) {
            const bool read = one.gyro_rad_per_s[i].allFinite() && one.accel_m_per_s2[i].allFinite();
            missing += !read;
            squares += read ? one.gyro_rad_per_s[i].squaredNorm() : 0;
        }
        if (double(missing) > kMostMissing * double(one.size()))
            return assignError(
                "sensor " + std::to_string(s + 1) + " lacks too many readings of gyroscope or accelerometer",
                "Record both quantities, or assign by names");
        turning = std::max(turning, std::sqrt(squares / double(std::max<size_t>(one.size(), 1))));
    }
    if (double(first.size()) < kShortest_s * first.rate_hz)
        return assignError("the recording is shorter than 5 s", "Walk for ten seconds and more");
    if (turning < kLeastTurning_rad_per_s)
        return assignError("nothing moves", "Walk for ten seconds and more");
    return Done{};
}

/// Missing readings repeat the ones before, so that sums stay whole.
std::vector<ImuSamples> wholeReadings(std::vector<ImuSamples> sensors) {
    for (ImuSamples& one : sensors)
        for (auto* list : {&one.gyro_rad_per_s, &one.accel_m_per_s2}) {
            Vector3d last(0, 0, 0);
            for (Vector3d& reading : *list) {
                if (!reading.allFinite())
                    reading = last;
                last = reading;
            }
        }
    return sensors;
}

const Body* bodyOf(size_t count) {
    for (const Body& body : bodies())
        if (body.segments.size() == count)
            return &body;
    return nullptr;
}

void describeAssignment(const Body& body, const Places& places, const std::vector<double>& gaps,
                        Assignment& result) {
    result.sensors.resize(places.size());
    for (size_t s = 0; s < places.size(); ++s) {
        AssignedSensor& sensor = result.sensors[size_t(places[s])];
        sensor.segment = body.segments[s];
        const double gap = std::max(gaps[size_t(places[s])], 0.0);
        sensor.confidence = gap / (gap + kGapOfHalf);
        const bool leg = s >= 1 && s <= 6, arm = s >= 10;
        if (leg || arm)
            sensor.confidence *= std::min(1.0, std::abs(result.legs_side) / kClearCorrelation);
        if (arm)
            sensor.confidence *= std::min(1.0, std::abs(result.arms_side) / kClearShare);
    }
    if (std::abs(result.legs_side) < kClearCorrelation)
        result.warnings.push_back(
            "Left and right leg could hardly be told apart; walk for ten seconds and more");
    if (body.limbs.size() > 2 &&
        (std::abs(result.arms_side) < kClearShare || std::abs(result.legs_side) < kClearCorrelation))
        result.warnings.push_back(
            "Left and right arm could hardly be told apart; turn round and swing the arms");
}

}  // namespace

std::vector<size_t> knownCounts() {
    std::vector<size_t> counts;
    for (const Body& body : bodies())
        counts.push_back(body.segments.size());
    return counts;
}

Result<Assignment> assignSegments(const std::vector<ImuSamples>& given, const JobContext& job) {
    const Body* body = bodyOf(given.size());
    if (!body)
        return assignError(
            std::to_string(given.size()) + " sensors are no set that a body is known for",
            "Give 7 (hips and legs), 8 (and the chest) or 16 (whole body), or assign by names");
    if (Status usable = checkSensors(given); !usable)
        return usable.error();
    const std::vector<ImuSamples> sensors = wholeReadings(given);
    std::vector<SmoothMotion> motions;
    for (const ImuSamples& one : sensors)
        motions.push_back(smoothMotion(one));
    const auto n = Eigen::Index(sensors.size());
    Eigen::MatrixXd log_misfit = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < i; ++j)
            log_misfit(i, j) = log_misfit(j, i) =
                std::log(jointEvidence(motions[size_t(i)], motions[size_t(j)]).misfit_m_per_s2 + 1e-6);
        job.progress(double(i + 1) / double(n), "Joints between sensors");
        if (job.cancelled())
            return JobContext::cancelledError();
    }
    const TreeSearch search(*body, log_misfit);
    Places places = search.best();
    const std::vector<double> gaps = search.gaps(places);
    Assignment result;
    Sides(*body, sensors, motions, places, result).tell();
    describeAssignment(*body, places, gaps, result);
    return result;
}

}  // namespace noctule::assignment
