// Which browser engines can be tested here, and how they are installed on Debian. Node built-ins only.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { Failure, main, mustRun, note, step } from './progress.mjs';

/** Debian's packages, and the file that tells whether they are there. */
const PACKAGES = {
  'chromium-headless-shell': () => onPath('chromium-headless-shell'),
  'firefox-esr': () => firefox(),
  'webkit2gtk-driver': () => webkitDriver() && miniBrowser(),
  xvfb: () => onPath('Xvfb'),
  xauth: () => onPath('xauth'),
  pulseaudio: () => onPath('pulseaudio'),
  'fonts-liberation': () =>
    existsSync('/usr/share/fonts/truetype/liberation') || existsSync('/usr/share/fonts/truetype/liberation2'),
};

const onPath = (...names) => {
  for (const name of names) {
    for (const folder of (process.env.PATH ?? '').split(delimiter)) {
      if (folder && existsSync(join(folder, name))) return join(folder, name);
    }
  }
  return null;
};

const firstOf = (...paths) => paths.find((path) => existsSync(path)) ?? null;

/** Debian's Chromium without a window, else a whole one: the same engine, but it draws no frame of a window around each page. */
const chromium = () =>
  onPath('chromium-headless-shell', 'chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable') ??
  firstOf(
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
    'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
  );

const firefox = () =>
  onPath('firefox-esr', 'firefox') ??
  firstOf('/Applications/Firefox.app/Contents/MacOS/firefox', 'C:\\Program Files\\Mozilla Firefox\\firefox.exe');

const webkitDriver = () => onPath('WebKitWebDriver');

/** WebKitGTK's test browser lies in a folder named after the machine's architecture. */
const miniBrowser = () => {
  if (!existsSync('/usr/lib')) return null;
  const folders = readdirSync('/usr/lib').filter((name) => name.endsWith('-linux-gnu'));
  return firstOf(...folders.map((name) => `/usr/lib/${name}/webkit2gtk-4.1/MiniBrowser`));
};

const hasScreen = () => process.platform !== 'linux' || Boolean(process.env.DISPLAY) || Boolean(onPath('Xvfb'));

/**
 * The engines that can be tested on this machine.
 *
 * @returns {{ engine: 'chromium' | 'firefox' | 'webkit', env: Record<string, string>, missing: string | null }[]}
 *   env tells playwright.config.ts where the programs are; missing says why an engine cannot run
 */
export function engines() {
  const screen = hasScreen() ? null : 'no screen: neither DISPLAY nor Xvfb';
  const driver = webkitDriver();
  const browser = miniBrowser();
  return [
    engine('chromium', { PARCOURS_CHROMIUM: chromium() }, null),
    engine('firefox', { PARCOURS_FIREFOX: firefox() }, screen),
    engine('webkit', { PARCOURS_WEBKIT_DRIVER: driver, PARCOURS_WEBKIT: browser }, screen),
  ];
}

function engine(name, programs, obstacle) {
  const absent = Object.values(programs).some((program) => !program);
  return { engine: name, env: absent ? {} : programs, missing: absent ? `${name} was not found` : obstacle };
}

/** On Debian as root: installs the packages that are missing. Elsewhere the engines that are there must do. */
export async function installBrowsers() {
  const missing = Object.keys(PACKAGES).filter((name) => !PACKAGES[name]());
  if (missing.length === 0 || !isDebian()) return;
  if (process.getuid?.() !== 0) {
    note(`Missing for the browser tests: ${missing.join(', ')} (as root: apt-get install ${missing.join(' ')}).`);
    return;
  }
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  const lock = 'DPkg::Lock::Timeout=300'; // another installation may be in progress
  await step(`Installing ${missing.join(', ')}`, async () => {
    await mustRun('apt-get', ['update', '-qq', '-o', lock], { env, quiet: true });
    const install = ['install', '-y', '-qq', '--no-install-recommends', '-o', lock];
    await mustRun('apt-get', [...install, 'libgl1-mesa-dri', ...missing], { env, quiet: true });
  });
}

const isDebian = () => existsSync('/etc/os-release') && /^ID=debian$/m.test(readFileSync('/etc/os-release', 'utf8'));

/**
 * Says which engines will run and which not.
 *
 * @throws Failure when an engine is missing and `CI` is `true`
 */
export function usableEngines() {
  const all = engines();
  const missing = all.filter((it) => it.missing);
  for (const it of missing) note(`Skipping ${it.engine}: ${it.missing}.`);
  if (missing.length > 0 && process.env.CI === 'true') {
    throw new Failure(`With CI=true every engine is needed; ${missing.map((it) => it.missing).join('; ')}.`);
  }
  return all.filter((it) => !it.missing);
}

await main(import.meta.url, async () => {
  await installBrowsers();
  for (const it of usableEngines()) note(`${it.engine}: ${Object.values(it.env).join(', ')}`);
});
