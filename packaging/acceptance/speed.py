# SPDX-License-Identifier: Apache-2.0
"""How much faster than the performance itself it is simulated and processed, on one core."""
import studio


def figure(options):
    motion = studio.REAL_MOTIONS / "Boxing_Toes.bvh"
    take = studio.OUT / "speed" / "speed_001.noctule"
    simulate_s = studio.seconds_on_one_core(lambda: studio.simulate(motion, take, "--level", "signal"))
    duration_s = studio.take_seconds(take)
    rows = [["simulate, level signal", f"{simulate_s:.1f}", f"{duration_s / simulate_s:.1f}"]]
    for sensors, estimator in (("AGD", "manifold"), ("AGD", "paper")):
        process_s = studio.seconds_on_one_core(
            lambda: studio.process(take, sensors, f"{sensors}-{estimator}", "--estimator", estimator))
        rows.append([f"process {'+'.join(sensors)}, {estimator}", f"{process_s:.1f}", f"{duration_s / process_s:.1f}"])
    return (f"{motion.stem}: a take of {duration_s:.1f} s from raw samples, whole programs with reading and writing "
            "of files, one core.\n\n" + studio.markdown_table(["what", "seconds", "times real time"], rows) + "\n")
