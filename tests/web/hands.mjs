/*
 * hands.mjs SHEEN PAGE FOLDER - what hands do to the page: clicks, keys, drags, touch, drops, links, bands one by one,
 * a header baked and downloaded; what it says where it cannot run. Leaves screenshots in FOLDER.
 */
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { execFileSync } from 'node:child_process';
import { Browser, differing, glass, judge, render, said, settle, PATIENCE } from './browser.mjs';

const [sheen, page_file, folder, source] = process.argv.slice(2);
const browser = await Browser.open(page_file);
const { check, end } = judge();
const data = name => path.join(source, 'tests', 'data', name);
const wait = ms => new Promise(resolve => setTimeout(resolve, ms));

/* The words of the line that the page shows, as a shell takes them, without `sheen render` and the output. */
async function shownWords(page) {
    const line = await page.$eval('#line', element => element.textContent);
    return execFileSync('bash', ['-c', `printf '%s\\0' ${line}`]).toString().split('\0').slice(2, -3);
}

/* Checks that the glass is what the command draws, given the line that the page shows. */
async function checkLine(page, what, cwd = folder) {
    await settle(page);
    const words = await shownWords(page);
    const at = process.cwd();
    process.chdir(cwd);
    const off = differing(await glass(page), render(sheen, folder, words));
    process.chdir(at);
    check(`${what}: ${words.join(' ')}: ${off} pixels differ`, off === 0);
    return words.join(' ');
}

async function clickText(page, selector, text) {
    for (const button of await page.$$(selector)) {
        if (await button.evaluate(element => element.textContent) === text)
            return button.click();
    }
    throw new Error(`no ${selector} says ${text}`);
}

async function middle(page, selector) {
    const element = await page.$(selector);
    await element.scrollIntoView();
    const box = await element.boundingBox();
    return [box.x + box.width / 2, box.y + box.height / 2, box.width, box.height];
}

async function drag(page, selector, dx, dy) {
    const [x, y] = await middle(page, selector);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 4 });
    await page.mouse.up();
}

// ---- clicks ----
let page = await browser.page();
await checkLine(page, 'at first');
for (const [selector, text, word] of [
    ['#shade button', 'slerp', '--shade slerp'], ['#shade button', 'flat', '--shade flat'],
    ['#meshes button', 'torus', 'builtin:torus'], ['#mirror', 'Mirror', '--orientation 5'],
    ['#quarter', 'Turn', '--orientation 6']]) {
    await clickText(page, selector, text);
    const words = await checkLine(page, `click on ${text}`);
    check(`click on ${text}: ${words}`, words.includes(word));
}
for (const [selector, value, word] of [['#panel', 'ssd1306-128x64', '--panel ssd1306-128x64'], ['#theme', 'yellow', ''],
    ['#panel', 'st7789-240x240-round', 'st7789-240x240-round'], ['#preset', 'chrome', '--color b8c0cc']]) {
    await page.select(selector, value);
    const words = await checkLine(page, `${value} chosen`);
    check(`${value} chosen: ${words}`, words.includes(word) && !words.includes('theme'));
}
await clickText(page, '#more-light', '+');
check('a second light', (await checkLine(page, 'a second light')).split('--light').length === 3);
await clickText(page, '#less-light', '−');
await page.$eval('#shininess', slider => { slider.value = 9; slider.dispatchEvent(new Event('input')); });
check('a slider', (await checkLine(page, 'a slider')).includes('--shininess 9'));
await page.$eval('#plan', element => { element.open = true; });
await page.select('#board', '0');
const planned = () => page.$eval('#plan-text', element => element.textContent);
await page.waitForFunction(() => document.querySelector('#plan-text').textContent.includes('Raspberry Pi Pico, '));
const told = execFileSync(sheen, ['plan', '--board', 'pico', ...await page.evaluate(() =>
    [...planWords(), '--', mesh])]).toString().replace(/\n {11}(?! )/g, ' '); // a page does not break lines
const lasting = text => text.split('\n').filter(line => !/ try /.test(line)).join('\n'); // a page does not simplify
check('the plan of what is shown', lasting(await planned()) === lasting(told) && / first try /.test(await planned()));
await page.screenshot({ path: path.join(folder, 'plan.png') });
await page.$eval('#plan', element => { element.open = false; });
await page.$eval('#controls details', element => { element.open = true; });
await page.select('#dither', 'off');
check('dither off', (await checkLine(page, 'dither off')).includes('--dither off'));
await page.type('#band', '8');
await page.keyboard.press('Enter');
check('bands of 8 rows', (await checkLine(page, 'bands of 8 rows')).includes('--band 8') &&
    await page.evaluate('sheen.x.web_bands() * 8 >= sheen.x.web_height()'));
for (const [name, text] of [['point-light', '0,.5,1.5,3,gold'], ['alpha-cutoff', '0.35'], ['fog', '1.5,4'], ['ambient-color', 'skyblue']]) {
    await page.type(`#${name}`, text);
    await page.keyboard.press('Enter');
    const words = await checkLine(page, `${name} typed`);
    check(`${name} typed: ${words}`, words.includes(`--${name} ${text}`));
}
await page.select('#matcap', 'jade');
check('a matcap that is not shown', !(await checkLine(page, 'no matcap')).includes('--matcap'));
await clickText(page, '#shade button', 'matcap');
check('a matcap', (await checkLine(page, 'a matcap')).includes('--matcap jade'));
await clickText(page, '#shade button', 'flat');
const ids = await page.$$eval('[id]', list => list.map(element => element.id));
check(`ids given twice: ${ids.filter((id, i) => ids.indexOf(id) !== i)}`, new Set(ids).size === ids.length);
await (await page.$('#ortho')).click();
check('no perspective', (await checkLine(page, 'no perspective')).includes('--ortho'));

// ---- drags, keys ----
await page.click('#reset');
await checkLine(page, 'reset');
await drag(page, '#glass', 40, -20);
check('a drag turns', /--yaw 50 --pitch 10|--pitch 10 .*--yaw 50/.test(await checkLine(page, 'a drag')));
await page.keyboard.down('Shift');
await drag(page, '#glass', 60, 30);
await page.keyboard.up('Shift');
let words = await checkLine(page, 'a drag with Shift');
check('a drag with Shift moves the light', words.includes('--light') && words.includes('--yaw 50'));
await drag(page, '#lights', 30, 25);
check('a drag of the light', (await checkLine(page, 'a drag of the light')) !== words);
await page.mouse.move(...(await middle(page, '#glass')).slice(0, 2));
await page.mouse.wheel({ deltaY: 200 });
await wait(100);
check('the wheel', !(await checkLine(page, 'the wheel')).includes('--distance 2.4'));
await page.focus('#glass');
for (const [key, word] of [['ArrowRight', '--yaw 55'], ['ArrowDown', '--pitch 15'], ['s', '--shade slerp'],
    ['o', '--orientation 2'], ['m', '--orientation 6'], ['p', '--panel st7789-240x320'], ['-', '--distance'], ['l', '']]) {
    await page.keyboard.press(key);
    const now = await checkLine(page, `key ${key}`);
    check(`key ${key}: ${now}`, now.includes(word));
}
words = await shownWords(page);
await page.keyboard.press('ArrowLeft');
check('an arrow moves the light after l', JSON.stringify(words) !== JSON.stringify((await checkLine(page, 'light')).split(' ')));
await page.keyboard.press(' ');
const was = await page.evaluate('setting("yaw")');
await page.waitForFunction(was => setting('yaw') !== was, {}, was);
await page.keyboard.press(' ');
await checkLine(page, 'after a spin');
await page.keyboard.press('t');
check('key t', await page.evaluate('setting("theme")') === 'plain');

// ---- links ----
await page.evaluate('setSpin(false)');
await settle(page);
const [hash, picture] = [await page.evaluate('link()'), await glass(page)];
for (const state of ['anew', 'in place']) {
    const other = await browser.page({ hash: state === 'anew' ? hash : '#panel=ssd1351' });
    if (state === 'in place') {
        await other.evaluate(hash => { location.hash = hash; }, hash);
        await other.waitForFunction(hash => link() === hash && !is_stale, {}, hash);
    }
    check(`a link ${state}: ${hash}`, differing(await glass(other), picture) === 0 &&
        await other.evaluate('link()') === hash && await other.evaluate('setting("theme")') === 'plain');
    await other.close();
}
for (const light of ['-0.4,0.6,0.8,red', '-0.4,0.6,0.8,00ff00', '0.25,-1,0.5']) {
    const other = await browser.page({ hash: `#light=${light}` }), line = await checkLine(other, light);
    check(`a link with light ${light}: ${line}`, line.includes(`--light ${light}`) && line.split('--light').length === 2 &&
        await other.evaluate('link()') === `#light=${light}`);
    await other.close();
}
for (const [bad, line] of [['#panel=tv', /no panel|tv/], ['#nonsense=1', /unknown or ambiguous option --nonsense/],
    ['#yaw=sideways', /--yaw 'sideways'/], ['#band=4000', /--band '4000'/], ['#light=1', /--light/],
    ['#light=1,2,3x', /--light '1,2,3x'/], ['#light=1,,2', /--light '1,,2'/], ['#light=1,2,3,rde', /--light/],
    ['#mesh=absent.stl', /absent.stl: No such file/], ['#mesh=%3Cimg src=x onerror=alert(1)%3E', /: No such file/]]) {
    const other = await browser.page({ hash: bad });
    const lines = await said(other);
    check(`${bad} says ${lines}`, lines.length === (bad.startsWith('#mesh') ? 2 : 1) && line.test(lines[0]) && lines[0].startsWith('sheen: '));
    await other.click('#reset');
    await settle(other);
    check(`${bad}: reset`, differing(await glass(other), render(sheen, folder,
        ['builtin:teapot', '--distance', '2.4', '--specular', '.6', '--cull', 'none'])) === 0);
    await other.close();
}
await page.click('#copy');
await page.waitForFunction('/link/.test(document.querySelector("#messages").textContent)');
check('the address is the link', await page.evaluate('location.hash === link()'));
await page.close();

// ---- the plan of a link ----
async function planOf(page) {
    await page.$eval('#plan', element => { element.open = true; });
    await page.select('#board', '0');
    await page.waitForFunction('document.querySelector("#plan-text").textContent.includes("Raspberry Pi Pico, ") ||' +
        '/^[^\\n]+$/.test(document.querySelector("#plan-text").textContent)');
    return page.$eval('#plan-text', element => element.textContent);
}
page = await browser.page({ hash: '#mesh=builtin:cube&yaw-step=10' });
const plan = await planOf(page);
check(`the plan of a link with a step: ${plan}`, plan.includes(' frames/s in the mean'));
await page.close();
for (const [hash, look] of [['#mesh=builtin:cube', ', smooth, dithered,'], ['#mesh=builtin:cube&panel=ssd1306', ', with outlines,'],
    ['#mesh=builtin:cube&edges=none', 'Phong, dithered,'], ['#mesh=builtin:cube&opacity=.5', 'Phong, by a pattern, dithered,']]) {
    page = await browser.page({ hash });
    const of = await planOf(page), parts = /vertices (\d+), lists (\d+), bands (\d+), the rest of the arena (\d+)/.exec(of).slice(1);
    const arena = parts.reduce((sum, part) => sum + +part, 0);
    const ram = await page.$eval('#n-ram', element => element.textContent.replace(/[, B]/g, ''));
    check(`the plan of ${hash}: ${arena} B, on the page ${ram} B: ${of.split('\n')[0]}`, of.includes(look) && arena === +ram);
    await page.close();
}

// ---- bands ----
page = await browser.page({ hash: '#panel=ili9341&yaw=0' });
const first = await glass(page), bands = await page.evaluate('sheen.x.web_bands()');
check(`${bands} bands`, bands === 15);
let above = first;
for (let band = 0; band < bands; band++) {
    await page.click('#step');
    const now = await glass(page);
    const rows = new Set();
    for (let i = 0; i < now.width * now.height; i++) {
        if (now.rgb.compare(above.rgb, 3 * i, 3 * i + 3, 3 * i, 3 * i + 3) !== 0)
            rows.add(Math.floor(i / now.width));
    }
    check(`band ${band} changes rows ${[...rows]}`, [...rows].every(row => row >> 4 === band));
    check(`caption of band ${band}`, (await page.$eval('#caption', e => e.textContent)).includes(`band ${band + 1} of 15: rows ${16 * band} to`));
    if (band === 7)
        await page.screenshot({ path: path.join(folder, 'bands.png') });
    above = now;
}
check('all bands make the next frame', differing(above, first) > 1000 && (await checkLine(page, 'all bands')).includes('--yaw 6'));
await page.click('#step');
await page.click('#spin');
await page.waitForFunction('document.querySelector("#rows").hidden');
await page.evaluate('setSpin(false)');
await checkLine(page, 'a frame begun is ended');

// ---- files: by drop, by dialog; bake ----
const client = await page.createCDPSession();
const downloads = path.join(folder, 'downloads');
fs.rmSync(downloads, { recursive: true, force: true });
await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
async function dropFiles(...files) {
    const [x, y] = await middle(page, '#glass');
    const drop = { items: [], files, dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'])
        await client.send('Input.dispatchDragEvent', { type, x, y, data: drop });
}
await dropFiles(data('star.obj'));
await page.waitForFunction('mesh === "star.obj" && !is_busy');
await checkLine(page, 'a drop', path.join(source, 'tests', 'data'));
fs.writeFileSync(path.join(folder, 'broken.stl'), 'no solid');
await dropFiles(path.join(folder, 'broken.stl'));
await page.waitForFunction('!is_busy && document.querySelector("#messages .bad")');
check(`a bad drop: ${await said(page)}`, (await said(page))[0].startsWith('sheen: broken.stl: '));
await checkLine(page, 'after a bad drop', path.join(source, 'tests', 'data'));
await page.screenshot({ path: path.join(folder, 'refused.png') });
await (await page.$('#file')).uploadFile(data('box.obj'), data('box.mtl'));
await page.waitForFunction('mesh === "box.obj" && !is_busy');
await (await page.$('#file-color')).evaluate(element => element.click());
check('colours', (await checkLine(page, 'colours', path.join(source, 'tests', 'data'))).includes('--color file'));

async function bakeAndCompare(name, mesh, ...words) {
    await page.click('#bake');
    const got = path.join(downloads, `${name}.h`), want = path.join(folder, `${name}.h`);
    for (let ms = 0; ms < PATIENCE && !fs.existsSync(got); ms += 50)
        await wait(50);
    await wait(100);
    const report = execFileSync(sheen, ['bake', mesh, ...words, '-o', want]).toString().trim().split('\n');
    check(`the header of ${name} is another`, fs.readFileSync(got).equals(fs.readFileSync(want)));
    const lines = (await said(page)).at(-1); // the page's RAM is that of a machine of 32 bits
    check(`the report on ${name}: ${lines}`, report.every(line => /^RAM/.test(line) || lines.includes(line)));
    execFileSync('gcc', ['-std=c11', '-Wall', '-Wno-unused-const-variable', '-Werror', '-I', path.join(source, 'core'),
        '-fsyntax-only', '-include', 'sheen.h', got]);
    const bytes = await page.$eval('#n-flash', element => element.textContent.replace(/[, B]/g, ''));
    check(`flash of ${name}: ${bytes}`, report.some(line => line === `flash: ${bytes} B`) || name === 'box');
}
await bakeAndCompare('box', data('box.obj'));
await page.evaluate(() => { // a reader that never answers, and a clock that does not wait for it
    const [worker, timeout] = [Worker, setTimeout];
    Worker = class { postMessage() {} terminate() { Worker = worker; window.setTimeout = timeout; } };
    window.setTimeout = (act, ms) => timeout(act, ms === 1000 * READ_SECONDS ? 50 : ms);
});
await (await page.$('#file')).uploadFile(data('egg.obj'));
await page.waitForFunction('/more than/.test(document.querySelector("#messages").textContent)');
check(`a reader without end: ${await said(page)}`, (await said(page))[0] === 'sheen: egg.obj: reading it takes more than 10 s');
await checkLine(page, 'after a reader without end', path.join(source, 'tests', 'data'));

await page.click('#reset');
await page.select('#normals', 'average');
await settle(page);
await bakeAndCompare('teapot', 'builtin:teapot', '--normals', 'average');
await (await page.$('#file')).uploadFile(data('ring.ply'));
await page.waitForFunction('mesh === "ring.ply" && !is_busy');
await page.select('#normals', '');
await page.select('#vertex-colors', 'off');
await settle(page);
await bakeAndCompare('ring', data('ring.ply'), '--vertex-colors', 'off');
await page.close();

// ---- another frame of a mesh: of a file, between them by a slider, of a glTF's own targets ----
page = await browser.page();
const folder_of_data = path.join(source, 'tests', 'data');
const frames = await page.createCDPSession();
await frames.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
async function chooseFrame(name) {
    await (await page.$('#frame')).uploadFile(name);
    await page.waitForFunction('is_busy || document.querySelector("#messages .bad") || settings.morph');
    await settle(page);
}
await (await page.$('#file')).uploadFile(data('globe.obj'));
await page.waitForFunction('mesh === "globe.obj" && !is_busy');
check('no frame yet', await page.evaluate('$("frame-sliders").hidden && $("own-frame").hidden && $("no-frame").hidden'));
await chooseFrame(data('globe_tall.obj'));
words = await checkLine(page, 'another frame', folder_of_data);
check(`another frame: ${words}`, words.includes('--morph globe_tall.obj') && words.includes('--morph-weight 0.5'));
for (const weight of ['0.25', '1']) {
    await page.$eval('#morph-weight', (slider, weight) => {
        slider.value = weight;
        slider.dispatchEvent(new Event('input'));
    }, weight);
    words = await checkLine(page, `weight ${weight}`, folder_of_data);
    check(`weight ${weight}: ${words}`, words.includes(`--morph-weight ${weight}`));
}
await page.screenshot({ path: path.join(folder, 'frame.png') });
await page.click('#bake');
for (let ms = 0; ms < PATIENCE && !fs.existsSync(path.join(downloads, 'globe.h')); ms += 50)
    await wait(50);
await wait(100);
check('a header of both', /const struct sheen_mesh globe_second = /.test(fs.readFileSync(path.join(downloads, 'globe.h'), 'utf8')));
await chooseFrame(data('star.obj'));
check(`a frame of another mesh: ${await said(page)}`, /^sheen: .*star.obj/.test((await said(page))[0]));
check('what was shown stays', (await checkLine(page, 'after such a frame', folder_of_data)).includes('--morph globe_tall.obj'));
await page.click('#no-frame');
check('no frame', !(await checkLine(page, 'no frame', folder_of_data)).includes('morph'));
const points = [[-1, -1, 0, 1, -1, 0, 0, 1, 0], [0, 0, 1, 0, 0, 0, 0, 0, 0], [0, 0, 0, 1, 1, 0, 0, 0, -1]];
const floats = Buffer.from(new Float32Array(points.flat()).buffer);
fs.writeFileSync(path.join(folder, 'bent.gltf'), JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, targets: [{ POSITION: 1 }, { POSITION: 2 }] }], weights: [0, 0] }],
    accessors: points.map((_, i) => ({ bufferView: i, componentType: 5126, count: 3, type: 'VEC3', min: [-1, -1, -1], max: [1, 1, 1] })),
    bufferViews: points.map((_, i) => ({ buffer: 0, byteOffset: 36 * i, byteLength: 36 })),
    buffers: [{ byteLength: floats.length, uri: `data:application/octet-stream;base64,${floats.toString('base64')}` }],
}));
await (await page.$('#file')).uploadFile(path.join(folder, 'bent.gltf'));
await page.waitForFunction('mesh === "bent.gltf" && !is_busy');
await page.click('#own-frame');
await page.waitForFunction('settings.morph === "bent.gltf" && !is_busy');
const bent = await checkLine(page, 'its own target');
await page.$eval('#morph-target', input => { input.value = 1; input.dispatchEvent(new Event('change')); });
await page.waitForFunction('!is_stale && !is_busy && frame.read.split("\\0").includes("1")');
words = await checkLine(page, 'its other target');
check(`targets: ${bent}; ${words}`, bent.includes('--morph bent.gltf') && words.includes('--morph-target 1'));
await clickText(page, '#meshes button', 'torus');
check('another mesh has no frame', !(await checkLine(page, 'another mesh')).includes('morph'));
await page.close();

// ---- a stranger: his STL, his panel, the header, a program with it ----
page = await browser.page();
const walk = await page.createCDPSession();
await walk.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
const stl = path.join(folder, 'wedge.stl');
fs.writeFileSync(stl, ['0 0 0 4 0 0 0 3 0', '0 0 0 0 3 0 0 0 2', '0 0 0 0 0 2 4 0 0', '4 0 0 0 0 2 0 3 0'].reduce((text, facet) => {
    const n = facet.split(' ').map(Number);
    return text + `facet normal 0 0 0\nouter loop\n${[0, 3, 6].map(at => `vertex ${n.slice(at, at + 3).join(' ')}\n`).join('')}` +
        'endloop\nendfacet\n';
}, 'solid wedge\n') + 'endsolid wedge\n');
await (await page.$('#file')).uploadFile(stl);
await page.waitForFunction('mesh === "wedge.stl" && !is_busy');
await page.select('#panel', 'st7789-135x240');
check('a stranger', (await checkLine(page, 'a stranger')).includes('--panel st7789-135x240'));
await bakeAndCompare('wedge', stl);
fs.writeFileSync(path.join(folder, 'wedge.c'), `#include <stdio.h>
#include "wedge.h"
int main(void)
{
    printf("%u vertices, %u triangles\\n", wedge.vertices, wedge.triangles);
    return sheen_mesh_check(&wedge, wedge.triangles);
}
`);
execFileSync('bash', ['-c', 'gcc -O0 -I "$1/core" -I "$2/downloads" -o "$2/wedge" "$2/wedge.c" "$1"/core/*/*.c', '-', source, folder]);
check('the header runs', execFileSync(path.join(folder, 'wedge')).toString() === '12 vertices, 4 triangles\n');
await page.close();

// ---- a phone: touch, and no scrolling sideways ----
page = await browser.page({ phone: true, width: 390, height: 844, hash: '#panel=gc9a01&distance=2.4&cull=none' });
check('as wide as the phone', await page.evaluate('document.documentElement.scrollWidth') === 390);
const small = await page.$$eval('button, select, .file', list =>
    list.filter(e => !e.closest('[hidden]') && e.getBoundingClientRect().height < 40).length);
check(`${small} controls too small for fingers`, small === 0);
const touch = await page.createCDPSession();
const send = (type, ...points) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
const [x, y] = await middle(page, '#glass');
await send('touchStart', [x, y]);
await send('touchMove', [x + 30, y]);
await send('touchMove', [x + 60, y]);
await send('touchEnd');
await page.waitForFunction('setting("yaw") === "60"');
await checkLine(page, 'a finger turns');
await send('touchStart', [x - 30, y], [x + 30, y]);
await send('touchMove', [x - 60, y], [x + 60, y]);
await send('touchEnd');
await page.waitForFunction('+setting("distance") < 2');
await checkLine(page, 'two fingers zoom');
await page.click('#drag');
await send('touchStart', [x, y]);
await send('touchMove', [x + 40, y + 40]);
await send('touchEnd');
await page.waitForFunction('link().includes("light=")');
await checkLine(page, 'a finger moves the light');
await page.screenshot({ path: path.join(folder, 'phone.png') });
await page.evaluate('scrollTo(0, 900)');
await wait(200);
await page.screenshot({ path: path.join(folder, 'phone-below.png') });
await page.close();

// ---- on a server of files; light and dark ----
const server = http.createServer((request, response) => {
    response.writeHead(request.url === '/' ? 200 : 404, { 'content-type': 'text/html' });
    response.end(request.url === '/' ? fs.readFileSync(page_file) : '');
}).listen(0, '127.0.0.1');
await new Promise(resolve => server.on('listening', resolve));
page = await browser.page({ url: `http://127.0.0.1:${server.address().port}/`, turns: true });
check('it turns at first', await page.evaluate('spinning'));
await page.evaluate('setSpin(false); set("yaw", 40)');
await checkLine(page, 'from a server');
await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'light' }]);
await page.screenshot({ path: path.join(folder, 'light.png') });
await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'dark' }]);
await page.screenshot({ path: path.join(folder, 'dark.png') });
await page.close();
server.close();

// ---- where it cannot run ----
for (const [before, line] of [['delete window.WebAssembly', /has no WebAssembly/],
    ['WebAssembly.compile = () => Promise.reject(new Error("no memory"))', /does not start in this browser: no memory/]]) {
    page = await browser.page({ before });
    const banner = await page.$eval('#banner', element => element.hidden ? '' : element.textContent);
    check(`${before}: says ${banner}`, line.test(banner));
    await page.close();
}
page = await browser.browser.newPage();
await page.setJavaScriptEnabled(false);
await page.goto(browser.url);
check('without JavaScript', await page.$eval('noscript', element => element.getBoundingClientRect().height > 0));
await page.close();

check(`requests: ${browser.outside}`, browser.outside.length === 0);
check(`errors: ${browser.errors}`, browser.errors.length === 0);
await browser.close();
end('hands');
