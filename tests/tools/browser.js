// SPDX-License-Identifier: MIT
// Chromium without a screen, driven over pipes by its DevTools protocol: node's own modules are enough.
'use strict';
const {spawn} = require('child_process');

// {send, on, waitFor, close} of a new page.
async function openBrowser(command, folder) {
    const browser = spawn(command, ['--headless=new', '--no-sandbox', '--disable-gpu', '--remote-debugging-pipe', '--no-first-run',
        '--disable-background-networking', '--disable-component-update', '--disable-dev-shm-usage', '--user-data-dir=' + folder, 'about:blank'],
    {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    const waiting = new Map(), listeners = [];
    let next = 1, rest = '', session;
    browser.on('error', (error) => waiting.forEach(({reject}) => reject(error)));
    browser.on('exit', () => waiting.forEach(({reject}) => reject(new Error('the browser ended'))));
    browser.stdio[4].setEncoding('utf8');
    browser.stdio[4].on('data', (text) => {
        const messages = (rest + text).split('\0');
        rest = messages.pop();
        for (const message of messages.map((one) => JSON.parse(one))) {
            const caller = waiting.get(message.id);
            waiting.delete(message.id);
            if (caller === undefined) {
                listeners.forEach((listener) => listener(message));
            } else if (message.error !== undefined) {
                caller.reject(new Error(message.error.message));
            } else {
                caller.resolve(message.result);
            }
        }
    });
    const send = (method, params = {}) => new Promise((resolve, reject) => {
        const id = next++;
        waiting.set(id, {resolve, reject});
        browser.stdio[3].write(JSON.stringify({id, method, params, sessionId: session}) + '\0');
    });
    const {targetInfos} = await send('Target.getTargets');
    const page = targetInfos.find((target) => target.type === 'page');
    session = (await send('Target.attachToTarget', {targetId: page.targetId, flatten: true})).sessionId;

    // The value of an expression of the page, which may be a promise.
    async function evaluate(expression) {
        const {result, exceptionDetails} = await send('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
        if (exceptionDetails !== undefined) {
            throw new Error(expression + ': ' + (exceptionDetails.exception?.description ?? exceptionDetails.text));
        }
        return result.value;
    }
    async function waitFor(expression, seconds = 10) {
        for (const end = Date.now() + 1000 * seconds; Date.now() < end;) {
            const value = await evaluate(expression);
            if (value) {
                return value;
            }
            await new Promise((done) => setTimeout(done, 20));
        }
        throw new Error('not within ' + seconds + ' seconds: ' + expression);
    }
    function close() {
        const ended = new Promise((done) => browser.removeAllListeners('exit').on('exit', done));
        browser.kill('SIGKILL');
        return ended;
    }
    return {send, evaluate, waitFor, on: (listener) => listeners.push(listener), close};
}

module.exports = {openBrowser};
