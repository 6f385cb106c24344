import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { shownNames } from '#check/report/names';
import { openGiven } from './file';
import { contentOf, givenFile, together, withOwnNames } from './sources';
import { addresses, hexOf, mailOf, samples } from './testing/samples';

const PROGRAM = 'from mbrobot import *\nforward()\n';
const UMLAUT = `# Übung\n${PROGRAM}`;
type Files = Readonly<Record<string, string | Uint8Array>>;
const bytesOf = (content: string | Uint8Array): Uint8Array => (typeof content === 'string' ? strToU8(content) : content); // prettier-ignore
const zipOf = (files: Files): Uint8Array =>
  zipSync(Object.fromEntries(Object.entries(files).map(([path, content]) => [path, bytesOf(content)])));

/** As Windows' old Notepad saves a text: with a mark in UTF-16, else a byte a sign. */
const utf16 = (text: string): Uint8Array => new Uint8Array(Uint16Array.from(`\ufeff${text}`, (sign) => sign.charCodeAt(0)).buffer); // prettier-ignore
const ansi = (text: string): Uint8Array => Uint8Array.from(text, (sign) => sign.charCodeAt(0));

/** An e-mail with a link in its text. */
const letter = (from: string, text: string): string => `From: ${from}\nSubject: Abgabe\n\n${text}\n`;
const from = (name: string, mail: string): string => mail.replace('Anna <a@example.org>', `${name} <a@example.org>`);

const moodle = (name: string, number: number, kind: 'file' | 'onlinetext' = 'file'): string =>
  `${name}_${String(number)}_assignsubmission_${kind}_`;
const project = samples.find(({ kind }) => kind === 'project')!.bytes;

/** The folder of downloads of a teacher after a lesson. */
const given: Files = {
  // Moodle: "download all", in folders.
  'INF 8b-Roboter-10230.zip': zipOf({
    [`${moodle('Weiß Tim', 10231)}/main.py`]: PROGRAM,
    [`${moodle('Huber Eva', 10232)}/Projekt/main.py`]: PROGRAM,
    [`${moodle('Müller Jürg', 10233)}/main.py.txt`]: PROGRAM,
    [`${moodle('Roth Lea', 10234)}/abgabe.zip`]: zipOf({
      'abgabe/main.py': 'import own\n',
      'abgabe/own.py': 'x = 1\n',
    }),
    [`${moodle('Bär Zoë', 10235)}/microbit.hex`]: hexOf(PROGRAM),
    [`${moodle('Kunz Noah', 10236, 'onlinetext')}/onlinetext.html`]: `<p><a href="${addresses.project}">Link</a></p>`,
    [`${moodle('Sutter Ida', 10237)}/robot.py`]: PROGRAM,
    [`${moodle('Sutter Ida', 10237)}/Thumbs.db`]: 'x',
  }),
  // The same without folders.
  'INF 8b-Nachzügler-10260.zip': zipOf({
    [`${moodle('Frei Mia', 10261)}main.py`]: 'import own\n',
    [`${moodle('Frei Mia', 10261)}own.py`]: 'x = 1\n',
    [`${moodle('Graf Leo', 10262)}Roboter.parcours.json`]: project,
  }),
  // OneDrive: a folder that was shared.
  'OneDrive_2026-11-30.zip': zipOf({
    '8b Roboter/Anna Keller/Projekt/main.py': PROGRAM,
    '8b Roboter/Ben Ott/robot.py': utf16(UMLAUT),
    '8b Roboter/Cem Ay/main.py': ansi(UMLAUT),
    '8b Roboter/Dora Vogt/microbit-main.hex': hexOf(PROGRAM),
    '8b Roboter/Emil Senn/main.py': PROGRAM,
    '8b Roboter/Emil Senn/alt/main.py': 'old\n',
    '8b Roboter/desktop.ini': 'x',
  }),
  // Mails, saved as files.
  'Abgabe.eml': from('Finn Arn', mailOf('main.py', PROGRAM)),
  'Abgabe (1).eml': from('Gina Zaugg', mailOf('microbit.hex', hexOf(PROGRAM))),
  'AW Roboter.eml': from('Hugo Lang', mailOf('abgabe.zip', String.fromCharCode(...zipOf({ 'a/main.py': PROGRAM })))),
  'Roboter.eml': from('Iris Marti', mailOf('Roboter.parcours.json', String.fromCharCode(...project))),
  'Link.eml': letter('Jan Egli <j@example.org>', `Hier: ${addresses.project}`),
  'Hallo.eml': letter('Kim Wyss <k@example.org>', `Guten Tag\n\n${addresses.program}`),
  // And what came on a stick.
  'lina.hex': hexOf(PROGRAM),
  'max.hex': hexOf(UMLAUT),
  'nora.py.txt': PROGRAM,
  'olivier.py': `\ufeff${UMLAUT.replaceAll('\n', '\r\n')}`,
};

describe('a class of 24, as platforms and mails bring its hand-ins', () => {
  it('is read as a whole: each has a program and a name', async () => {
    const opened = await Promise.all(
      Object.entries(given).map(async ([path, content]) => {
        const bytes = bytesOf(content);
        return givenFile(await openGiven({ path, size: bytes.length, read: () => ({ bytes }) }), () => null, false);
      }),
    );
    const sources = withOwnNames(together(opened));
    const contents = await Promise.all(sources.map((source) => contentOf(source)));
    expect(contents.flatMap((content) => ('problem' in content ? [content.problem] : []))).toEqual([]);
    expect(shownNames(sources.map(({ name }) => name))).toEqual([
      ...[
        'Bär Zoë',
        'Huber Eva',
        'Kunz Noah',
        'Müller Jürg',
        'Roth Lea',
        'Sutter Ida',
        'Weiß Tim',
        'Frei Mia',
        'Graf Leo',
      ],
      ...['Anna Keller', 'Ben Ott', 'Cem Ay', 'Dora Vogt', 'Emil Senn'],
      ...[
        'Finn Arn',
        'Gina Zaugg',
        'Hugo Lang',
        'Iris Marti',
        'Jan Egli',
        'Kim Wyss',
        'lina',
        'max',
        'nora',
        'olivier',
      ],
    ]);
  });
});
