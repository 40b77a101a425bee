/*
 * pictures.mjs SHEEN PAGE FOLDER [--fault] - every panel in every shading, orientations, lights, materials: the page's
 * glass is the command's picture, pixel for pixel, and the canvas shows that glass.
 *
 * --fault: the page is given another colour, so that all pictures must differ.
 */
import { execFileSync } from 'node:child_process';
import { Browser, differing, glass, judge, render } from './browser.mjs';

const [sheen, page_file, folder, fault] = process.argv.slice(2);
const browser = await Browser.open(page_file);
const page = await browser.page();
const { check, end } = judge();

const SHADES = ['flat', 'gouraud', 'phong', 'slerp'];
const panels = await page.evaluate(() => [...$('panel').options].map(option => option.value));
const cases = panels.flatMap(panel => SHADES.map(shade =>
    ['builtin:teapot', '--panel', panel, '--shade', shade, '--yaw', '77']));
for (let k = 0; k < 8; k++) {
    cases.push(['builtin:torus', '--panel', 'ili9341', '--orientation', `${k}`, '--light', '1,.2,.3', '--light', '-1,.5,.2']);
    cases.push(['builtin:sphere', '--panel', 'ssd1327', '--orientation', `${k}`, '--shade', SHADES[k % 4]]);
}
cases.push(['builtin:cube', '--color', '3a6fd8', '--background', 'linen', '--ortho', '--cull', 'none', '--dither', 'off'],
    ['builtin:teapot', '--distance', '1.3', '--fov', '80', '--perspective', 'affine', '--band', '7', '--buffers', '2'],
    ['builtin:teapot', '--panel', 'ideal', '--size', '101x77', '--ambient', '.05', '--specular', '1.2', '--shininess', '5']);
for (const ramp of ['half', 'gamma', 'gamma:1.6', 'toon'])
    cases.push(['builtin:teapot', '--ramp', ramp, '--shade', ramp === 'toon' ? 'gouraud' : 'phong']);
for (const shade of [...SHADES, 'matcap', 'matcap-vertex'])
    cases.push(['builtin:torus', '--shade', shade, '--fog', '2.2,3.9', '--background', 'lightsteelblue'],
        ['builtin:torus', '--shade', shade, '--opacity', '.6', '--phase', '3', '--fog', '2,4', '--fog-color', 'linen']);

for (const words of fault ? cases.slice(0, 8) : cases) {
    const told = fault ? [...words, '--color', '48a0d8'] : words;
    const error = await page.evaluate(words => sheen.x.web_show(sheen.words(['view', ...words])) &&
        sheen.text(sheen.x.web_problem()), told);
    const off = error ? error : differing(await glass(page), render(sheen, folder, words));
    check(`${words.join(' ')}: ${error || `${off} pixels differ`}`, off === 0);
}

// The canvas: each pixel of the glass in the middle of its square, as plain glass shows it.
for (const panel of ['ili9341', 'ssd1306', 'gc9a01']) {
    const other = await browser.page({ hash: `#panel=${panel}&theme=plain&yaw=12` });
    const seen = await other.evaluate(() => {
        const canvas = $('glass'), x = sheen.x, scale = canvas.width / x.web_width();
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height), rgb = [];
        for (let row = 0; row < x.web_height(); row++) {
            for (let column = 0; column < x.web_width(); column++) {
                const at = 4 * ((row * scale + (scale >> 1)) * canvas.width + column * scale + (scale >> 1));
                rgb.push(...data.slice(at, at + 3));
            }
        }
        return { rgb };
    });
    const want = await glass(other), got = Buffer.from(seen.rgb);
    const round = panel === 'gc9a01'; // its corners show what is around the glass
    let off = 0;
    for (let i = 0; i < want.width * want.height; i++) {
        const dx = i % want.width - (want.width - 1) / 2, dy = Math.floor(i / want.width) - (want.height - 1) / 2;
        if (!round || Math.hypot(dx, dy) < want.width / 2 - 1)
            off += want.rgb.compare(got, 3 * i, 3 * i + 3, 3 * i, 3 * i + 3) !== 0;
    }
    check(`canvas of ${panel}: ${off} pixels differ from the glass`, off === 0 && got.length === want.rgb.length);
    await other.close();
}

// `sheen plan`: the command's lines.
for (const words of [['builtin:teapot'], ['builtin:torus', '--panel', 'ssd1306', '--shade', 'gouraud', '--band', '8'],
    ['builtin:cube', '--panel', 'st7789-240x240', '--buffers', '2', '--shade', 'slerp', '--dither', 'off'],
    ['builtin:teapot', '--shade', 'matcap', '--fog', '2,4', '--edges', 'smooth']]) {
    const got = await page.evaluate(words => sheen.x.web_plan(sheen.words(['plan', ...words]), -1)
        ? sheen.text(sheen.x.web_problem()) : sheen.text(sheen.x.web_text()), words);
    const want = execFileSync(sheen, ['plan', ...words]).toString().replace(/\n {11}(?! )/g, ' '); // a page does not break lines
    check(`plan ${words.join(' ')}: ${got} is not ${want}`, got === want);
}

// What a frame takes here, for who reads this.
for (const shade of SHADES) {
    const ms = await page.evaluate(shade => {
        sheen.x.web_show(sheen.words(['view', 'builtin:teapot', '--shade', shade]));
        const start = performance.now();
        for (let i = 0; i < 50; i++)
            sheen.x.web_again();
        return (performance.now() - start) / 50;
    }, shade);
    console.log(`teapot on ili9341, ${shade}: ${ms.toFixed(2)} ms a whole frame, core, driver and controller`);
}
check(`requests: ${browser.outside}`, browser.outside.length === 0);
check(`errors: ${browser.errors}`, browser.errors.length === 0);
await browser.close();
end('pictures');
