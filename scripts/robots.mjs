// Writes the lists of all robots (src/robots/index.ts, builds.ts, references.ts, sheets.ts) from the folders in
// src/robots: npm run robots. With --check it only says which of them are stale.
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { Failure, main, note, root } from './progress.mjs';

const FIRST_LINE = '// Written by `npm run robots`: do not edit.';

/** Folders that hold no robot: the test bench, and the words that all robots share. */
const SHARED = ['testing', 'words'];

/** The files that every robot's folder has, and how what each exports is called. */
const PARTS = {
  'type.ts': (name) => name,
  'robot.ts': (name) => `${name}Build`,
  'reference.ts': (name) => `${name}Reference`,
  'sheet.ts': (name) => `${name}Sheet`,
};

/** How a robot is called in TypeScript: maqueen-plus-v2 → maqueenPlusV2. */
export function exportName(folder) {
  return folder.replace(/-(\w)/g, (_, letter) => letter.toUpperCase());
}

/**
 * The folders of all robots, sorted by name.
 *
 * @param {string} place the folder that holds them
 * @throws {Failure} naming the file that a folder lacks, or the name that a file should export
 */
export async function robotFolders(place) {
  const entries = await readdir(place, { withFileTypes: true });
  const folders = entries
    .filter((entry) => entry.isDirectory() && !SHARED.includes(entry.name))
    .map(({ name }) => name);
  const lacks = await Promise.all(folders.map((folder) => whatLacks(place, folder)));
  if (lacks.flat().length > 0) throw new Failure(`${lacks.flat().join('\n')}\nSee CONTRIBUTING.md, “A new robot”.`);
  return folders.sort();
}

async function whatLacks(place, folder) {
  const lines = Object.entries(PARTS).map(async ([file, nameOf]) => {
    const wanted = `export const ${nameOf(exportName(folder))}`;
    const source = await readFile(join(place, folder, file), 'utf8').catch(() => null);
    if (source === null) return `src/robots/${folder} lacks ${file}.`;
    return new RegExp(`^${wanted}\\b`, 'm').test(source) ? '' : `src/robots/${folder}/${file} lacks “${wanted}”.`;
  });
  return (await Promise.all(lines)).filter((line) => line !== '');
}

/** The lists of these robots: file name → source, not yet formatted. */
export function robotLists(folders) {
  return { 'index.ts': index(folders), ...Object.fromEntries(LATE_LISTS.map((list) => late(folders, list))) };
}

function index(folders) {
  return `${FIRST_LINE}
${imports(folders, 'type.ts')}
import type { RobotType } from './robot';

/** Every robot there is, in the order in which they are offered. */
export const robotTypes: readonly RobotType[] = [${names(folders, 'type.ts')}].sort((one, other) => one.place - other.place);

/** The robot with this id, or \`null\`. */
export function findRobot(id: string): RobotType | null {
  return robotTypes.find((type) => type.id === id) ?? null;
}
`;
}

const LATE_LISTS = [
  {
    file: 'builds.ts',
    part: 'robot.ts',
    type: 'RobotBuild',
    from: './robot',
    says: 'The parts of every robot that a run needs. Apart from `index.ts`, as only a run loads them.',
  },
  {
    file: 'references.ts',
    part: 'reference.ts',
    type: 'RobotReference',
    from: '#reference/types',
    says: 'The libraries of robots, for the editor. Apart from `index.ts`, as only the editor loads them, and later.',
  },
  {
    file: 'sheets.ts',
    part: 'sheet.ts',
    type: 'RobotSheet',
    from: './robot',
    says: 'The texts of the gallery on every robot. Apart from `index.ts`, as only the gallery loads them, and later.',
  },
];

function late(folders, { file, part, type, from, says }) {
  const own = imports(folders, part);
  const theirs = `import type { ${type} } from '${from}';`;
  const source = `${FIRST_LINE}
${from.startsWith('#') ? `${theirs}\n${own}` : `${own}\n${theirs}`}

/** ${says} */
export const robot${type.replace('Robot', '')}s: readonly ${type}[] = [${names(folders, part)}];
`;
  return [file, source];
}

const imports = (folders, part) =>
  folders
    .map((folder) => `import { ${PARTS[part](exportName(folder))} } from './${folder}/${part.replace('.ts', '')}';`)
    .join('\n');
const names = (folders, part) => folders.map((folder) => PARTS[part](exportName(folder))).join(', ');

/**
 * Writes the lists, or only compares them.
 *
 * @param {string} place the folder that holds the robots' folders
 * @param {{ write: boolean }} options
 * @returns {Promise<string[]>} the lists that were not what the folders say
 */
export async function renewLists(place, { write }) {
  const options = await resolveConfig(join(root, 'src/robots/index.ts'));
  const stale = [];
  for (const [file, source] of Object.entries(robotLists(await robotFolders(place)))) {
    const wanted = await format(source, { ...options, parser: 'typescript' });
    if ((await readFile(join(place, file), 'utf8').catch(() => '')) === wanted) continue;
    stale.push(file);
    if (write) await writeFile(join(place, file), wanted);
  }
  return stale;
}

await main(import.meta.url, async ([option]) => {
  const stale = await renewLists(join(root, 'src/robots'), { write: option !== '--check' });
  if (stale.length === 0) note('The lists of robots are what the folders in src/robots say.');
  else if (option !== '--check') note(`Written: ${stale.join(', ')}.`);
  else throw new Failure(`Stale in src/robots: ${stale.join(', ')}. Renew with: npm run robots`);
});
