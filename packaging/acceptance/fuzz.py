# SPDX-License-Identifier: Apache-2.0
"""Damaged bytes into the link's parser, the reader of takes and the readers of JSON, inside one process each."""
import os

import built_tests


def figure(options):
    count = str(options.damaged_inputs)
    in_memory = {"TMPDIR": "/dev/shm"} if os.access("/dev/shm", os.W_OK) else {}
    text = ""
    for what, program, cases in (
            ("link, bytes of a stream", "test_devices_driver_box", "FuzzLink.BytesOfAStream"),
            ("link, payloads to the studio", "test_devices_driver_box", "FuzzLink.PayloadsToTheStudio"),
            ("link, payloads to the box", "test_devices_driver_box", "FuzzLink.PayloadsToTheBox"),
            ("takes", "test_core_recording", "FuzzTake.DamagedFiles"),
            ("rows of takes", "test_core_recording", "FuzzRows.DamagedValues"),
            ("JSON of takes", "test_core_recording", "FuzzJson.DamagedDocuments"),
            ("JSON of sessions", "test_core_session", "FuzzSession.DamagedDocuments"),
            ("recordings of other sensors and markers", "test_core_import", "FuzzImport.*")):
        found = built_tests.run(program, cases, "damaged inputs|could be opened", NOCTULE_FUZZ_INPUTS=count, **in_memory)
        text += f"{what}:\n\n{found}\n"
    # A process for each: fewer of them.
    found = built_tests.run("test_core_mesh", "FuzzMesh.*", "damaged inputs|could be opened",
                            NOCTULE_FUZZ_INPUTS=str(min(options.damaged_inputs, options.damaged_meshes)), **in_memory)
    return text + f"meshes, each in a reader of its own:\n\n{found}\n"
