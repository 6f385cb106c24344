import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { openGiven } from './file';
import { contentOf, givenFile, givenFolder, together, withOwnNames, type Given } from './sources';
import type { TreeFile } from './tree';

const none = () => null;

type Files = Readonly<Record<string, string | Uint8Array>>;
const bytesOf = (content: string | Uint8Array): Uint8Array => (typeof content === 'string' ? strToU8(content) : content); // prettier-ignore
const file = (path: string, content: string | Uint8Array): TreeFile => {
  const bytes = bytesOf(content);
  return { path, size: bytes.length, read: () => ({ bytes }) };
};
const zipOf = (files: Files): Uint8Array =>
  zipSync(Object.fromEntries(Object.entries(files).map(([path, content]) => [path, bytesOf(content)])));
const zip = (name: string, files: Files, isAlone = true): Promise<Given> => opened(file(name, zipOf(files)), isAlone);
const opened = async (given: TreeFile, isAlone = true): Promise<Given> =>
  givenFile(await openGiven(given), none, isAlone);
const folder = (name: string, files: Files, isAlone = true): Given =>
  givenFolder(name, Object.entries(files).map(([path, text]) => file(path, text)), none, isAlone); // prettier-ignore

/** The name of each hand-in, and the files of its program or the reason why there is none. */
async function found(...given: readonly (Given | Promise<Given>)[]) {
  const sources = withOwnNames(together(await Promise.all(given.map((one) => Promise.resolve(one)))));
  return Promise.all(
    sources.map(async (source) => {
      const content = await contentOf(source);
      const what = 'handIn' in content ? content.handIn.project.files.map(({ name }) => name) : content.problem;
      return [source.name, what] as const;
    }),
  );
}

describe('hand-ins as pupils and platforms pack them', () => {
  it('have their program at any depth', async () => {
    const files = {
      '8b/Weiss Tim/Projekt/main.py': 'a',
      '8b/Huber Eva/v2/src/main.py': 'b',
      '8b/Roth Jo/main.py': 'c',
    };
    const all = [['Huber Eva', ['main.py']], ['Roth Jo', ['main.py']], ['Weiss Tim', ['main.py']]]; // prettier-ignore
    expect(await found(zip('class.zip', files))).toEqual(all);
    expect(await found(folder('class', files))).toEqual(all);
  });

  it('have the modules that lie beside their main.py, and no others', async () => {
    const files = { 'Ada/Projekt/main.py': 'a', 'Ada/Projekt/own.py': 'b', 'Ada/other.py': 'c', 'Ben/main.py': 'd' };
    expect(await found(zip('class.zip', files))).toEqual([['Ada', ['main.py', 'own.py']], ['Ben', ['main.py']]]); // prettier-ignore
  });

  it('are the main.py above all others where old ones lie below it', async () => {
    const files = { 'Ada/Projekt/main.py': 'new', 'Ada/Projekt/old/main.py': 'old', 'Ben/robot.py': 'b' };
    expect(await found(folder('class', files))).toEqual([['Ada', ['main.py']], ['Ben', ['main.py']]]); // prettier-ignore
  });

  it('may be one program of any name, one project, or one zip in a zip in a folder', async () => {
    const inner = zipOf({ 'work/main.py': 'a', 'work/own.py': 'b' });
    const files = { 'Ada/a/robot.py': 'a', 'Ada/photo.jpg': 'x', 'Ben/b.zip': zipOf({ 'b/b.zip': inner }) };
    expect(await found(zip('class.zip', files))).toEqual([['Ada', ['main.py']], ['Ben', ['main.py', 'own.py']]]); // prettier-ignore
  });

  it('name the candidates if several files may be the program', async () => {
    const files = {
      'Ada/one/main.py': 'a',
      'Ada/two/main.py': 'b',
      'Ben/b.py': 'b',
      'Ben/x/a.py': 'b',
      'Cem/x.jpg': '',
    };
    expect(await found(folder('class', files))).toEqual([
      ['Ada', { code: 'several', params: { files: 'one/main.py, two/main.py' } }],
      ['Ben', { code: 'several', params: { files: 'b.py, x/a.py' } }],
      ['Cem', { code: 'no-main', params: {} }],
    ]);
    const many = Object.fromEntries(Array.from({ length: 14 }, (_, index) => [`Ada/x${index}.py`, 'x']));
    expect(await found(folder('class', { ...many, 'Ben/main.py': '' }))).toMatchObject([
      [
        'Ada',
        {
          params: {
            files: 'x0.py, x1.py, x10.py, x11.py, x12.py, x13.py, x2.py, x3.py, x4.py, x5.py, x6.py, x7.py, …',
          },
        },
      ],
      ['Ben', ['main.py']],
    ]);
  });

  it('bring each candidate with what lies beside it, also from a zip in their zip, and none that is no program', async () => {
    const inner = zipOf({ 'src/one.py': 'import own', 'src/own.py': 'x = 1' });
    const given = zip('class.zip', { 'Ada/all.zip': inner, 'Ada/b.py': 'b', 'Ada/list.json': '[]', 'Ben/main.py': '' });
    const content = await contentOf((await given).sources[0]!);
    const choices = 'choices' in content ? (content.choices ?? []) : [];
    expect(choices.map(({ file, handIn }) => [file, handIn.project.files.map(({ name, text }) => `${name} ${text}`)])).toEqual([
      ['all.zip/src/one.py', ['main.py import own', 'own.py x = 1']],
      ['all.zip/src/own.py', ['main.py x = 1', 'one.py import own']],
      ['b.py', ['main.py b', 'list.json []']],
    ]); // prettier-ignore
    expect(await found(folder('class', { 'Ada/robot.py': '', 'Ada/list.json': '[]', 'Ben/main.py': '' }))).toEqual([
      ['Ada', ['main.py', 'list.json']],
      ['Ben', ['main.py']],
    ]);
  });

  it('are one pupil’s where Moodle has given two files, or their folder, the pupil’s name', async () => {
    const [weiss, huber] = ['Weiss Tim_10231_assignsubmission_file_', 'Huber Eva_10232_assignsubmission_file_'];
    const flat = { [`${weiss}main.py`]: 'a', [`${weiss}own.py`]: 'b', [`${huber}robot.py`]: 'c' };
    expect(await found(zip('class.zip', flat))).toEqual([[`${huber}robot`, ['main.py']], [weiss, ['main.py', 'own.py']]]); // prettier-ignore
    const one = { [`${weiss}/a.py`]: 'a', [`${weiss}/b.py`]: 'b' };
    for (const given of [zip('class.zip', one), folder('class', one)])
      expect(await found(given)).toEqual([[weiss, { code: 'several', params: { files: 'a.py, b.py' } }]]);
  });

  it('are one pupil’s where all programs of a folder are called like programs, and several pupils’ else', async () => {
    for (const [packed, ending] of [
      [zip, '.zip'],
      [folder, ''],
    ] as const) {
      const tries = { 'Weiss Tim/versuch1.py': 'a', 'Weiss Tim/Versuch 2 (neu).py': 'b' };
      expect((await found(packed(`eins${ending}`, tries))).map(([name]) => name)).toEqual(['Weiss Tim']);
      const pupils = { '8b/anna.py': 'a', '8b/ben_robot.py': 'b' };
      expect((await found(packed(`class${ending}`, pupils))).map(([name]) => name)).toEqual(['anna', 'ben_robot']);
    }
  });

  it('are not what Windows and macOS leave in folders', async () => {
    const litter = {
      'Thumbs.db': 'x',
      'desktop.ini': 'x',
      '.DS_Store': 'x',
      '__MACOSX/._anna.py': 'x',
      '~$anna.docx': 'x',
    };
    const files = { ...litter, 'anna.py': 'a', 'Ben/main.py': 'b', 'Ben/Thumbs.db': 'x' };
    for (const given of [zip('class.zip', files), folder('class', files)])
      expect(await found(given)).toEqual([['Ben', ['main.py']], ['anna', ['main.py']]]); // prettier-ignore
    expect(await found(opened(file('Thumbs.db', 'x'), false), opened(file('anna.py', 'a'), false))).toEqual([['anna', ['main.py']]]); // prettier-ignore
  });

  it('may have the ending that Windows hides, or be a program in a text', async () => {
    const files = {
      'Ada/main.py.txt': 'a',
      'Ada/own.py': 'b',
      'Ben.py.txt': 'c',
      'Cem/x.txt': 'from mbrobot import *\n',
    };
    expect(await found(zip('class.zip', files))).toEqual([['Ada', ['main.py', 'own.py']], ['Ben', ['main.py']], ['Cem', ['main.py']]]); // prettier-ignore
    const alone = ['robot.txt', 'anna.py.txt'].map((name) => opened(file(name, 'while True:\r\n  forward()'), false));
    expect(await found(...alone)).toEqual([['robot', ['main.py']], ['anna', ['main.py']]]); // prettier-ignore
    expect(await found(opened(file('letter.txt', 'Liebe Frau Keller\nimport is hard: see you\n')))).toMatchObject([['letter', { code: 'no-link' }]]); // prettier-ignore
  });
});

describe('a zip or folder with main.py at its top', () => {
  const own = { 'main.py': 'import own', 'own.py': 'x = 1', 'film.mp4': new Uint8Array(300_000) };

  it('is one hand-in with its modules, called like it, alone or beside others', async () => {
    expect(await found(zip('anna.zip', own))).toEqual([['anna', ['main.py', 'own.py']]]);
    expect(await found(zip('anna.zip', own, false), folder('ben', own, false), zip('Cem.ZIP', own, false))).toEqual([
      ['anna', ['main.py', 'own.py']],
      ['ben', ['main.py', 'own.py']],
      ['Cem', ['main.py', 'own.py']],
    ]);
  });

  it('is one of a class where it is given alone, and others have theirs beside it', async () => {
    const others = { 'main.py': '', 'Ada/main.py': '', 'Ben/main.py': '' };
    expect((await found(zip('class.zip', others))).map(([name]) => name)).toEqual(['Ada', 'Ben', 'main']);
    const downloads = { 'main.py': 'a', 'main (1).py': 'b', 'main (2).py': 'c' };
    expect((await found(folder('class', downloads))).map(([name]) => name)).toEqual(['main (1)', 'main (2)', 'main']);
    expect(await found(zip('anna.zip', others, false), folder('ben', own, false))).toEqual([['anna', ['main.py']], ['ben', ['main.py', 'own.py']]]); // prettier-ignore
  });

  it('is nobody else’s where several files have one name', async () => {
    const twice = { './a.py': 'a', '../a.py': 'b', 'b.py': 'c' };
    expect((await found(zip('class.zip', twice))).map(([name]) => name)).toEqual(['a', 'a (2)', 'b']);
  });

  it('says whose a single program in it is, where several are given', async () => {
    const given = [zip('anna.zip', { 'Projekt/main.py': 'a' }), zip('ben.zip', { 'robot.py': 'b' }), folder('cem', { 'x/y/main.py': 'c' })]; // prettier-ignore
    expect((await found(...given)).map(([name]) => name)).toEqual(['anna', 'ben', 'cem']);
    const classes = [zip('7a.zip', { 'Ada/main.py': '', 'Ben/main.py': '' }), zip('7b.zip', { 'Cem/main.py': '', 'Dora.py': '' })]; // prettier-ignore
    expect((await found(...classes)).map(([name]) => name)).toEqual(['Ada', 'Ben', 'Cem', 'Dora']);
  });

  it('has the name of its folder where that of the zip is none of a pupil', async () => {
    const given = [zip('Abgabe.zip', { 'Huber Eva/main.py': 'a', 'Huber Eva/test.py': 'b' }), zip('ben.zip', { 'Slalom/main.py': 'c' })]; // prettier-ignore
    expect((await found(...given)).map(([name]) => name)).toEqual(['Huber Eva', 'ben']);
  });

  it('keeps the name that a platform has given, although its zip lies beside others', async () => {
    const task = (name: string) => zip(`${name}.zip`, { 'Weiss Tim_10231_assignsubmission_file_/main.py': name });
    const twoTasks = await found(task('Slalom'), task('Garage'));
    expect(twoTasks.map(([name]) => name)).toEqual([
      'Weiss Tim_10231_assignsubmission_file_',
      'Weiss Tim_10231_assignsubmission_file_ (2)',
    ]);
  });
});

/** A zip in which so many names stand for the same bytes. */
function manyAtOnePlace(names: readonly string[], content: Uint8Array): Uint8Array {
  const one = zipSync({ [names[0] ?? '']: content });
  const view = new DataView(one.buffer);
  const directory = view.getUint32(one.length - 6, true);
  const record = one.subarray(directory, one.length - 22);
  const written = new TextEncoder();
  const records = names.map((name) => {
    const named = new Uint8Array([...record.subarray(0, 46), ...written.encode(name)]);
    new DataView(named.buffer).setUint16(28, name.length, true);
    return named;
  });
  const end = Uint8Array.from(one.subarray(one.length - 22));
  const endView = new DataView(end.buffer);
  for (const at of [8, 10]) endView.setUint16(at, names.length, true);
  endView.setUint32(12, records.reduce((sum, { length }) => sum + length, 0), true); // prettier-ignore
  return new Uint8Array([one.subarray(0, directory), ...records, end].flatMap((part) => [...part]));
}

/** A zip that says of each of its files that it is so large. */
function sayingSize(zip: Uint8Array, size: number): Uint8Array {
  const view = new DataView(zip.buffer);
  let at = view.getUint32(zip.length - 6, true);
  while (view.getUint32(at, true) === 0x02014b50) {
    view.setUint32(at + 24, size, true);
    at += 46 + view.getUint16(at + 28, true);
  }
  return zip;
}

describe('what is made to unpack to more than a computer has', () => {
  const large = new Uint8Array(5_000_000).fill(10);

  it('is refused by the directory of its zip, and the others of the class are read', async () => {
    const bomb = manyAtOnePlace(['main.py', ...Array.from({ length: 5000 }, (_, index) => `a${index}.py`)], large);
    const files = { 'Ada/hand-in.zip': bomb, 'Ben/main.py': 'b' };
    expect(await found(zip('class.zip', files))).toEqual([
      ['Ada', { code: 'zip-twice', params: {} }],
      ['Ben', ['main.py']],
    ]);
    expect(await found(opened(file('bomb.zip', bomb), true))).toEqual([
      ['bomb.zip', { code: 'zip-twice', params: {} }],
    ]);
  });

  it('may have no more programs than a project, told before one is unpacked', async () => {
    const modules = Object.fromEntries(Array.from({ length: 30 }, (_, index) => [`Ada/m${index}.py`, 'x']));
    expect(await found(zip('class.zip', { ...modules, 'Ada/main.py': '', 'Ben.py': '' }))).toMatchObject([
      ['Ada', { code: 'many-files', params: { count: 31, most: 20 } }],
      ['Ben', ['main.py']],
    ]);
  });

  it('is a program that is too large, alone or beside a main.py, also where the zip says something else', async () => {
    const told = { code: 'large', params: { most: 262_144 } };
    expect(await found(zip('class.zip', { 'Ada.py': large, 'Ben/main.py': '', 'Ben/b.py': large, 'Cem.py': '' }))).toMatchObject([['Ada', told], ['Ben', told], ['Cem', ['main.py']]]); // prettier-ignore
    const lying = sayingSize(zipSync({ 'Ada.py': large, 'Ben.py': strToU8('') }), 10);
    expect(await found(opened(file('class.zip', lying), true))).toMatchObject([
      ['Ada', { code: 'zip-bomb' }],
      ['Ben', ['main.py']],
    ]);
  });

  it('is a zip whose files are more together than any class has', async () => {
    const files = Object.fromEntries(Array.from({ length: 63 }, (_, index) => [`a${index}.json`, '{}']));
    const whole = sayingSize(zipOf(files), 16_000_000);
    expect(await found(opened(file('class.zip', whole), true))).toEqual([
      ['class.zip', { code: 'zip-much', params: { most: 1_000_000_000 } }],
    ]);
  });

  it('leaves out what a board could not hold, and keeps what a program may read', async () => {
    const photos = Object.fromEntries(Array.from({ length: 40 }, (_, index) => [`p${index}.jpg`, new Uint8Array(200_000).fill(0xff)])); // prettier-ignore
    expect(await found(folder('anna', { ...photos, 'main.py': 'x', 'data.csv': '1,2' }))).toEqual([
      ['anna', ['main.py', 'data.csv']],
    ]);
  });
});
