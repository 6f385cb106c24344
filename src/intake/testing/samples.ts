/** Something of each kind that comes in, for tests of the doors. */
import { strToU8, zipSync } from 'fflate';
import { cleanFirmware } from '#hex/clean';
import { makeHex } from '#hex/make';
import { firmwareText, makeCodeText } from '#hex/testing/firmware';
import LZString from 'lz-string';
import { seriesLinkOf } from '#check/series/series-link';
import { aSeries, readyCourses } from '#check/series/testing/series';
import { seriesForPupils, seriesToFolder, seriesToText } from '#check/series/write-series';
import { projectWith, sceneWith, targetAt } from '#check/testing/tasks';
import { tournamentFile, type Entry } from '#lab/tournament/file';
import { projectToText } from '#project/file';
import { linkOf } from '#project/link/link';
import { serializeScene } from '#scene/serialize';
import { soloRun } from '#simulation/run-setup';
import { tapeToText } from '#tape/file';
import { runLinkOf } from '#tape/link';
import type { AddressDocument, Document } from '../document';

/** A course with a task. */
const scene = sceneWith([targetAt(600, 500)], { name: 'Hall' });
const project = projectWith(scene, 'forward()\n');
const run = tapeToText({
  ...{ madeBy: '0.0.0', physics: 2, untilUs: 5_000_000, untilProgramEnds: true },
  setup: soloRun({ scene, files: { 'main.py': 'forward()\n' }, seed: 1, reality: 0, robot: 'maqueen-lite', board: 'microbit-v2' }), // prettier-ignore
  result: { traceHash: '0', simulatedUs: 5_000_000, devices: [] },
});
/** Its set-up was changed afterwards, so that nobody runs it again to compare. */
const changedRun = run.replace('"seed":1', '"seed":2');
/** A tournament of two programs, each of which drives alone; it says nothing of what came of it. */
const cup: Entry = {
  ...{ name: 'Hall', scene, mode: 'league', seeds: [1] },
  programs: ['anna', 'ben'].map((name) => ({ name, files: { 'main.py': 'forward()\n' } })),
};
const projectLink = linkOf(project, { courses: readyCourses, program: true })?.fragment ?? '';

/** A program with a world, and a world alone, as WebTigerPython packs them. */
const packed = (value: unknown): string => LZString.compressToBase64(JSON.stringify(value)).replaceAll('+', '-').replaceAll('/', '_'); // prettier-ignore
const world = { StartBox: [400, 400, 0], Wallobjects: [[660, 976, 557, 6]], playgroundSize: [2000, 1500] };

const zipOf = (files: Readonly<Record<string, string>>): Uint8Array =>
  zipSync(Object.fromEntries(Object.entries(files).map(([path, text]) => [path, strToU8(text)])));

/** A board's file with this program and a library of ours. */
export function hexOf(program: string): string {
  const cleaned = cleanFirmware(firmwareText('microbit-v2'));
  const files = [{ name: 'mbrobot.py', text: '# ours\n' }, { name: 'main.py', text: program }, { name: 'way.py', text: 'x = 1\n' }]; // prettier-ignore
  const made = makeHex('firmwares' in cleaned ? cleaned.firmwares : [], files);
  if (made.kind !== 'hex') throw new Error(made.kind);
  return made.text;
}
/** An e-mail with a file. */
export const mailOf = (name: string, content: string): string =>
  [
    'From: Anna <a@example.org>',
    'Content-Type: multipart/mixed; boundary="x"',
    '',
    '--x',
    'Content-Type: text/plain',
    '',
    'Hallo',
    '--x',
    'Content-Type: application/octet-stream',
    `Content-Disposition: attachment; filename="${name}"`,
    'Content-Transfer-Encoding: base64',
    '',
    ...(btoa(content).match(/.{1,76}/g) ?? []),
    '--x--',
    '',
  ].join('\r\n');
const seriesFolder = () => seriesToFolder(aSeries(), ({ title }) => title || 'task');

/** A file, and the kind of document that it is. */
export interface Sample {
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly kind: Document['kind'];
}

const sample = (kind: Sample['kind'], name: string, content: string | Uint8Array): Sample => ({
  ...{ kind, name },
  bytes: typeof content === 'string' ? strToU8(content) : content,
});

/** A file of each kind. */
export const samples: readonly Sample[] = [
  sample('program', 'anna.py', 'forward()\n'),
  sample('hex', 'anna.hex', hexOf('forward()\n')),
  sample('project', 'anna.parcours.json', projectToText(project)),
  sample('project', 'without-ending', projectToText(project)),
  sample('course', 'hall.json', serializeScene(scene)),
  sample('course', 'mylevel.json', JSON.stringify(world)),
  sample('series', 'week.json', seriesToText(seriesForPupils(aSeries()))),
  sample('recording', 'anna.run.json', changedRun),
  sample('tournament', 'cup.json', tournamentFile(cup, [])),
  sample('zip', 'class.zip', zipOf({ 'Anna/main.py': 'forward()\n', 'Ben/main.py': '' })),
  sample('zip', 'week.zip', zipOf(Object.fromEntries(seriesFolder().map(({ name, text }) => [name, text])))),
  sample('links', 'links.txt', `Anna: https://parcours.example/#${projectLink}\n`),
  sample('links', 'links.csv', `Name,Link\nAnna,#${projectLink}\n`),
  sample('links', 'links.eml', `From: Anna <a@example.org>\n\n#${projectLink}\n`),
  sample('zip', 'attached.eml', mailOf('board.hex', hexOf('forward()\n'))),
  sample('log', 'walk.csv', 'Time (seconds),cm\n0.10,12.5\n0.20,11\n'),
  sample('picture', 'floor.png', Uint8Array.of(0x89, 0x50, 0x4e, 0x47)),
  sample('unreadable', 'broken.json', '{ "format": "parcours-project", '),
  sample('unreadable', 'broken.py', Uint8Array.of(0xff, 0xfe, 0)),
  sample('unreadable', 'broken.zip', 'no zip'),
  sample('unreadable', 'blocks.hex', makeCodeText()),
  sample('unreadable', 'film.mp4', Uint8Array.of(0, 1, 2)),
];

/** An address of each kind. */
export const addresses: Readonly<Record<AddressDocument['kind'], string>> = {
  program: `https://webtigerpython.ethz.ch/?code=${packed([{ name: 'main.py', data: 'forward()\n' }])}&playground=${packed(world)}`, // prettier-ignore
  course: `https://webtigerpython.ethz.ch/#?device=micro%3Abit&playground=${packed(world)}`,
  project: `https://parcours.example/#${projectLink}`,
  recording: `https://parcours.example/#${runLinkOf(changedRun, 0)}`,
  'series-link': `https://parcours.example/#${seriesLinkOf(seriesForPupils(aSeries()), readyCourses)?.fragment ?? ''}`,
  'series-place': 'https://parcours.example/#series=week/series.json',
  ready: 'https://parcours.example/?task=closed-line',
  unreadable: 'https://example.org/',
};
