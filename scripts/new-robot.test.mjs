import { execFile } from 'node:child_process';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { inEvery } from '../src/core/words';
import { mistakesIn } from '../src/reference/testing/catalogues';
import { textsOfRobot } from '../src/reference/texts';
import { putOnFloor } from '../src/robots/testing/floor';
import { makeRobot } from './new-robot.mjs';
import { renewLists } from './robots.mjs';

const ROBOTS = 'src/robots';

/** A copy of src/robots with one robot in it. It lies in the repository, so that `#room/…` is found from there. */
let place;

beforeEach(async () => {
  await mkdir('.cache', { recursive: true });
  place = join(await mkdtemp('.cache/new-robot-'), 'robots');
  await mkdir(place);
  for (const shared of [
    'maqueen-lite',
    'robot.ts',
    'mounting.ts',
    'wheels.ts',
    'line-row.ts',
    'echo.ts',
    'incidence.ts',
    'colour-options.ts',
    'camera-options.ts',
    'words',
    'testing',
  ])
    await cp(join(ROBOTS, shared), join(place, shared), { recursive: true });
  await renewLists(place, { write: true });
});

afterEach(() => rm(join(place, '..'), { recursive: true }));

async function textsOf(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name));
  return Promise.all(files.map((file) => readFile(file, 'utf8')));
}

/** The type checker's messages on a robot's folder. */
async function mistakesOfType(robot) {
  const configuration = { extends: '../../tsconfig.node.json', include: ['../../src/globals.d.ts', `robots/${robot}`] };
  await writeFile(join(place, '../tsconfig.json'), JSON.stringify(configuration));
  const args = ['node_modules/typescript/bin/tsc', '--noEmit', '--pretty', 'false', '-p', join(place, '..')];
  const output = await new Promise((resolve) => execFile(process.execPath, args, (_, stdout) => resolve(stdout)));
  return output.split(/\r?\n/).filter((line) => line.includes(`robots/${robot}/`) && !line.startsWith('src/'));
}

const inPlace = (file) => import(pathToFileURL(join(process.cwd(), place, file)).href);

describe('npm run new:robot', () => {
  it('makes a folder with everything that a robot has', async () => {
    expect(await makeRobot('tank-2', place)).toEqual([
      'SOURCES.md',
      'controller.ts',
      'examples/first_drive.py',
      'examples/words/de.json',
      'examples/words/en.json',
      'examples/words/fr.json',
      'examples/words/it.json',
      'library/tank_2.py',
      'reference.ts',
      'robot.svg',
      'robot.test.ts',
      'robot.ts',
      'sheet.ts',
      'type.ts',
      ...['reference', 'sheet'].flatMap((piece) =>
        ['de', 'en', 'fr', 'it'].map((language) => `words/${piece}/${language}.json`),
      ),
    ]);
  });

  it('puts its name in everywhere', async () => {
    await makeRobot('tank-2', place);
    const texts = (await textsOf(join(place, 'tank-2'))).join('\n');
    expect(texts).not.toMatch(/new.?robot/i);
    for (const name of ['tank-2', 'tank2', 'tank_2', 'Tank 2']) expect(texts).toContain(name);
  });

  it('gives it words in every language that say the same', async () => {
    await makeRobot('tank-2', place);
    const { tank2Reference } = await inPlace('tank-2/reference.ts');
    expect(mistakesIn(inEvery((language) => textsOfRobot(tank2Reference, language)))).toEqual([]);
  });

  it('adds it to the lists, after all others', async () => {
    await makeRobot('tank', place);
    expect(await renewLists(place, { write: false })).toEqual([]);
    const { robotTypes } = await inPlace('index.ts');
    expect(robotTypes.map(({ id }) => id)).toEqual(['maqueen-lite', 'tank']);
    const { robotSheets } = await inPlace('sheets.ts');
    expect(robotSheets.map(({ robot }) => robot)).toEqual(['maqueen-lite', 'tank']);
  });

  it('makes a robot that runs its example: it drives, turns, and sees the bare floor', async () => {
    await makeRobot('tank', place);
    const { tankBuild } = await inPlace('tank/robot.ts');
    const { tankSheet } = await inPlace('tank/sheet.ts');
    const firmware = new WebAssembly.Module(await readFile('.cache/vm/vm.wasm'));
    const { run, chassis } = putOnFloor(tankBuild);
    const { exception, lines } = run(firmware, tankSheet.examples[0].source.en, 3000);
    expect([exception, lines]).toEqual([null, ['light']]);
    expect(chassis.pathMm()).toBeGreaterThan(100);
    expect(chassis.turnedRad()).toBeGreaterThan(0.5);
  });

  it('makes a folder without a mistake of type: the checker finds only the one put in here', async () => {
    await makeRobot('tank', place);
    await writeFile(join(place, 'tank/wrong.ts'), "export const wrong: number = '1';\n");
    expect(await mistakesOfType('tank')).toEqual([expect.stringContaining('tank/wrong.ts(1,14): error TS2322')]);
  });

  it.each([
    ['', 'How shall it be called?'],
    ['My Robot', '“My Robot” is no name for a robot'],
    ['../robot', '“../robot” is no name for a robot'],
    ['tank-', '“tank-” is no name for a robot'],
    ['2cv', '“2cv” is no name for a robot'],
    ['a'.repeat(41), 'is longer than 40 characters'],
    ['class', '“class” is a word of the language'],
    ['lambda', '“lambda” is a word of the language'],
    ['maqueen-lite', 'src/robots has something called maqueen-lite already'],
    ['index', 'src/robots has something called index already'],
    ['microbit', 'The board has a module microbit'],
    ['mbrobot', 'maqueen-lite brings a module mbrobot along already'],
  ])('refuses the name “%s” with a reason', async (name, reason) => {
    await expect(makeRobot(name, place)).rejects.toThrow(reason);
  });
});

describe('npm run robots', () => {
  it('finds stale lists and renews them', async () => {
    await cp(join(place, 'maqueen-lite'), join(place, 'tank'), { recursive: true });
    await expect(renewLists(place, { write: true })).rejects.toThrow(
      'src/robots/tank/type.ts lacks “export const tank”.',
    );
    await rm(join(place, 'tank'), { recursive: true });
    await makeRobot('tank', place);
    await rm(join(place, 'tank'), { recursive: true });
    expect(await renewLists(place, { write: false })).toEqual(['index.ts', 'builds.ts', 'references.ts', 'sheets.ts']);
    expect(await renewLists(place, { write: true })).toHaveLength(4);
    expect(await renewLists(place, { write: false })).toEqual([]);
  });

  it('names the file that a folder lacks', async () => {
    await makeRobot('tank', place);
    await rm(join(place, 'tank/sheet.ts'));
    await expect(renewLists(place, { write: true })).rejects.toThrow('src/robots/tank lacks sheet.ts.');
  });
});
