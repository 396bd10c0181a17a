// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/step_spool.h"

#include <array>

namespace noctule {
namespace {

void putVector(UnnamedFile& file, const Vector3d& v) {
    file.putBytes(v.data(), sizeof(double) * 3);
}

bool takeVector(UnnamedFile& file, Vector3d& v) {
    return file.takeBytes(v.data(), sizeof(double) * 3);
}

void putTriad(UnnamedFile& file, const TriadReading& triad) {
    file.put(triad.count);
    for (int i = 0; i < triad.count; ++i) {
        const AxisReading& axis = triad.axes[static_cast<size_t>(i)];
        putVector(file, axis.sensitive_axis_board);
        file.put(axis.value);
        file.put(axis.sigma);
        file.put(axis.beyond);
    }
}

bool takeTriad(UnnamedFile& file, TriadReading& triad) {
    bool whole = file.take(triad.count);
    for (int i = 0; whole && i < triad.count; ++i) {
        AxisReading& axis = triad.axes[static_cast<size_t>(i)];
        whole = takeVector(file, axis.sensitive_axis_board) && file.take(axis.value) &&
                file.take(axis.sigma) && file.take(axis.beyond);
    }
    return whole;
}

void putOne(UnnamedFile& file, const InertialMeasurement& m) {
    file.put(m.board);
    file.put(m.time_s);
    putTriad(file, m.gyro);
    putTriad(file, m.accel);
}

bool takeOne(UnnamedFile& file, InertialMeasurement& m) {
    return file.take(m.board) && file.take(m.time_s) && takeTriad(file, m.gyro) && takeTriad(file, m.accel);
}

void putOne(UnnamedFile& file, const DistanceMeasurement& m) {
    file.put(m);
}

bool takeOne(UnnamedFile& file, DistanceMeasurement& m) {
    return file.take(m);
}

void putOne(UnnamedFile& file, const RootMeasurement& m) {
    file.put(m.time_s);
    putVector(file, m.p_world_root);
    file.putBytes(m.q_world_root.coeffs().data(), sizeof(double) * 4);
    file.put(m.sigma_p_m);
    file.put(m.sigma_q_rad);
}

bool takeOne(UnnamedFile& file, RootMeasurement& m) {
    return file.take(m.time_s) && takeVector(file, m.p_world_root) &&
           file.takeBytes(m.q_world_root.coeffs().data(), sizeof(double) * 4) && file.take(m.sigma_p_m) &&
           file.take(m.sigma_q_rad);
}

void putState(UnnamedFile& file, const BodyState& state) {
    for (const size_t size : {state.motion.q_parent_link.size(), state.motion.angle_rad.size(),
                              static_cast<size_t>(state.motion.rate.size()), state.gyro_bias.size(),
                              state.accel_bias.size(), state.source_offset_m.size()})
        file.put(size);
    forEachNumber(state, [&](const double* numbers, Eigen::Index count) {
        file.putBytes(numbers, sizeof(double) * static_cast<size_t>(count));
    });
}

bool takeState(UnnamedFile& file, BodyState& state) {
    std::array<size_t, 6> sizes{};
    bool whole = true;
    for (size_t& size : sizes)
        whole = whole && file.take(size);
    if (!whole)
        return false;
    state.motion.q_parent_link.resize(sizes[0]);
    state.motion.angle_rad.resize(sizes[1]);
    state.motion.rate.resize(static_cast<Eigen::Index>(sizes[2]));
    state.motion.accel.resize(static_cast<Eigen::Index>(sizes[2]));
    state.gyro_bias.resize(sizes[3]);
    state.accel_bias.resize(sizes[4]);
    state.source_offset_m.resize(sizes[5]);
    forEachNumber(state, [&](double* numbers, Eigen::Index count) {
        whole = whole && file.takeBytes(numbers, sizeof(double) * static_cast<size_t>(count));
    });
    return whole;
}

template <class Measurement>
void putAll(UnnamedFile& file, const std::vector<Measurement>& measurements) {
    file.put(measurements.size());
    for (const Measurement& measurement : measurements)
        putOne(file, measurement);
}

template <class Measurement>
bool takeAll(UnnamedFile& file, std::vector<Measurement>& measurements) {
    size_t count = 0;
    bool whole = file.take(count);
    measurements.assign(whole ? count : 0, {});
    for (Measurement& measurement : measurements)
        whole = whole && takeOne(file, measurement);
    return whole;
}

}  // namespace

void putInput(UnnamedFile& file, const ManifoldFilter::StepInput& input) {
    putAll(file, input.roots);
    putAll(file, input.inertial);
    putAll(file, input.distances);
    file.put(input.about.has_value());
    if (input.about) {
        putState(file, input.about->from);
        putState(file, input.about->to);
    }
}

bool takeInput(UnnamedFile& file, ManifoldFilter::StepInput& input) {
    bool has_about = false;
    if (!takeAll(file, input.roots) || !takeAll(file, input.inertial) || !takeAll(file, input.distances) ||
        !file.take(has_about))
        return false;
    input.about.reset();
    if (!has_about)
        return true;
    input.about.emplace();
    return takeState(file, input.about->from) && takeState(file, input.about->to);
}

Error unreadableSpool() {
    return {ErrorKind::kDisk, "what the smoother had put aside could not be read back",
            "Check that the disk has room, or process without smoothing"};
}

void StepSpool::add(const ManifoldFilter::StepInput& input) {
    putInput(file_, input);
    ++marks_.back().steps;
}

void StepSpool::mark(const ManifoldFilter::Memory& memory) {
    marks_.push_back({file_.position(), 0, memory});
    const Eigen::MatrixXd& P = memory.P.dense();
    size_ = P.rows();
    file_.putBytes(P.data(), sizeof(double) * static_cast<size_t>(P.size()));
    marks_.back().memory.P = Covariance();
}

Result<ManifoldFilter::Memory> StepSpool::goTo(int stretch) {
    const Mark& mark = marks_[static_cast<size_t>(stretch)];
    const bool kept = file_.good();
    file_.seek(mark.position);
    left_ = mark.steps;
    ManifoldFilter::Memory memory = mark.memory;
    memory.P = Covariance(Eigen::VectorXd::Zero(size_));
    Eigen::MatrixXd& P = memory.P.dense();
    if (!kept || !file_.takeBytes(P.data(), sizeof(double) * static_cast<size_t>(P.size())))
        return unreadableSpool();
    return memory;
}

bool StepSpool::next(ManifoldFilter::StepInput& input) {
    if (left_ == 0)
        return false;
    --left_;
    is_whole_ = takeInput(file_, input);
    return is_whole_;
}

Status StepSpool::status() const {
    return is_whole_ ? Status(Done{}) : unreadableSpool();
}

}  // namespace noctule
