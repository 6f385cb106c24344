// Makes a robot's folder from scripts/robot-template: npm run new:robot NAME. What comes out works as it is: it drives,
// has a light, a line sensor, a library, an example and tests. CONTRIBUTING.md says what to change then.
import { existsSync } from 'node:fs';
import { mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { Failure, main, note, root } from './progress.mjs';
import { exportName, renewLists, robotFolders } from './robots.mjs';
import { writeWordTypes } from './word-types.mjs';

const TEMPLATE = join(root, 'scripts/robot-template');
const DEVICE_MODULES = join(root, 'src/vm/library/modules');
const LONGEST_NAME = 40;

/** Words that name nothing in TypeScript or Python. */
const RESERVED =
  `and as assert async await break case catch class const continue debugger def default del delete do elif
  else enum except export extends false finally for from function global if implements import in instanceof interface is
  lambda let new nonlocal not null or package pass private protected public raise return static super switch this throw
  true try type typeof var void while with yield`.split(/\s+/);

/** How the new robot is called in each place where the template says `new-robot`, `newRobot`, `new_robot`, `New Robot`. */
function namesOf(id) {
  const title = id
    .split('-')
    .map((word) => word.charAt(0).toUpperCase() + word.slice(1))
    .join(' ');
  return { id, camel: exportName(id), module: id.replaceAll('-', '_'), title };
}

/** Why there cannot be a robot of that name in `place`, or `null`. */
async function problemWith(id, place) {
  if (id === '') return 'How shall it be called? npm run new:robot my-robot';
  if (!/^[a-z][a-z0-9]*(-[a-z0-9]+)*$/.test(id))
    return `“${id}” is no name for a robot: small letters, digits and single hyphens, beginning with a letter: my-robot-2`;
  if (id.length > LONGEST_NAME) return `“${id}” is longer than ${LONGEST_NAME} characters.`;
  const { camel, module } = namesOf(id);
  if (RESERVED.includes(camel) || RESERVED.includes(module)) return `“${id}” is a word of the language. Try my-${id}.`;
  if ((await readdir(place)).some((file) => file === id || file.startsWith(`${id}.`)))
    return `src/robots has something called ${id} already.`;
  if (existsSync(join(DEVICE_MODULES, `${module}.py`))) return `The board has a module ${module}. Try my-${id}.`;
  const owner = await ownerOfModule(`${module}.py`, place);
  return owner === null ? null : `${owner} brings a module ${module} along already. Try my-${id}.`;
}

async function ownerOfModule(file, place) {
  const folders = await robotFolders(place);
  return folders.find((folder) => existsSync(join(place, folder, 'library', file))) ?? null;
}

/** The first free place in lists: one after the last robot's. */
async function nextPlace(place) {
  const folders = await robotFolders(place);
  const sources = folders.map((folder) => readFile(join(place, folder, 'type.ts'), 'utf8'));
  const places = (await Promise.all(sources)).map((source) => Number(/^ {2}place: (\d+),$/m.exec(source)?.[1] ?? 0));
  return Math.max(0, ...places) + 1;
}

/**
 * Writes the robot's folder and renews the lists of robots.
 *
 * @param {string} id its name: small letters, digits, hyphens
 * @param {string} place the folder that holds the robots' folders
 * @returns {Promise<string[]>} the files of its folder
 * @throws {Failure} when there cannot be a robot of that name
 */
export async function makeRobot(id, place) {
  const problem = await problemWith(id, place);
  if (problem !== null) throw new Failure(problem);
  const fill = filler(namesOf(id), await nextPlace(place));
  const entries = await readdir(TEMPLATE, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name));
  const made = [];
  for (const file of files) {
    const name = fill(file.slice(TEMPLATE.length + 1));
    const target = join(place, id, name);
    await mkdir(dirname(target), { recursive: true });
    await writeFile(target, await layout(fill(await readFile(file, 'utf8')), target));
    made.push(name.replaceAll('\\', '/'));
  }
  await writeWordTypes(join(place, id));
  await renewLists(place, { write: true });
  return made.sort();
}

/** Fills in the names; the place in lists is only in type.ts. */
function filler({ id, camel, module, title }, place) {
  return (text) =>
    text
      .replaceAll('new-robot', id)
      .replaceAll('newRobot', camel)
      .replaceAll('new_robot', module)
      .replaceAll('New Robot', title)
      .replace(/^ {2}place: 99,$/m, `  place: ${place},`);
}

/** Longer or shorter names shift the lines: reformatted, as `npm run format` would do. */
async function layout(source, file) {
  if (!/\.(ts|md)$/.test(file)) return source;
  const options = await resolveConfig(join(root, 'src/robots/index.ts'));
  return format(source, { ...options, filepath: file });
}

await main(import.meta.url, async ([id = '']) => {
  const files = await makeRobot(id, join(root, 'src/robots'));
  note(`src/robots/${id}: ${files.join(', ')}`);
  note('It works as it is: npm run check && npm run unit. What to change now: CONTRIBUTING.md, “A new robot”.');
});
