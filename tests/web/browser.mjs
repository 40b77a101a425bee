/*
 * browser.mjs - a headless Chromium with the page in it, and what the tests share.
 */
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { execFileSync } from 'node:child_process';
import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

export const PATIENCE = 120000; // ms

/* A PNG of 8 bits a channel without interlace: width, height, rgb. */
export function decodePng(file) {
    const png = fs.readFileSync(file), parts = [];
    const width = png.readUInt32BE(16), height = png.readUInt32BE(20), kind = png[25];
    let palette = null;
    for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
        const type = png.toString('latin1', at + 4, at + 8), data = png.subarray(at + 8, at + 8 + png.readUInt32BE(at));
        if (type === 'IDAT')
            parts.push(data);
        if (type === 'PLTE')
            palette = data;
    }
    if (png[24] !== 8 || png[28] !== 0 || ![0, 2, 3].includes(kind))
        throw new Error(`${file}: a PNG of another kind`);
    const each = kind === 2 ? 3 : 1, stride = width * each, raw = zlib.inflateSync(Buffer.concat(parts));
    const rows = Buffer.alloc(stride * height), rgb = Buffer.alloc(3 * width * height);
    for (let y = 0; y < height; y++) {
        const filter = raw[y * (stride + 1)];
        for (let x = 0; x < stride; x++) {
            const left = x >= each ? rows[y * stride + x - each] : 0, up = y ? rows[(y - 1) * stride + x] : 0;
            const corner = x >= each && y ? rows[(y - 1) * stride + x - each] : 0, guess = left + up - corner;
            const [a, b, c] = [left, up, corner].map(v => Math.abs(guess - v));
            const paeth = a <= b && a <= c ? left : b <= c ? up : corner;
            rows[y * stride + x] = raw[y * (stride + 1) + 1 + x] + [0, left, up, (left + up) >> 1, paeth][filter];
        }
    }
    for (let i = 0; i < width * height; i++) {
        for (let k = 0; k < 3; k++)
            rgb[3 * i + k] = kind === 2 ? rows[3 * i + k] : kind === 3 ? palette[3 * rows[i] + k] : rows[i];
    }
    return { width, height, rgb };
}

/* The picture that the command makes of these words. */
export function render(sheen, folder, words) {
    const out = path.join(folder, 'command.png');
    execFileSync(sheen, ['render', '-o', out, ...words], { stdio: ['ignore', 'pipe', 'pipe'] });
    return decodePng(out);
}

/* Pixels that differ between two pictures; Infinity for other sizes. */
export function differing(a, b) {
    if (a.width !== b.width || a.height !== b.height)
        return Infinity;
    let count = 0;
    for (let i = 0; i < a.width * a.height; i++)
        count += a.rgb.compare(b.rgb, 3 * i, 3 * i + 3, 3 * i, 3 * i + 3) !== 0;
    return count;
}

/* Counts checks: `check(what, is_so)`; `end()` prints the result. */
export function judge() {
    let good = 0, bad = 0;
    return {
        check(what, is_so) {
            if (is_so)
                good++;
            else if (++bad <= 20)
                console.error(`web: ${what}`);
            return is_so;
        },
        end(what) {
            console.log(`${what}: ${good} as they should be, ${bad} not`);
            process.exitCode = bad || !good ? 1 : 0;
        },
    };
}

/* A browser; every page of it is watched for requests and errors. */
export class Browser {
    static async open(file) {
        const self = new Browser();
        self.url = pathToFileURL(file).href;
        self.outside = [];
        self.errors = [];
        self.browser = await puppeteer.launch({
            executablePath: '/usr/bin/chromium', headless: true, protocolTimeout: PATIENCE, timeout: PATIENCE,
            args: ['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage'],
        });
        return self;
    }

    /* A new page at the address with this #..., ready, and still unless it is left to turn. */
    async page({ hash = '', width = 1280, height = 800, phone = false, before = null, turns = false, url = this.url } = {}) {
        const page = await this.browser.newPage();
        page.setDefaultTimeout(PATIENCE);
        page.on('request', request => {
            if (!/^(data|blob):/.test(request.url()) && request.url().split('#')[0] !== url)
                this.outside.push(request.url());
        });
        page.on('pageerror', error => this.errors.push(error.message));
        page.on('console', message => this.errors.push(message.text()));
        await page.setViewport({ width, height, deviceScaleFactor: phone ? 2 : 1, isMobile: phone, hasTouch: phone });
        if (before)
            await page.evaluateOnNewDocument(before);
        await page.goto(url + hash);
        await page.waitForFunction('document.body.dataset.state');
        if (!turns && await page.evaluate('document.body.dataset.state') === 'ready')
            await page.evaluate('setSpin(false)');
        return page;
    }

    async close() {
        await this.browser.close();
    }
}

/* Waits until what was asked for is on the glass. */
export async function settle(page) {
    await page.waitForFunction('!is_stale && !is_busy');
}

/* The glass of the page: width, height, rgb. */
export async function glass(page) {
    const got = await page.evaluate(() => {
        const x = sheen.x, width = x.web_width(), height = x.web_height();
        const all = sheen.bytes(x.web_rgb(), 3 * width * height);
        let text = '';
        for (let i = 0; i < all.length; i += 8192)
            text += String.fromCharCode(...all.subarray(i, i + 8192));
        return { width, height, rgb: btoa(text) };
    });
    return { ...got, rgb: Buffer.from(got.rgb, 'base64') };
}

/* The page's messages, one string per line. */
export async function said(page) {
    return page.$$eval('#messages li', list => list.map(item => item.textContent));
}
