# SPDX-License-Identifier: Apache-2.0
"""Calibration on simulated rigs, many suits of 18 boards, and from rendered photographs; true values hidden."""
import built_tests


def figure(options):
    rigs = built_tests.run("test_core_calibration", "*", r"[0-9].*(mm|mg|deg|°|named|error)",
                           NOCTULE_CALIBRATION_TRIALS=str(options.calibration_trials))
    photographs = built_tests.run("test_core_vision", "*", r"(mm|px|chi-square)")
    return (f"Nominal scenario, {options.calibration_trials} suits each.\n\n### Rigs and rest pose\n\n{rigs}\n"
            f"### Photographs with markers\n\n{photographs}")
