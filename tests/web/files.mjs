/*
 * files.mjs CASES PAGE - files of tests/web/cases given to the page: pictures are the command's, pixel for pixel, and so
 * are warnings and the lines on what is wrong; after a bad one the picture before it is still there.
 */
import fs from 'node:fs';
import path from 'node:path';
import { Browser, decodePng, differing, glass, judge, said, settle } from './browser.mjs';

const [cases_file, page_file] = process.argv.slice(2);
const browser = await Browser.open(page_file);
const page = await browser.page({ hash: '#panel=ili9341' });
const { check, end } = judge();

/* What the page cannot do it says, in words of its own. */
const WITHOUT = /; the command sheen reads it, this page does not$/;

/* About a broken picture libpng and libjpeg say one thing, stb_image another; and the page has no --help. */
const same = line => line.replace(/ \(see sheen (--help|help [a-z-]+)\)$/, '').replace(/(a broken (PNG|JPEG): ).*?(; --texture off does without)?$/, '$1$3');

function isSaid(command, lines) {
    return JSON.stringify(command.split('\n').filter(Boolean).map(same)) === JSON.stringify(lines.map(same));
}

/* Files by the name that a mesh has for them: such with folders in it cannot be chosen in a dialog. */
async function give(names, folder) {
    const given = names.map(name => ({ name, bytes: fs.readFileSync(path.join(folder, name)).toString('base64') }));
    await page.evaluate(async given => {
        await take(given.map(({ name, bytes }) =>
            new File([Uint8Array.from(atob(bytes), c => c.charCodeAt(0))], name)));
    }, given);
    await settle(page);
}

/* The link of these options, followed: what is shown is drawn anew. */
async function follow(words) {
    const link = new URLSearchParams();
    for (let i = 0; i < words.length; i += 2)
        link.append(words[i].slice(2), words[i + 1]);
    await page.evaluate(query => {
        const was = mesh;
        history.replaceState(null, '', `#panel=ili9341&${query}`);
        followLink();
        mesh = was;
    }, link.toString());
    await settle(page);
}

const tally = { good: 0, bad: 0, without: 0, later: 0 };
for (const one of JSON.parse(fs.readFileSync(cases_file, 'utf8'))) {
    const mesh = one.files[0], label = `${path.basename(one.folder)}/${mesh} ${one.words.join(' ')}`;
    await page.evaluate(() => { mesh = 'builtin:teapot'; });
    await follow(one.words);
    const before = await glass(page);
    await give(one.files, one.folder);
    const lines = await said(page), now = await glass(page);
    if (lines.length === 1 && WITHOUT.test(lines[0])) {
        tally.without++;
        check(`${label}: ${lines}`, /fbx|xyzzy|no_ending|draco|meshopt|text\.stl|noise|letter/.test(mesh));
        check(`${label}: the picture before it is gone`, differing(before, now) === 0);
    } else if (one.good) {
        tally.good++;
        const off = differing(now, decodePng(path.join(one.folder, 'picture.png')));
        check(`${label}: ${off} pixels differ`, off === 0);
        check(`${label}: says ${JSON.stringify(lines)} for ${JSON.stringify(one.said)}`, isSaid(one.said, lines));
    } else {
        tally.bad++;
        check(`${label}: says ${JSON.stringify(lines)} for ${JSON.stringify(one.said)}`, isSaid(one.said, lines));
        check(`${label}: the picture before it is gone`, differing(before, now) === 0);
    }
}
// What a file's pictures are read with may change after it has been dropped, and a picture may come later than its mesh.
const LATER = ['--filter', '--wrap', '--texture-size', '--palette', '--alpha-cutoff', '--texture'];
for (const one of JSON.parse(fs.readFileSync(cases_file, 'utf8')).filter(one => one.good)) {
    const at = one.words.findIndex(word => LATER.includes(word)), own = one.words[at + 1];
    if (at < 0)
        continue;
    await page.evaluate(() => { mesh = 'builtin:teapot'; });
    await follow(one.words.toSpliced(at, 2));
    await give(one.files.filter(name => name !== own), one.folder);
    if (await page.evaluate('mesh') !== one.files[0]) // it names another picture, which is not there
        continue;
    const before = await glass(page), want = decodePng(path.join(one.folder, 'picture.png'));
    if (one.files.includes(own))
        await give([own], one.folder);
    else
        await follow(one.words);
    const off = differing(await glass(page), want);
    check(`later ${path.basename(one.folder)}/${one.files[0]} ${one.words.join(' ')}: ${off} pixels differ`, off === 0);
    tally.later += differing(before, want) !== 0;
}
check(`${tally.later} pictures changed later`, tally.later > 10);
console.log(`${tally.good} good, ${tally.bad} bad, ${tally.without} that the page does without, ${tally.later} changed later`);
check(`requests: ${browser.outside}`, browser.outside.length === 0);
check(`errors: ${browser.errors}`, browser.errors.length === 0);
await browser.close();
end('files');
