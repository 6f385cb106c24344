// The licences of everything that the built app is made of, as one text.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { exists } from './fingerprint.mjs';
import { root } from './progress.mjs';

/** What the app is built with is within it, but comes from tools: the service worker's own code. */
const BUILT_IN = ['workbox-precaching'];

/** Who made what names nobody itself: MicroPython's sources say so at the head of each file. */
const MAKERS = { '@micropython/micropython-webassembly-pyscript': 'Copyright (c) Damien P. George and contributors' };

/**
 * Gathers the licences of the app itself and of every package whose code may be in it.
 *
 * @returns {Promise<string>} one section per package, by name
 */
export async function licencesOfApp() {
  const { dependencies, version } = await about('');
  const folders = await withTheirs([...Object.keys(dependencies), ...BUILT_IN]);
  const own = `Parcours ${version}\n\n${await readFile(join(root, 'LICENSE'), 'utf8')}`;
  const sections = await Promise.all([...folders].sort().map(licenceOf));
  return `${[own, ...sections].map((text) => text.trim()).join(`\n\n${'-'.repeat(80)}\n\n`)}\n`;
}

/** The folders of packages and of those that they need, and so on. */
async function withTheirs(names) {
  const all = new Set();
  const waiting = names.map((name) => ({ name, by: '' }));
  for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
    const folder = await folderOf(next.name, next.by);
    if (all.has(folder)) continue;
    all.add(folder);
    const needed = Object.keys((await about(folder)).dependencies ?? {});
    waiting.push(...needed.map((name) => ({ name, by: folder })));
  }
  return all;
}

/** Where a package lies that another one needs: within it, or further out. */
async function folderOf(name, by) {
  const within = join(by, 'node_modules', name);
  if (by === '' || (await exists(join(root, within)))) return within;
  return folderOf(name, by.includes('/node_modules/') ? by.slice(0, by.lastIndexOf('/node_modules/')) : '');
}

async function licenceOf(folder) {
  const { name, version, license, author, homepage } = await about(folder);
  const files = (await readdir(join(root, folder))).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file)).sort();
  const texts = await Promise.all(files.map((file) => readFile(join(root, folder, file), 'utf8')));
  if (texts.length === 0 && /MIT/.test(license)) texts.push(await mitTerms());
  const by = typeof author === 'object' ? author.name : author;
  const facts = [
    `${name} ${version}`,
    `Licence: ${license}`,
    MAKERS[name],
    by && `By: ${by}`,
    homepage && `See: ${homepage}`,
  ];
  return [facts.filter(Boolean).join('\n'), ...texts].join('\n\n');
}

/** The terms of the MIT licence, for packages that name it and have no copy: as in our own. */
async function mitTerms() {
  const own = await readFile(join(root, 'LICENSE'), 'utf8');
  return own.slice(own.indexOf('Permission is hereby granted'));
}

const about = async (folder) => JSON.parse(await readFile(join(root, folder, 'package.json'), 'utf8'));
