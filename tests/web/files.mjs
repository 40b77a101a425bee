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

/* What the page does without it says, and says so in words of its own. */
const WITHOUT = /; the command sheen reads it, this page does not$/;

function isSaid(command, lines) {
    return JSON.stringify(command.split('\n').filter(Boolean)) === JSON.stringify(lines);
}

const tally = { good: 0, bad: 0, without: 0 };
for (const one of JSON.parse(fs.readFileSync(cases_file, 'utf8'))) {
    const mesh = one.files[0], label = `${path.basename(one.folder)}/${mesh} ${one.words.join(' ')}`;
    const link = new URLSearchParams();
    for (let i = 0; i < one.words.length; i += 2)
        link.append(one.words[i].slice(2), one.words[i + 1]);
    await page.evaluate(query => {
        history.replaceState(null, '', `#panel=ili9341&${query}`);
        followLink();
        show();
    }, link.toString());
    const before = await glass(page);
    // Names with folders cannot be chosen with a dialog: the page is handed such files as a drop would.
    const given = one.files.map(name => ({ name, bytes: fs.readFileSync(path.join(one.folder, name)).toString('base64') }));
    await page.evaluate(async given => {
        await take(given.map(({ name, bytes }) =>
            new File([Uint8Array.from(atob(bytes), c => c.charCodeAt(0))], name)));
    }, given);
    await settle(page);
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
console.log(`${tally.good} good, ${tally.bad} bad, ${tally.without} that the page does without`);
check(`requests: ${browser.outside}`, browser.outside.length === 0);
check(`errors: ${browser.errors}`, browser.errors.length === 0);
await browser.close();
end('files');
