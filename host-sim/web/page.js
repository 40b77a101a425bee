/*
 * page.js - the page: makes the words of a command line from its controls' values, and the module obeys them.
 */
'use strict';

const $ = id => document.getElementById(id);
const MESHES = ['teapot', 'sphere', 'torus', 'cube'];
const SLIDERS = { // name: least, most, step, unit
    ambient: [0, 1, .01, ''], diffuse: [0, 1.5, .01, ''], specular: [0, 1.5, .01, ''], shininess: [1, 128, 1, ''],
    yaw: [-180, 180, .5, '°'], pitch: [-90, 90, .5, '°'], roll: [-180, 180, .5, '°'], distance: [1.2, 10, .01, ''],
    fov: [5, 120, 1, '°'], opacity: [0, 1, .01, ''], 'morph-weight': [0, 1, .01, ''],
};
const MORE = ['phase', 'fog', 'fog-color', 'ambient-color', 'point-light', 'vertex-colors', 'dither', 'ramp', 'edges', 'line-color', 'perspective',
    'cull', 'normals', 'weights', 'crease', 'up', 'reduce', 'band', 'buffers', 'texture', 'filter', 'wrap', 'texture-size', 'palette', 'alpha-cutoff', 'matcap'];
const PRESETS = { // color, ambient, diffuse, specular, shininess
    'as it comes': ['', '', '', '', ''],
    gold: ['d8a048', .18, .62, .9, 48], clay: ['c8694a', .25, .85, .05, 8], porcelain: ['f2efe8', .28, .72, .5, 96],
    jade: ['3f9a72', .2, .7, .55, 40], chrome: ['b8c0cc', .1, .55, 1.1, 80], 'blue plastic': ['3a6fd8', .2, .75, .7, 64],
    rubber: ['3c3c40', .3, .8, .18, 6],
};
const SPIN_DEGREES = 36; // per second
const READ_SECONDS = 10;

let code, sheen; // the compiled module, its instance that draws
const defaults = {}, choices = {}, helps = {}; // of the options of `sheen view`, by name
let settings = {}; // options whose value is not the default; lights are in a list of their own
let lights = [];
let mesh = 'builtin:teapot';
let own = null; // the mesh of a file: { files: all that came with it, name, read: the words that it was read with }
let frame = null; // another frame of the mesh, in the same form
let chosen = 0; // the number of the light that moves
let shown = false, spinning = false, moves_light = false, is_stale = true, is_busy = false;
let times = [], timed = '', last = 0; // ms of the latest frames; the mesh that they show; when the last tick was

/* ---- settings and words ---- */

const setting = name => settings[name] ?? defaults[name] ?? '';

function set(name, value) {
    const text = String(value);
    if (text === '' || text === (defaults[name] ?? ''))
        delete settings[name];
    else
        settings[name] = text;
    is_stale = true;
}

function setNumber(name, value) {
    const [least, most, step] = SLIDERS[name];
    set(name, +Math.min(most, Math.max(least, value)).toFixed(step < .1 ? 2 : 1));
}

const turned = degrees => ((degrees + 180) % 360 + 360) % 360 - 180;
const textOf = v => v.map(x => +x.toFixed(3)).join(',');

function setLights(list) {
    lights = list;
    is_stale = true;
}

const LOOK = ['theme', 'gap', 'scale'];
const NOT_PLANNED = [...LOOK, 'yaw-step', 'edges']; // a plan is of a whole turn; planWords() adds the edges
const READS = ['texture', 'wrap', 'texture-size', 'alpha-cutoff']; // options that decide how a file's pictures are read
const BAKES = ['normals', 'weights', 'crease', 'up', 'reduce', 'filter', 'palette', 'morph', 'morph-target', 'vertex-colors',
    ...READS];

function optionWords(keep) {
    const words = [];
    for (const [name, value] of Object.entries(settings)) {
        if (keep(name) && (name !== 'matcap' || setting('shade').startsWith('matcap')))
            words.push(...(choices[name] === null ? [`--${name}`] : [`--${name}`, value]));
    }
    if (keep('light') && (settings['point-light'] || lights.length !== 1 || textOf(lights[0]) !== defaults.light))
        lights.forEach(v => words.push('--light', textOf(v)));
    return words;
}

const quoted = word => /^[\w.,:+=/@%-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`;

function commandLine() {
    const words = optionWords(name => !LOOK.includes(name));
    return ['sheen', 'render', mesh, ...words, '-o', 'out.png'].map(quoted).join(' ');
}

/* ---- the link ---- */

const FIRST = '#distance=2.4&specular=0.6&cull=none'; // the settings of a page that was opened without a link

function link() {
    const query = new URLSearchParams();
    if (mesh !== 'builtin:teapot')
        query.append('mesh', mesh);
    for (const [name, value] of Object.entries(settings))
        query.append(name, choices[name] === null ? '' : value);
    if (textOf(lights[0]) !== defaults.light || lights.length > 1)
        lights.forEach(v => query.append('light', textOf(v)));
    return '#' + query.toString().replace(/%2C/g, ',').replace(/%3A/g, ':');
}

/* Three numbers are a light that the page can move. A light with a colour, or any other text, stays a plain setting. */
const isDirection = text => /^[^,]+,[^,]+,[^,]+$/.test(text) &&
    text.split(',').every(part => part.trim() !== '' && Number.isFinite(Number(part)));

function followLink() {
    const query = new URLSearchParams((location.hash.length > 1 ? location.hash : FIRST).slice(1));
    const given = [];
    settings = {};
    mesh = 'builtin:teapot';
    for (const [name, value] of query) {
        if (name === 'mesh')
            mesh = value;
        else if (name === 'light' && isDirection(value))
            given.push(value.split(',').map(Number));
        else
            settings[name] = value;
    }
    chosen = 0;
    lights = given.length ? given : [defaults.light.split(',').map(Number)];
    is_stale = true;
}

let linkTimer = 0;
function keepLink() {
    clearTimeout(linkTimer);
    linkTimer = setTimeout(() => history.replaceState(null, '', link() === '#' ? '#mesh=builtin:teapot' : link()), 250);
}

/* ---- messages ---- */

function say(lines, kind = '') {
    $('messages').replaceChildren(...lines.map(line => {
        const item = document.createElement('li');
        item.textContent = line;
        item.className = kind;
        return item;
    }));
}

/* Takes the warnings that the module has printed since the last call. */
function takeWarnings() {
    const lines = sheen.errors.split('\n').filter(Boolean);
    sheen.errors = '';
    return lines;
}

/* ---- a frame ---- */

function scaleOf(width, height) {
    const stage = document.querySelector('main').clientWidth, wide = innerWidth > 920;
    const room = (wide ? stage - 372 - 44 : innerWidth - 24) - 36, tall = wide ? innerHeight - 240 : .36 * innerHeight;
    const scale = Math.floor(devicePixelRatio * Math.min(room / width, tall / height));
    return Math.min(16, Math.max(1, scale));
}

function paint() {
    const x = sheen.x, width = x.web_width(), height = x.web_height(), scale = scaleOf(width, height);
    const canvas = $('glass'), across = width * scale, down = height * scale;
    if (canvas.width !== across || canvas.height !== down) {
        canvas.width = across;
        canvas.height = down;
    }
    canvas.style.width = `${across / devicePixelRatio}px`;
    const at = x.web_glass(scale);
    if (at)
        canvas.getContext('2d').putImageData(new ImageData(sheen.bytes(at, 4 * across * down).slice(), across, down), 0, 0);
    $('module').classList.toggle('round', !!x.web_is_round());
}

/* The median time of the latest frames. */
const timeText = () => times.length ? `${[...times].sort((a, b) => a - b)[times.length >> 1].toFixed(1)} ms` : '–';
const count = n => Math.round(n).toLocaleString('en-US');

function showNumbers() {
    const x = sheen.x, stats = JSON.parse(sheen.text(x.web_stats())), clock = x.web_clock(), whole = x.web_frame_bytes();
    const band = x.web_shown_band(), sent = stats.bus.bytes, rate = bytes => (clock / 8 / bytes).toFixed(1);
    $('n-time').textContent = timeText();
    $('n-bus').textContent = `${count(sent)} B`;
    $('n-bus-sub').textContent = sent > whole ? 'the whole glass, commands and all'
        : `${Math.round(100 * sent / whole)} % of a whole frame: what changed`;
    $('n-ceiling').textContent = clock ? `${rate(whole)} fps` : 'none';
    $('n-ceiling-sub').textContent = clock ? `at ${clock / 1e6} MHz; ${sent ? `${rate(sent)} like this` : 'nothing sent'}`
        : 'plain memory, no wire';
    $('n-ram').textContent = `${count(x.web_arena())} B`;
    $('n-ram-sub').textContent = `a framebuffer alone: ${count(whole)} B`;
    $('n-flash').textContent = `${count(x.web_flash())} B`;
    $('n-flash-sub').textContent = `${count(stats.triangles.in)} triangles, ${count(x.web_vertices())} vertices`;
    $('caption').textContent = `${sheen.text(x.web_panel())} · ${x.web_width()}×${x.web_height()} · orientation ` +
        `${x.web_orientation()} · ` + (band < 0 ? `${setting('shade')}, ${count(stats.triangles.drawn)} triangles drawn, ` +
        `${count(stats.pixels.shaded)} pixels shaded`
        : `band ${band + 1} of ${x.web_bands()}: rows ${x.web_band_row(0)} to ${x.web_band_row(1) - 1}, ` +
        `${count(sent)} B so far`);
    const box = $('rows');
    box.hidden = band < 0;
    box.style.top = `${100 * x.web_band_row(0) / x.web_height()}%`;
    box.style.height = `${100 * (x.web_band_row(1) - x.web_band_row(0)) / x.web_height()}%`;
}

function failed(why) {
    shown = false;
    $('caption').textContent = 'nothing is shown';
    say([`sheen: ${why}`], 'bad');
}

/* Draws what the settings ask for. Returns whether that succeeded. */
function show() {
    is_stale = false;
    const words = ['view', ...optionWords(() => true), '--', mesh];
    const start = performance.now();
    const error = sheen.x.web_show(sheen.words(words));
    const ms = performance.now() - start;
    keepLink();
    if (error) {
        takeWarnings();
        failed(sheen.text(sheen.x.web_problem()));
        if (!mesh.startsWith('builtin:') && !sheen.files.has(mesh))
            $('messages').append(make('li', {}, 'The link is to a file of somebody’s own. Dropped here it is shown as the link says.'));
        return false;
    }
    const is_first = !shown || timed !== mesh; // this frame loads the mesh, its time does not count
    times = is_first ? [] : [...times.slice(-24), ms];
    timed = mesh;
    const was_shown = shown, warnings = takeWarnings();
    shown = true;
    if (warnings.length || !was_shown)
        say(warnings);
    $('line').textContent = commandLine();
    plan();
    paint();
    if (is_first) {
        showNumbers();
        const again = performance.now();
        sheen.x.web_again();
        times = [performance.now() - again];
        $('n-time').textContent = timeText();
    } else {
        showNumbers();
    }
    return true;
}

function tick(now) {
    const seconds = Math.min(.1, (now - last) / 1000);
    last = now;
    if (spinning && !is_busy) {
        set('yaw', +turned(+setting('yaw') + SPIN_DEGREES * seconds).toFixed(1));
        showSlider('yaw');
    }
    if (is_stale && !is_busy && !readAgain())
        show();
    requestAnimationFrame(tick);
}

/* ---- files ---- */

const READABLE = /\.(obj|stlb?|stla|ply|c?n?off|glb|gltf|vrm)$/i, PICTURE = /\.(png|jpe?g)$/i;

const readWords = name => ['view', ...optionWords(option => READS.includes(option)), '--', name];

/* The module's answer to a file, from a worker that is ended after READ_SECONDS. */
function answerFrom(given, name, words) {
    const source = $('host').textContent + `
        onmessage = async ({ data }) => {
            try {
                postMessage({ answer: await sheenRead(data.code, new Map(data.files), data.name, data.words) });
            } catch (error) {
                postMessage({ broken: String(error.message || error) });
            }
        };`;
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    return new Promise((resolve, reject) => {
        const worker = new Worker(url);
        const end = (settle, value) => {
            clearTimeout(timer);
            worker.terminate();
            URL.revokeObjectURL(url);
            settle(value);
        };
        const timer = setTimeout(() => end(reject, `${name}: reading it takes more than ${READ_SECONDS} s`),
            1000 * READ_SECONDS);
        worker.onmessage = ({ data }) => data.answer ? end(resolve, data.answer)
            : end(reject, `${name}: its importer crashed (${data.broken})`);
        worker.onerror = event => end(reject, `${name}: its importer crashed (${event.message})`);
        worker.postMessage({ code, files: [...given], name, words });
    });
}

const frameKey = name => `frame of ${name}`; // as in web_mesh.c
const frameWords = name => ['view', '--morph', name, '--morph-target', setting('morph-target'), '--', name];

function dropFrame() {
    frame = null;
    ['morph', 'morph-target', 'morph-weight'].forEach(name => set(name, ''));
}

/* Lets `act` change what is shown and shows it. On an error, shows the state before again and throws the error lines. */
function showChanged(act) {
    const was = { mesh, own, frame, settings: { ...settings }, files: new Map(sheen.files) };
    act();
    sheen.x.web_forget();
    shown = false;
    if (!show()) {
        const lines = [...$('messages').children].map(item => item.textContent);
        ({ mesh, own, frame, settings, files: sheen.files } = was);
        sheen.x.web_forget();
        show();
        throw lines;
    }
}

/* Reads a file's mesh and pictures and shows them. */
async function showFile(files, name) {
    const words = readWords(name), answer = await answerFrom(files, name, words);
    showChanged(() => {
        if (frame && mesh !== name)
            dropFrame();
        sheen.files = new Map([...sheen.files].filter(([key]) => frame && key === frameKey(frame.name)));
        sheen.files.set(name, answer);
        own = { files, name, read: words.join('\0') };
        mesh = name;
    });
}

/* Reads another frame of the mesh and shows a morph between the two, half way at first. */
async function showFrame(files, name) {
    const words = frameWords(name), answer = await answerFrom(files, name, words);
    showChanged(() => {
        sheen.files.set(frameKey(name), answer);
        if (!frame)
            set('morph-weight', .5);
        frame = { files, name, read: words.join('\0') };
        set('morph', name);
    });
}

/* Runs `act` while the page is marked as busy, and shows its errors. */
async function busily(act) {
    is_busy = true;
    document.body.dataset.state = 'busy';
    try {
        await act();
    } catch (why) {
        say(Array.isArray(why) ? why : [`sheen: ${why.message ?? why}`], 'bad');
    }
    showControls();
    is_busy = false;
    document.body.dataset.state = 'ready';
}

/* Reads files that were dropped or chosen. Returns them and the name of the mesh, undefined if there is no file. */
async function readFiles(list) {
    const files = new Map();
    for (const file of list)
        files.set(file.name, new Uint8Array(await file.arrayBuffer()));
    const names = [...files.keys()];
    return [files, names.find(n => READABLE.test(n)) ?? names[0]];
}

/* Takes files: a mesh with the files that it names, or a picture for the mesh of a file that is shown. */
const take = list => busily(async () => {
    const [given, name] = await readFiles(list);
    if (!name)
        throw 'that was no file';
    say([`${name}: reading it …`]);
    if (!PICTURE.test(name) || mesh !== own?.name) {
        await showFile(given, name);
        return;
    }
    const was = settings.texture;
    set('texture', name);
    try {
        await showFile(new Map([...own.files, ...given]), own.name);
    } catch (why) {
        set('texture', was ?? '');
        show();
        throw why;
    }
});

const takeFrame = list => busily(async () => {
    const [given, name] = await readFiles(list);
    if (name)
        await showFrame(given, name);
});

/* Reads a file again if its pictures or its morph target are to be read with other options. Returns whether it does. */
function readAgain() {
    if (frame && settings.morph === frame.name && frame.read !== frameWords(frame.name).join('\0')) {
        frame.read = frameWords(frame.name).join('\0');
        busily(() => showFrame(frame.files, frame.name));
        return true;
    }
    if (!own || mesh !== own.name || own.read === readWords(mesh).join('\0'))
        return false;
    own.read = readWords(mesh).join('\0'); // noted at once, so that a failure is not tried again
    busily(() => showFile(own.files, own.name));
    return true;
}

/* ---- boards ---- */

let planTimer = 0;

const planWords = () => [...optionWords(name => !NOT_PLANNED.includes(name)),
    '--edges', choices.edges.split('|')[sheen.x.web_edges()]];

/* Shows what `sheen plan` says of the mesh, if that part of the page is open, once nothing has changed for a moment. */
function plan() {
    clearTimeout(planTimer);
    if (!$('plan').open || !shown)
        return;
    planTimer = setTimeout(() => {
        if (!shown) // it may have failed meanwhile
            return;
        const words = ['plan', ...planWords(), '--', mesh];
        const error = sheen.x.web_plan(sheen.words(words), +$('board').value);
        takeWarnings();
        $('plan-text').textContent = sheen.text(error ? sheen.x.web_problem() : sheen.x.web_text());
    }, 400);
}

function makePlan() {
    $('board').append(make('option', { value: -1 }, 'all of them'));
    for (let i = 0, name; (name = sheen.text(sheen.x.web_board(i))); i++)
        $('board').append(make('option', { value: i }, name));
    $('board').onchange = $('plan').ontoggle = plan;
}

/* ---- baking ---- */

function bake() {
    const name = mesh.replace(/^builtin:/, '').replace(/\.[^.]*$/, '') + '.h';
    const words = ['bake', ...optionWords(option => BAKES.includes(option)), '-o', name, '--', mesh];
    sheen.output.length = 0;
    const status = sheen.x.web_bake(sheen.words(words)), warnings = takeWarnings();
    if (status) {
        say([`sheen: ${sheen.text(sheen.x.web_problem())}`], 'bad');
        return;
    }
    const report = sheen.output.map(part => new TextDecoder().decode(part)).join('').trim().split('\n');
    const url = URL.createObjectURL(new Blob([sheen.text(sheen.x.web_text())], { type: 'text/x-c' }));
    const anchor = Object.assign(document.createElement('a'), { href: url, download: name });
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
    say([...warnings, `${name} downloaded. ${report.join(' · ')}`]);
}

/* ---- controls ---- */

function make(tag, fields, ...children) {
    const element = Object.assign(document.createElement(tag), fields);
    element.append(...children);
    return element;
}

function slider(name) {
    const [least, most, step] = SLIDERS[name];
    const input = make('input', { type: 'range', id: name, min: least, max: most, step, title: helps[name] });
    input.oninput = () => {
        set(name, input.value);
        showSlider(name);
    };
    return make('label', { className: 'slider' }, make('span', {}, name.replace('morph-', '')), input, make('output', { id: `${name}-is` }));
}

function showSlider(name) {
    $(name).value = setting(name);
    $(`${name}-is`).textContent = +(+setting(name)).toFixed(2) + SLIDERS[name][3];
}

function chooser(name) {
    const words = choices[name];
    const isWords = words && words.includes('|'), isText = words && /,|COLOR/.test(words); // numbers or a colour
    const input = isWords ? make('select', {}, make('option', { value: '' }, defaults[name] ?? 'as it comes'),
        ...words.split('|').filter(word => word !== defaults[name] && word !== 'FILE').map(word => make('option', {}, word)))
        : make('input', isText ? { type: 'text', placeholder: words } :
            { type: 'number', placeholder: defaults[name] ?? '–', min: 0, step: 'any' });
    Object.assign(input, { id: name, title: helps[name] });
    input.onchange = () => set(name, input.value);
    return make('label', { className: 'choose' }, make('span', {}, name), input);
}

function choiceButtons(id, words, isOn, choose) {
    $(id).setAttribute('role', 'radiogroup');
    $(id).replaceChildren(...words.map(word => {
        const button = make('button', { type: 'button', onclick: () => choose(word) }, word);
        button.setAttribute('role', 'radio');
        button.dataset.word = word;
        return button;
    }));
    $(id).check = () => [...$(id).children].forEach(b => b.setAttribute('aria-checked', isOn(b.dataset.word)));
}

function makeControls() {
    choiceButtons('meshes', MESHES, word => mesh === `builtin:${word}`, word => {
        mesh = `builtin:${word}`;
        dropFrame();
        showControls();
    });
    choiceButtons('shade', choices.shade.split('|'), word => setting('shade') === word, word => {
        set('shade', word);
        showControls();
    });
    const groups = new Map();
    for (let i = 0, name; (name = sheen.text(sheen.x.web_panel_name(i))) !== null; i++) {
        const chip = name.slice(0, name.indexOf('-')), about = sheen.text(sheen.x.web_panel_about(i));
        if (!groups.has(chip))
            groups.set(chip, make('optgroup', { label: chip.toUpperCase() }));
        groups.get(chip).append(make('option', { value: name, title: about }, name));
    }
    $('panel').append(...groups.values(), make('option', { value: 'ideal' }, 'ideal: plain memory'));
    $('panel').onchange = () => {
        delete settings.orientation;
        delete settings.size;
        set('panel', $('panel').value);
    };
    $('theme').append(...choices.theme.split('|').map(word => make('option', { value: word }, `${word} look`)));
    $('theme').onchange = () => set('theme', $('theme').value);
    $('gap').onchange = () => set('gap', $('gap').checked ? '' : 0);
    $('preset').append(...Object.keys(PRESETS).map(name => make('option', {}, name)), make('option', {}, 'own'));
    $('preset').onchange = () => {
        const preset = PRESETS[$('preset').value];
        if (preset)
            ['color', 'ambient', 'diffuse', 'specular', 'shininess'].forEach((name, i) => set(name, preset[i]));
        showControls();
    };
    $('color').oninput = () => {
        set('color', $('color').value.slice(1));
        drawLights();
    };
    $('background').oninput = () => set('background', $('background').value.slice(1));
    $('material-sliders').append(...['ambient', 'diffuse', 'specular', 'shininess'].map(slider));
    $('frame-sliders').append(slider('morph-weight'));
    $('morph-target').title = helps['morph-target'];
    $('morph-target').onchange = () => set('morph-target', $('morph-target').value);
    $('own-frame').onclick = () => busily(() => showFrame(own.files, own.name));
    $('no-frame').onclick = () => {
        dropFrame();
        showControls();
    };
    $('view-sliders').append(...['yaw', 'pitch', 'roll', 'distance', 'fov'].map(slider));
    const ortho = make('input', { type: 'checkbox', id: 'ortho', title: helps.ortho });
    ortho.onchange = () => {
        if (ortho.checked)
            settings.ortho = '';
        else
            delete settings.ortho;
        is_stale = true;
    };
    const colors = make('input', { type: 'checkbox', id: 'file-color', title: 'the colours of the file’s materials' });
    colors.onchange = () => set('color', colors.checked ? 'file' : '');
    $('more').append(make('div', { className: 'row' }, make('label', { className: 'check' }, ortho, 'no perspective'),
        make('label', { className: 'check' }, colors, 'the file’s colours')), slider('opacity'), ...MORE.map(chooser));
}

function showControls() {
    const is_file = !mesh.startsWith('builtin:');
    $('file-name').textContent = is_file ? mesh : 'Your OBJ, STL, PLY, GLB … or drop it anywhere';
    $('file-name').parentElement.classList.toggle('taken', is_file);
    $('frame-name').textContent = settings.morph ?? 'Another frame of it: its faces elsewhere';
    $('frame-name').parentElement.classList.toggle('taken', 'morph' in settings);
    $('own-frame').hidden = !own || mesh !== own.name || !/\.(glb|gltf|vrm)$/i.test(mesh);
    $('no-frame').hidden = $('frame-sliders').hidden = !('morph' in settings);
    $('morph-target').parentElement.hidden = $('own-frame').hidden && !/\.(glb|gltf|vrm)$/i.test(settings.morph ?? '');
    $('morph-target').value = settings['morph-target'] ?? '';
    $('meshes').check();
    $('shade').check();
    const known = [...$('panel').options].map(option => option.value);
    const panel = setting('panel').toLowerCase();
    $('panel').value = known.find(name => name === panel) ?? known.find(name => name.startsWith(`${panel}-`)) ?? '';
    $('theme').value = setting('theme');
    $('gap').checked = settings.gap !== '0';
    $('color').value = `#${/^[0-9a-f]{6}$/i.test(setting('color')) ? setting('color') : 'd8a048'}`;
    $('background').value = `#${/^[0-9a-f]{6}$/i.test(setting('background')) ? setting('background') : '101018'}`;
    const is = name => ['color', 'ambient', 'diffuse', 'specular', 'shininess']
        .every((part, i) => setting(part) === (String(PRESETS[name][i]) || (defaults[part] ?? '')));
    $('preset').value = Object.keys(PRESETS).find(is) ?? 'own';
    Object.keys(SLIDERS).forEach(showSlider);
    if (settings.texture && ![...$('texture').options].some(option => option.value === settings.texture))
        $('texture').append(make('option', {}, settings.texture));
    MORE.forEach(name => { $(name).value = settings[name] ?? ''; });
    $('ortho').checked = 'ortho' in settings;
    $('file-color').checked = settings.color === 'file';
    $('less-light').disabled = lights.length < 2;
    $('more-light').disabled = lights.length > 3;
    drawLights();
}

/* ---- lights: a ball seen from the eye, a dot at each light's direction ---- */

const unit = v => v.map(x => x / (Math.hypot(...v) || 1));

function drawLights() {
    const canvas = $('lights'), g = canvas.getContext('2d'), r = canvas.width / 2, [x, y] = unit(lights[0] ?? [0, 0, 1]);
    const ball = g.createRadialGradient(r + x * r * .7, r - y * r * .7, r * .05, r, r, r * 1.1);
    const color = [1, 3, 5].map(at => parseInt($('color').value.slice(at, at + 2), 16));
    const mixed = (other, part) => `rgb(${color.map(c => Math.round(c + (other - c) * part))})`;
    ball.addColorStop(0, mixed(255, .7));
    ball.addColorStop(.45, mixed(0, .25));
    ball.addColorStop(1, mixed(0, .85));
    g.clearRect(0, 0, 2 * r, 2 * r);
    g.fillStyle = ball;
    g.beginPath();
    g.arc(r, r, r - 1, 0, 7);
    g.fill();
    lights.forEach((light, i) => {
        const [lx, ly, lz] = unit(light);
        g.beginPath();
        g.arc(r + lx * (r - 12), r - ly * (r - 12), 9, 0, 7);
        g.fillStyle = lz >= 0 ? '#fffbe8' : '#6b5a38';
        g.fill();
        g.lineWidth = i === chosen && lights.length > 1 ? 5 : 2;
        g.strokeStyle = '#1a1204';
        g.stroke();
    });
}

/* The direction of a place on the ball: x to the right, y upwards, -1..1. */
function lightAt(x, y) {
    const far = Math.hypot(x, y), k = far > .995 ? .995 / far : 1;
    return [x * k, y * k, Math.sqrt(1 - (x * k) ** 2 - (y * k) ** 2)];
}

function moveLight(dx, dy) {
    const [x, y, z] = unit(lights[chosen]);
    const next = lightAt(x + dx, y + dy);
    setLights(lights.map((light, i) => i === chosen ? (z < 0 ? [next[0], next[1], -next[2]] : next) : light));
    drawLights();
}

function holdLights() {
    const canvas = $('lights');
    const place = event => {
        const box = canvas.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2];
    };
    canvas.onpointerdown = event => {
        const at = place(event);
        const off = light => Math.hypot(unit(light)[0] - at[0], unit(light)[1] - at[1]);
        chosen = lights.reduce((best, light, i) => off(light) < off(lights[best]) ? i : best, 0);
        canvas.setPointerCapture(event.pointerId);
        canvas.onpointermove(event);
    };
    canvas.onpointermove = event => {
        if (!event.buttons)
            return;
        const next = lightAt(...place(event));
        setLights(lights.map((light, i) => i === chosen ? next : light));
        drawLights();
    };
    canvas.onkeydown = event => {
        const step = { ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, .1], ArrowDown: [0, -.1] }[event.key];
        if (step) {
            moveLight(...step);
            event.preventDefault();
        }
    };
    $('more-light').onclick = () => {
        const more = [[.8, .2, .5], [-.2, -.8, .5], [.1, .9, .3]][lights.length - 1];
        chosen = lights.length;
        setLights([...lights, more]);
        showControls();
    };
    $('less-light').onclick = () => {
        chosen = 0;
        setLights(lights.slice(0, -1));
        showControls();
    };
}

/* ---- the glass: drag, pinch, wheel, keys ---- */

function turn(dx, dy) {
    set('yaw', +turned(+setting('yaw') + dx).toFixed(1));
    setNumber('pitch', +setting('pitch') + dy);
    showSlider('yaw');
    showSlider('pitch');
}

function zoom(factor) {
    setNumber('distance', +setting('distance') * factor);
    showSlider('distance');
}

function setSpin(on) {
    spinning = on;
    $('spin').setAttribute('aria-pressed', on);
}

function setDrag(light) {
    moves_light = light;
    $('drag').setAttribute('aria-pressed', light);
    $('drag').textContent = light ? 'Drag: light' : 'Drag: model';
}

function holdGlass() {
    const canvas = $('glass'), held = new Map();
    canvas.onpointerdown = event => {
        canvas.setPointerCapture(event.pointerId);
        held.set(event.pointerId, [event.clientX, event.clientY]);
        canvas.focus({ preventScroll: true });
        setSpin(false);
    };
    canvas.onpointerup = canvas.onpointercancel = event => held.delete(event.pointerId);
    canvas.onpointermove = event => {
        const was = held.get(event.pointerId);
        if (!was)
            return;
        const now = [event.clientX, event.clientY], dx = now[0] - was[0], dy = now[1] - was[1];
        if (held.size === 2) {
            const other = [...held].find(([id]) => id !== event.pointerId)[1];
            const span = at => Math.hypot(at[0] - other[0], at[1] - other[1]) || 1;
            zoom(span(was) / span(now));
        } else if (moves_light || event.shiftKey || event.buttons === 2) {
            moveLight(2 * dx / canvas.clientWidth, -2 * dy / canvas.clientHeight);
        } else {
            turn(dx / 2, dy / 2);
        }
        held.set(event.pointerId, now);
    };
    canvas.oncontextmenu = event => event.preventDefault();
    canvas.addEventListener('wheel', event => {
        event.preventDefault();
        zoom(Math.exp(event.deltaY / 800));
    }, { passive: false });
    canvas.onkeydown = key;
}

function next(name, list) {
    set(name, list[(list.indexOf(setting(name)) + 1) % list.length]);
    showControls();
}

function nextPanel() {
    $('panel').selectedIndex = ($('panel').selectedIndex + 1) % $('panel').options.length;
    $('panel').onchange();
    showControls();
}

/* Changes the orientation; quarter turns keep the mirroring, mirroring keeps the turn. */
function orient(change) {
    if (!shown)
        return;
    delete settings.size;
    settings.orientation = String(change(sheen.x.web_orientation()));
    is_stale = true;
}

const quarter = () => orient(k => (k & 4) | ((k + 1) & 3));
const mirror = () => orient(k => k ^ 4);

function reset() {
    history.replaceState(null, '', ' ');
    followLink();
    setDrag(false);
    say([]);
    showControls();
}

function stepBand() {
    setSpin(false);
    if (is_stale)
        show();
    if (!shown)
        return;
    const begins = sheen.x.web_shown_band() < 0 || sheen.x.web_shown_band() + 1 === sheen.x.web_bands();
    if (sheen.x.web_band()) {
        failed(sheen.text(sheen.x.web_problem()));
        return;
    }
    if (begins) { // a frame turned by --yaw-step has begun
        set('yaw', +turned(+setting('yaw') + +setting('yaw-step')).toFixed(1));
        showSlider('yaw');
        is_stale = false;
        $('line').textContent = commandLine();
        keepLink();
    }
    paint();
    showNumbers();
}

const KEYS = {
    ArrowLeft: () => arrow(-1, 0), ArrowRight: () => arrow(1, 0), ArrowUp: () => arrow(0, -1),
    ArrowDown: () => arrow(0, 1), '+': () => zoom(1 / 1.1), '=': () => zoom(1 / 1.1), '-': () => zoom(1.1),
    s: () => next('shade', choices.shade.split('|')), p: nextPanel, o: quarter, m: mirror,
    t: () => next('theme', choices.theme.split('|')), l: () => setDrag(!moves_light), b: stepBand,
    ' ': () => setSpin(!spinning), r: reset,
};

function arrow(x, y) {
    if (moves_light)
        moveLight(x / 10, -y / 10);
    else
        turn(5 * x, 5 * y);
}

function key(event) {
    const act = !event.ctrlKey && !event.metaKey && !event.altKey && KEYS[event.key];
    if (act) {
        act();
        event.preventDefault();
    }
}

async function copyLink() {
    history.replaceState(null, '', link());
    try {
        await navigator.clipboard.writeText(location.href);
        say(['The link is copied.']);
    } catch {
        say([`The link: ${location.href}`]);
    }
}

function holdPage() {
    let depth = 0;
    const over = on => { $('drop').hidden = !on; };
    addEventListener('dragenter', event => { event.preventDefault(); depth++; over(true); });
    addEventListener('dragleave', () => { if (--depth <= 0) over(false); });
    addEventListener('dragover', event => event.preventDefault());
    addEventListener('drop', event => {
        event.preventDefault();
        depth = 0;
        over(false);
        take([...event.dataTransfer.files]);
    });
    $('file').onchange = () => {
        take([...$('file').files]).then(() => { $('file').value = ''; });
    };
    $('frame').onchange = () => {
        takeFrame([...$('frame').files]).then(() => { $('frame').value = ''; });
    };
    $('controls').onsubmit = event => event.preventDefault();
    $('spin').onclick = () => setSpin(!spinning);
    $('drag').onclick = () => setDrag(!moves_light);
    $('step').onclick = stepBand;
    $('bake').onclick = bake;
    $('copy').onclick = copyLink;
    $('reset').onclick = reset;
    $('quarter').onclick = quarter;
    $('mirror').onclick = mirror;
    addEventListener('resize', () => { is_stale = true; });
    addEventListener('hashchange', () => {
        followLink();
        setSpin(false);
        showControls();
    });
}

/* ---- the beginning ---- */

function learnOptions() {
    for (let i = 0, name; (name = sheen.text(sheen.x.web_option(i, 0))) !== null; i++) {
        const help = sheen.text(sheen.x.web_option(i, 3));
        if (help === null) // not an option of `view`
            continue;
        helps[name] = help;
        choices[name] = sheen.text(sheen.x.web_option(i, 1));
        defaults[name] = sheen.text(sheen.x.web_option(i, 2)) ?? undefined;
    }
}

async function begin() {
    const banner = $('banner');
    if (typeof WebAssembly !== 'object') {
        banner.textContent = 'This browser has no WebAssembly, which sheen runs as here, or it is switched off ' +
            '(some do that in a secure mode). A current Firefox, Chrome, Edge or Safari has it.';
        banner.hidden = false;
        document.body.dataset.state = 'none';
        return;
    }
    try {
        code = await WebAssembly.compile(Uint8Array.from(atob($('wasm').textContent.trim()), c => c.charCodeAt(0)));
        sheen = await sheenHost(code, new Map());
    } catch (error) {
        banner.textContent = `sheen does not start in this browser: ${error.message}`;
        banner.hidden = false;
        document.body.dataset.state = 'none';
        return;
    }
    learnOptions();
    followLink();
    makeControls();
    makePlan();
    holdGlass();
    holdLights();
    holdPage();
    setSpin(!location.hash && !matchMedia('(prefers-reduced-motion: reduce)').matches);
    showControls();
    show();
    document.body.dataset.state = 'ready';
    requestAnimationFrame(now => {
        last = now;
        tick(now);
    });
}

begin();
