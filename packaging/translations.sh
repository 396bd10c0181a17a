#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Brings new sentences of the sources into resources/translations/*.ts, and takes out those that are gone. They are
# then translated with Qt Linguist; a test says when one is missing.
set -euo pipefail
cd "$(dirname "$0")/.."

update() {
    lupdate ui app -I . -extensions cpp,h -locations none -no-obsolete "$@"
}
update -ts resources/translations/noctule_de.ts
update -pluralonly -ts resources/translations/noctule_en.ts
packaging/core_sentences.py
