// SPDX-License-Identifier: Apache-2.0
// node validate_gltf.js FOLDER FILE...: what Khronos' validator says about glTF files. Its npm package goes into
// FOLDER, once. Exit code 77: it cannot be had, with the reason; 1: a file has errors, which are printed.
const fs = require('fs');
const path = require('path');
const { spawnSync } = require('child_process');

const SKIP = 77;
const VERSION = '2.0.0-dev.3.10';
const [parent, ...files] = process.argv.slice(2);
const folder = path.join(parent, VERSION);
const place = path.join(folder, 'node_modules', 'gltf-validator');

// Tests that run at the same time each install into a folder of their own; the first to end gives it its name.
if (!fs.existsSync(place)) {
    fs.mkdirSync(parent, { recursive: true });
    const begun = fs.mkdtempSync(folder + '-');
    const done = spawnSync('npm', ['install', '--prefix', begun, '--no-audit', '--no-fund', '--fetch-retries=0',
        '--fetch-timeout=20000', 'gltf-validator@' + VERSION], { encoding: 'utf8' });
    const installed = !done.error && done.status === 0;
    try {
        if (installed)
            fs.renameSync(begun, folder);
    } catch (error) {
        if (!fs.existsSync(place))
            throw error;
    } finally {
        fs.rmSync(begun, { recursive: true, force: true });
    }
    if (!installed) {
        console.log('Khronos\' glTF validator cannot be installed: npm or the network is not there');
        process.exit(SKIP);
    }
}

const validator = require(place);
Promise.all(files.map(file => validator.validateBytes(new Uint8Array(fs.readFileSync(file))).then(report => {
    const issues = report.issues;
    console.log(`${path.basename(file)}: ${issues.numErrors} errors, ${issues.numWarnings} warnings, ` +
        `${report.info.animationCount} animations, ${report.info.totalVertexCount} vertices`);
    issues.messages.filter(message => message.severity < 2).slice(0, 20)
        .forEach(message => console.log(`${message.code} ${message.pointer}: ${message.message}`));
    return issues.numErrors;
}))).then(errors => process.exit(errors.some(count => count > 0) ? 1 : 0));
