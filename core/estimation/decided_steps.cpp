// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/decided_steps.h"

namespace noctule {
namespace {

void putNumbers(UnnamedFile& file, const Eigen::VectorXd& numbers) {
    file.put(numbers.size());
    file.putBytes(numbers.data(), sizeof(double) * static_cast<size_t>(numbers.size()));
}

bool takeNumbers(UnnamedFile& file, Eigen::VectorXd& numbers) {
    Eigen::Index size = 0;
    const bool whole = file.take(size);
    numbers.resize(whole ? size : 0);
    return whole && file.takeBytes(numbers.data(), sizeof(double) * static_cast<size_t>(size));
}

/// Of a pull only the states that it pulls: what turns with the heading is left out when it is made again.
void putBlock(UnnamedFile& file, const ObservationBlock& block) {
    file.put(block.origin.kind);
    file.put(block.origin.index);
    putNumbers(file, block.origin.target);
    putNumbers(file, block.variance);
    if (block.origin.kind == ObservationOrigin::Kind::kPull)
        file.putBytes(block.columns.data(), sizeof(int) * static_cast<size_t>(block.rows()));
}

bool takeBlock(UnnamedFile& file, ObservationBlock& block) {
    const bool whole = file.take(block.origin.kind) && file.take(block.origin.index) &&
                       takeNumbers(file, block.origin.target) && takeNumbers(file, block.variance);
    if (!whole || block.origin.kind != ObservationOrigin::Kind::kPull)
        return whole;
    const Eigen::Index rows = block.variance.size();
    block.columns.resize(static_cast<size_t>(rows));
    block.H = Eigen::MatrixXd::Identity(rows, rows);
    return file.takeBytes(block.columns.data(), sizeof(int) * block.columns.size());
}

}  // namespace

void DecidedStep::note(const FilterTape& tape) {
    widened.resize(0);
    updates.clear();
    is_frame = false;
    for (const auto& event : tape) {
        if (const auto* widening = std::get_if<Widening>(&event))
            widened = widened.size() == 0 ? widening->variance : widened + widening->variance;
        if (const auto* update = std::get_if<ObservedUpdate>(&event); update && !update->blocks.empty())
            updates.push_back(update->blocks);
        if (const auto* frame = std::get_if<TapedFrame>(&event)) {
            is_frame = true;
            time_ns = frame->times_ns.back();
            flesh_rad2 = frame->flesh_rad2;
        }
    }
}

void DecidedSteps::add(const DecidedStep& step) {
    putInput(file_, step.input);
    putNumbers(file_, step.acceleration_variance);
    putNumbers(file_, step.widened);
    file_.put(step.is_frame);
    file_.put(step.time_ns);
    file_.put(step.flesh_rad2);
    file_.put(step.updates.size());
    for (const auto& blocks : step.updates) {
        file_.put(blocks.size());
        for (const ObservationBlock& block : blocks)
            putBlock(file_, block);
    }
    ++stretches_.back().steps;
}

void DecidedSteps::goTo(int stretch) {
    file_.good();  // what is written can be read
    file_.seek(stretches_[static_cast<size_t>(stretch)].position);
}

bool DecidedSteps::next(DecidedStep& step) {
    size_t updates = 0;
    bool whole = takeInput(file_, step.input) && takeNumbers(file_, step.acceleration_variance) &&
                 takeNumbers(file_, step.widened) && file_.take(step.is_frame) && file_.take(step.time_ns) &&
                 file_.take(step.flesh_rad2) && file_.take(updates);
    step.updates.assign(whole ? updates : 0, {});
    for (auto& blocks : step.updates) {
        size_t count = 0;
        whole = whole && file_.take(count);
        blocks.assign(whole ? count : 0, {});
        for (ObservationBlock& block : blocks)
            whole = whole && takeBlock(file_, block);
    }
    return whole;
}

}  // namespace noctule
