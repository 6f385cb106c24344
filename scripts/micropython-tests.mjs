// node scripts/micropython-tests.mjs FOLDER: runs MicroPython's own tests (the folder `tests` of its source code, which is
// not part of this repository) on the simulated micro:bit, and tells which print something else than MicroPython's authors
// expect: what their `.exp` file says, else what Python prints. Differences that docs/micropython-tests.md names with a
// reason are known; any other is a failure. With names behind the folder, such as basics/int1, only those.
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const FOLDERS = ['basics', 'float', 'micropython'];
const AT_ONCE = 2;
const here = (path) => fileURLToPath(new URL(path, import.meta.url));

const [folder, ...only] = process.argv.slice(2);
if (folder === undefined || !existsSync(join(folder, 'basics'))) {
  process.stderr.write('Which folder? For example: node scripts/micropython-tests.mjs ~/micropython/tests\n');
  process.exit(2);
}
const known = new Set(
  [
    ...readFileSync(here('../docs/micropython-tests.md'), 'utf8').matchAll(/`((?:basics|float|micropython)\/\w+)`/g),
  ].map((match) => match[1]),
);
const names = FOLDERS.flatMap((kind) =>
  readdirSync(join(folder, kind))
    .filter((name) => name.endsWith('.py'))
    .map((name) => `${kind}/${name.slice(0, -3)}`),
).filter((name) => only.length === 0 || only.includes(name));

const counts = { equal: 0, skipped: 0, known: 0, new: 0 };
const unexpected = [];
const mended = [];
await Promise.all(Array.from({ length: AT_ONCE }, work));
process.stdout.write(`${JSON.stringify(counts)}\n`);
if (mended.length > 0) process.stdout.write(`Equal, though the page lists them: ${mended.sort().join(', ')}\n`);
if (unexpected.length > 0) process.stdout.write(`Different, and not listed: ${unexpected.sort().join(', ')}\n`);
process.exit(unexpected.length > 0 ? 1 : 0);

async function work() {
  for (let name = names.pop(); name !== undefined; name = names.pop()) {
    const file = join(folder, `${name}.py`);
    const printed = await output(process.execPath, [here('../bin/parcours.mjs'), 'run', file, '--robot', 'none']);
    if (/^SKIP\s*$/m.test(printed)) {
      counts.skipped += 1;
      continue;
    }
    const isEqual = plain(printed) === plain(expectedOf(file));
    if (isEqual) {
      counts.equal += 1;
      if (known.has(name)) mended.push(name);
    } else if (known.has(name)) counts.known += 1;
    else {
      counts.new += 1;
      unexpected.push(name);
    }
    if (!isEqual && only.length > 0)
      process.stdout.write(`--- ${name}, expected:\n${expectedOf(file)}\n--- printed:\n${printed}\n`);
  }
}

function expectedOf(file) {
  if (existsSync(`${file}.exp`)) return readFileSync(`${file}.exp`, 'utf8');
  return spawnSync('python3', [file], { encoding: 'utf8', env: { ...process.env, PYTHONIOENCODING: 'utf-8' } }).stdout;
}

/** The name of the file differs: on the board it is main.py. */
function plain(text) {
  return text
    .replaceAll('\r\n', '\n')
    .replace(/File "[^"]*"/g, 'File ""')
    .trimEnd();
}

function output(command, args) {
  return new Promise((resolve) => {
    const child = spawn(command, args, { stdio: ['ignore', 'pipe', 'ignore'] });
    let text = '';
    child.stdout.setEncoding('utf8').on('data', (part) => (text += part));
    child.on('close', () => resolve(text));
  });
}
