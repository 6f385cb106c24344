// npm run school-zip: the built app for a school's web server, ready to be unpacked there, in dist/parcours-school.zip: with
// the headers for Apache and nginx, a page that checks the server (examples/school), and a readme in four languages.
import { mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { zipSync } from 'fflate';
import { main, note, root } from './progress.mjs';
import { PAGE_POLICY, WORKER_POLICY } from './serve.mjs';
import { setUpApp } from './setup.mjs';

const MADE = 'dist/parcours-school.zip';
/** The folder that is uploaded. */
const FOLDER = 'parcours';
const READMES = ['LIES-MICH.txt', 'LISEZ-MOI.txt', 'LEGGIMI.txt', 'README.txt'];
/** The page that checks the server. */
const CHECK = ['check.html', 'check.css', 'check.js', 'judge.js', 'texts.js'];
/** Schools change these, and add to them. */
const LEFT_OUT = /^firmware\//;
/** The same moment for every file, so that the same app gives the same zip. */
const MOMENT = '1980-01-02T00:00:00';
/** Already compressed. */
const PACKED = /\.(png|woff2)$/;

/** @param {string} path */
const read = async (path) => new Uint8Array(await readFile(join(root, path)));
/** @param {string} text */
const bytesOf = (text) => new TextEncoder().encode(text);

/**
 * The files of the zip.
 *
 * @param {string} [app] the folder of the built app
 * @returns {Promise<ReadonlyMap<string, Uint8Array>>} by their names, in their order
 */
export async function schoolFiles(app = 'dist/app') {
  const folder = resolve(root, app);
  const all = await readdir(folder, { recursive: true, withFileTypes: true });
  const names = all
    .filter((one) => one.isFile())
    .map((one) =>
      join(one.parentPath, one.name)
        .slice(folder.length + 1)
        .replaceAll('\\', '/'),
    )
    .filter((name) => !LEFT_OUT.test(name))
    .sort();
  /** @type {Map<string, Uint8Array>} */
  const served = new Map();
  for (const name of names) served.set(name, new Uint8Array(await readFile(join(folder, name))));
  for (const name of CHECK) served.set(name, await read(`examples/school/${name}`));
  const list = {
    policies: { page: PAGE_POLICY, worker: WORKER_POLICY },
    files: [...served].map(([file, { length }]) => ({ file, bytes: length })),
  };
  served.set('files.json', bytesOf(`${JSON.stringify(list)}\n`));
  const htaccess = new TextDecoder().decode(await read('examples/school/htaccess'));
  served.set(
    '.htaccess',
    bytesOf(htaccess.replace('PAGE_POLICY', PAGE_POLICY).replace('WORKER_POLICY', WORKER_POLICY)),
  );
  /** @type {Map<string, Uint8Array>} */
  const files = new Map();
  for (const name of READMES)
    files.set(
      name,
      bytesOf(`\ufeff${new TextDecoder().decode(await read(`examples/school/${name}`)).replaceAll('\n', '\r\n')}`),
    ); // for Windows' Notepad
  files.set('nginx.conf', await read('examples/container/nginx.conf'));
  for (const [name, bytes] of served) files.set(`${FOLDER}/${name}`, bytes);
  return files;
}

/**
 * Packs them. The same app gives the same zip, byte for byte.
 *
 * @param {ReadonlyMap<string, Uint8Array>} files
 */
export const schoolZip = (files) =>
  zipSync(
    Object.fromEntries([...files].map(([name, bytes]) => [name, [bytes, { level: PACKED.test(name) ? 0 : 9 }]])),
    { mtime: MOMENT },
  );

await main(import.meta.url, async () => {
  await setUpApp();
  const zip = schoolZip(await schoolFiles());
  const path = join(root, MADE);
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, zip);
  note(`${MADE}, ${(zip.length / 1_000_000).toFixed(1)} MB. Unpack it; README.txt says the rest.`);
});
